#include "microslip/numerics/quarter_transform.hpp"

#include "microslip/numerics/fftw.hpp"

namespace microslip {
namespace {

void transform_even(int columns, int rows, std::vector<double>& quarter) {
  std::vector<int> sizes;
  for (const int n : {rows, columns})
    if (n > 1) sizes.push_back(n);
  if (sizes.empty()) return;
  const fftw_r2r_kind kinds[] = {FFTW_REDFT00, FFTW_REDFT00};
  const fftw::Plan plan = fftw::make([&] {
    return fftw_plan_r2r(static_cast<int>(sizes.size()), sizes.data(), quarter.data(), quarter.data(), kinds,
                         FFTW_ESTIMATE);
  });
  fftw_execute(plan.get());
}

void transform_odd(int columns, int rows, std::vector<double>& quarter) {
  if (rows <= 2 || columns <= 2) return; // nothing but the zeros at offset 0 and at half the period
  const int sizes[] = {rows - 2, columns - 2}, room[] = {rows, columns};
  const fftw_r2r_kind kinds[] = {FFTW_RODFT00, FFTW_RODFT00};
  double* inner = quarter.data() + columns + 1;
  const fftw::Plan plan = fftw::make(
      [&] { return fftw_plan_many_r2r(2, sizes, 1, inner, room, 1, 0, inner, room, 1, 0, kinds, FFTW_ESTIMATE); });
  fftw_execute(plan.get());
  for (double& value : quarter) value = -value; // two odd directions: (-i)^2
}

} // namespace

void transform_quarter(int columns, int rows, Parity parity, std::vector<double>& quarter) {
  parity == Parity::even ? transform_even(columns, rows, quarter) : transform_odd(columns, rows, quarter);
}

} // namespace microslip
