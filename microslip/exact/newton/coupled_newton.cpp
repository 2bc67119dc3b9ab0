#include "microslip/exact/newton/coupled_newton.hpp"

#include "microslip/exact/newton/semismooth_newton.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace microslip {
namespace {

using Field = std::vector<double>;

/// Unknowns are px, py (in units of the mean friction), p_n of all elements, and then what forces determine: delta and
/// the constants of cx, cy. What the equations make of them.
class Iterate {
public:
  using Real = double;

  explicit Iterate(const CoupledFrictionProblem& problem, std::span<const double> pressure)
      : problem_(problem), n_(problem.gap.size()), rho_(1 / problem.response.slip_diagonal()),
        normal_rho_(1 / problem.response.normal_diagonal()), slip_(n_), alpha_(n_), normal_x_(n_), normal_y_(n_),
        in_contact_(n_), under_pressure_(n_), px_(n_), py_(n_) {
    double sum = 0, bound = 0;
    for (std::size_t k = 0; k < n_; ++k) {
      sum += pressure[k];
      bound += problem.friction[k] * pressure[k];
      scale_ += pressure[k] * pressure[k];
    }
    scale_ = std::sqrt(scale_);
    unit_ = std::clamp(sum > 0 ? bound / sum : 1, least_unit, 1.0);
    if (problem.load.given == NormalLoad::Given::force) delta_ = 3 * n_;
    std::size_t next = 3 * n_ + (delta_ ? 1 : 0);
    if (problem.force_x) force_[0] = next++;
    if (problem.force_y) force_[1] = next++;
    size_ = next;
    const double share = 1 / std::sqrt(std::max(1.0, static_cast<double>(elements_of(pressure))));
    delta_unit_ = share / normal_rho_;
    constant_unit_ = share * unit_ / rho_;
    row_unit_ = share;
  }

  std::size_t size() const { return size_; }
  std::size_t responses() const { return 3 * n_; }
  double scale() const { return scale_; }

  void start(const CoupledNewton::Start& from, std::span<double> unknowns, std::span<double> response) {
    std::fill(unknowns.begin(), unknowns.end(), 0.0);
    for (std::size_t k = 0; k < n_; ++k) {
      if (!from.px.empty()) unknowns[k] = from.px[k] / unit_, unknowns[n_ + k] = from.py[k] / unit_;
      unknowns[2 * n_ + k] = from.pressure[k];
    }
    find_response(unknowns, response);
    choose_constants(unknowns, response);
  }

  /// Slip and deformed gap.
  void find_response(std::span<const double> unknowns, std::span<double> response) {
    respond(unknowns, response);
    for (std::size_t k = 0; k < n_; ++k) {
      response[k] += problem_.cx[k];
      response[n_ + k] += problem_.cy[k];
      response[2 * n_ + k] += problem_.gap[k] - (delta_ ? 0 : problem_.load.value);
    }
  }

  /// Slip and deformed gap as they change with the unknowns.
  void respond(std::span<const double> unknowns, std::span<double> response) {
    for (std::size_t k = 0; k < n_; ++k) px_[k] = unit_ * unknowns[k], py_[k] = unit_ * unknowns[n_ + k];
    const std::array out = {response.subspan(0, n_), response.subspan(n_, n_), response.subspan(2 * n_, n_)};
    problem_.response.apply({px_, py_, unknowns.subspan(2 * n_, n_)}, out);
    for (std::size_t c = 0; c < 2; ++c)
      if (force_[c])
        for (double& s : out[c]) s += constant_unit_ * unknowns[*force_[c]];
    if (delta_)
      for (double& e : out[2]) e -= delta_unit_ * unknowns[*delta_];
  }

  /// The linear systems have no preconditioner.
  void precondition(std::span<double>) const {}

  /// The residual F; its norm.
  double evaluate(std::span<const double> v, std::span<const double> response, std::span<double> f) const {
    double norm2 = 0;
    for (std::size_t k = 0; k < n_; ++k) {
      const Point at = point(v, response, k);
      const double factor = at.size > at.bound ? at.bound / at.size : 1;
      f[k] = v[k] - factor * at.zx;
      f[n_ + k] = v[n_ + k] - factor * at.zy;
      f[2 * n_ + k] = v[2 * n_ + k] - std::max(0.0, at.z_normal);
    }
    double forces[3] = {};
    for (std::size_t k = 0; k < n_; ++k)
      for (std::size_t c = 0; c < 3; ++c) forces[c] += v[c * n_ + k];
    if (delta_) f[*delta_] = row_unit_ * (forces[2] - problem_.load.value / problem_.element_area);
    if (force_[0]) f[*force_[0]] = row_unit_ * (forces[0] - *problem_.force_x / unit_ * forces[2]);
    if (force_[1]) f[*force_[1]] = row_unit_ * (forces[1] - *problem_.force_y / unit_ * forces[2]);
    for (const double value : f) norm2 += value * value;
    return std::sqrt(norm2);
  }

  /// Fixes contact, adhesion, slip and directions for the derivative at this point.
  void linearise(std::span<const double> v, std::span<const double> response) {
    for (std::size_t k = 0; k < n_; ++k) {
      const Point at = point(v, response, k);
      in_contact_[k] = at.z_normal > 0;
      under_pressure_[k] = v[2 * n_ + k] > 0;
      slip_[k] = at.size > at.bound || !(at.bound > 0);
      normal_x_[k] = at.size > 0 ? at.zx / at.size : 1;
      normal_y_[k] = at.size > 0 ? at.zy / at.size : 0;
      alpha_[k] = at.size > 0 ? at.bound / at.size : 0;
    }
  }

  /// How much the constants can move the tractions: 1 where all adheres.
  double mean_alpha() const {
    double sum = 0, count = 0;
    for (std::size_t k = 0; k < n_; ++k)
      if (in_contact_[k]) sum += slip_[k] ? alpha_[k] : 1, ++count;
    return count > 0 ? sum / count : 1;
  }

  /// The derivative of F times v, whose response is `response`.
  void derivative(std::span<const double> v, std::span<const double> response, double damping,
                  std::span<double> out) const {
    const double rho = rho_ / unit_;
    double forces[3] = {};
    for (std::size_t k = 0; k < n_; ++k) {
      const double vx = v[k], vy = v[n_ + k], vn = v[2 * n_ + k];
      forces[0] += vx, forces[1] += vy, forces[2] += vn;
      out[2 * n_ + k] = in_contact_[k] ? normal_rho_ * response[2 * n_ + k] : vn;
      const double gx = rho * response[k], gy = rho * response[n_ + k];
      if (!slip_[k]) {
        out[k] = gx;
        out[n_ + k] = gy;
        continue;
      }
      const double nx = normal_x_[k], ny = normal_y_[k], a = alpha_[k];
      const double growth = under_pressure_[k] ? problem_.friction[k] / unit_ * vn : 0;
      const double along = nx * vx + ny * vy - growth;
      const double across = (1 - a) * (nx * vy - ny * vx) + a * (nx * gy - ny * gx);
      out[k] = along * nx - across * ny;
      out[n_ + k] = along * ny + across * nx;
    }
    if (delta_) out[*delta_] = row_unit_ * forces[2];
    for (std::size_t c = 0; c < 2; ++c) {
      const auto& force = c == 0 ? problem_.force_x : problem_.force_y;
      if (force_[c]) out[*force_[c]] = row_unit_ * (forces[c] - *force / unit_ * forces[2]) - damping * v[*force_[c]];
    }
  }

  CoupledFrictionSolution solution(std::span<const double> v, std::span<const double> response) const {
    CoupledFrictionSolution out;
    FrictionSolution& s = out.friction;
    for (auto* field : {&s.px, &s.py, &s.sx, &s.sy, &out.pressure}) field->assign(n_, 0.0);
    s.sliding.assign(n_, 0);
    out.approach = delta_ ? delta_unit_ * v[*delta_] : problem_.load.value;
    for (std::size_t k = 0; k < n_; ++k) {
      const Point at = point(v, response, k);
      if (!(at.z_normal > 0)) continue;
      out.pressure[k] = at.z_normal;
      const double bound = problem_.friction[k] / unit_ * at.z_normal;
      const double factor = at.size > bound ? bound / at.size : 1;
      s.px[k] = unit_ * factor * at.zx;
      s.py[k] = unit_ * factor * at.zy;
      s.sx[k] = response[k];
      s.sy[k] = response[n_ + k];
      s.sliding[k] = at.size > bound;
    }
    if (force_[0]) s.constant_x = constant_unit_ * v[*force_[0]];
    if (force_[1]) s.constant_y = constant_unit_ * v[*force_[1]];
    return out;
  }

private:
  static constexpr double least_unit = 1e-12; // of the mean friction: there may be none

  struct Point {
    double zx, zy, size, bound, z_normal;
  };

  /// What is projected, in the unknowns' units.
  Point point(std::span<const double> v, std::span<const double> response, std::size_t k) const {
    const double rho = rho_ / unit_, zx = v[k] - rho * response[k], zy = v[n_ + k] - rho * response[n_ + k];
    const double p = v[2 * n_ + k], bound = problem_.friction[k] / unit_ * std::max(0.0, p);
    return {zx, zy, std::hypot(zx, zy), bound, p - normal_rho_ * response[2 * n_ + k]};
  }

  static std::size_t elements_of(std::span<const double> pressure) {
    return static_cast<std::size_t>(std::count_if(pressure.begin(), pressure.end(), [](double p) { return p > 0; }));
  }

  /// Such that slip and deformed gap vanish on the average over the pressure. Far from there everything slides or
  /// nothing touches, and a Newton step would send the constants to infinity.
  void choose_constants(std::span<double> unknowns, std::span<double> response) const {
    const std::optional<std::size_t> unknown[] = {force_[0], force_[1], delta_};
    const double unit[] = {constant_unit_, constant_unit_, -delta_unit_};
    for (std::size_t c = 0; c < 3; ++c) {
      if (!unknown[c]) continue;
      double sum = 0, weight = 0;
      for (std::size_t k = 0; k < n_; ++k) {
        const double p = unknowns[2 * n_ + k];
        if (!(p > 0)) continue;
        sum += p * response[c * n_ + k];
        weight += p;
      }
      const double constant = weight > 0 ? -sum / weight : 0;
      for (std::size_t k = 0; k < n_; ++k) response[c * n_ + k] += constant;
      unknowns[*unknown[c]] = constant / unit[c];
    }
  }

  const CoupledFrictionProblem& problem_;
  std::size_t n_, size_ = 0;
  double rho_, normal_rho_, scale_ = 0;
  double unit_ = 1; ///< of tractions: the mean friction, so that they weigh as much as the pressure
  double delta_unit_ = 1, constant_unit_ = 1, row_unit_ = 1;
  std::optional<std::size_t> delta_;    ///< where the unknown approach is
  std::optional<std::size_t> force_[2]; ///< and the unknown constants
  std::vector<char> slip_;
  Field alpha_, normal_x_, normal_y_;
  std::vector<char> in_contact_, under_pressure_;
  Field px_, py_;
};

} // namespace

CoupledFrictionSolution CoupledNewton::solve(const CoupledFrictionProblem& problem, const Options& options,
                                             const Start& start) {
  const long products_before = problem.response.products();
  Iterate at(problem, start.pressure);
  Field x(at.size()), response(at.responses()), f(at.size());
  at.start(start, x, response);
  const NewtonLimits limits{options.tolerance * at.scale(), options.most_steps, options.most_inner, options.progress};
  NewtonState state;
  for (bool done = false; !done;) {
    take_newton_steps(at, gmres_, limits, x, response, state);
    if (!(state.norm <= limits.goal)) break;
    at.find_response(x, response); // what rounding has done to it on the way
    done = at.evaluate(x, response, f) <= limits.goal;
  }
  CoupledFrictionSolution s = at.solution(x, response);
  s.friction.residual = at.scale() > 0 ? state.norm / at.scale() : 0;
  s.friction.newton_steps = state.steps;
  s.friction.products = problem.response.products() - products_before;
  s.friction.status = state.norm <= limits.goal ? Status::ok : Status::not_converged;
  return s;
}

} // namespace microslip
