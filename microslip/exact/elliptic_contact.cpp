#include "microslip/exact/elliptic_contact.hpp"

#include "microslip/elasticity/hertz.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/fastsim2_start.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace microslip {
namespace {

constexpr int margin = 2; // the discrete contact may be a little larger than the ellipse
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

ExactContact invalid() {
  ExactContact out;
  out.fields.forces = {nan, nan, nan, nan, nan, Status::invalid_input};
  out.fields.frictional_power = out.approach = out.peak_pressure = out.power_by_creepage = out.elastic_energy = nan;
  out.creepage = {nan, nan, nan};
  out.peak_traction = out.residual = nan;
  return out;
}

bool is_valid(const EllipticContact& c) {
  const auto positive = [](double value) { return value > 0 && std::isfinite(value); };
  return positive(c.a) && positive(c.b) && positive(c.shear_modulus) && positive(c.normal_force) &&
         positive(c.rolling_speed) && c.poisson_ratio >= 0 && c.poisson_ratio <= 0.5 &&
         c.friction.kind() == FrictionLaw::Kind::coulomb && std::isfinite(c.creepage.longitudinal) &&
         std::isfinite(c.creepage.lateral) && std::isfinite(c.creepage.spin);
}

bool is_valid(const ExactMotion& m) {
  return std::isfinite(m.force_x.value_or(0)) && std::isfinite(m.force_y.value_or(0)) && m.step >= 0 &&
         std::isfinite(m.step) && m.steps >= 1 && m.steps <= 1000000;
}

} // namespace

EllipticContactSolver::EllipticContactSolver(const ExactOptions& options) : options_(options) {
  require_count("mx", options.mx, 1, 4000);
  require_count("my", options.my, 1, 4000);
  require_between("tolerance", options.tolerance, "-", 1e-14, 1);
}

/// Everything that depends on ellipse and material only. Pressure is proportional to the load at a given ellipse, so
/// the normal problem is solved once, for 1 N.
void EllipticContactSolver::prepare(const EllipticContact& contact) {
  const CombinedMaterial material = {contact.shear_modulus, contact.poisson_ratio, 0};
  const bool same = tangential_ && a_ == contact.a && b_ == contact.b &&
                    material_.shear_modulus == material.shear_modulus &&
                    material_.poisson_ratio == material.poisson_ratio;
  if (same) return;
  tangential_.reset();
  grid_ = ElementGrid::across_ellipse(contact.a, contact.b, options_.mx, options_.my, margin);
  const GapCurvatures gap = hertz_from_ellipse(contact.a, contact.b, material, 1).gap;
  std::vector<double> h(grid_.count());
  for (int j = 0; j < grid_.my; ++j)
    for (int i = 0; i < grid_.mx; ++i)
      h[static_cast<std::size_t>(j) * grid_.mx + i] = gap.x * grid_.x(i) * grid_.x(i) + gap.y * grid_.y(j) * grid_.y(j);
  normal_ = NormalProblem(material, grid_).solve(h, {NormalLoad::Given::force, 1});
  gap_ = std::move(h);
  for (std::size_t k = 0; k < gap_.size(); ++k) gap_[k] += normal_.displacement[k] - normal_.approach;
  tangential_ = std::make_unique<TangentialProblem>(material, grid_);
  a_ = contact.a;
  b_ = contact.b;
  material_ = material;
}

/// Solves the tangential problem; transient rolling step by step.
TangentialSolution EllipticContactSolver::roll(const EllipticContact& contact, const ExactMotion& motion,
                                               std::span<const double> bound, const Progress& progress,
                                               std::vector<ExactStep>& history) {
  TangentialInput input;
  input.motion = motion.kind;
  input.creepage = contact.creepage;
  input.force_x = motion.force_x;
  input.force_y = motion.force_y;
  input.step = motion.step;
  input.direction = options_.direction;
  input.rolling_speed = contact.rolling_speed;
  input.tolerance = options_.tolerance;
  TangentialState state;
  const bool creepages_given = !motion.force_x && !motion.force_y;
  if (motion.kind == ContactMotion::steady && creepages_given) {
    state = start_from_fastsim2(contact, grid_, bound, options_.direction);
    input.start = &state;
  }
  TangentialSolution s = tangential_->solve(bound, input);
  if (motion.kind != ContactMotion::transient) return s;
  const auto remember = [&] {
    history.push_back({s.creepage, s.forces, s.residual, s.newton_steps, s.products});
    return !progress || progress(double(history.size()) / motion.steps);
  };
  input.previous = &state;
  while (remember() && static_cast<int>(history.size()) < motion.steps) {
    state = std::move(s.tractions);
    s = tangential_->solve(bound, input);
  }
  return s;
}

/// Results as they are passed on: rows from the leading to the trailing edge.
ExactContact EllipticContactSolver::results(TangentialSolution s, double normal_force) const {
  const auto in_rows = [&](auto field) {
    if (options_.direction == RollingDirection::forward)
      for (auto row = field.begin(); row != field.end(); row += grid_.mx) std::reverse(row, row + grid_.mx);
    return field;
  };
  ExactContact out;
  ContactFields& f = out.fields = ContactFields(grid_.mx, grid_.my);
  out.pressure = normal_.pressure;
  out.gap = gap_;
  for (std::size_t k = 0; k < grid_.count(); ++k) {
    f.x[k] = grid_.x(static_cast<int>(k % grid_.mx));
    f.y[k] = grid_.y(static_cast<int>(k / grid_.mx));
    f.area[k] = grid_.element_area();
    out.pressure[k] *= normal_force;
    out.gap[k] *= normal_force;
  }
  for (auto* field : {&f.x, &out.pressure, &out.gap}) *field = in_rows(std::move(*field));
  f.bound = in_rows(std::move(s.bound));
  f.px = in_rows(std::move(s.tractions.px));
  f.py = in_rows(std::move(s.tractions.py));
  f.sx = in_rows(std::move(s.sx));
  f.sy = in_rows(std::move(s.sy));
  f.state = in_rows(std::move(s.state));
  out.ux = in_rows(std::move(s.ux));
  out.uy = in_rows(std::move(s.uy));
  f.forces = s.forces;
  f.frictional_power = s.frictional_power;
  out.creepage = s.creepage;
  out.approach = normal_.approach * normal_force;
  out.peak_pressure = normal_.peak_pressure * normal_force;
  out.peak_traction = s.peak_traction;
  out.power_by_creepage = s.power_by_creepage;
  out.elastic_energy = s.elastic_energy;
  out.residual = s.residual;
  out.newton_steps = s.newton_steps;
  out.products = s.products;
  return out;
}

ExactContact EllipticContactSolver::solve(const EllipticContact& contact, const ExactMotion& motion,
                                          const Progress& progress) {
  if (!is_valid(contact) || !is_valid(motion)) return invalid();
  try {
    prepare(contact);
  } catch (const Error&) { // numbers that overflow on the way
    return invalid();
  }
  std::vector<double> bound = normal_.pressure;
  for (double& g : bound) g *= contact.friction.static_coefficient() * contact.normal_force;
  std::vector<ExactStep> history;
  ExactContact out = results(roll(contact, motion, bound, progress, history), contact.normal_force);
  out.history = std::move(history);
  if (normal_.status != Status::ok) out.fields.forces.status = normal_.status;
  for (std::size_t i = 0; i + 1 < out.history.size(); ++i) {
    out.newton_steps += out.history[i].newton_steps;
    out.products += out.history[i].products;
  }
  return out;
}

} // namespace microslip
