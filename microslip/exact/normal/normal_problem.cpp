#include "microslip/exact/normal/normal_problem.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/halfspace/coarser_elements.hpp"
#include "microslip/exact/halfspace/memory_need.hpp"
#include "microslip/exact/normal/normal_totals.hpp"
#include "microslip/numerics/threads.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace microslip {
namespace {

constexpr int most_iterations = 1000;
constexpr int largest_coarsest = 32;      // elements along an axis that need no start from coarser ones
constexpr double coarse_tolerance = 5e-3; // what a start loses by its interpolation
constexpr double first_length = 0.5, shortest_length = 0.1, longest_length = 0.8; // of trial steps

constexpr double about_least = 0.3; // of a step's length, by which it may miss the least energy along its direction

using Field = std::vector<double>;

/// State of one solve; members are the fields of the iteration.
class Iteration {
public:
  Iteration(NormalOperator& normal_operator, const ElementGrid& grid, std::span<const double> gap,
            const NormalLoad& load)
      : operator_(normal_operator), grid_(grid), gap_(gap), by_force_(load.given == NormalLoad::Given::force),
        value_(load.value), products_before_(normal_operator.products()), pressure_(grid.count()),
        displacement_(grid.count()), distance_(grid.count()), direction_(grid.count()), step_(grid.count()),
        response_of_step_(grid.count()), sums_((grid.count() + block_size - 1) / block_size),
        threads_(threads_for(grid.count(), smallest_threaded)) {}

  /// `start` is a pressure of which the shape counts; if it is empty or no use, the bodies' overlap.
  NormalSolution run(Field start, double tolerance, const Progress& progress) {
    approach_ = value_;
    if (!by_force_ && nearest() >= value_) return finish(0, Status::no_contact);
    if (start.empty() || !begin(std::move(start))) begin(overlap());
    double first = 0;
    for (int k = 1;; ++k) {
      find_distance();
      if (residual_ <= tolerance) return finish(k, Status::ok);
      if (k == 1) first = residual_;
      const Progress on = [&](double) { return !progress || progress(digits_done(first, residual_, tolerance)); };
      if (!on(0) || k >= most_iterations || !step(on)) return finish(k, Status::not_converged);
    }
  }

  /// Before it has begun: no pressure.
  NormalSolution stop() { return finish(0, Status::not_converged); }

private:
  static constexpr std::size_t block_size = std::size_t(1) << 14, smallest_threaded = 4 * block_size; // of elements
  static constexpr double far = HUGE_VAL; // e where the pressure may not change
  using Sums = std::array<double, 8>;

  /// Some elements, side by side, with their part of each field.
  struct Block {
    const double* gap;
    double *pressure, *displacement, *distance, *direction, *step, *response_of_step;
    std::size_t size;
  };

  /// Calls work(block) for all blocks, and keeps what it returns.
  template <class Work> void for_blocks(const Work& work) {
    distribute(static_cast<int>(sums_.size()), threads_, [&](int b, int) {
      const std::size_t k = static_cast<std::size_t>(b) * block_size;
      sums_[static_cast<std::size_t>(b)] =
          work(Block{&gap_[k], &pressure_[k], &displacement_[k], &distance_[k], &direction_[k], &step_[k],
                     &response_of_step_[k], std::min(block_size, pressure_.size() - k)});
    });
  }

  /// The sums of what work(block) returns, in the order of the blocks, whatever the number of threads.
  template <class Work> Sums sum(const Work& work) {
    for_blocks(work);
    Sums all{};
    for (const Sums& of_block : sums_)
      for (std::size_t i = 0; i < all.size(); ++i) all[i] += of_block[i];
    return all;
  }

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
    if (by_force_) scale_to_force();
    operator_.apply(pressure_, displacement_);
    return by_force_ || scale_to_least_energy();
  }

  /// The multiple of the pressure with the least energy, which takes no product. False if it is not positive.
  bool scale_to_least_energy() {
    const Sums s = sum([&](const Block f) {
      double work = 0, twice_energy = 0;
#pragma omp simd reduction(+ : work, twice_energy)
      for (std::size_t k = 0; k < f.size; ++k) {
        work += f.pressure[k] * (value_ - f.gap[k]);
        twice_energy += f.pressure[k] * f.displacement[k];
      }
      return Sums{work, twice_energy};
    });
    const double scale = s[0] / s[1];
    for (double& p : pressure_) p *= scale;
    for (double& u : displacement_) u *= scale;
    return scale > 0;
  }

  void scale_to_force() {
    const double force = sum([&](const Block f) {
      double part = 0;
#pragma omp simd reduction(+ : part)
      for (std::size_t k = 0; k < f.size; ++k) part += f.pressure[k];
      return Sums{part};
    })[0];
    const double scale = value_ / (force * grid_.element_area());
    for (double& p : pressure_) p *= scale;
  }

  /// With the force given delta is such that e = h - delta + u is zero on the average.
  void find_approach() {
    const Sums s = sum([&](const Block f) {
      double part = 0, n = 0;
#pragma omp simd reduction(+ : part, n)
      for (std::size_t k = 0; k < f.size; ++k) {
        const double in_contact = f.pressure[k] > 0 ? 1 : 0;
        part += in_contact * (f.gap[k] + f.displacement[k]);
        n += in_contact;
      }
      return Sums{part, n};
    });
    approach_ = s[0] / s[1];
  }

  /// The residual, the elements whose pressure may change, in contact or overlapping, and e there.
  void find_distance() {
    if (by_force_) find_approach();
    for_blocks([&](const Block f) {
      const double approach = approach_;
      double worst = 0, largest = 0, part = 0, n = 0;
#pragma omp simd reduction(max : worst, largest) reduction(+ : part, n)
      for (std::size_t k = 0; k < f.size; ++k) {
        const double e = f.gap[k] + f.displacement[k] - approach, u = std::abs(f.displacement[k]);
        const bool in_contact = f.pressure[k] > 0, is_free = in_contact || e < 0;
        const double error = in_contact ? std::abs(e) : -e;
        worst = error > worst ? error : worst;
        largest = u > largest ? u : largest;
        f.distance[k] = is_free ? e : far;
        part += is_free ? e : 0;
        n += is_free ? 1 : 0;
      }
      return Sums{worst, largest, part, n};
    });
    double worst = 0, largest = 0, part = 0;
    free_count_ = 0;
    for (const Sums& s : sums_) {
      worst = std::max(worst, s[0]);
      largest = std::max(largest, s[1]);
      part += s[2];
      free_count_ += s[3];
    }
    residual_ = worst / largest;
    mean_distance_ = by_force_ ? part / free_count_ : 0;
  }

  /// Downhill, where the pressure may change; with the force given, without a mean.
  void find_gradient() {
    const double mean = mean_distance_;
    for_blocks([&](const Block f) {
#pragma omp simd
      for (std::size_t k = 0; k < f.size; ++k) f.direction[k] = f.distance[k] < far ? mean - f.distance[k] : 0;
      return Sums{};
    });
  }

  /// The near inverse of the gradient, conjugate to what the step before did where the pressure may change, if that
  /// went about to the least energy along its direction; also if it may change in other elements than before, since on
  /// rough surfaces some change in every iteration.
  void find_direction() {
    find_gradient();
    operator_.apply_near_inverse(direction_, direction_);
    const Sums s = sum([&](const Block f) {
      double d = 0, step = 0, e = 0, y = 0, d_e = 0, d_y = 0, step_e = 0, step_y = 0;
#pragma omp simd reduction(+ : d, step, e, y, d_e, d_y, step_e, step_y)
      for (std::size_t k = 0; k < f.size; ++k) {
        const bool is_free = f.distance[k] < far;
        const double dk = is_free ? f.direction[k] : 0, sk = is_free ? f.step[k] : 0;
        const double ek = is_free ? f.distance[k] : 0, yk = is_free ? f.response_of_step[k] : 0;
        d += dk, step += sk, e += ek, y += yk;
        d_e += dk * ek, d_y += dk * yk, step_e += sk * ek, step_y += sk * yk;
      }
      return Sums{d, step, e, y, d_e, d_y, step_e, step_y};
    });
    const double mean = by_force_ ? s[0] / free_count_ : 0, mean_step = by_force_ ? s[1] / free_count_ : 0;
    const double uphill = s[4] - mean * s[2], step_uphill = s[6] - mean_step * s[2];
    // Negative where the set of elements has changed much: the step before is of no use then.
    double ratio = std::max(0.0, -(s[5] - mean * s[3]) / (s[7] - mean_step * s[3]));
    if (!is_conjugate_ || !(uphill + ratio * step_uphill < 0)) ratio = 0;
    const double constant = mean + ratio * mean_step;
    for_blocks([&](const Block f) {
#pragma omp simd
      for (std::size_t k = 0; k < f.size; ++k)
        f.direction[k] = f.distance[k] < far ? f.direction[k] + ratio * f.step[k] - constant : 0;
      return Sums{};
    });
  }

  /// The change of the pressure over some length along the direction, without its negative part. Whether there was one.
  bool find_step(double length) {
    const Sums s = sum([&](const Block f) {
      double part = 0, least = 0;
#pragma omp simd reduction(+ : part) reduction(min : least)
      for (std::size_t k = 0; k < f.size; ++k) {
        const double p = f.pressure[k] + length * f.direction[k];
        least = p < least ? p : least;
        part += p > 0 ? p : 0;
      }
      return Sums{part, least < 0 ? 1.0 : 0.0};
    });
    const double scale = by_force_ ? value_ / (s[0] * grid_.element_area()) : 1;
    downhill_ = -sum([&](const Block f) {
      double part = 0;
#pragma omp simd reduction(+ : part)
      for (std::size_t k = 0; k < f.size; ++k) {
        const double p = f.pressure[k] + length * f.direction[k];
        const double step = (p > 0 ? scale * p : 0) - f.pressure[k];
        f.step[k] = step;
        part += step != 0 ? f.distance[k] * step : 0;
      }
      return Sums{part};
    })[0];
    return s[1] > 0;
  }

  /// Largest share of the step before the pressure is zero somewhere.
  double longest_share() const {
    double share = HUGE_VAL;
    for (std::size_t k = 0; k < step_.size(); ++k)
      if (step_[k] < 0) share = std::min(share, pressure_[k] / -step_[k]);
    return share;
  }

  double curvature_along_step() {
    operator_.apply(step_, response_of_step_);
    return sum([&](const Block f) {
      double part = 0;
#pragma omp simd reduction(+ : part)
      for (std::size_t k = 0; k < f.size; ++k) part += f.step[k] * f.response_of_step[k];
      return Sums{part};
    })[0];
  }

  /// Moves to the trial, so that the elements without pressure there leave the contact, or to the least energy along
  /// the direction. False if no direction leads downhill, which is so when rounding is all that is left, or if the
  /// progress function does not want to go on between its two products.
  bool step(const Progress& progress) {
    find_direction();
    if (!progress(0)) return false;
    bool clipped = find_step(length_);
    if (!(downhill_ > 0)) {
      find_gradient();
      clipped = find_step(1 / operator_.diagonal());
    }
    const double curvature = curvature_along_step();
    if (!(downhill_ > 0 && curvature > 0)) return false;
    const double least = downhill_ / curvature;
    const double share = clipped ? (least > 0.5 ? 1 : least) : std::min(least, longest_share());
    move(share);
    is_conjugate_ = share == least || std::abs(least - 1) < about_least;
    // Without a product, the slowest part of the error goes; and no conjugacy, as the next direction starts anew.
    if (!by_force_ && clipped) {
      scale_to_least_energy();
      is_conjugate_ = false;
    }
    length_ = std::clamp(length_ * least, shortest_length, longest_length);
    return true;
  }

  void move(double share) {
    for_blocks([&](const Block f) {
      const double of_step = share;
#pragma omp simd
      for (std::size_t k = 0; k < f.size; ++k) {
        const double p = f.pressure[k] + of_step * f.step[k];
        f.pressure[k] = p > 0 ? p : 0;
        f.displacement[k] += of_step * f.response_of_step[k];
      }
      return Sums{};
    });
  }

  NormalSolution finish(int iterations, Status status) {
    // Before there is memory for the deformed gap.
    for (auto* field : {&distance_, &direction_, &step_, &response_of_step_}) *field = Field();
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
  Field pressure_, displacement_;
  Field distance_; ///< e = h - delta + u where the pressure may change, `far` elsewhere
  Field direction_, step_, response_of_step_;
  double free_count_ = 0, mean_distance_ = 0; ///< of the elements whose pressure may change
  std::vector<Sums> sums_;                    ///< of blocks
  int threads_;
  double approach_ = 0, residual_ = 0, length_ = first_length;
  double downhill_ = 0;       ///< along the step
  bool is_conjugate_ = false; ///< the next direction may be, to the step
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
  if (coarser_) {
    bool stopped = false;
    const Progress on_coarser = [&](double) { return !(stopped = progress && !progress(0)); };
    const NormalSolution coarse =
        coarser_->solve_nested(mean_on_coarser(grid_, gap), load, std::max(tolerance, coarse_tolerance),
                               progress ? on_coarser : Progress(), coarser_products);
    if (stopped) return Iteration(operator_, grid_, gap, load).stop();
    const double share = static_cast<double>(coarse.pressure.size()) / static_cast<double>(gap.size());
    coarser_products = share * (coarser_products + static_cast<double>(coarse.products));
    if (coarse.normal_force > 0 && std::isfinite(coarse.normal_force))
      start = pressure_from_coarser(grid_, coarse.pressure);
  }
  return Iteration(operator_, grid_, gap, load).run(std::move(start), tolerance, progress);
}

} // namespace microslip
