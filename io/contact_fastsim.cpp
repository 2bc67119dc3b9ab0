#include "io/contact_fastsim.hpp"

#include "io/contact_set_up.hpp"
#include "microslip/error.hpp"
#include "microslip/simplified/fastrip.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

namespace microslip {
namespace {

constexpr double mm = 1e-3, mm3_per_newton = 1e-9;

bool is_fastrip(const ContactCase& c) {
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

SlopeReduction slope_reduction(const ContactCase& c) {
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

/// One case on the way through its rows.
class March {
public:
  March(const ContactCase& c, const ContactStep& step, const NormalSolution& normal, double normal_force)
      : case_(c), grid_(step.grid), motion_(step.motion), pressure_(normal.pressure), creepage_{c.x, c.y, c.phi / mm},
        forward_(motion_.direction == RollingDirection::forward),
        solver_(MarchingScheme::fastsim, {.mx = 1, .my = 1, .direction = motion_.direction}) {
    friction_ = friction_at(step, motion_.rolling_speed * std::hypot(creepage_.longitudinal, creepage_.lateral));
    at_rest_ = friction_at(step, 0);
    of_elements_ = equivalent_contact(step, normal_force);
    hertz_ = hertzian_contact(step).value_or(of_elements_);
    find_flexibilities();
  }

  TangentialSolution solve() {
    const auto n = grid_.count();
    TangentialSolution s;
    s.tractions = {std::vector<double>(n), std::vector<double>(n)};
    for (auto* field : {&s.bound, &s.ux, &s.uy, &s.sx, &s.sy, &s.slip_direction}) field->assign(n, 0);
    s.state.assign(n, CellState::exterior);
    s.creepage = motion_.creepage;
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

  std::optional<EllipticContact> hertzian_contact(const ContactStep& step) const {
    if (case_.potential->kind < -3 || case_.potential->kind > 0) return {};
    const bool by_force = step.load.given == NormalLoad::Given::force;
    const HertzContact h = by_force ? hertz_from_load(*gap_curvatures(case_), step.bodies.material, step.load.value)
                                    : hertz_from_approach(*gap_curvatures(case_), step.bodies.material, step.load.value);
    return contact(step, h.a, h.b, h.normal_force);
  }

  /// Flexibilities come from Hertz's ellipse, but the reduction of the slope from that of the elements.
  void find_flexibilities() {
    const SlopeReduction reduction = slope_reduction(case_);
    const double k = flexibilities(FlexibilityModel::three, {}, of_elements_).longitudinal /
                     flexibilities(FlexibilityModel::three, reduction, of_elements_).longitudinal;
    EllipticContact at_rest = hertz_;
    at_rest.friction = FrictionLaw::coulomb(mean(at_rest_));
    Flexibilities l = flexibilities(FlexibilityModel::blended, {}, at_rest);
    if (case_.digits.mater == 2) {
      const double given = require_positive("FLX", case_.material->model_data[0], "mm3/N") * mm3_per_newton;
      l = {given, given, given};
    }
    flexibilities_ = {l.longitudinal / k, l.lateral / k, l.spin / k};
  }

  double friction_of(int row) const { return friction_.size() == 1 ? friction_[0] : friction_[row]; }

  ContactFields solve(const Run& run) {
    std::vector<double> pressure;
    for (const int i : run.columns) pressure.push_back(pressure_[static_cast<std::size_t>(run.row) * grid_.mx + i]);
    const double ahead = forward_ ? 1 : -1, y = grid_.y(run.row) - case_.spin_y * mm;
    const double leading = grid_.x(run.columns.front()) + ahead * grid_.dx / 2 - case_.spin_x * mm;
    const double trailing = grid_.x(run.columns.back()) - ahead * grid_.dx / 2 - case_.spin_x * mm;
    const PatchRows patch = {
        static_cast<int>(pressure.size()), grid_.dy, {&y, 1}, {&leading, 1}, {&trailing, 1}, pressure};
    // The rigid slip a part of a step ahead of the elements' centres.
    const Flexibilities& l = flexibilities_;
    Creepage creepage = creepage_;
    creepage.lateral += creepage.spin * motion_.spin_offset * ahead * grid_.dx * l.lateral / l.spin;
    const double friction = friction_of(run.row);
    ContactFields f = solver_.fields(patch, {l, FrictionLaw::coulomb(friction), creepage, motion_.rolling_speed});
    if (is_fastrip(case_) && friction > 0) {
      const double middle = (leading + trailing) / 2, half_length = std::abs(leading - trailing) / 2;
      take_strips(f, {y, middle, half_length, f.x, f.bound, f.px, f.py, f.sx, f.sy, f.state}, run.row);
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
    const Creepage& w = motion_.creepage;
    s.power_by_creepage = -motion_.rolling_speed * (w.longitudinal * t.fx + w.lateral * t.fy + w.spin * t.mz);
  }

  const ContactCase& case_;
  const ElementGrid& grid_;
  const TangentialInput& motion_;
  const std::vector<double>& pressure_;
  Creepage creepage_; ///< at the centre of spin, from which places count
  bool forward_;
  RowSolver solver_;
  std::vector<double> at_rest_;
  std::vector<double> friction_; ///< at the creepage's velocity, of all rows or of each
  EllipticContact of_elements_, hertz_;
  Flexibilities flexibilities_ = {};
};

} // namespace

bool is_simplified(const ContactCase& c) {
  const int m = c.digits.mater;
  return c.digits.tang != 0 && (m == 2 || m == 3 || m >= 5);
}

ContactStepSolution solve_simplified(const ContactCase& c, const ContactStep& step, ContactSequence& steps) {
  ContactStep normal = step;
  normal.frictionless = true;
  ContactStepSolution out = steps.solve(normal);
  if (step.given) out.normal.elastic_energy = 0;
  if (out.contact_elements == 0) return out;
  out.tangential = March(c, step, out.normal, out.normal_force).solve();
  const auto& state = out.tangential.state;
  out.adhesion_elements = static_cast<int>(std::count(state.begin(), state.end(), CellState::adhesion));
  out.slip_elements = out.contact_elements - out.adhesion_elements;
  return out;
}

} // namespace microslip
