#include "tests/oracles/active_set_tangential.hpp"

#include "microslip/error.hpp"
#include "microslip/numerics/gmres.hpp"
#include "tests/oracles/friction_residual.hpp"
#include "tests/oracles/prescribed_force.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace microslip {
namespace {

constexpr int most_newton_steps = 30, most_halvings = 10, most_products = 500;

using Field = std::vector<double>;

class Tang {
public:
  Tang(const FrictionProblem& problem, double tolerance, std::span<const double> start_px,
       std::span<const double> start_py)
      : problem_(problem), tolerance_(tolerance * bound_norm(problem)), rho_(1 / problem.slip_operator.diagonal()),
        wide_x_(problem.bound.size()), wide_y_(wide_x_), wide_sx_(wide_x_), wide_sy_(wide_x_) {
    for (std::size_t k = 0; k < problem.bound.size(); ++k)
      if (problem.bound[k] > 0) elements_.push_back(k);
    n_ = elements_.size();
    slips_.assign(n_, 0);
    p_.assign(2 * n_, 0.0);
    s_ = step_ = right_ = p_;
    for (std::size_t k = 0; k < n_ && !start_px.empty(); ++k) {
      p_[k] = start_px[elements_[k]];
      p_[n_ + k] = start_py[elements_[k]];
      slips_[k] = on_bound(p_[k], p_[n_ + k], bound(k));
    }
    move_beyond_bound();
  }

  /// Adds to `divisions`.
  FrictionSolution run(int most_divisions, int& divisions) {
    for (int k = 0; k < most_divisions; ++k) {
      ++divisions;
      solve_equations();
      if (!move_beyond_bound() && !move_wrong_slip()) break;
    }
    FrictionSolution solution;
    solution.traction.x.assign(problem_.bound.size(), 0.0);
    solution.traction.y = solution.traction.x;
    for (std::size_t k = 0; k < n_; ++k) {
      solution.traction.x[elements_[k]] = p_[k];
      solution.traction.y[elements_[k]] = p_[n_ + k];
    }
    solution.report.newton_steps = newton_steps_;
    return solution;
  }

private:
  double bound(std::size_t k) const { return problem_.bound[elements_[k]]; }

  /// out = D in.
  void growth(std::span<const double> in, std::span<double> out) {
    for (std::size_t k = 0; k < n_; ++k) {
      wide_x_[elements_[k]] = in[k];
      wide_y_[elements_[k]] = in[n_ + k];
    }
    problem_.slip_operator.apply(wide_x_, wide_y_, wide_sx_, wide_sy_);
    for (std::size_t k = 0; k < n_; ++k) {
      out[k] = wide_sx_[elements_[k]];
      out[n_ + k] = wide_sy_[elements_[k]];
    }
  }

  /// Slip of p, the equations' right sides in units of traction, and their norm: s in adhesion, in slip its part across
  /// the traction.
  double evaluate(const Field& p) {
    growth(p, s_);
    double sum = 0;
    for (std::size_t k = 0; k < n_; ++k) {
      s_[k] += problem_.cx[elements_[k]];
      s_[n_ + k] += problem_.cy[elements_[k]];
      right_[k] = -rho_ * s_[k];
      right_[n_ + k] = -rho_ * s_[n_ + k];
      if (slips_[k]) {
        const double nx = p[k] / bound(k), ny = p[n_ + k] / bound(k);
        const double across = nx * right_[n_ + k] - ny * right_[k];
        right_[k] = -across * ny;
        right_[n_ + k] = across * nx;
      }
      sum += right_[k] * right_[k] + right_[n_ + k] * right_[n_ + k];
    }
    return std::sqrt(sum);
  }

  /// The derivative of the equations. In slip p = g n turns: dp = q t, d(t.s) = t.D dp - (n.s) q/g.
  void derivative(std::span<const double> v, std::span<double> out) {
    growth(v, out);
    for (std::size_t k = 0; k < n_; ++k) {
      out[k] *= rho_;
      out[n_ + k] *= rho_;
      if (!slips_[k]) continue;
      const double g = bound(k), nx = p_[k] / g, ny = p_[n_ + k] / g;
      const double along = nx * v[k] + ny * v[n_ + k], q = nx * v[n_ + k] - ny * v[k];
      const double across = nx * out[n_ + k] - ny * out[k] - rho_ * (nx * s_[k] + ny * s_[n_ + k]) * q / g;
      out[k] = along * nx - across * ny;
      out[n_ + k] = along * ny + across * nx;
    }
  }

  /// p after a step of this length; tractions in slip turn.
  Field moved(double length) const {
    Field p(p_);
    for (std::size_t k = 0; k < n_; ++k) {
      if (!slips_[k]) {
        p[k] += length * step_[k];
        p[n_ + k] += length * step_[n_ + k];
        continue;
      }
      const double g = bound(k), nx = p_[k] / g, ny = p_[n_ + k] / g;
      const double angle = length * (nx * step_[n_ + k] - ny * step_[k]) / g;
      const double x = nx * std::cos(angle) - ny * std::sin(angle), y = ny * std::cos(angle) + nx * std::sin(angle);
      const double size = std::hypot(x, y); // 1 but for rounding, which would add up
      p[k] = g * (x / size);
      p[n_ + k] = g * (y / size);
    }
    return p;
  }

  /// Newton's method for the equations of this division.
  void solve_equations() {
    double norm = evaluate(p_);
    for (int k = 0; k < most_newton_steps && norm > 0.1 * tolerance_; ++k) {
      gmres_.solve([this](std::span<const double> v, std::span<double> out) { derivative(v, out); }, right_, step_,
                   1e-3, most_products);
      double length = 1;
      Field trial = moved(length);
      double trial_norm = evaluate(trial);
      for (int halving = 0; halving < most_halvings && !(trial_norm < norm); ++halving) {
        length /= 2;
        trial = moved(length);
        trial_norm = evaluate(trial);
      }
      p_ = std::move(trial);
      norm = trial_norm;
      ++newton_steps_;
    }
  }

  /// From adhesion to slip; the traction is put on the bound.
  bool move_beyond_bound() {
    bool any = false;
    for (std::size_t k = 0; k < n_; ++k) {
      const double size = std::hypot(p_[k], p_[n_ + k]);
      if (slips_[k] || size <= bound(k)) continue;
      slips_[k] = 1;
      p_[k] *= bound(k) / size;
      p_[n_ + k] *= bound(k) / size;
      any = true;
    }
    return any;
  }

  /// From slip to adhesion, where slip has the traction's direction.
  bool move_wrong_slip() {
    bool any = false;
    for (std::size_t k = 0; k < n_; ++k) {
      if (!slips_[k] || p_[k] * s_[k] + p_[n_ + k] * s_[n_ + k] <= 0) continue;
      slips_[k] = 0;
      any = true;
    }
    return any;
  }

  const FrictionProblem& problem_;
  double tolerance_, rho_;
  std::size_t n_ = 0;
  std::vector<std::size_t> elements_;
  std::vector<char> slips_;
  Field p_, s_, right_, step_; ///< x components, then y components, of the elements in contact
  Field wide_x_, wide_y_, wide_sx_, wide_sy_;
  Gmres<double> gmres_;
  int newton_steps_ = 0;
};

} // namespace

TangSolution solve_tang(const FrictionProblem& problem, const TangOptions& options, std::span<const double> start_px,
                        std::span<const double> start_py) {
  require_positive("tolerance", options.tolerance, "-");
  require_count("most_divisions", options.most_divisions, 1, 1000000);
  const long products_before = problem.slip_operator.products();
  TangSolution solution;
  int newton_steps = 0;
  static_cast<FrictionSolution&>(solution) = solve_prescribed_force(
      problem, options.tolerance,
      [&](const FrictionProblem& given, double wanted, std::span<const double> px, std::span<const double> py) {
        FrictionSolution s = Tang(given, wanted, px, py).run(options.most_divisions, solution.divisions);
        find_residual(given, s);
        s.report.status = s.report.residual <= wanted ? Status::ok : Status::not_converged;
        newton_steps += s.report.newton_steps;
        return s;
      },
      start_px, start_py);
  solution.report.newton_steps = newton_steps;
  solution.report.products = problem.slip_operator.products() - products_before;
  return solution;
}

} // namespace microslip
