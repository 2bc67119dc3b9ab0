#include "microslip/exact/fitted/grid_kernel.hpp"

#include "microslip/exact/halfspace/offset_kernel.hpp"

#include <numbers>
#include <utility>

namespace microslip {

void combine_integrals(double poisson_ratio, std::span<double> xx, std::span<double> yy, std::span<double> xy) {
  const double f = 1 / std::numbers::pi;
  for (std::size_t k = 0; k < xx.size(); ++k) {
    const double x = xx[k], y = yy[k];
    xx[k] = f * (x + (1 - poisson_ratio) * y);
    yy[k] = f * (y + (1 - poisson_ratio) * x);
    xy[k] *= f * poisson_ratio;
  }
}

SymmetricToeplitz<double> GridKernel::transform(const TransformPlans& plans,
                                                std::optional<SymmetricToeplitz<double>> memory) const {
  const SymmetricToeplitz<double>::Kernels kernels = {of_[component::xx], of_[component::xy], of_[component::yy]};
  if (!memory || memory->mx() != mx_ || memory->my() != my_) return {mx_, my_, kernels, plans};
  memory->replace(kernels);
  return std::move(*memory);
}

SymmetricToeplitz<double> GridKernel::near_inverse(const TransformPlans& plans) const {
  return SymmetricToeplitz<double>::near_inverse(mx_, my_, {of_[component::xx], of_[component::xy], of_[component::yy]},
                                                 plans);
}

double GridKernel::middle() const {
  std::vector<double> mean(of_[component::xx]);
  for (std::size_t k = 0; k < mean.size(); ++k) mean[k] = (mean[k] + of_[component::yy][k]) / 2;
  return middle_eigenvalue(mean, mx_);
}

GridKernel::GridKernel(double poisson_ratio, const ElementGrid& grid, const Progress& progress)
    : mx_(grid.mx), my_(grid.my) {
  HalfStrips strips = half_strips(grid, -0.5, static_cast<std::size_t>(mx_) + 1);
  for (auto& values : of_) values.resize(grid.count());
  for (int j = 0; j < my_; ++j) {
    go_on(progress, 0);
    const HalfStrips::Row at = strips.at(j);
    const std::size_t first = static_cast<std::size_t>(j) * mx_;
    for (int i = 0; i < mx_; ++i) {
      of_[component::xx][first + i] = at.xx[i + 1] - at.xx[i];
      of_[component::yy][first + i] = at.yy[i + 1] - at.yy[i];
      of_[component::xy][first + i] = at.xy[i + 1] - at.xy[i];
    }
  }
  combine_integrals(poisson_ratio, of_[component::xx], of_[component::yy], of_[component::xy]);
}

} // namespace microslip
