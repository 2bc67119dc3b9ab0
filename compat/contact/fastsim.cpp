#include "compat/contact/fastsim.hpp"

#include "compat/contact/set_up.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/classical/tangential_totals.hpp"
#include "microslip/numerics/plane_root.hpp"
#include "microslip/simplified/fastrip.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <optional>

namespace microslip::contact_program {
namespace {

constexpr double mm = 1e-3, mm3_per_newton = 1e-9;

bool is_fastrip(const Case& c) {
  return c.digits.mater >= 5;
}

/// mu of each law at a slip velocity [m/s].
std::vector<double> friction_at(const ContactStep& step, double velocity) {
  std::vector<double> mu;
  for (const FrictionLaw& law : step.friction) mu.push_back(law.coefficient(velocity));
  return mu;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

SlopeReduction slope_reduction(const Case& c) {
  const auto& data = c.material->model_data;
  if (data.size() < 3) return {};
  const std::size_t first = data.size() - 3;
  return {require_between("K0_MF", data[first], "-", 1e-6, 1), require_between("ALFAMF", data[first + 1], "-", 0, 1),
          require_between("BETAMF", data[first + 2], "-", 0, 1e6)};
}

/// The extent of the elements in contact.
struct Extent {
  int count = 0, columns = 0, rows = 0;
};

Extent extent(const ElementGrid& grid, const std::vector<double>& pressure) {
  int first_i = grid.mx, last_i = -1, first_j = grid.my, last_j = -1, count = 0;
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) {
      if (!(pressure[static_cast<std::size_t>(j) * grid.mx + i] > 0)) continue;
      ++count;
      first_i = std::min(first_i, i);
      last_i = std::max(last_i, i);
      first_j = std::min(first_j, j);
      last_j = std::max(last_j, j);
    }
  return {count, last_i - first_i + 1, last_j - first_j + 1};
}

/// Elements next to each other in a row that are in contact, in the order of the particles' way.
struct Run {
  int row;
  std::vector<int> columns;
};

std::vector<Run> runs_of(const ElementGrid& grid, const std::vector<double>& pressure, bool forward) {
  std::vector<Run> runs;
  for (int j = 0; j < grid.my; ++j) {
    bool goes_on = false;
    for (int n = 0; n < grid.mx; ++n) {
      const int i = forward ? grid.mx - 1 - n : n;
      const bool touches = pressure[static_cast<std::size_t>(j) * grid.mx + i] > 0;
      if (touches && !goes_on) runs.push_back({j, {}});
      if (touches) runs.back().columns.push_back(i);
      goes_on = touches;
    }
  }
  return runs;
}

/// Displacements that the particles of the elements had before the step [m]; empty: none.
struct Springs {
  std::vector<double> x = {}, y = {};

  Vec2 at(std::size_t k) const { return x.empty() ? Vec2{} : Vec2{x[k], y[k]}; }
};

/// Those of the case before, at the places that the particles come from.
Springs springs_before(const Case& c, const ContactStep& step, const SpringState& state) {
  if (c.digits.pvtime != 0 || c.digits.tang != 2 || state.x.empty()) return {};
  TangentialState u = moved_to(origin_of_particles(step), {state.x, state.y}, state.grid);
  return {std::move(u.px), std::move(u.py)};
}

/// One case with its creepages, on the way through its rows.
class March {
public:
  March(const Case& c, const ContactStep& step, const NormalSolution& normal, double normal_force,
        const Creepage& creepage, const Springs& before)
      : case_(c), step_(step), grid_(step.grid), motion_(step.motion), pressure_(normal.pressure), creepage_(creepage),
        before_(before), forward_(motion_.direction == RollingDirection::forward) {
    friction_ = friction_at(step, motion_.rolling_speed * std::hypot(creepage_.longitudinal, creepage_.lateral));
    at_rest_ = friction_at(step, 0);
    of_elements_ = equivalent_contact(step, normal_force);
    const auto shape = hertzian_shape(c, step);
    hertz_ = shape ? contact(step, shape->a, shape->b, shape->normal_force) : of_elements_;
    find_flexibilities();
  }

  TangentialSolution solve() {
    const auto n = grid_.count();
    TangentialSolution s;
    s.tractions = {std::vector<double>(n), std::vector<double>(n)};
    for (auto* field : {&s.bound, &s.ux, &s.uy, &s.sx, &s.sy, &s.slip_direction}) field->assign(n, 0);
    s.state.assign(n, CellState::exterior);
    // The frame's origin is not the centre of spin.
    const double phi = creepage_.spin;
    s.creepage = {creepage_.longitudinal + phi * case_.spin_y * mm, creepage_.lateral - phi * case_.spin_x * mm, phi};
    for (const Run& run : runs_of(grid_, pressure_, forward_)) put(run, solve(run), s);
    find_totals(s);
    return s;
  }

private:
  EllipticContact contact(const ContactStep& step, double a, double b, double normal_force) const {
    return {.a = a,
            .b = b,
            .shear_modulus = step.bodies.material.shear_modulus,
            .poisson_ratio = step.bodies.material.poisson_ratio,
            .normal_force = normal_force,
            .friction = FrictionLaw::coulomb(mean(friction_)),
            .creepage = creepage_,
            .rolling_speed = motion_.rolling_speed};
  }

  /// The ellipse with the area and the ratio of length to width of the elements in contact.
  EllipticContact equivalent_contact(const ContactStep& step, double normal_force) const {
    const Extent e = extent(grid_, pressure_);
    const double size = std::sqrt(e.count * grid_.element_area() / std::numbers::pi);
    const double ratio = std::sqrt(e.columns * grid_.dx / (e.rows * grid_.dy));
    return contact(step, size * ratio, size / ratio, normal_force);
  }

  /// Flexibilities come from Hertz's ellipse, but the reduction of the slope from that of the elements. They are
  /// blended only if the creepages are given.
  void find_flexibilities() {
    const SlopeReduction reduction = slope_reduction(case_);
    const double k = flexibilities(FlexibilityModel::three, {}, of_elements_).longitudinal /
                     flexibilities(FlexibilityModel::three, reduction, of_elements_).longitudinal;
    EllipticContact at_rest = hertz_;
    at_rest.friction = FrictionLaw::coulomb(mean(at_rest_));
    Flexibilities l =
        flexibilities(case_.digits.force > 0 ? FlexibilityModel::three : FlexibilityModel::blended, {}, at_rest);
    if (case_.digits.mater == 2) {
      const double given = require_positive("FLX", case_.material->model_data[0], "mm3/N") * mm3_per_newton;
      l = {given, given, given};
    }
    flexibilities_ = {l.longitudinal / k, l.lateral / k, l.spin / k};
  }

  double friction_of(int row) const { return friction_.size() == 1 ? friction_[0] : friction_[row]; }

  /// At an element, a part of a step ahead of its centre; the spin's parts scaled to the flexibilities. E drops one of
  /// them, or adds to them.
  Vec2 rigid_slip(int i, int j) const {
    const Flexibilities& l = flexibilities_;
    const Vec2 ahead = way_of(motion_, motion_.spin_offset * way_);
    const double x = grid_.x(i) + ahead.x - case_.spin_x * mm, y = grid_.y(j) + ahead.y - case_.spin_y * mm;
    Vec2 w = {creepage_.longitudinal, creepage_.lateral};
    if (case_.extra != 3) w.x -= creepage_.spin * y * l.longitudinal / l.spin;
    if (case_.extra != 2) w.y += creepage_.spin * x * l.lateral / l.spin;
    if (case_.extra != 9) return w;
    const std::size_t k = index(i, j);
    return {w.x + step_.extra_slip_x[k], w.y + step_.extra_slip_y[k]};
  }

  std::size_t index(int i, int j) const { return static_cast<std::size_t>(j) * grid_.mx + i; }

  /// FASTSIM's step from element to element, u' + s dq = u + w dq: in steady rolling u' is that of the element before.
  ContactFields solve(const Run& run) {
    const Flexibilities& l = flexibilities_;
    const double friction = friction_of(run.row), length = std::abs(way_);
    ContactFields f(static_cast<int>(run.columns.size()), 1);
    Vec2 u;
    for (std::size_t n = 0; n < run.columns.size(); ++n) {
      const int i = run.columns[n];
      const std::size_t k = index(i, run.row);
      if (case_.digits.tang == 2) u = before_.at(k);
      const Vec2 w = rigid_slip(i, run.row);
      Vec2 p = {(u.x - w.x * length) / l.longitudinal, (u.y - w.y * length) / l.lateral};
      const double size = std::hypot(p.x, p.y);
      f.x[n] = grid_.x(i) - case_.spin_x * mm;
      f.bound[n] = friction * pressure_[k];
      f.state[n] = CellState::adhesion;
      Vec2 after = {l.longitudinal * p.x, l.lateral * p.y};
      if (size > f.bound[n]) {
        p = {p.x * f.bound[n] / size, p.y * f.bound[n] / size};
        after = {l.longitudinal * p.x, l.lateral * p.y};
        f.state[n] = CellState::slip;
        f.sx[n] = w.x + (after.x - u.x) / length;
        f.sy[n] = w.y + (after.y - u.y) / length;
      }
      f.px[n] = p.x;
      f.py[n] = p.y;
      u = after;
    }
    if (is_fastrip(case_) && friction > 0) {
      const double first = f.x.front(), last = f.x.back();
      const StripRow row = {grid_.y(run.row) - case_.spin_y * mm,
                            (first + last) / 2,
                            (std::abs(first - last) + grid_.dx) / 2,
                            f.x,
                            f.bound,
                            f.px,
                            f.py,
                            f.sx,
                            f.sy,
                            f.state};
      take_strips(f, row, run.row);
    }
    return f;
  }

  void take_strips(ContactFields& f, StripRow row, int j) const {
    const bool first_form = case_.digits.mater >= 6;
    const EllipticContact& ellipse = first_form ? hertz_ : of_elements_;
    if (first_form) row.half_length = ellipse.a * std::sqrt(std::max(0.0, 1 - std::pow(grid_.y(j) / ellipse.b, 2)));
    const StripTheory theory(ellipse, friction_of(j), motion_.direction);
    const bool all_slides = case_.digits.mater == 7 && std::abs(theory.scaled_spin()) >= 1;
    if (!all_slides) return theory.solve(row);
    for (std::size_t k = 0; k < f.px.size(); ++k) {
      const double size = std::hypot(f.px[k], f.py[k]);
      if (!(size > 0)) continue;
      f.px[k] *= f.bound[k] / size;
      f.py[k] *= f.bound[k] / size;
      f.state[k] = CellState::slip;
    }
  }

  void put(const Run& run, const ContactFields& f, TangentialSolution& s) const {
    for (std::size_t n = 0; n < run.columns.size(); ++n) {
      const auto k = static_cast<std::size_t>(run.row) * grid_.mx + run.columns[n];
      s.tractions.px[k] = f.px[n];
      s.tractions.py[k] = f.py[n];
      s.bound[k] = f.bound[n];
      s.ux[k] = flexibilities_.longitudinal * f.px[n];
      s.uy[k] = flexibilities_.lateral * f.py[n];
      s.sx[k] = f.sx[n];
      s.sy[k] = f.sy[n];
      if (f.sx[n] != 0 || f.sy[n] != 0) s.slip_direction[k] = std::atan2(f.sy[n], f.sx[n]);
      s.state[k] = f.state[n];
    }
  }

  /// What the first form of FaStrip multiplies the forces by, in its second form as far as friction allows.
  double force_factor(const ContactForces& forces) const {
    const double ratio = hertz_.a / hertz_.b;
    if (case_.digits.mater < 6 || !(ratio < 1)) return 1;
    const double factor = 1 + std::pow(1 - ratio, 4);
    const double limit = mean(friction_) * hertz_.normal_force, force = std::hypot(forces.fx, forces.fy);
    return case_.digits.mater == 6 ? factor : std::clamp(limit / force, 1.0, factor);
  }

  void find_totals(TangentialSolution& s) const {
    ContactForces& t = s.forces;
    const double area = grid_.element_area();
    for (std::size_t k = 0; k < s.state.size(); ++k) {
      const double px = s.tractions.px[k] * area, py = s.tractions.py[k] * area;
      const double x = grid_.x(static_cast<int>(k % grid_.mx)), y = grid_.y(static_cast<int>(k / grid_.mx));
      t.fx += px;
      t.fy += py;
      t.mz += x * py - y * px;
      s.frictional_power -= motion_.rolling_speed * (px * s.sx[k] + py * s.sy[k]);
      s.peak_traction = std::max(s.peak_traction, std::hypot(px, py) / area);
      if (s.state[k] == CellState::adhesion) t.adhesion_area += area;
      if (s.state[k] == CellState::slip) t.slip_area += area;
    }
    const double factor = force_factor(t);
    t.fx *= factor;
    t.fy *= factor;
    t.mz *= factor;
    const Creepage& w = s.creepage;
    s.power_by_creepage = -motion_.rolling_speed * (w.longitudinal * t.fx + w.lateral * t.fy + w.spin * t.mz);
  }

  const Case& case_;
  const ContactStep& step_;
  const ElementGrid& grid_;
  const TangentialInput& motion_;
  const std::vector<double>& pressure_;
  Creepage creepage_; ///< at the centre of spin, from which places count
  const Springs& before_;
  bool forward_;
  double way_ = case_.digits.tang == 2 ? signed_step(motion_, grid_) : (forward_ ? grid_.dx : -grid_.dx);
  std::vector<double> at_rest_;
  std::vector<double> friction_; ///< at the creepage's velocity, of all rows or of each
  EllipticContact of_elements_, hertz_;
  Flexibilities flexibilities_ = {};
};

} // namespace

bool is_simplified(const Case& c) {
  const int m = c.digits.mater;
  return c.digits.tang != 0 && (m == 2 || m == 3 || m >= 5);
}

namespace {

/// The creepages of a case whose forces are given are the roots of what the march's forces lack, over all that friction
/// bears. Beyond that all slides in the direction of the force.
class GivenForces {
public:
  using Solve = std::function<TangentialSolution(const Creepage&)>;

  GivenForces(const Case& c, const ContactStep& step, const std::vector<double>& pressure, double normal_force,
              Solve solve)
      : solve_(std::move(solve)),
        grid_(step.grid), creepage_{c.digits.force >= 1 ? 0 : c.x, c.digits.force == 2 ? 0 : c.y, c.phi / mm},
        tolerance_(step.motion.tolerance) {
    if (step.force_x) x_ = *step.force_x * normal_force;
    if (step.force_y) y_ = *step.force_y * normal_force;
    const std::vector<double> mu = friction_at(step, 0);
    double area = 0;
    for (std::size_t k = 0; k < pressure.size(); ++k) {
      const double element = step.grid.element_area();
      capacity_ += (mu.size() == 1 ? mu[0] : mu[k / step.grid.mx]) * pressure[k] * element;
      if (pressure[k] > 0) area += element;
    }
    scale_ = capacity_ / (step.bodies.material.shear_modulus * area);
  }

  TangentialSolution solution() const {
    const double wanted = std::hypot(x_.value_or(0), y_.value_or(0));
    if (!(wanted < capacity_)) return sliding(wanted);
    const auto misfit = [&](Vec2 v) -> Vec2 {
      const ContactForces f = solve_(with(v)).forces;
      return {(f.fx - *x_) / capacity_, y_ ? (f.fy - *y_) / capacity_ : v.y / scale_};
    };
    const PlaneRoot root = find_plane_root(misfit, {}, {scale_, scale_}, tolerance_);
    TangentialSolution s = solve_(with(root.at));
    s.residual = root.size;
    if (!root.found) s.forces.status = Status::not_converged;
    return s;
  }

private:
  Creepage with(Vec2 v) const { return {v.x, y_ ? v.y : creepage_.lateral, creepage_.spin}; }

  /// Friction at rest everywhere.
  TangentialSolution sliding(double wanted) const {
    TangentialSolution s = solve_({0, 0, 0});
    const Vec2 direction = {x_.value_or(0) / wanted, y_.value_or(0) / wanted};
    s.creepage = creepage_;
    s.residual = wanted / capacity_ - 1;
    s.frictional_power = s.power_by_creepage = 0;
    s.forces = {.slip_area = s.forces.adhesion_area + s.forces.slip_area, .status = Status::no_solution};
    for (std::size_t k = 0; k < s.bound.size(); ++k) {
      s.tractions.px[k] = s.bound[k] * direction.x;
      s.tractions.py[k] = s.bound[k] * direction.y;
      s.peak_traction = std::max(s.peak_traction, s.bound[k]);
      if (s.state[k] != CellState::exterior) s.state[k] = CellState::slip;
      const double moment =
          grid_.x(static_cast<int>(k % grid_.mx)) * direction.y - grid_.y(static_cast<int>(k / grid_.mx)) * direction.x;
      s.forces.mz += s.bound[k] * moment * grid_.element_area();
    }
    s.forces.fx = capacity_ * direction.x;
    s.forces.fy = capacity_ * direction.y;
    return s;
  }

  Solve solve_;
  const ElementGrid& grid_;
  Creepage creepage_; ///< where it is given
  double tolerance_;
  std::optional<double> x_, y_; ///< [N]
  double capacity_ = 0;         ///< what all elements bear at rest [N]
  double scale_ = 0;            ///< of the creepages
};

} // namespace

ContactStepSolution solve_simplified(const Case& c, const ContactStep& step, ContactSequence& steps,
                                     SpringState& springs) {
  ContactStep normal = step;
  normal.frictionless = true;
  ContactStepSolution out = steps.solve(normal);
  if (step.given) out.normal.elastic_energy = 0;
  if (out.contact_elements > 0) {
    const Springs before = springs_before(c, step, springs);
    const auto solve = [&](const Creepage& creepage) {
      return March(c, step, out.normal, out.normal_force, creepage, before).solve();
    };
    out.tangential = c.digits.force == 0
                         ? solve({c.x, c.y, c.phi / mm})
                         : GivenForces(c, step, out.normal.pressure, out.normal_force, solve).solution();
    if (out.status == Status::ok) out.status = out.tangential.forces.status;
    const auto& state = out.tangential.state;
    out.adhesion_elements = static_cast<int>(std::count(state.begin(), state.end(), CellState::adhesion));
    out.slip_elements = out.contact_elements - out.adhesion_elements;
  }
  springs = {step.grid, out.tangential.ux, out.tangential.uy};
  return out;
}

} // namespace microslip::contact_program
