#include "microslip/simplified/grid_fastsim.hpp"

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
    : pressure_(pressure.begin(), pressure.end()) {
  check(grid);
  check_size("pressure", pressure.size(), grid);
  elements_ = Elements(grid);
  runs_ = find_runs(grid, pressure_);
}

void GridFastsim::check_friction(std::span<const double> friction) const {
  if (friction.size() != 1 && friction.size() != static_cast<std::size_t>(grid().my))
    throw Error("friction: must have one value, or one for each of the " + std::to_string(grid().my) + " rows");
}

double GridFastsim::friction_of(int row, std::span<const double> friction) const {
  return friction.size() == 1 ? friction[0] : friction[row];
}

double GridFastsim::contact_area() const {
  double area = 0;
  for (const double p : pressure_)
    if (p > 0) area += grid().element_area();
  return area;
}

double GridFastsim::capacity(std::span<const double> friction) const {
  check_friction(friction);
  double capacity = 0;
  for (std::size_t k = 0; k < pressure_.size(); ++k)
    capacity += friction_of(static_cast<int>(k / grid().mx), friction) * pressure_[k] * grid().element_area();
  return capacity;
}

Vec2 GridFastsim::equivalent_axes() const {
  int count = 0, first = grid().mx, last = -1;
  for (const ElementRun& run : runs_) {
    count += run.count;
    first = std::min(first, run.first);
    last = std::max(last, run.first + run.count - 1);
  }
  if (runs_.empty()) return {};
  const int columns = last - first + 1, rows = runs_.back().row - runs_.front().row + 1;
  const double size = std::sqrt(count * grid().element_area() / std::numbers::pi);
  const double ratio = std::sqrt(columns * grid().dx / (rows * grid().dy));
  return {size * ratio, size / ratio};
}

/// Solution without tractions, with the bound of the elements in contact.
ContactSolution GridFastsim::empty_solution(std::span<const double> friction) const {
  check_friction(friction);
  ContactSolution s;
  s.elements = elements_;
  s.fields = SurfaceFields(elements_.size());
  for (const ElementRun& run : runs_)
    for (int n = 0; n < run.count; ++n) {
      const std::size_t k = elements_.index(run.first + n, run.row);
      s.fields.bound[k] = friction_of(run.row, friction) * pressure_[k];
      s.fields.state[k] = CellState::adhesion;
    }
  return s;
}

ContactSolution GridFastsim::solve(const Flexibilities& l, std::span<const double> friction,
                                   const GridRolling& rolling) const {
  check_rolling(grid(), l, rolling);
  ContactSolution s = empty_solution(friction);
  SurfaceFields& f = s.fields;
  const RigidSlip rigid_slip(grid(), l, rolling);
  const bool forward = rolling.direction == RollingDirection::forward;
  const double length = rolling.before != nullptr ? rolling.step : grid().dx;
  for (const ElementRun& run : runs_) {
    Vec2 u;
    for (int n = 0; n < run.count; ++n) {
      const int i = run.first + (forward ? run.count - 1 - n : n);
      const std::size_t k = elements_.index(i, run.row);
      if (rolling.before != nullptr)
        u = rolling.before->x.empty() ? Vec2{} : Vec2{rolling.before->x[k], rolling.before->y[k]};
      const Vec2 w = rigid_slip.at(i, run.row, k);
      Vec2 p = {(u.x - w.x * length) / l.longitudinal, (u.y - w.y * length) / l.lateral};
      const double size = std::hypot(p.x, p.y);
      Vec2 after = {l.longitudinal * p.x, l.lateral * p.y};
      if (size > f.bound[k]) {
        p = {p.x * f.bound[k] / size, p.y * f.bound[k] / size};
        after = {l.longitudinal * p.x, l.lateral * p.y};
        f.state[k] = CellState::slip;
        f.slip.x[k] = w.x + (after.x - u.x) / length;
        f.slip.y[k] = w.y + (after.y - u.y) / length;
      }
      f.traction.x[k] = p.x;
      f.traction.y[k] = p.y;
      u = after;
    }
  }
  find_totals(l, rolling, s);
  return s;
}

ContactSolution GridFastsim::slide(const Flexibilities& l, std::span<const double> friction, Vec2 direction) const {
  ContactSolution s = empty_solution(friction);
  SurfaceFields& f = s.fields;
  for (std::size_t k = 0; k < f.bound.size(); ++k) {
    f.traction.x[k] = f.bound[k] * direction.x;
    f.traction.y[k] = f.bound[k] * direction.y;
    if (f.state[k] != CellState::exterior) f.state[k] = CellState::slip;
  }
  find_totals(l, {}, s);
  return s;
}

void find_totals(const Flexibilities& l, const GridRolling& rolling, ContactSolution& s) {
  s.fields.displacement = s.fields.traction;
  for (double& u : s.fields.displacement.x) u *= l.longitudinal;
  for (double& u : s.fields.displacement.y) u *= l.lateral;
  const auto [xi, eta, phi] = rolling.creepage;
  s.creepage = {xi + phi * rolling.spin_centre.y, eta - phi * rolling.spin_centre.x, phi};
  s.totals = find_totals(s.elements, s.fields, s.creepage, rolling.rolling_speed);
}

} // namespace microslip
