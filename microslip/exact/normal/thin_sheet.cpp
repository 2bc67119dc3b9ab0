#include "microslip/exact/normal/thin_sheet.hpp"

#include "microslip/error.hpp"
#include "microslip/exact/normal/normal_totals.hpp"

#include <algorithm>
#include <string>

namespace microslip {
namespace {

/// The approach at which the sheet carries a force: as many of the lowest elements are in contact as it then reaches.
double approach_for(std::vector<double> gaps, double flexibility_times_force_over_area) {
  std::sort(gaps.begin(), gaps.end());
  double sum = flexibility_times_force_over_area, approach = 0;
  for (std::size_t n = 1; n <= gaps.size(); ++n) {
    sum += gaps[n - 1];
    approach = sum / static_cast<double>(n);
    if (n < gaps.size() && approach <= gaps[n]) break;
  }
  return approach;
}

} // namespace

NormalSolution solve_thin_sheet(double flexibility, const ElementGrid& grid, std::span<const double> gap,
                                const NormalLoad& load, std::span<const char> excluded) {
  require_positive("flexibility", flexibility, "m/Pa");
  check(grid);
  check(grid, gap, load);
  if (!excluded.empty() && excluded.size() != grid.count())
    throw Error("excluded: must have mx times my = " + std::to_string(grid.count()) + " values");
  const auto is_out = [&](std::size_t k) { return !excluded.empty() && excluded[k]; };
  NormalSolution s;
  s.approach = load.value;
  if (load.given == NormalLoad::Given::force) {
    std::vector<double> gaps;
    for (std::size_t k = 0; k < gap.size(); ++k)
      if (!is_out(k)) gaps.push_back(gap[k]);
    s.approach = approach_for(std::move(gaps), flexibility * load.value / grid.element_area());
  }
  for (std::size_t k = 0; k < gap.size(); ++k) {
    s.displacement.push_back(is_out(k) ? 0 : std::max(0.0, s.approach - gap[k]));
    s.pressure.push_back(s.displacement[k] / flexibility);
  }
  find_totals(grid, gap, s);
  if (s.status == Status::ok && s.contact_elements == 0) s.status = Status::no_contact;
  return s;
}

} // namespace microslip
