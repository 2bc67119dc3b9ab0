#include "tests/oracles/convex_gauss_seidel.hpp"

#include "microslip/error.hpp"
#include "tests/oracles/direct_operator.hpp"
#include "tests/oracles/friction_residual.hpp"
#include "tests/oracles/prescribed_force.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace microslip {
namespace {

using Field = std::vector<double>;

/// Tractions from this share of the bound on count as being on it.
constexpr double nearly_on_bound = 0.99;

/// The direction of p = g (cos, sin) with p opposite to the slip r + D p for a diagonal D, by Newton's method. It is
/// kept between the direction of the traction that would make the slip zero and that of -r: the solution is
/// -(D + lambda)^-1 r with lambda > 0, so that it lies between them.
double sliding_direction(double rx, double ry, double dxx, double dyy, double g) {
  double low = std::atan2(-ry / dyy, -rx / dxx), high = std::atan2(-ry, -rx);
  // Slip along the tangent, and its derivative to the angle.
  const auto across = [&](double c, double s) { return ry * c - rx * s + g * (dyy - dxx) * s * c; };
  const bool sign = across(std::cos(low), std::sin(low)) > 0;
  double angle = low;
  for (int k = 0; k < 50; ++k) {
    const double c = std::cos(angle), s = std::sin(angle), f = across(c, s);
    ((f > 0) == sign ? low : high) = angle;
    double next = angle - f / (g * (dyy - dxx) * (c * c - s * s) - rx * c - ry * s);
    if (!(next >= std::min(low, high) && next <= std::max(low, high))) next = (low + high) / 2;
    if (std::abs(next - angle) < 1e-14) return next;
    angle = next;
  }
  return angle;
}

class Sweeper {
public:
  Sweeper(const FrictionProblem& problem, const TangentialKernel& kernel, const Relaxation& relaxation, int threads)
      : problem_(problem), kernel_(kernel), relaxation_(relaxation), threads_(threads), mx_(kernel.xx.mx()),
        sx_(problem.bound.size()), sy_(sx_) {
    for (int row = 0; row < kernel.xx.my(); ++row) {
      const auto in_contact = [&](int i) { return problem.bound[index(row, i)] > 0; };
      RowPart part{row, 0, mx_};
      while (part.begin < part.end && !in_contact(part.begin)) ++part.begin;
      while (part.begin < part.end && !in_contact(part.end - 1)) --part.end;
      if (part.begin < part.end) rows_.push_back(part);
    }
    forward_ = mx_ == 1 || kernel.xx.at(-1, 0) <= kernel.xx.at(1, 0);
  }

  /// One sweep over all elements; returns the 2-norm of the steps to their solutions.
  double sweep(Field& px, Field& py) {
    double sum = 0;
    for (const RowPart& row : rows_) {
      sum_other_rows(row, px, py);
      add_slip(kernel_, row, px, py, row, sx_, sy_);
      for (int k = 0; k < row.end - row.begin; ++k)
        sum += visit(row, forward_ ? row.begin + k : row.end - 1 - k, px, py);
    }
    return std::sqrt(sum);
  }

private:
  std::size_t index(int row, int i) const { return static_cast<std::size_t>(row) * mx_ + i; }

  void sum_other_rows(const RowPart& row, const Field& px, const Field& py) {
    const int width = row.end - row.begin;
#pragma omp parallel for schedule(static) num_threads(threads_)
    for (int t = 0; t < threads_; ++t) {
      const RowPart part{row.row, row.begin + width * t / threads_, row.begin + width * (t + 1) / threads_};
      for (int i = part.begin; i < part.end; ++i) {
        sx_[index(row.row, i)] = problem_.cx[index(row.row, i)];
        sy_[index(row.row, i)] = problem_.cy[index(row.row, i)];
      }
      for (const RowPart& from : rows_)
        if (from.row != row.row) add_slip(kernel_, from, px, py, part, sx_, sy_);
    }
  }

  /// Relaxes element i and brings its row's slip up to date; returns the square of the full step.
  double visit(const RowPart& row, int i, Field& px, Field& py) {
    const std::size_t k = index(row.row, i);
    const double g = problem_.bound[k];
    if (!(g > 0)) return 0;
    const double dxx = kernel_.xx.at(0, 0), dyy = kernel_.yy.at(0, 0);
    const double rx = sx_[k] - dxx * px[k], ry = sy_[k] - dyy * py[k];
    const double old_x = px[k], old_y = py[k], old_size = std::hypot(old_x, old_y);
    double own_x = -rx / dxx, own_y = -ry / dyy;
    const bool slides = std::hypot(own_x, own_y) > g;
    if (slides) {
      const double angle = sliding_direction(rx, ry, dxx, dyy, g);
      own_x = g * std::cos(angle);
      own_y = g * std::sin(angle);
    }
    if (slides && old_size >= nearly_on_bound * g) {
      const double turn = std::atan2(old_x * own_y - old_y * own_x, old_x * own_x + old_y * own_y);
      const double angle = std::atan2(old_y, old_x) + relaxation_.slip * turn;
      px[k] = g * std::cos(angle);
      py[k] = g * std::sin(angle);
    } else {
      px[k] += relaxation_.adhesion * (own_x - old_x);
      py[k] += relaxation_.adhesion * (own_y - old_y);
      const double size = std::hypot(px[k], py[k]);
      if (size > g) px[k] *= g / size, py[k] *= g / size;
    }
    add_change(row, i, px[k] - old_x, py[k] - old_y);
    return std::pow(own_x - old_x, 2) + std::pow(own_y - old_y, 2);
  }

  void add_change(const RowPart& row, int source, double x, double y) {
    const double *const xx = kernel_.xx.row(0) - source, *const xy = kernel_.xy.row(0) - source,
                        *const yy = kernel_.yy.row(0) - source;
    double *const sx = sx_.data() + index(row.row, 0), *const sy = sy_.data() + index(row.row, 0);
    for (int i = row.begin; i < row.end; ++i) {
      sx[i] += xx[i] * x + xy[i] * y;
      sy[i] += xy[i] * x + yy[i] * y;
    }
  }

  const FrictionProblem& problem_;
  const TangentialKernel& kernel_;
  Relaxation relaxation_;
  int threads_, mx_;
  bool forward_; ///< particles come from larger x
  std::vector<RowPart> rows_;
  Field sx_, sy_; ///< slip of the row that is being swept
};

/// For given creepages. Adds to `sweeps`.
FrictionSolution iterate(const FrictionProblem& problem, const TangentialKernel& kernel,
                         const GaussSeidelOptions& options, std::span<const double> start_px,
                         std::span<const double> start_py, int& sweeps) {
  FrictionSolution s;
  s.traction.x.assign(problem.bound.size(), 0.0);
  s.traction.y = s.traction.x;
  for (std::size_t k = 0; k < start_px.size(); ++k)
    if (problem.bound[k] > 0) s.traction.x[k] = start_px[k], s.traction.y[k] = start_py[k];
  Sweeper sweeper(problem, kernel, options.relaxation.value_or(Relaxation::of(kernel)), options.threads);
  const double scale = bound_norm(problem);
  // The residual costs as much as a sweep, so it is asked for only when the steps have become small.
  double small = options.tolerance * scale;
  for (int k = 1; k <= options.most_sweeps; ++k) {
    ++sweeps;
    const double step = sweeper.sweep(s.traction.x, s.traction.y);
    if (step > small && k < options.most_sweeps) continue;
    find_residual(problem, s);
    if (s.report.residual <= options.tolerance) return s;
    small = std::min(small, step) / 2;
  }
  s.report.status = Status::not_converged;
  return s;
}

} // namespace

Relaxation Relaxation::of(const TangentialKernel& kernel) {
  double omega = 0.9;
  if (kernel.xx.mx() > 1) {
    const double ahead = std::min(kernel.xx.at(-1, 0), kernel.xx.at(1, 0));
    omega = std::min(omega, 0.7 * std::pow(kernel.xx.at(0, 0) / ahead, 2));
  }
  return {omega, omega};
}

GaussSeidelSolution solve_convex_gauss_seidel(const FrictionProblem& problem, const TangentialKernel& kernel,
                                              const GaussSeidelOptions& options, std::span<const double> start_px,
                                              std::span<const double> start_py) {
  require_positive("tolerance", options.tolerance, "-");
  require_count("most_sweeps", options.most_sweeps, 1, 1000000000);
  require_count("threads", options.threads, 1, 1024);
  if (options.relaxation)
    for (const double omega : {options.relaxation->adhesion, options.relaxation->slip})
      if (!(omega > 0 && omega < 2)) throw Error("relaxation", omega, "-", "above 0 and below 2");
  const long products_before = problem.slip_operator.products();
  GaussSeidelSolution solution;
  static_cast<FrictionSolution&>(solution) = solve_prescribed_force(
      problem, options.tolerance,
      [&](const FrictionProblem& given, double tolerance, std::span<const double> px, std::span<const double> py) {
        GaussSeidelOptions inner = options;
        inner.tolerance = tolerance;
        return iterate(given, kernel, inner, px, py, solution.sweeps);
      },
      start_px, start_py);
  solution.report.products = problem.slip_operator.products() - products_before;
  return solution;
}

} // namespace microslip
