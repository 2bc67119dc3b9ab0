#include "microslip/exact/newton/coupled_equations.hpp"

#include "microslip/exact/newton/disk_projection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace microslip {
namespace {

using Field = std::vector<double>;

constexpr double least_unit = 1e-12; // of the mean friction: there may be none

double sum_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

std::size_t elements_of(std::span<const double> pressure) {
  return static_cast<std::size_t>(std::count_if(pressure.begin(), pressure.end(), [](double p) { return p > 0; }));
}

} // namespace

/// Point that is projected, in the unknowns' units, and the pressure's.
struct CoupledEquations::Point {
  double zx, zy, z_normal;
};

CoupledEquations::CoupledEquations(const CoupledFrictionProblem& problem, std::span<const double> pressure,
                                   bool preconditioned)
    : problem_(problem), n_(problem.gap.size()), preconditioned_(preconditioned),
      rho_(1 / (preconditioned ? problem.coupled_operator.slip_scale() : problem.coupled_operator.slip_diagonal())),
      normal_rho_(
          1 / (preconditioned ? problem.coupled_operator.normal_scale() : problem.coupled_operator.normal_diagonal())),
      friction_(n_), in_contact_(n_), under_pressure_(n_), bound_(n_), bound_change_(n_), pressure_change_(n_),
      change_(2 * n_), px_(n_), py_(n_) {
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
  if (!problem.slip_dependent) return;
  rho_ = std::max(1 / problem.coupled_operator.slip_diagonal(), problem.slip_dependent->least_rho(pressure));
  for (auto* field : {&sizes_, &pressure_, &q_, &own_}) field->resize(n_);
}

void CoupledEquations::start(const CoupledFrictionStart& from, std::span<double> unknowns, std::span<double> response) {
  std::fill(unknowns.begin(), unknowns.end(), 0.0);
  for (std::size_t k = 0; k < n_; ++k) {
    if (!from.px.empty()) unknowns[k] = from.px[k] / unit_, unknowns[n_ + k] = from.py[k] / unit_;
    unknowns[2 * n_ + k] = from.pressure[k];
  }
  find_response(unknowns, response);
  choose_constants(unknowns, response);
}

void CoupledEquations::take(const CoupledFrictionSolution& solution, std::span<double> unknowns,
                            std::span<double> response) {
  const FrictionSolution& s = solution.friction;
  for (std::size_t k = 0; k < n_; ++k) {
    unknowns[k] = s.traction.x[k] / unit_;
    unknowns[n_ + k] = s.traction.y[k] / unit_;
    unknowns[2 * n_ + k] = solution.pressure[k];
  }
  if (delta_) unknowns[*delta_] = solution.approach / delta_unit_;
  if (force_[0]) unknowns[*force_[0]] = s.constants.x / constant_unit_;
  if (force_[1]) unknowns[*force_[1]] = s.constants.y / constant_unit_;
  find_response(unknowns, response);
}

void CoupledEquations::find_response(std::span<const double> unknowns, std::span<double> response) {
  respond(unknowns, response);
  for (std::size_t k = 0; k < n_; ++k) {
    response[k] += problem_.cx[k];
    response[n_ + k] += problem_.cy[k];
    response[2 * n_ + k] += problem_.gap[k] - (delta_ ? 0 : problem_.load.value);
  }
}

void CoupledEquations::respond(std::span<const double> unknowns, std::span<double> response) {
  for (std::size_t k = 0; k < n_; ++k) px_[k] = unit_ * unknowns[k], py_[k] = unit_ * unknowns[n_ + k];
  const std::array out = {response.subspan(0, n_), response.subspan(n_, n_), response.subspan(2 * n_, n_)};
  problem_.coupled_operator.apply({px_, py_, unknowns.subspan(2 * n_, n_)}, out);
  for (std::size_t c = 0; c < 2; ++c)
    if (force_[c])
      for (double& s : out[c]) s += constant_unit_ * unknowns[*force_[c]];
  if (delta_)
    for (double& e : out[2]) e -= delta_unit_ * unknowns[*delta_];
}

double CoupledEquations::evaluate(std::span<const double> v, std::span<const double> response, std::span<double> f) {
  find_bounds(v, response);
  double norm2 = 0;
  for (std::size_t k = 0; k < n_; ++k) {
    const Point at = point(v, response, k);
    const double factor = project_on_disk(at.zx, at.zy, bound_[k]).scale;
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

void CoupledEquations::linearise(std::span<const double> v, std::span<const double> response) {
  find_bounds(v, response);
  if (problem_.slip_dependent) problem_.slip_dependent->linearise(sizes_, pressure_, rho_, q_, own_);
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < n_; ++k) {
    const Point at = point(v, response, k);
    in_contact_[k] = at.z_normal > 0;
    under_pressure_[k] = v[2 * n_ + k] > 0;
    if (problem_.slip_dependent)
      friction_.set(k, at.zx, at.zy, bound_[k], own_[k]);
    else
      friction_.set(k, at.zx, at.zy, bound_[k]);
    const double size = std::hypot(at.zx, at.zy);
    if (in_contact_[k]) sum += size > bound_[k] ? bound_[k] / size : 1, ++count;
  }
  mean_alpha_ = count > 0 ? sum / count : 1;
  if (preconditioned_) find_responses_to_constants();
}

void CoupledEquations::derivative(std::span<const double> v, std::span<const double> response, double damping,
                                  std::span<double> out) {
  const std::span<const double> tractions = v.first(2 * n_), slip = response.first(2 * n_);
  friction_.derivative(tractions, slip, rho_ / unit_, out);
  find_bound_changes(v, response);
  friction_.subtract_along(bound_change_, out);
  double forces[3] = {};
  for (std::size_t k = 0; k < n_; ++k) {
    forces[0] += v[k], forces[1] += v[n_ + k], forces[2] += v[2 * n_ + k];
    out[2 * n_ + k] = in_contact_[k] ? normal_rho_ * response[2 * n_ + k] : v[2 * n_ + k];
  }
  if (delta_) out[*delta_] = row_unit_ * forces[2];
  for (std::size_t c = 0; c < 2; ++c) {
    const auto& force = c == 0 ? problem_.force_x : problem_.force_y;
    if (force_[c]) out[*force_[c]] = row_unit_ * (forces[c] - *force / unit_ * forces[2]) - damping * v[*force_[c]];
  }
}

void CoupledEquations::add_load(double change, std::span<double> f) const {
  if (delta_) f[*delta_] += row_unit_ * change / problem_.element_area;
}

std::array<Field, 3> CoupledEquations::fields_of(std::span<const double> unknowns) const {
  std::array<Field, 3> out;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto part = unknowns.subspan(c * n_, n_);
    out[c].assign(part.begin(), part.end());
    if (c < 2)
      for (double& p : out[c]) p *= unit_;
  }
  return out;
}

void CoupledEquations::precondition(std::span<double> unknowns) {
  if (!preconditioned_) return;
  precondition_pressure(unknowns.subspan(2 * n_, n_));
  satisfy_load(unknowns);
  precondition_tractions(unknowns.first(2 * n_));
  follow_pressure(unknowns);
  satisfy_forces(unknowns);
}

void CoupledEquations::precondition_pressure(std::span<double> pressure) {
  for (std::size_t k = 0; k < n_; ++k) px_[k] = in_contact_[k] ? pressure[k] : 0;
  problem_.coupled_operator.precondition_pressure(px_, py_);
  for (std::size_t k = 0; k < n_; ++k)
    if (in_contact_[k]) pressure[k] = py_[k];
}

/// Preconditions as FrictionEquations does.
void CoupledEquations::precondition_tractions(std::span<double> tractions) {
  friction_.free_part(tractions, change_);
  problem_.coupled_operator.precondition_tractions(std::span(change_).first(n_), std::span(change_).subspan(n_), px_,
                                                   py_);
  const double share = 1 / (rho_ * problem_.coupled_operator.slip_scale());
  for (std::size_t k = 0; k < n_; ++k) {
    change_[k] = share * px_[k] - change_[k];
    change_[n_ + k] = share * py_[k] - change_[n_ + k];
  }
  friction_.free_part(change_, change_);
  for (std::size_t k = 0; k < 2 * n_; ++k) tractions[k] += change_[k];
}

/// Tractions that slide grow with the pressure.
void CoupledEquations::follow_pressure(std::span<double> unknowns) {
  for (std::size_t k = 0; k < n_; ++k) {
    const double grown = under_pressure_[k] ? problem_.friction[k] / unit_ * unknowns[2 * n_ + k] : 0;
    bound_change_[k] = -(1 - friction_.beta(k)) * grown;
  }
  friction_.subtract_along(bound_change_, unknowns.first(2 * n_));
}

void CoupledEquations::find_responses_to_constants() {
  if (delta_) {
    by_delta_.assign(n_, normal_rho_ * delta_unit_);
    for (std::size_t k = 0; k < n_; ++k)
      if (!in_contact_[k]) by_delta_[k] = 0;
    precondition_pressure(by_delta_);
  }
  for (std::size_t c = 0; c < 2; ++c) {
    if (!force_[c]) continue;
    Field& by = by_constant_[c];
    by.assign(2 * n_, 0.0);
    std::fill_n(by.begin() + static_cast<std::ptrdiff_t>(c * n_), n_, -rho_ / unit_ * constant_unit_);
    friction_.free_part(by, by);
    precondition_tractions(by);
    friction_.free_part(by, by);
  }
}

/// Chooses the approach that the load requires.
void CoupledEquations::satisfy_load(std::span<double> unknowns) const {
  if (!delta_) return;
  const std::span<double> pressure = unknowns.subspan(2 * n_, n_);
  const double slope = sum_of(by_delta_);
  if (slope == 0) return;
  const double delta = (unknowns[*delta_] / row_unit_ - sum_of(pressure)) / slope;
  unknowns[*delta_] = delta;
  for (std::size_t k = 0; k < n_; ++k) pressure[k] += delta * by_delta_[k];
}

/// Chooses the constants that the forces require, one after the other: a constant hardly changes the other force.
void CoupledEquations::satisfy_forces(std::span<double> unknowns) const {
  constexpr double least = 0.02; // of what a constant does where all adheres: near full sliding it does next to nothing
  const auto contacts = std::count(in_contact_.begin(), in_contact_.end(), 1);
  const double normal = sum_of(unknowns.subspan(2 * n_, n_));
  for (std::size_t c = 0; c < 2; ++c) {
    if (!force_[c]) continue;
    const double slope = sum_of(std::span(by_constant_[c]).subspan(c * n_, n_));
    if (!(std::abs(slope) > least * rho_ / unit_ * constant_unit_ * static_cast<double>(contacts))) continue;
    const double wanted = *(c == 0 ? problem_.force_x : problem_.force_y) / unit_ * normal;
    const double lack = unknowns[*force_[c]] / row_unit_ + wanted - sum_of(unknowns.subspan(c * n_, n_));
    const double constant = lack / slope;
    unknowns[*force_[c]] = constant;
    for (std::size_t k = 0; k < 2 * n_; ++k) unknowns[k] += constant * by_constant_[c][k];
  }
}

double CoupledEquations::strictness() const {
  const CoupledOperator& o = problem_.coupled_operator;
  return std::max({1.0, 1 / (rho_ * o.slip_diagonal()), 1 / (normal_rho_ * o.normal_diagonal())});
}

CoupledFrictionSolution CoupledEquations::solution(std::span<const double> v, std::span<const double> response) {
  find_bounds(v, response);
  CoupledFrictionSolution out{FrictionSolution(n_), Field(n_)};
  FrictionSolution& s = out.friction;
  out.approach = delta_ ? delta_unit_ * v[*delta_] : problem_.load.value;
  for (std::size_t k = 0; k < n_; ++k) {
    const Point at = point(v, response, k);
    if (!(at.z_normal > 0)) continue;
    out.pressure[k] = at.z_normal;
    const double bound = problem_.slip_dependent ? bound_[k] : problem_.friction[k] / unit_ * at.z_normal;
    const DiskProjection on_disk = project_on_disk(at.zx, at.zy, bound);
    s.traction.x[k] = unit_ * on_disk.scale * at.zx;
    s.traction.y[k] = unit_ * on_disk.scale * at.zy;
    s.slip.x[k] = response[k];
    s.slip.y[k] = response[n_ + k];
    s.sliding[k] = on_disk.outside;
  }
  if (force_[0]) s.constants.x = constant_unit_ * v[*force_[0]];
  if (force_[1]) s.constants.y = constant_unit_ * v[*force_[1]];
  return out;
}

CoupledEquations::Point CoupledEquations::point(std::span<const double> v, std::span<const double> response,
                                                std::size_t k) const {
  const double rho = rho_ / unit_, zx = v[k] - rho * response[k], zy = v[n_ + k] - rho * response[n_ + k];
  return {zx, zy, v[2 * n_ + k] - normal_rho_ * response[2 * n_ + k]};
}

/// |z| and p_n of all elements.
void CoupledEquations::find_sizes(std::span<const double> v, std::span<const double> response) {
  for (std::size_t k = 0; k < n_; ++k) {
    sizes_[k] = std::hypot(unit_ * v[k] - rho_ * response[k], unit_ * v[n_ + k] - rho_ * response[n_ + k]);
    pressure_[k] = std::max(0.0, v[2 * n_ + k]);
  }
}

void CoupledEquations::find_bounds(std::span<const double> v, std::span<const double> response) {
  if (problem_.slip_dependent) {
    find_sizes(v, response);
    problem_.slip_dependent->project(sizes_, pressure_, rho_, q_);
  }
  for (std::size_t k = 0; k < n_; ++k) {
    const double bound = problem_.slip_dependent ? q_[k] : problem_.friction[k] * std::max(0.0, v[2 * n_ + k]);
    bound_[k] = bound / unit_;
  }
}

/// z| its bound changes.|The changes of an element's bound by anything but its |z|.|z| its bound changes.
void CoupledEquations::find_bound_changes(std::span<const double> v, std::span<const double> response) {
  for (std::size_t k = 0; k < n_; ++k) pressure_change_[k] = under_pressure_[k] ? v[2 * n_ + k] : 0;
  if (problem_.slip_dependent) {
    friction_.change_of_size(v.first(2 * n_), response.first(2 * n_), rho_ / unit_, sizes_);
    for (double& size : sizes_) size *= unit_;
    problem_.slip_dependent->carry(sizes_, pressure_change_, q_);
  }
  for (std::size_t k = 0; k < n_; ++k) {
    const double change =
        problem_.slip_dependent ? q_[k] : (1 - friction_.beta(k)) * problem_.friction[k] * pressure_change_[k];
    bound_change_[k] = change / unit_;
  }
}

/// Such that slip and deformed gap vanish on the average over the pressure. Far from there everything slides or nothing
/// touches, and a Newton step would send the constants to infinity.
void CoupledEquations::choose_constants(std::span<double> unknowns, std::span<double> response) const {
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

} // namespace microslip
