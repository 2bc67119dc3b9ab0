#include "microslip/exact/elliptic_contact.hpp"

#include "microslip/elasticity/hertz.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/fastsim2_start.hpp"

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
  out.residual = nan;
  return out;
}

bool is_valid(const EllipticContact& c) {
  const auto positive = [](double value) { return value > 0 && std::isfinite(value); };
  return positive(c.a) && positive(c.b) && positive(c.shear_modulus) && positive(c.normal_force) &&
         positive(c.rolling_speed) && c.poisson_ratio >= 0 && c.poisson_ratio <= 0.5 &&
         c.friction.kind() == FrictionLaw::Kind::coulomb && std::isfinite(c.creepage.longitudinal) &&
         std::isfinite(c.creepage.lateral) && std::isfinite(c.creepage.spin);
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
  tangential_ = std::make_unique<TangentialProblem>(material, grid_);
  a_ = contact.a;
  b_ = contact.b;
  material_ = material;
}

ContactFields EllipticContactSolver::fields_of(const TangentialSolution& s) const {
  ContactFields f(grid_.mx, grid_.my);
  f.forces = s.forces;
  f.frictional_power = s.frictional_power;
  const bool forward = options_.direction == RollingDirection::forward;
  for (int j = 0; j < grid_.my; ++j)
    for (int i = 0; i < grid_.mx; ++i) {
      const int column = forward ? grid_.mx - 1 - i : i;
      const std::size_t to = static_cast<std::size_t>(j) * grid_.mx + i, from = to - i + column;
      f.x[to] = grid_.x(column);
      f.y[to] = grid_.y(j);
      f.area[to] = grid_.element_area();
      f.bound[to] = s.bound[from];
      f.px[to] = s.tractions.px[from];
      f.py[to] = s.tractions.py[from];
      f.sx[to] = s.sx[from];
      f.sy[to] = s.sy[from];
      f.state[to] = s.state[from];
    }
  return f;
}

ExactContact EllipticContactSolver::solve(const EllipticContact& contact) {
  if (!is_valid(contact)) return invalid();
  prepare(contact);
  std::vector<double> bound(grid_.count());
  const double scale = contact.friction.static_coefficient() * contact.normal_force;
  for (std::size_t k = 0; k < bound.size(); ++k) bound[k] = scale * normal_.pressure[k];
  TangentialInput input;
  input.creepage = contact.creepage;
  input.direction = options_.direction;
  input.rolling_speed = contact.rolling_speed;
  input.tolerance = options_.tolerance;
  const TangentialState start = start_from_fastsim2(contact, grid_, bound, options_.direction);
  input.start = &start;
  const TangentialSolution s = tangential_->solve(bound, input);

  ExactContact out;
  out.fields = fields_of(s);
  if (normal_.status != Status::ok) out.fields.forces.status = normal_.status;
  out.approach = normal_.approach * contact.normal_force;
  out.peak_pressure = normal_.peak_pressure * contact.normal_force;
  out.power_by_creepage = s.power_by_creepage;
  out.elastic_energy = s.elastic_energy;
  out.residual = s.residual;
  out.newton_steps = s.newton_steps;
  out.products = s.products;
  return out;
}

} // namespace microslip
