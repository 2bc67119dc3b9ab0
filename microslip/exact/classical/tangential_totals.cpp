#include "microslip/exact/classical/tangential_totals.hpp"

#include "microslip/contact/totals.hpp"

#include <cmath>

namespace microslip {
namespace {

std::vector<double> scaled(std::vector<double> field, double factor) {
  for (double& value : field) value *= factor;
  return field;
}

/// The growth of a displacement per metre rolled along the axis, at element n of `count` that lie `stride` apart in the
/// field: half the difference of both neighbours, at a grid's end that of one.
double growth(const std::vector<double>& u, std::size_t k, int n, int count, std::size_t stride, double spacing) {
  const bool first = n == 0, last = n == count - 1;
  if (first && last) return 0;
  const double behind = first ? u[k] : u[k - stride], ahead = last ? u[k] : u[k + stride];
  return (behind - ahead) / ((first || last ? 1 : 2) * spacing);
}

/// -sum of p.s dx dy in steady rolling with the slip at the elements' centres, (E23a) without V [N].
double work_on_centred_slip(const ContactSolution& s, const TangentialInput& motion) {
  const ElementGrid& grid = s.elements.grid;
  const double side = motion.direction == RollingDirection::forward ? 1 : -1;
  const Vec2 direction = {side * std::cos(motion.heading), side * std::sin(motion.heading)};
  TangentialInput at_centres = motion;
  at_centres.spin_offset = 0;
  std::vector<double> sx(grid.count()), sy(grid.count());
  find_rigid_slip(grid, at_centres, s.creepage, 0, sx, sy);
  const auto add_growth = [&](const std::vector<double>& u, std::size_t k, int i, int j, double& slip) {
    slip += direction.x * growth(u, k, i, grid.mx, 1, grid.dx);
    if (direction.y != 0) slip += direction.y * growth(u, k, j, grid.my, static_cast<std::size_t>(grid.mx), grid.dy);
  };
  const SurfaceFields& f = s.fields;
  double work = 0;
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * grid.mx + i;
      if (f.state[k] == CellState::exterior) continue;
      add_growth(f.displacement.x, k, i, j, sx[k]);
      add_growth(f.displacement.y, k, i, j, sy[k]);
      work -= (f.traction.x[k] * sx[k] + f.traction.y[k] * sy[k]) * grid.element_area();
    }
  return work;
}

} // namespace

double signed_step(const TangentialInput& input, const ElementGrid& grid) {
  const double length = input.step > 0 ? input.step : grid.dx;
  return input.direction == RollingDirection::forward ? length : -length;
}

Vec2 way_of(const TangentialInput& input, double step) {
  if (input.heading == 0) return {step, 0};
  return {step * std::cos(input.heading), step * std::sin(input.heading)};
}

void find_rigid_slip(const ElementGrid& grid, const TangentialInput& input, const Creepage& creepage, double step,
                     std::span<double> cx, std::span<double> cy) {
  const Vec2 ahead = way_of(input, input.motion == ContactMotion::shift ? 0 : input.spin_offset * step);
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * grid.mx + i;
      cx[k] = creepage.longitudinal - creepage.spin * (grid.y(j) + ahead.y);
      cy[k] = creepage.lateral + creepage.spin * (grid.x(i) + ahead.x);
      if (!input.extra_x.empty()) cx[k] += input.extra_x[k];
      if (!input.extra_y.empty()) cy[k] += input.extra_y[k];
    }
}

double speed_of(const TangentialInput& input) {
  return input.motion == ContactMotion::shift ? 1 : input.rolling_speed;
}

void finish(const TangentialInput& input, FrictionSolution s, ContactSolution& out) {
  SurfaceFields& f = out.fields;
  f.traction = std::move(s.traction);
  f.slip = std::move(s.slip);
  f.state.assign(f.bound.size(), CellState::exterior);
  for (std::size_t k = 0; k < f.bound.size(); ++k)
    if (f.bound[k] > 0) f.state[k] = s.sliding[k] ? CellState::slip : CellState::adhesion;
  out.totals = find_totals(out.elements, f, out.creepage, speed_of(input));
  out.report = s.report;
  const bool has_numbers =
      is_finite(out.totals) && std::isfinite(s.report.residual + out.creepage.longitudinal + out.creepage.lateral);
  if (s.report.status != Status::no_solution && !has_numbers) out.report.status = Status::invalid_input;
}

void add_normal(ContactSolution& s, const NormalSolution& normal, double load) {
  s.fields.pressure = scaled(normal.pressure, load);
  s.fields.gap = scaled(normal.gap, load);
  s.approach = normal.approach * load;
  add(s.totals, s.elements, s.fields.pressure);
}

void find_centred_power(const TangentialInput& input, ContactSolution& s) {
  if (s.motion == ContactMotion::steady)
    s.totals.frictional_power = input.rolling_speed * work_on_centred_slip(s, input);
}

} // namespace microslip
