#include "microslip/exact/normal_problem.hpp"

#include "microslip/error.hpp"
#include "microslip/exact/memory_need.hpp"
#include "microslip/exact/normal_totals.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace microslip {
namespace {

constexpr int most_iterations = 1000;

using Field = std::vector<double>;

double mean_in_contact(const Field& of, const Field& pressure) {
  double sum = 0;
  int n = 0;
  for (std::size_t k = 0; k < of.size(); ++k)
    if (pressure[k] > 0) sum += of[k], ++n;
  return n > 0 ? sum / n : 0;
}

/// One solve; members are the fields of the iteration.
class Iteration {
public:
  Iteration(NormalResponse& response, const ElementGrid& grid, std::span<const double> gap, const NormalLoad& load)
      : response_(response), grid_(grid), gap_(gap), by_force_(load.given == NormalLoad::Given::force),
        value_(load.value), pressure_(grid.count()), displacement_(grid.count()), distance_(grid.count()),
        direction_(grid.count()), response_of_direction_(grid.count()) {}

  NormalSolution run(double tolerance) {
    const long before = response_.products();
    if (!start()) return finish(0, Status::no_contact, before);
    for (int k = 1; k <= most_iterations; ++k) {
      find_distance();
      residual_ = find_residual();
      if (residual_ <= tolerance) return finish(k, Status::ok, before);
      step();
    }
    find_distance();
    residual_ = find_residual();
    return finish(most_iterations, Status::not_converged, before);
  }

private:
  /// Pressure where the bodies would overlap; with the force given everywhere.
  bool start() {
    const double nearest = *std::min_element(gap_.begin(), gap_.end());
    approach_ = value_;
    if (!by_force_ && nearest >= value_) return false;
    const double depth = by_force_ ? 1 : value_ - nearest;
    for (std::size_t k = 0; k < pressure_.size(); ++k)
      pressure_[k] = by_force_ ? 1 : std::max(0.0, value_ - gap_[k]) / depth;
    response_.apply(pressure_, displacement_);
    if (by_force_) return scale_to_force(), true;
    // So that the deepest point comes right.
    const auto deepest = std::min_element(gap_.begin(), gap_.end()) - gap_.begin();
    for (double& p : pressure_) p *= depth / displacement_[deepest];
    return true;
  }

  void scale_to_force() {
    double force = 0;
    for (double p : pressure_) force += p;
    for (double& p : pressure_) p *= value_ / (force * grid_.element_area());
  }

  /// e = h - delta + u; with the force given delta is such that e is zero on the average.
  void find_distance() {
    response_.apply(pressure_, displacement_);
    for (std::size_t k = 0; k < distance_.size(); ++k) distance_[k] = gap_[k] + displacement_[k];
    if (by_force_) approach_ = mean_in_contact(distance_, pressure_);
    for (double& e : distance_) e -= approach_;
  }

  double find_residual() const {
    double worst = 0, largest = 0;
    for (std::size_t k = 0; k < distance_.size(); ++k) {
      worst = std::max(worst, pressure_[k] > 0 ? std::abs(distance_[k]) : -distance_[k]);
      largest = std::max(largest, std::abs(displacement_[k]));
    }
    return worst / largest;
  }

  void step() {
    double size2 = 0;
    for (std::size_t k = 0; k < distance_.size(); ++k)
      if (pressure_[k] > 0) size2 += distance_[k] * distance_[k];
    for (std::size_t k = 0; k < direction_.size(); ++k)
      direction_[k] = pressure_[k] > 0 ? distance_[k] + conjugate_ * (size2 / last_size2_) * direction_[k] : 0;
    last_size2_ = size2;
    response_.apply(direction_, response_of_direction_);
    const double shift = by_force_ ? mean_in_contact(response_of_direction_, pressure_) : 0;
    double slope = 0, curvature = 0;
    for (std::size_t k = 0; k < direction_.size(); ++k) {
      if (!(pressure_[k] > 0)) continue;
      slope += distance_[k] * direction_[k];
      curvature += (response_of_direction_[k] - shift) * direction_[k];
    }
    const double length = curvature > 0 ? slope / curvature : 0;
    bool enters = false;
    for (std::size_t k = 0; k < pressure_.size(); ++k) {
      if (pressure_[k] > 0) pressure_[k] = std::max(0.0, pressure_[k] - length * direction_[k]);
      if (!(pressure_[k] > 0) && distance_[k] < 0) { // overlap: comes into contact
        pressure_[k] -= length * distance_[k];
        enters = true;
      }
    }
    conjugate_ = enters ? 0 : 1;
    if (by_force_) scale_to_force();
  }

  NormalSolution finish(int iterations, Status status, long products_before) {
    NormalSolution s;
    s.approach = approach_;
    s.pressure = std::move(pressure_);
    s.displacement = std::move(displacement_);
    s.residual = residual_;
    s.iterations = iterations;
    s.products = response_.products() - products_before;
    s.status = status;
    find_totals(grid_, gap_, s);
    return s;
  }

  NormalResponse& response_;
  const ElementGrid& grid_;
  std::span<const double> gap_;
  bool by_force_;
  double value_;
  Field pressure_, displacement_, distance_, direction_, response_of_direction_;
  double approach_ = 0, residual_ = 0, last_size2_ = 1, conjugate_ = 0;
};

} // namespace

NormalProblem::NormalProblem(const CombinedMaterial& material, const ElementGrid& grid)
    : grid_(require_memory(ContactProblem::normal, grid)), response_(material, grid) {}

NormalSolution NormalProblem::solve(std::span<const double> gap, const NormalLoad& load, double tolerance) {
  if (gap.size() != grid_.count())
    throw Error("gap: must have mx times my = " + std::to_string(grid_.count()) + " values");
  for (std::size_t k = 0; k < gap.size(); ++k)
    if (!std::isfinite(gap[k])) throw Error("gap[" + std::to_string(k) + "]", gap[k], "m", "finite");
  if (load.given == NormalLoad::Given::force)
    require_positive("normal_force", load.value, "N");
  else
    require_finite("approach", load.value, "m");
  return Iteration(response_, grid_, gap, load).run(tolerance);
}

} // namespace microslip
