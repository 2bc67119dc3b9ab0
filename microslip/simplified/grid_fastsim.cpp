#include "microslip/simplified/grid_fastsim.hpp"

#include "microslip/contact/totals.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace microslip {
namespace {

std::vector<ElementRun> find_runs(const ElementGrid& grid, const std::vector<double>& pressure) {
  std::vector<ElementRun> runs;
  for (int j = 0; j < grid.my; ++j) {
    bool goes_on = false;
    for (int i = 0; i < grid.mx; ++i) {
      const bool touches = pressure[static_cast<std::size_t>(j) * grid.mx + i] > 0;
      if (touches && !goes_on) runs.push_back({j, i, 0});
      if (touches) ++runs.back().count;
      goes_on = touches;
    }
  }
  return runs;
}

void check_size(const char* name, std::size_t size, const ElementGrid& grid) {
  if (size != grid.count())
    throw Error(std::string(name) + ": must have mx times my = " + std::to_string(grid.count()) + " values");
}

void check_rolling(const ElementGrid& grid, const Flexibilities& l, const GridRolling& rolling) {
  require_positive("flexibilities.longitudinal", l.longitudinal, "m/Pa");
  require_positive("flexibilities.lateral", l.lateral, "m/Pa");
  require_positive("flexibilities.spin", l.spin, "m/Pa");
  if (!rolling.extra_x.empty()) check_size("extra_x", rolling.extra_x.size(), grid);
  if (!rolling.extra_y.empty()) check_size("extra_y", rolling.extra_y.size(), grid);
  if (rolling.before == nullptr) return;
  require_positive("step", rolling.step, "m");
  if (!rolling.before->x.empty()) check_size("before.x", rolling.before->x.size(), grid);
  if (rolling.before->y.size() != rolling.before->x.size())
    throw Error("before.y: must have as many values as before.x");
}

/// Rigid slip of the elements.
class RigidSlip {
public:
  RigidSlip(const ElementGrid& grid, const Flexibilities& l, const GridRolling& rolling)
      : grid_(grid), l_(l), rolling_(rolling) {}

  Vec2 at(int i, int j, std::size_t k) const {
    const Creepage& c = rolling_.creepage;
    const double x = grid_.x(i) + rolling_.ahead.x - rolling_.spin_centre.x;
    const double y = grid_.y(j) + rolling_.ahead.y - rolling_.spin_centre.y;
    Vec2 w = {c.longitudinal, c.lateral};
    if (rolling_.spin_in_x) w.x -= c.spin * y * l_.longitudinal / l_.spin;
    if (rolling_.spin_in_y) w.y += c.spin * x * l_.lateral / l_.spin;
    if (!rolling_.extra_x.empty()) w.x += rolling_.extra_x[k];
    if (!rolling_.extra_y.empty()) w.y += rolling_.extra_y[k];
    return w;
  }

private:
  const ElementGrid& grid_;
  const Flexibilities& l_;
  const GridRolling& rolling_;
};

} // namespace

GridFastsim::GridFastsim(const ElementGrid& grid, std::span<const double> pressure)
    : grid_(grid), pressure_(pressure.begin(), pressure.end()) {
  check(grid);
  check_size("pressure", pressure.size(), grid);
  runs_ = find_runs(grid_, pressure_);
}

void GridFastsim::check_friction(std::span<const double> friction) const {
  if (friction.size() != 1 && friction.size() != static_cast<std::size_t>(grid_.my))
    throw Error("friction: must have one value, or one for each of the " + std::to_string(grid_.my) + " rows");
}

double GridFastsim::friction_of(int row, std::span<const double> friction) const {
  return friction.size() == 1 ? friction[0] : friction[row];
}

double GridFastsim::contact_area() const {
  double area = 0;
  for (const double p : pressure_)
    if (p > 0) area += grid_.element_area();
  return area;
}

double GridFastsim::capacity(std::span<const double> friction) const {
  check_friction(friction);
  double capacity = 0;
  for (std::size_t k = 0; k < pressure_.size(); ++k)
    capacity += friction_of(static_cast<int>(k / grid_.mx), friction) * pressure_[k] * grid_.element_area();
  return capacity;
}

Vec2 GridFastsim::equivalent_axes() const {
  int count = 0, first = grid_.mx, last = -1;
  for (const ElementRun& run : runs_) {
    count += run.count;
    first = std::min(first, run.first);
    last = std::max(last, run.first + run.count - 1);
  }
  if (runs_.empty()) return {};
  const int columns = last - first + 1, rows = runs_.back().row - runs_.front().row + 1;
  const double size = std::sqrt(count * grid_.element_area() / std::numbers::pi);
  const double ratio = std::sqrt(columns * grid_.dx / (rows * grid_.dy));
  return {size * ratio, size / ratio};
}

/// Solution without tractions, with the bound of the elements in contact.
GridSolution GridFastsim::empty_solution(std::span<const double> friction) const {
  check_friction(friction);
  GridSolution s;
  for (auto* field : {&s.bound, &s.px, &s.py, &s.ux, &s.uy, &s.sx, &s.sy}) field->assign(grid_.count(), 0);
  s.state.assign(grid_.count(), CellState::exterior);
  for (const ElementRun& run : runs_)
    for (int n = 0; n < run.count; ++n) {
      const std::size_t k = static_cast<std::size_t>(run.row) * grid_.mx + run.first + n;
      s.bound[k] = friction_of(run.row, friction) * pressure_[k];
      s.state[k] = CellState::adhesion;
    }
  return s;
}

GridSolution GridFastsim::solve(const Flexibilities& l, std::span<const double> friction,
                                const GridRolling& rolling) const {
  check_rolling(grid_, l, rolling);
  GridSolution s = empty_solution(friction);
  const RigidSlip rigid_slip(grid_, l, rolling);
  const bool forward = rolling.direction == RollingDirection::forward;
  const double length = rolling.before != nullptr ? rolling.step : grid_.dx;
  for (const ElementRun& run : runs_) {
    Vec2 u;
    for (int n = 0; n < run.count; ++n) {
      const int i = run.first + (forward ? run.count - 1 - n : n);
      const std::size_t k = static_cast<std::size_t>(run.row) * grid_.mx + i;
      if (rolling.before != nullptr)
        u = rolling.before->x.empty() ? Vec2{} : Vec2{rolling.before->x[k], rolling.before->y[k]};
      const Vec2 w = rigid_slip.at(i, run.row, k);
      Vec2 p = {(u.x - w.x * length) / l.longitudinal, (u.y - w.y * length) / l.lateral};
      const double size = std::hypot(p.x, p.y);
      Vec2 after = {l.longitudinal * p.x, l.lateral * p.y};
      if (size > s.bound[k]) {
        p = {p.x * s.bound[k] / size, p.y * s.bound[k] / size};
        after = {l.longitudinal * p.x, l.lateral * p.y};
        s.state[k] = CellState::slip;
        s.sx[k] = w.x + (after.x - u.x) / length;
        s.sy[k] = w.y + (after.y - u.y) / length;
      }
      s.px[k] = p.x;
      s.py[k] = p.y;
      u = after;
    }
  }
  find_totals(grid_, l, rolling.rolling_speed, s);
  return s;
}

GridSolution GridFastsim::slide(const Flexibilities& l, std::span<const double> friction, Vec2 direction) const {
  GridSolution s = empty_solution(friction);
  for (std::size_t k = 0; k < s.bound.size(); ++k) {
    s.px[k] = s.bound[k] * direction.x;
    s.py[k] = s.bound[k] * direction.y;
    if (s.state[k] != CellState::exterior) s.state[k] = CellState::slip;
  }
  find_totals(grid_, l, 0, s);
  return s;
}

void find_totals(const ElementGrid& grid, const Flexibilities& l, double rolling_speed, GridSolution& s) {
  Totals totals;
  for (std::size_t k = 0; k < s.state.size(); ++k) {
    s.ux[k] = l.longitudinal * s.px[k];
    s.uy[k] = l.lateral * s.py[k];
    if (s.state[k] == CellState::exterior) continue;
    add(totals, {.x = grid.x(static_cast<int>(k % grid.mx)),
                 .y = grid.y(static_cast<int>(k / grid.mx)),
                 .area = grid.element_area(),
                 .slides = s.state[k] == CellState::slip,
                 .traction = {s.px[k], s.py[k]},
                 .slip = {s.sx[k], s.sy[k]}});
  }
  s.forces = {totals.fx, totals.fy, totals.mz, totals.adhesion_area, totals.slip_area, s.forces.status};
  s.frictional_power = rolling_speed * totals.frictional_power;
  s.peak_traction = totals.peak_traction;
}

} // namespace microslip
