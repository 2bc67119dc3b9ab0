#include "microslip/exact/newton/friction_equations.hpp"

#include "microslip/exact/newton/disk_projection.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {

using Field = std::vector<double>;

FrictionEquations::FrictionEquations(const FrictionProblem& problem)
    : problem_(problem), rho_(1 / problem.slip_operator.scale()) {
  for (std::size_t k = 0; k < problem.bound.size(); ++k)
    if (problem.bound[k] > 0) elements_.push_back(k);
  if (problem.force_x) forces_.push_back(0);
  if (problem.force_y) forces_.push_back(1);
  n_ = elements_.size();
  for (Field* field : {&wide_sx_, &wide_sy_}) field->resize(problem.bound.size());
  if (!is_whole())
    for (Field* field : {&wide_px_, &wide_py_}) field->resize(problem.bound.size());
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
  if (!problem.slip_dependent) return;
  rho_ = std::max(1 / problem.slip_operator.diagonal(), problem.slip_dependent->least_rho(problem.pressure));
  size_change_.resize(n_);
  for (auto* field : {&wide_size_, &wide_bound_, &wide_own_}) field->resize(problem.bound.size());
}

/// |z| of all elements.
void FrictionEquations::find_sizes(std::span<const double> unknowns, std::span<const double> slip) {
  for (std::size_t k = 0; k < n_; ++k)
    wide_size_[elements_[k]] = std::hypot(unknowns[k] - rho_ * slip[k], unknowns[n_ + k] - rho_ * slip[n_ + k]);
}

/// Finds the bounds that depend on the slip.
void FrictionEquations::find_bounds(std::span<const double> unknowns, std::span<const double> slip) {
  if (!problem_.slip_dependent) return;
  find_sizes(unknowns, slip);
  problem_.slip_dependent->project(wide_size_, problem_.pressure, rho_, wide_bound_);
  for (std::size_t k = 0; k < n_; ++k) g_[k] = wide_bound_[elements_[k]];
}

void FrictionEquations::start(const FrictionStart& from, std::span<double> unknowns, std::span<double> slip) {
  std::fill(unknowns.begin(), unknowns.end(), 0.0);
  use_derivatives(from.by_constants);
  for (std::size_t k = 0; k < n_ && !from.px.empty(); ++k) {
    unknowns[k] = from.px[elements_[k]];
    unknowns[n_ + k] = from.py[elements_[k]];
  }
  for (std::size_t f = 0; f < forces_.size() && from.constants; ++f)
    unknowns[2 * n_ + f] = (forces_[f] == 0 ? from.constants->x : from.constants->y) / unit_[f];
  if (from.px.empty() && !from.constants)
    std::fill(slip.begin(), slip.end(), 0.0);
  else
    respond(unknowns, slip);
  add_constants(slip);
  if (!from.constants) choose_constants(unknowns, slip);
}

void FrictionEquations::respond(std::span<const double> unknowns, std::span<double> slip_change, Apply apply) {
  const std::span<double> sx = slip_change.first(n_), sy = slip_change.subspan(n_, n_);
  const auto [px, py] = spread(unknowns);
  if (is_whole()) {
    (problem_.slip_operator.*apply)(px, py, sx, sy);
  } else {
    (problem_.slip_operator.*apply)(px, py, wide_sx_, wide_sy_);
    for (std::size_t k = 0; k < n_; ++k) sx[k] = wide_sx_[elements_[k]], sy[k] = wide_sy_[elements_[k]];
  }
  for (std::size_t f = 0; f < forces_.size(); ++f)
    for (std::size_t k = 0; k < n_; ++k) slip_change[forces_[f] * n_ + k] += share(k) * unit_[f] * unknowns[2 * n_ + f];
}

double FrictionEquations::evaluate(std::span<const double> unknowns, std::span<const double> slip,
                                   std::span<double> f) {
  find_bounds(unknowns, slip);
  return evaluate(rho_, unknowns, slip, f);
}

/// Evaluates F with the bounds of the last point.
double FrictionEquations::evaluate(double rho, std::span<const double> unknowns, std::span<const double> slip,
                                   std::span<double> f) const {
  double norm2 = 0;
  for (std::size_t k = 0; k < n_; ++k) {
    const double zx = unknowns[k] - rho * slip[k], zy = unknowns[n_ + k] - rho * slip[n_ + k];
    const double scale = project_on_disk(zx, zy, g_[k]).scale;
    f[k] = unknowns[k] - scale * zx;
    f[n_ + k] = unknowns[n_ + k] - scale * zy;
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

void FrictionEquations::linearise(std::span<const double> unknowns, std::span<const double> slip) {
  if (problem_.slip_dependent) {
    find_sizes(unknowns, slip);
    problem_.slip_dependent->linearise(wide_size_, problem_.pressure, rho_, wide_bound_, wide_own_);
  }
  for (std::size_t k = 0; k < n_; ++k) {
    const double zx = unknowns[k] - rho_ * slip[k], zy = unknowns[n_ + k] - rho_ * slip[n_ + k];
    const std::size_t e = elements_[k];
    if (problem_.slip_dependent)
      friction_.set(k, zx, zy, wide_bound_[e], wide_own_[e]);
    else
      friction_.set(k, zx, zy, g_[k]);
  }
  if (!derivatives_given_) estimate_derivatives();
}

void FrictionEquations::derivative(std::span<const double> v, std::span<const double> slip_change, double damping,
                                   std::span<double> out) {
  friction_.derivative(v, slip_change, rho_, out);
  if (problem_.slip_dependent) {
    friction_.change_of_size(v, slip_change, rho_, size_change_);
    for (std::size_t k = 0; k < n_; ++k) wide_size_[elements_[k]] = size_change_[k];
    if (problem_.slip_dependent->carry(wide_size_, {}, wide_bound_)) {
      for (std::size_t k = 0; k < n_; ++k) size_change_[k] = wide_bound_[elements_[k]];
      friction_.subtract_along(size_change_, out);
    }
  }
  for (std::size_t i = 0; i < forces_.size(); ++i)
    out[2 * n_ + i] = mean_force(i, v.first(n_), v.subspan(n_, n_)) - damping * v[2 * n_ + i];
}

void FrictionEquations::precondition(std::span<double> unknowns) {
  precondition_tractions(unknowns);
  satisfy_forces(unknowns);
}

FrictionSolution FrictionEquations::solution(std::span<const double> unknowns, std::span<const double> slip) {
  find_bounds(unknowns, slip);
  FrictionSolution s(problem_.bound.size());
  for (std::size_t k = 0; k < n_; ++k) {
    const double zx = unknowns[k] - rho_ * slip[k], zy = unknowns[n_ + k] - rho_ * slip[n_ + k];
    const DiskProjection on_disk = project_on_disk(zx, zy, g_[k]);
    s.traction.x[elements_[k]] = on_disk.scale * zx;
    s.traction.y[elements_[k]] = on_disk.scale * zy;
    s.slip.x[elements_[k]] = slip[k];
    s.slip.y[elements_[k]] = slip[n_ + k];
    s.sliding[elements_[k]] = on_disk.outside;
  }
  for (std::size_t i = 0; i < forces_.size(); ++i)
    (forces_[i] == 0 ? s.constants.x : s.constants.y) = unit_[i] * unknowns[2 * n_ + i];
  Field f(size());
  s.report.residual = scale_ > 0 ? evaluate(strictness() * rho_, unknowns, slip, f) / scale_ : 0;
  return s;
}

/// Tractions of the elements in contact as fields of all elements, copied only where others are among these.
TractionsView FrictionEquations::spread(std::span<const double> tractions) {
  if (is_whole()) return {tractions.first(n_), tractions.subspan(n_, n_)};
  for (std::size_t k = 0; k < n_; ++k) {
    wide_px_[elements_[k]] = tractions[k];
    wide_py_[elements_[k]] = tractions[n_ + k];
  }
  return {wide_px_, wide_py_};
}

void FrictionEquations::add_constants(std::span<double> slip) const {
  for (std::size_t k = 0; k < n_; ++k) {
    slip[k] += problem_.cx[elements_[k]];
    slip[n_ + k] += problem_.cy[elements_[k]];
  }
}

/// Chooses the unknown constants so that the mean slip vanishes, and adds them to the slip. Far from there everything
/// slides, the tractions hardly depend on the constants, and a Newton step would send them to infinity.
void FrictionEquations::choose_constants(std::span<double> unknowns, std::span<double> slip) const {
  for (std::size_t f = 0; f < forces_.size() && n_ > 0; ++f) {
    const std::span<double> s = slip.subspan(forces_[f] * n_, n_);
    double sum = 0, shares = 0;
    for (std::size_t k = 0; k < n_; ++k) sum += s[k], shares += share(k);
    const double constant = -sum / shares;
    for (std::size_t k = 0; k < n_; ++k) s[k] += share(k) * constant;
    unknowns[2 * n_ + f] = constant / unit_[f];
  }
}

/// Applies the operator's preconditioner, for the part of the tractions that slip can change.
void FrictionEquations::precondition_tractions(std::span<double> unknowns) {
  friction_.free_part(unknowns, change_);
  if (!apply_preconditioner()) return;
  friction_.free_part(change_, change_);
  for (std::size_t k = 0; k < 2 * n_; ++k) unknowns[k] += change_[k];
}

/// change_ = (M^-1/(rho scale) - 1) change_, so that M is near rho D; false if there is no preconditioner.
bool FrictionEquations::apply_preconditioner() {
  const auto [px, py] = spread(change_);
  if (!problem_.slip_operator.precondition(px, py, wide_sx_, wide_sy_)) return false;
  const double share = 1 / (rho_ * problem_.slip_operator.scale());
  for (std::size_t k = 0; k < n_; ++k) {
    change_[k] = share * wide_sx_[elements_[k]] - change_[k];
    change_[n_ + k] = share * wide_sy_[elements_[k]] - change_[n_ + k];
  }
  return true;
}

/// Replaces the unknown constants by what the equations of the forces require (E37): with the tractions' derivatives
/// with respect to them, the tractions then have these forces, and their slip hardly changes.
void FrictionEquations::satisfy_forces(std::span<double> unknowns) const {
  if (!derivatives_known_) return;
  const auto lack = [&](std::size_t i) {
    return unknowns[2 * n_ + i] - mean_force(i, unknowns.first(n_), unknowns.subspan(n_, n_));
  };
  const auto& m = force_slope_;
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
      unknowns[k] += constant * by_constants_[f][k];
      unknowns[n_ + k] += constant * by_constants_[f][n_ + k];
    }
  }
}

/// Contribution of tractions to the equation of force i (E20).
double FrictionEquations::mean_force(std::size_t i, std::span<const double> px, std::span<const double> py) const {
  const std::span<const double> along = forces_[i] == 0 ? px : py;
  double sum = 0;
  for (std::size_t k = 0; k < n_; ++k) sum += area(k) * along[k];
  return sum / std::sqrt(double(n_));
}

/// Takes the derivatives and makes a unit of each constant one that changes its force's equation by one.
void FrictionEquations::use_derivatives(const std::array<TractionsView, 2>& by_constants) {
  derivatives_given_ = !forces_.empty() && n_ > 0 &&
                       std::all_of(forces_.begin(), forces_.end(), [&](auto f) { return !by_constants[f].px.empty(); });
  derivatives_known_ = false;
  if (!derivatives_given_) return;
  for (std::size_t f = 0; f < forces_.size(); ++f) {
    const TractionsView& by = by_constants[forces_[f]];
    by_constants_[f].resize(2 * n_);
    for (std::size_t k = 0; k < n_; ++k) {
      by_constants_[f][k] = by.px[elements_[k]];
      by_constants_[f][n_ + k] = by.py[elements_[k]];
    }
  }
  const auto unit = unit_;
  unit_ = {1, 1};
  find_force_slopes();
  for (std::size_t f = 0; f < forces_.size(); ++f) unit_[f] = 1 / std::abs(force_slope_[f][f]);
  derivatives_known_ = find_force_slopes();
  if (!derivatives_known_) unit_ = unit;
}

/// Estimates by the operator's preconditioner: the slip of the tractions' change is to undo that of the constant.
void FrictionEquations::estimate_derivatives() {
  derivatives_known_ = false;
  for (std::size_t f = 0; f < forces_.size() && n_ > 0; ++f) {
    Field& by = by_constants_[f];
    by.assign(2 * n_, 0.0);
    for (std::size_t k = 0; k < n_; ++k) by[forces_[f] * n_ + k] = -rho_ * share(k);
    friction_.free_part(by, by);
    change_ = by;
    if (!apply_preconditioner()) return;
    for (std::size_t k = 0; k < 2 * n_; ++k) by[k] += change_[k];
    friction_.free_part(by, by);
  }
  derivatives_known_ = !forces_.empty() && n_ > 0 && find_force_slopes();
}

/// Finds slopes of the forces' equations by the constants. False if a force hardly depends on its constant, or one
/// constant does what the other does.
bool FrictionEquations::find_force_slopes() {
  constexpr double least_slope = 0.02; // of that where all adheres; near full sliding the forces hardly depend on it
  constexpr double least_determinant = 0.1; // over the product of the diagonal entries
  auto& m = force_slope_;
  for (std::size_t f = 0; f < forces_.size(); ++f) {
    const std::span<const double> by = by_constants_[f];
    for (std::size_t i = 0; i < forces_.size(); ++i) m[i][f] = unit_[f] * mean_force(i, by.first(n_), by.subspan(n_));
  }
  for (std::size_t f = 0; f < forces_.size(); ++f)
    if (!(std::abs(m[f][f]) > least_slope)) return false;
  if (forces_.size() == 1) return true;
  const double product = m[0][0] * m[1][1];
  return std::abs(product - m[0][1] * m[1][0]) > least_determinant * std::abs(product);
}

} // namespace microslip
