#include "microslip/exact/normal/normal_problem.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/halfspace/coarser_elements.hpp"
#include "microslip/exact/halfspace/memory_need.hpp"
#include "microslip/exact/normal/normal_totals.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace microslip {
namespace {

constexpr int most_iterations = 1000;
constexpr int largest_coarsest = 32;      // elements along an axis that need no start from coarser ones
constexpr double coarse_tolerance = 5e-3; // what a start loses by its interpolation
constexpr double first_length = 0.5, shortest_length = 0.1, longest_length = 0.8; // of trial steps

using Field = std::vector<double>;

double dot(const Field& a, const Field& b) {
  double sum = 0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  return sum;
}

/// State of one solve; members are the fields of the iteration.
class Iteration {
public:
  Iteration(NormalOperator& normal_operator, const ElementGrid& grid, std::span<const double> gap,
            const NormalLoad& load)
      : operator_(normal_operator), grid_(grid), gap_(gap), by_force_(load.given == NormalLoad::Given::force),
        value_(load.value), products_before_(normal_operator.products()), pressure_(grid.count()),
        displacement_(grid.count()), distance_(grid.count()), direction_(grid.count()), trial_(grid.count()),
        step_(grid.count()), response_of_step_(grid.count()), free_(grid.count()) {}

  /// `start` is a pressure of which the shape counts; if it is empty or no use, the bodies' overlap.
  NormalSolution run(Field start, double tolerance, const Progress& progress) {
    approach_ = value_;
    if (!by_force_ && nearest() >= value_) return finish(0, Status::no_contact);
    if (start.empty() || !begin(std::move(start))) begin(overlap());
    double first = 0;
    for (int k = 1;; ++k) {
      find_distance();
      residual_ = find_residual();
      if (residual_ <= tolerance) return finish(k, Status::ok);
      if (k == 1) first = residual_;
      const Progress on = [&](double) { return !progress || progress(digits_done(first, residual_, tolerance)); };
      if (!on(0) || k >= most_iterations || !step(on)) return finish(k, Status::not_converged);
    }
  }

  /// Before it has begun: no pressure.
  NormalSolution stop() { return finish(0, Status::not_converged); }

private:
  double nearest() const { return *std::min_element(gap_.begin(), gap_.end()); }

  /// Overlap over its depth; 1 everywhere if the force is prescribed.
  Field overlap() const {
    Field p(grid_.count(), 1.0);
    if (by_force_) return p;
    const double depth = value_ - nearest();
    for (std::size_t k = 0; k < p.size(); ++k) p[k] = std::max(0.0, value_ - gap_[k]) / depth;
    return p;
  }

  /// The multiple of a pressure that has the force or, with the approach given, the least energy. False if that is not
  /// positive.
  bool begin(Field start) {
    pressure_ = std::move(start);
    if (by_force_) scale_to_force(pressure_);
    operator_.apply(pressure_, displacement_);
    return by_force_ || scale_to_least_energy();
  }

  /// The multiple of the pressure with the least energy, which takes no product. False if it is not positive.
  bool scale_to_least_energy() {
    double work = 0;
    for (std::size_t k = 0; k < gap_.size(); ++k) work += pressure_[k] * (value_ - gap_[k]);
    const double scale = work / dot(pressure_, displacement_);
    for (double& p : pressure_) p *= scale;
    for (double& u : displacement_) u *= scale;
    return scale > 0;
  }

  void scale_to_force(Field& pressure) const {
    double force = 0;
#pragma omp simd reduction(+ : force)
    for (std::size_t k = 0; k < pressure.size(); ++k) force += pressure[k];
    const double scale = value_ / (force * grid_.element_area());
    for (double& p : pressure) p *= scale;
  }

  /// e = h - delta + u; with the force given delta is such that e is zero on the average.
  void find_distance() {
    double sum = 0, n = 0;
#pragma omp simd reduction(+ : sum, n)
    for (std::size_t k = 0; k < distance_.size(); ++k) {
      const double e = gap_[k] + displacement_[k], in_contact = pressure_[k] > 0 ? 1 : 0;
      distance_[k] = e;
      sum += in_contact * e;
      n += in_contact;
    }
    if (by_force_) approach_ = sum / n;
    for (double& e : distance_) e -= approach_;
  }

  double find_residual() const {
    double worst = 0, largest = 0;
#pragma omp simd reduction(max : worst, largest)
    for (std::size_t k = 0; k < distance_.size(); ++k) {
      const double e = pressure_[k] > 0 ? std::abs(distance_[k]) : -distance_[k], u = std::abs(displacement_[k]);
      worst = e > worst ? e : worst;
      largest = u > largest ? u : largest;
    }
    return worst / largest;
  }

  /// The elements whose pressure may change, in contact or overlapping. Whether they are others than before.
  bool find_free() {
    int changes = 0;
#pragma omp simd reduction(| : changes)
    for (std::size_t k = 0; k < free_.size(); ++k) {
      const char now = static_cast<char>(static_cast<int>(pressure_[k] > 0) | static_cast<int>(distance_[k] < 0));
      changes |= now ^ free_[k];
      free_[k] = now;
    }
    return changes != 0;
  }

  /// Zero where the pressure may not change; with the force given, no mean where it may.
  void project(Field& field) const {
    double sum = 0, n = 0;
#pragma omp simd reduction(+ : sum, n)
    for (std::size_t k = 0; k < field.size(); ++k) {
      const double is_free = free_[k];
      sum += is_free * field[k];
      n += is_free;
    }
    const double mean = by_force_ ? sum / n : 0;
#pragma omp simd
    for (std::size_t k = 0; k < field.size(); ++k) field[k] = free_[k] ? field[k] - mean : 0;
  }

  /// Slope of the energy along a change of the pressure, where positive is downhill.
  double slope(const Field& change) const {
    return -dot(distance_, change);
  }

  void find_gradient(Field& downhill) const {
    for (std::size_t k = 0; k < downhill.size(); ++k) downhill[k] = -distance_[k];
    project(downhill);
  }

  /// Conjugate to the step before if that went to the least energy along its direction and the same elements may
  /// change.
  void find_direction() {
    const bool conjugate = !find_free() && at_least_;
    find_gradient(trial_);
    operator_.apply_near_inverse(trial_, direction_);
    project(direction_);
    const double ratio = conjugate ? -dot(direction_, response_of_step_) / dot(step_, response_of_step_) : 0;
    if (!(slope(direction_) + ratio * slope(step_) > 0)) return;
    for (std::size_t k = 0; k < direction_.size(); ++k) direction_[k] += ratio * step_[k];
  }

  /// The pressure after a step of some length along the direction, without its negative part. Whether there was one.
  bool find_trial(double length) {
    double least = 0;
#pragma omp simd reduction(min : least)
    for (std::size_t k = 0; k < trial_.size(); ++k) {
      const double p = pressure_[k] + length * direction_[k];
      least = p < least ? p : least;
      trial_[k] = p > 0 ? p : 0;
    }
    if (by_force_) scale_to_force(trial_);
    for (std::size_t k = 0; k < trial_.size(); ++k) step_[k] = trial_[k] - pressure_[k];
    return least < 0;
  }

  /// Largest share of the step before the pressure is zero somewhere.
  double longest_share() const {
    double share = HUGE_VAL;
    for (std::size_t k = 0; k < step_.size(); ++k)
      if (step_[k] < 0) share = std::min(share, pressure_[k] / -step_[k]);
    return share;
  }

  /// Moves to the trial, so that the elements without pressure there leave the contact, or to the least energy along
  /// the direction. False if no direction leads downhill, which is so when rounding is all that is left, or if the
  /// progress function does not want to go on between its two products.
  bool step(const Progress& progress) {
    find_direction();
    if (!progress(0)) return false;
    bool clipped = find_trial(length_);
    if (!(slope(step_) > 0)) {
      find_gradient(direction_);
      clipped = find_trial(1 / operator_.diagonal());
    }
    const double downhill = slope(step_);
    operator_.apply(trial_, response_of_step_);
    for (std::size_t k = 0; k < step_.size(); ++k) response_of_step_[k] -= displacement_[k];
    const double curvature = dot(step_, response_of_step_);
    if (!(downhill > 0 && curvature > 0)) return false;
    const double least = downhill / curvature;
    const double share = clipped ? (least > 0.5 ? 1 : least) : std::min(least, longest_share());
    for (std::size_t k = 0; k < step_.size(); ++k) {
      pressure_[k] = share == 1 ? trial_[k] : std::max(0.0, pressure_[k] + share * step_[k]);
      displacement_[k] += share * response_of_step_[k];
    }
    // Without a product, the slowest part of the error goes; and no conjugacy, as the next direction starts anew.
    if (!by_force_ && clipped) scale_to_least_energy();
    length_ = std::clamp(length_ * least, shortest_length, longest_length);
    at_least_ = share == least;
    return true;
  }

  NormalSolution finish(int iterations, Status status) {
    NormalSolution s;
    s.approach = approach_;
    s.pressure = std::move(pressure_);
    s.displacement = std::move(displacement_);
    s.residual = residual_;
    s.iterations = iterations;
    s.products = operator_.products() - products_before_;
    s.status = status;
    find_totals(grid_, gap_, s);
    return s;
  }

  NormalOperator& operator_;
  const ElementGrid& grid_;
  std::span<const double> gap_;
  bool by_force_;
  double value_;
  long products_before_;
  Field pressure_, displacement_, distance_, direction_, trial_, step_, response_of_step_;
  std::vector<char> free_;
  double approach_ = 0, residual_ = 0, length_ = first_length;
  bool at_least_ = false; ///< along the direction of the last step
};

} // namespace

NormalProblem::NormalProblem(const CombinedMaterial& material, const ElementGrid& grid, const Progress& progress,
                             const TransformPlans& plans)
    : grid_(require_memory(ContactProblem::normal, grid)), operator_(material, grid, progress, plans) {
  if (std::max(grid.mx, grid.my) > largest_coarsest)
    coarser_ = std::make_unique<NormalProblem>(material, coarser_grid(grid), progress, plans);
}

NormalProblem::NormalProblem(const InfluenceTable& table, const ElementGrid& grid)
    : grid_(require_memory(ContactProblem::normal, grid)), operator_(table, grid) {}

void check(const ElementGrid& grid, std::span<const double> gap, const NormalLoad& load) {
  if (gap.size() != grid.count())
    throw Error("gap: must have mx times my = " + std::to_string(grid.count()) + " values");
  for (std::size_t k = 0; k < gap.size(); ++k)
    if (!std::isfinite(gap[k])) throw Error("gap[" + std::to_string(k) + "]", gap[k], "m", "finite");
  if (load.given == NormalLoad::Given::force)
    require_positive("normal_force", load.value, "N");
  else
    require_finite("approach", load.value, "m");
}

NormalSolution NormalProblem::solve(std::span<const double> gap, const NormalLoad& load, double tolerance,
                                    const Progress& progress) {
  check(grid_, gap, load);
  require_between("tolerance", tolerance, "-", smallest_tolerance, largest_tolerance);
  double coarser_products = 0;
  NormalSolution s = solve_nested(gap, load, tolerance, progress, coarser_products);
  s.products += std::lround(coarser_products);
  return s;
}

NormalSolution NormalProblem::solve_from(std::vector<double> pressure, std::span<const double> gap,
                                         const NormalLoad& load, double tolerance, const Progress& progress) {
  check(grid_, gap, load);
  require_between("tolerance", tolerance, "-", smallest_tolerance, largest_tolerance);
  return Iteration(operator_, grid_, gap, load).run(std::move(pressure), tolerance, progress);
}

NormalSolution NormalProblem::solve_nested(std::span<const double> gap, const NormalLoad& load, double tolerance,
                                           const Progress& progress, double& coarser_products) {
  Field start;
  Iteration iteration(operator_, grid_, gap, load);
  if (coarser_) {
    bool stopped = false;
    const Progress on_coarser = [&](double) { return !(stopped = progress && !progress(0)); };
    const NormalSolution coarse =
        coarser_->solve_nested(mean_on_coarser(grid_, gap), load, std::max(tolerance, coarse_tolerance),
                               progress ? on_coarser : Progress(), coarser_products);
    if (stopped) return iteration.stop();
    const double share = static_cast<double>(coarse.pressure.size()) / static_cast<double>(gap.size());
    coarser_products = share * (coarser_products + static_cast<double>(coarse.products));
    if (coarse.normal_force > 0 && std::isfinite(coarse.normal_force))
      start = pressure_from_coarser(grid_, coarse.pressure);
  }
  return iteration.run(std::move(start), tolerance, progress);
}

} // namespace microslip
