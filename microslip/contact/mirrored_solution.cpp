#include "microslip/contact/mirrored_solution.hpp"

#include "microslip/contact/quantities.hpp"

namespace microslip {
namespace {

void mirror(Creepage& creepage, Totals& totals) {
  for (double* odd : {&creepage.lateral, &creepage.spin, &totals.fy, &totals.mz}) *odd = -*odd;
}

} // namespace

void mirror(ContactSolution& solution) {
  ElementGrid& grid = solution.elements.grid;
  grid.y0 = -(grid.y0 + (grid.my - 1) * grid.dy);
  for (const FieldQuantity& field : field_quantities()) {
    auto& values = const_cast<std::vector<double>&>(field.values(solution)); // of a solution that may change
    if (values.empty()) continue;
    reverse_rows(values, grid.mx);
    if (field.is_odd)
      for (double& value : values) value = 0 - value; // zero stays without a sign
  }
  if (!solution.fields.state.empty()) reverse_rows(solution.fields.state, grid.mx);
  mirror(solution.creepage, solution.totals);
  for (SolutionStep& step : solution.history) mirror(step.creepage, step.totals);
}

} // namespace microslip
