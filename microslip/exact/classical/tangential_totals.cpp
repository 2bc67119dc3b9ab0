#include "microslip/exact/classical/tangential_totals.hpp"

#include "microslip/contact/totals.hpp"

#include <cmath>

namespace microslip {
namespace {

bool is_finite(const TangentialSolution& s) {
  const ContactForces& f = s.forces;
  return std::isfinite(f.fx) && std::isfinite(f.fy) && std::isfinite(f.mz) && std::isfinite(s.elastic_energy) &&
         std::isfinite(s.frictional_power) && std::isfinite(s.power_by_creepage) &&
         std::isfinite(s.creepage.longitudinal) && std::isfinite(s.creepage.lateral) && std::isfinite(s.residual);
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

void find_totals(const ElementGrid& grid, const TangentialInput& input, FrictionSolution s, TangentialSolution& out) {
  const std::size_t n = grid.count();
  const double area = grid.element_area();
  out.residual = s.residual;
  out.newton_steps = s.newton_steps;
  out.products = s.products;
  out.state.assign(n, CellState::exterior);
  out.slip_direction.assign(n, 0.0);
  Totals totals;
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * grid.mx + i;
      if (!(out.bound[k] > 0)) continue;
      const bool slides = s.sliding[k];
      out.state[k] = slides ? CellState::slip : CellState::adhesion;
      if (slides)
        out.slip_direction[k] = std::atan2(-s.py[k], -s.px[k]); // known even where slip is as small as its residual
      add(totals, {.x = grid.x(i),
                   .y = grid.y(j),
                   .area = area,
                   .slides = slides,
                   .traction = {s.px[k], s.py[k]},
                   .slip = {s.sx[k], s.sy[k]},
                   .displacement = {out.ux[k], out.uy[k]}});
    }
  const double speed = input.motion == ContactMotion::shift ? 1 : input.rolling_speed;
  ContactForces& f = out.forces;
  f = {totals.fx, totals.fy, totals.mz, totals.adhesion_area, totals.slip_area, s.status};
  out.elastic_energy = totals.elastic_energy;
  out.peak_traction = totals.peak_traction;
  out.frictional_power = speed * totals.frictional_power;
  out.power_by_creepage = power_by_creepage(totals, out.creepage, speed);
  out.tractions = {std::move(s.px), std::move(s.py)};
  out.sx = std::move(s.sx);
  out.sy = std::move(s.sy);
  if (f.status != Status::no_solution && !is_finite(out)) f.status = Status::invalid_input;
}

} // namespace microslip
