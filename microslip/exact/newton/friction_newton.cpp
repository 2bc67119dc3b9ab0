#include "microslip/exact/newton/friction_newton.hpp"

#include "microslip/exact/newton/linearised_friction.hpp"
#include "microslip/exact/newton/semismooth_newton.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {
namespace {

using Field = std::vector<double>;

/// Of |F| over |g|: what rounding leaves of it on fine grids.
constexpr double least_goal = 1e-12;

/// Tractions of the elements in contact as one vector (x components, then y components, then the constants of c), and
/// what the equations make of it.
class Iterate {
public:
  using Real = double;

  Iterate(const FrictionProblem& problem, double rho)
      : problem_(problem), rho_(rho), wide_px_(problem.bound.size()), wide_py_(wide_px_), wide_sx_(wide_px_),
        wide_sy_(wide_px_) {
    for (std::size_t k = 0; k < problem.bound.size(); ++k)
      if (problem.bound[k] > 0) elements_.push_back(k);
    if (problem.force_x) forces_.push_back(0);
    if (problem.force_y) forces_.push_back(1);
    n_ = elements_.size();
    // With this unit a unit of the unknown constant weighs as much as a unit of all tractions together.
    unit_.fill(1 / (rho_ * std::sqrt(double(std::max<std::size_t>(n_, 1)))));
    g_.resize(n_);
    for (std::size_t k = 0; k < n_; ++k) {
      g_[k] = problem.bound[elements_[k]];
      scale_ += g_[k] * g_[k];
    }
    scale_ = std::sqrt(scale_);
    friction_ = LinearisedFriction<double>(n_);
    change_.resize(2 * n_);
  }

  std::size_t size() const { return 2 * n_ + forces_.size(); }
  std::size_t elements() const { return n_; }
  double scale() const { return scale_; }

  /// The slip's growth D dp + constants, for a vector of unknowns; both in the order x, y.
  void respond(std::span<const double> unknowns, std::span<double> growth) {
    for (std::size_t k = 0; k < n_; ++k) {
      wide_px_[elements_[k]] = unknowns[k];
      wide_py_[elements_[k]] = unknowns[n_ + k];
    }
    problem_.response.apply(wide_px_, wide_py_, wide_sx_, wide_sy_);
    if (problem_.centred) {
      problem_.centred->move(wide_sx_);
      problem_.centred->move(wide_sy_);
    }
    for (std::size_t k = 0; k < n_; ++k) {
      growth[k] = wide_sx_[elements_[k]];
      growth[n_ + k] = wide_sy_[elements_[k]];
    }
    for (std::size_t f = 0; f < forces_.size(); ++f)
      for (std::size_t k = 0; k < n_; ++k) growth[forces_[f] * n_ + k] += share(k) * unit_[f] * unknowns[2 * n_ + f];
  }

  void add_constants(std::span<double> slip) const {
    for (std::size_t k = 0; k < n_; ++k) {
      slip[k] += problem_.cx[elements_[k]];
      slip[n_ + k] += problem_.cy[elements_[k]];
    }
  }

  /// Chooses the unknown constants so that the mean slip vanishes, and adds them to the slip. Far from there everything
  /// slides, the tractions hardly depend on the constants, and a Newton step would send them to infinity.
  void choose_constants(std::span<double> unknowns, std::span<double> slip) const {
    for (std::size_t f = 0; f < forces_.size() && n_ > 0; ++f) {
      const std::span<double> s = slip.subspan(forces_[f] * n_, n_);
      double sum = 0, shares = 0;
      for (std::size_t k = 0; k < n_; ++k) sum += s[k], shares += share(k);
      const double constant = -sum / shares;
      for (std::size_t k = 0; k < n_; ++k) s[k] += share(k) * constant;
      unknowns[2 * n_ + f] = constant / unit_[f];
    }
  }

  /// F and, behind it, the equations of the forces; its norm.
  double evaluate(std::span<const double> unknowns, std::span<const double> slip, std::span<double> f) const {
    double norm2 = 0;
    for (std::size_t k = 0; k < n_; ++k) {
      const double zx = unknowns[k] - rho_ * slip[k], zy = unknowns[n_ + k] - rho_ * slip[n_ + k];
      const double size = std::hypot(zx, zy), factor = size > g_[k] ? g_[k] / size : 1;
      f[k] = unknowns[k] - factor * zx;
      f[n_ + k] = unknowns[n_ + k] - factor * zy;
      norm2 += f[k] * f[k] + f[n_ + k] * f[n_ + k];
    }
    for (std::size_t i = 0; i < forces_.size(); ++i) {
      const double target = forces_[i] == 0 ? *problem_.force_x : *problem_.force_y;
      double sum = -target / problem_.element_area;
      for (std::size_t k = 0; k < n_; ++k) sum += area(k) * unknowns[forces_[i] * n_ + k];
      f[2 * n_ + i] = n_ > 0 ? sum / std::sqrt(double(n_)) : 0;
      norm2 += f[2 * n_ + i] * f[2 * n_ + i];
    }
    return std::sqrt(norm2);
  }

  /// At the point of the derivative: how much the constants can move the tractions.
  double mean_alpha() const { return friction_.mean_alpha(); }

  /// Fixes adhesion, slip and directions for the derivative at this point.
  void linearise(std::span<const double> unknowns, std::span<const double> slip) {
    for (std::size_t k = 0; k < n_; ++k)
      friction_.set(k, unknowns[k] - rho_ * slip[k], unknowns[n_ + k] - rho_ * slip[n_ + k], g_[k]);
  }

  /// The derivative of F times a vector whose response is `growth`. `damping` keeps the constants' steps finite
  /// where everything slides: there the forces do not depend on them, and the matrix is singular.
  void derivative(std::span<const double> v, std::span<const double> growth, double damping,
                  std::span<double> out) const {
    friction_.derivative(v, growth, rho_, out);
    for (std::size_t i = 0; i < forces_.size(); ++i) {
      double sum = 0;
      for (std::size_t k = 0; k < n_; ++k) sum += area(k) * v[forces_[i] * n_ + k];
      out[2 * n_ + i] = sum / std::sqrt(double(n_)) - damping * v[2 * n_ + i];
    }
  }

  /// Unknowns and slip to begin with.
  void start(const FrictionNewton::Start& from, std::span<double> unknowns, std::span<double> slip) {
    std::fill(unknowns.begin(), unknowns.end(), 0.0);
    use_growth(from.growth);
    for (std::size_t k = 0; k < n_ && !from.px.empty(); ++k) {
      unknowns[k] = from.px[elements_[k]];
      unknowns[n_ + k] = from.py[elements_[k]];
    }
    for (std::size_t f = 0; f < forces_.size() && from.constants; ++f)
      unknowns[2 * n_ + f] = (forces_[f] == 0 ? from.constants->x : from.constants->y) / unit_[f];
    respond(unknowns, slip);
    add_constants(slip);
    if (!from.constants) choose_constants(unknowns, slip);
  }

  /// The linear systems' right preconditioner: turns a vector that GMRES works with into unknowns.
  void precondition(std::span<double> unknowns) {
    if (problem_.preconditioner) follow_waves(unknowns);
    follow_constants(unknowns);
  }

  void copy_to(FrictionSolution& s, std::span<const double> unknowns, std::span<const double> slip) const {
    for (auto* field : {&s.px, &s.py, &s.sx, &s.sy}) field->assign(problem_.bound.size(), 0.0);
    s.sliding.assign(problem_.bound.size(), 0);
    for (std::size_t k = 0; k < n_; ++k) {
      // P_g(p - rho s), which differs from p by the residual and obeys the bound to rounding.
      const double zx = unknowns[k] - rho_ * slip[k], zy = unknowns[n_ + k] - rho_ * slip[n_ + k];
      const double size = std::hypot(zx, zy), factor = size > g_[k] ? g_[k] / size : 1;
      s.px[elements_[k]] = factor * zx;
      s.py[elements_[k]] = factor * zy;
      s.sx[elements_[k]] = slip[k];
      s.sy[elements_[k]] = slip[n_ + k];
      s.sliding[elements_[k]] = size > g_[k];
    }
    for (std::size_t i = 0; i < forces_.size(); ++i)
      (forces_[i] == 0 ? s.constant_x : s.constant_y) = unit_[i] * unknowns[2 * n_ + i];
  }

private:
  void follow_waves(std::span<double> unknowns) {
    friction_.free_part(unknowns, change_);
    for (std::size_t k = 0; k < n_; ++k) {
      wide_px_[elements_[k]] = change_[k];
      wide_py_[elements_[k]] = change_[n_ + k];
    }
    if (problem_.centred) {
      problem_.centred->nearly_undo(wide_px_);
      problem_.centred->nearly_undo(wide_py_);
    }
    problem_.preconditioner->apply(wide_px_, wide_py_, wide_sx_, wide_sy_);
    for (std::size_t k = 0; k < n_; ++k) {
      change_[k] = wide_sx_[elements_[k]] + wide_px_[elements_[k]] - change_[k];
      change_[n_ + k] = wide_sy_[elements_[k]] + wide_py_[elements_[k]] - change_[n_ + k];
    }
    friction_.free_part(change_, change_);
    for (std::size_t k = 0; k < 2 * n_; ++k) unknowns[k] += change_[k];
  }

  /// Replaces the unknown constants by what the equations of the forces want: with the tractions that grow with the
  /// constants, the tractions then have these forces, and their slip hardly changes.
  void follow_constants(std::span<double> unknowns) const {
    if (!growth_is_known_) return;
    const auto lack = [&](std::size_t i) {
      return unknowns[2 * n_ + i] - mean_force(i, unknowns.first(n_), unknowns.subspan(n_, n_));
    };
    const auto& m = force_growth_;
    std::array<double, 2> constants = {};
    if (forces_.size() == 1) {
      constants[0] = lack(0) / m[0][0];
    } else {
      const double x = lack(0), y = lack(1), determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
      constants = {(m[1][1] * x - m[0][1] * y) / determinant, (m[0][0] * y - m[1][0] * x) / determinant};
    }
    for (std::size_t f = 0; f < forces_.size(); ++f) {
      unknowns[2 * n_ + f] = constants[f];
      const double constant = unit_[f] * constants[f];
      for (std::size_t k = 0; k < n_; ++k) {
        unknowns[k] += constant * growth_[f].px[elements_[k]];
        unknowns[n_ + k] += constant * growth_[f].py[elements_[k]];
      }
    }
  }

  /// What tractions contribute to the equation of force i.
  double mean_force(std::size_t i, std::span<const double> px, std::span<const double> py) const {
    const std::span<const double> along = forces_[i] == 0 ? px : py;
    double sum = 0;
    for (std::size_t k = 0; k < n_; ++k) sum += area(k) * along[k];
    return sum / std::sqrt(double(n_));
  }

  /// Also makes a unit of each constant one that changes its force's equation by one.
  void use_growth(const std::array<FrictionNewton::Tractions, 2>& growth) {
    constexpr double least_determinant = 0.1; // else one constant does what the other does
    growth_is_known_ = !forces_.empty() && n_ > 0;
    for (std::size_t f = 0; f < forces_.size() && growth_is_known_; ++f) {
      growth_[f] = growth[forces_[f]];
      growth_is_known_ = !growth_[f].px.empty();
    }
    if (!growth_is_known_) return;
    Field px(n_), py(n_);
    std::array<double, 2> unit = {};
    for (std::size_t f = 0; f < forces_.size(); ++f) {
      for (std::size_t k = 0; k < n_; ++k) px[k] = growth_[f].px[elements_[k]], py[k] = growth_[f].py[elements_[k]];
      const double own = mean_force(f, px, py);
      unit[f] = 1 / std::abs(own);
      for (std::size_t i = 0; i < forces_.size(); ++i) force_growth_[i][f] = unit[f] * mean_force(i, px, py);
      growth_is_known_ = growth_is_known_ && own != 0;
    }
    const auto& m = force_growth_;
    if (forces_.size() == 2 && !(std::abs(m[0][0] * m[1][1] - m[0][1] * m[1][0]) > least_determinant))
      growth_is_known_ = false;
    if (growth_is_known_) unit_ = unit;
  }

  double share(std::size_t k) const {
    return problem_.constant_share.empty() ? 1 : problem_.constant_share[elements_[k]];
  }

  double area(std::size_t k) const { return problem_.area_share.empty() ? 1 : problem_.area_share[elements_[k]]; }

  const FrictionProblem& problem_;
  double rho_, scale_ = 0;
  std::array<double, 2> unit_ = {}; ///< of the unknown constants
  std::size_t n_ = 0;
  std::vector<std::size_t> elements_;
  std::vector<std::size_t> forces_;                        ///< directions in which the force is given
  std::array<FrictionNewton::Tractions, 2> growth_ = {};   ///< with the constant of each of them
  bool growth_is_known_ = false;                           ///< for all of them
  std::array<std::array<double, 2>, 2> force_growth_ = {}; ///< of each force's equation with each constant
  Field g_;
  LinearisedFriction<double> friction_{0};
  Field change_; ///< of the tractions
  Field wide_px_, wide_py_, wide_sx_, wide_sy_;
};

} // namespace

FrictionSolution FrictionNewton::solve(const FrictionProblem& problem, const Options& options, const Start& start) {
  const long products_before = problem.response.products();
  Iterate at(problem, 1 / problem.response.diagonal());
  Field x(at.size()), slip(2 * at.elements()), f(at.size());
  double goal = options.tolerance * at.scale();
  if (options.before) {
    at.start({.px = options.before->px, .py = options.before->py}, x, slip);
    const double change = at.evaluate(x, slip, f);
    goal = std::min(goal, std::max(options.tolerance * change, least_goal * at.scale()));
  }
  FrictionSolution s;
  at.start(start, x, slip);
  const NewtonLimits limits{goal, options.most_steps, options.most_inner, options.progress};
  NewtonState state;
  take_newton_steps(at, gmres_, limits, x, slip, state);
  s.newton_steps = state.steps;
  if (!(state.norm <= goal) && !start.px.empty() && !state.stopped) { // a start may be worse than none
    Field other_x(x.size()), other_slip(slip.size());
    NewtonState other;
    at.start({}, other_x, other_slip);
    take_newton_steps(at, gmres_, limits, other_x, other_slip, other);
    s.newton_steps += other.steps;
    if (other.norm < state.norm || std::isnan(state.norm))
      state.norm = other.norm, x = std::move(other_x), slip = std::move(other_slip);
  }
  at.copy_to(s, x, slip);
  s.residual = at.scale() > 0 ? state.norm / at.scale() : 0;
  s.products = problem.response.products() - products_before;
  s.status = state.norm <= goal ? Status::ok : Status::not_converged;
  return s;
}

} // namespace microslip
