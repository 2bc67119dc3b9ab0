#include "microslip/contact/mirrored_solution.hpp"

#include <algorithm>

namespace microslip {
namespace {

template <class Value> void reverse_rows(std::vector<Value>& values, int mx) {
  const auto rows = static_cast<std::ptrdiff_t>(values.size()) / std::max(mx, 1);
  for (std::ptrdiff_t j = 0; j < rows / 2; ++j)
    std::swap_ranges(values.begin() + j * mx, values.begin() + (j + 1) * mx, values.begin() + (rows - 1 - j) * mx);
}

void negate(std::vector<double>& values) {
  for (double& value : values) value = -value;
}

} // namespace

void mirror(ContactSolution& solution) {
  const int mx = solution.elements.mx();
  auto& [grid, x, y, width, area] = solution.elements;
  grid.y0 = -(grid.y0 + (grid.my - 1) * grid.dy);
  SurfaceFields& f = solution.fields;
  for (auto* values : {&x, &y, &width, &area, &f.traction.x, &f.traction.y, &f.slip.x, &f.slip.y, &f.displacement.x,
                       &f.displacement.y, &f.bound, &f.pressure, &f.gap, &f.friction, &f.temperature1, &f.temperature2})
    reverse_rows(*values, mx);
  reverse_rows(f.state, mx);
  for (auto* values : {&y, &f.traction.y, &f.slip.y, &f.displacement.y}) negate(*values);
  for (SolutionStep& step : solution.history)
    for (double* odd : {&step.creepage.lateral, &step.creepage.spin, &step.totals.fy, &step.totals.mz}) *odd = -*odd;
  for (double* odd : {&solution.creepage.lateral, &solution.creepage.spin, &solution.totals.fy, &solution.totals.mz})
    *odd = -*odd;
}

} // namespace microslip
