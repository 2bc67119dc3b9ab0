#include "compat/contact/set_up.hpp"

#include "microslip/elasticity/half_ellipses.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/classical/tangential_totals.hpp"
#include "microslip/exact/halfspace/memory_need.hpp"
#include "microslip/exact/normal/approximate_pressure.hpp"
#include "microslip/exact/normal/thin_sheet.hpp"
#include "microslip/friction/line_traction_bound.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace microslip::contact_program {
namespace {

HertzContact hertz_with(const GapCurvatures& gap, const CombinedMaterial& material, const NormalLoad& load) {
  return load.given == NormalLoad::Given::force ? hertz_from_load(gap, material, load.value)
                                                : hertz_from_approach(gap, material, load.value);
}

/// The curvatures that go with an ellipse are proportional to force and approach.
GapCurvatures gap_of_ellipse(double a, double b, const CombinedMaterial& material, const NormalLoad& load) {
  const bool by_force = load.given == NormalLoad::Given::force;
  const double force = by_force ? load.value : load.value / hertz_from_ellipse(a, b, material, 1).approach;
  return hertz_from_ellipse(a, b, material, force).gap;
}

/// IPOTCN = -6.
HalfEllipses half_ellipses(const PotentialContact& p, double normal_force) {
  return {p.values[0], p.values[1], p.values[2], normal_force};
}

GapCurvatures gap_of(const PotentialContact& p, const CombinedMaterial& material, const NormalLoad& load) {
  const auto [first, second, third, fourth] = p.values;
  switch (p.kind) {
  case Potential::curvatures:
    return {first, second};
  case Potential::curvature_and_ratio: {
    const GapCurvatures of_ratio = hertz_from_ellipse(second, 1, material, 1).gap;
    return {first, first * of_ratio.y / of_ratio.x};
  }
  case Potential::semi_axes:
    return gap_of_ellipse(first, second, material, load);
  case Potential::line_curvature:
    return {first, 0};
  case Potential::half_ellipses: // given by its contact alone
    return {0, 0};
  default: { // line_half_width: p0 = 2 fn/(pi a) = E* A a
    const double a = first, force_per_length = load.value / (2 * second);
    return {2 * force_per_length / (std::numbers::pi * a * a * material.contact_modulus()), 0};
  }
  }
}

/// The ellipse, or the strip, for a load.
HertzianShape shape_of(const PotentialContact& p, const CombinedMaterial& material, const GapCurvatures& gap,
                       const NormalLoad& load) {
  if (p.kind == Potential::half_ellipses) {
    const HalfEllipses contact = half_ellipses(p, load.value);
    return {contact.a, contact.half_width(), gap, 0, load.value};
  }
  if (p.is_line()) {
    const double length = 2 * p.values[1];
    const LineContact line = line_contact_from_load(gap.x, material, load.value / length);
    return {line.half_width, length / 2, gap, 0, load.value};
  }
  const HertzContact hertz = hertz_with(gap, material, load);
  return {hertz.a, hertz.b, hertz.gap, hertz.approach, hertz.normal_force};
}

/// By how much the rows of a line contact reach beyond its length: a whole number of them within it, and an even one
/// beyond.
double scale_of_rows(const PotentialContact& p) {
  if (p.scale <= 1) return 1;
  int within = std::max(1, static_cast<int>(std::lround(p.my / p.scale)));
  if ((p.my - within) % 2 != 0) ++within;
  return static_cast<double>(p.my) / within;
}

ElementGrid hertzian_grid(const PotentialContact& p, const HertzianShape& shape) {
  const double half_y = shape.b * (p.is_line() ? scale_of_rows(p) : p.scale), half_x = shape.a * p.scale;
  ElementGrid grid{p.mx, p.my, 0, 0, 2 * half_x / p.mx, 2 * half_y / p.my};
  grid.x0 = -half_x + grid.dx / 2;
  grid.y0 = -half_y + grid.dy / 2;
  return grid;
}

ElementGrid given_grid(const PotentialContact& p) {
  const auto [x, y, second_x, second_y] = p.values;
  ElementGrid grid{p.mx, p.my, x, y, second_x, second_y};
  if (p.kind == Potential::corners) {
    grid.dx = (second_x - x) / p.mx;
    grid.dy = (second_y - y) / p.my;
  }
  if (p.kind == Potential::centres) { // of the first and the last element
    grid.dx = (second_x - x) / (p.mx - 1);
    grid.dy = (second_y - y) / (p.my - 1);
  }
  if (p.kind == Potential::corner_and_size || p.kind == Potential::corners) {
    grid.x0 += grid.dx / 2;
    grid.y0 += grid.dy / 2;
  }
  return grid;
}

double quadratic_form(const double* b, double x, double y) {
  return b[0] * x * x + b[1] * x * y + b[2] * y * y + b[3] * x + b[4] * y + b[5];
}

/// Straight lines between points at y1, y1 + spacing, ..., and on beyond them.
double interpolated(const double* heights, std::size_t count, double y1, double spacing, double y) {
  if (count == 1) return heights[0];
  const double position = (y - y1) / spacing, last = static_cast<double>(count - 1);
  const auto k = static_cast<std::size_t>(std::clamp(std::floor(position), 0.0, last - 1));
  const double share = position - static_cast<double>(k);
  return (1 - share) * heights[k] + share * heights[k + 1];
}

/// The undeformed distance at a point. A circle is the parabola of its curvature, as in CONTACT.
double distance(const Geometry& g, double x, double y) {
  const double* v = g.values.data();
  if (g.base == Base::quadratic) return quadratic_form(v, x, y);
  if (g.base == Base::circle)
    return (x - v[0]) * (x - v[0]) / (2 * v[1]) + interpolated(v + 4, g.values.size() - 4, v[2], v[3], y);
  return v[0] * std::sin(v[1] * (x - v[2])) - v[3] * std::sin(v[4] * (x - v[5])) + x * x / v[6] + y * y / v[7];
}

/// IPLAN = 2, 3: whether contact is impossible in parts of the plane.
bool excludes(const Geometry& g) {
  return g.planform == Planform::quadratic || g.planform == Planform::rectangles;
}

bool is_excluded(const Geometry& g, double x, double y) {
  const double* v = g.plan_values.data();
  if (!excludes(g)) return false;
  if (g.planform == Planform::quadratic) return !(quadratic_form(v, x, y) < 0);
  const auto within = [&](const double* side) { return x >= side[0] && x <= side[1] && y >= side[2] && y <= side[3]; };
  return !within(v) && !within(v + 4);
}

void set_given_geometry(const Geometry& g, ContactStep& step) {
  const ElementGrid& grid = step.grid;
  step.gap.resize(grid.count());
  if (excludes(g)) step.excluded.resize(grid.count());
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) {
      const auto k = static_cast<std::size_t>(j) * grid.mx + i;
      const double x = grid.x(i), y = grid.y(j);
      step.gap[k] = g.base == Base::by_element ? g.values[k] : distance(g, x, y);
      if (excludes(g)) step.excluded[k] = is_excluded(g, x, y);
    }
  const bool none_left = std::all_of(step.excluded.begin(), step.excluded.end(), [](char out) { return out; });
  if (none_left && excludes(g)) throw Error(written(g.planform) + ": leaves no element");
}

/// IPLAN = 4: NPATCH, YSEP between them, FAC of each pair: 1 and 2, 1 and 3, ..., 2 and 3, ...
WeightedPatches weighted_patches(const Geometry& g, const ElementGrid& grid) {
  WeightedPatches patches;
  patches.count = static_cast<int>(g.plan_values[0]);
  if (patches.count == 1) return patches;
  const auto separators = std::span(g.plan_values).subspan(1, static_cast<std::size_t>(patches.count) - 1);
  for (int j = 0; j < grid.my; ++j) {
    const auto above = std::upper_bound(separators.begin(), separators.end(), grid.y(j));
    patches.patch_of_row.push_back(static_cast<int>(above - separators.begin()));
  }
  const auto count = static_cast<std::size_t>(patches.count);
  patches.factors.assign(count * count, 1);
  std::size_t next = count;
  for (std::size_t p = 0; p < count; ++p)
    for (std::size_t q = p + 1; q < count; ++q)
      patches.factors[p * count + q] = patches.factors[q * count + p] = g.plan_values[next++];
  return patches;
}

/// B = 2, 3: Hertz's pressure, or the parabola, for the load of this case.
GivenPressure hertzian_pressure(const Case& c, const ContactStep& step) {
  const PotentialContact& p = *c.potential;
  const HertzianShape shape = shape_of(p, step.bodies.material, *gap_curvatures(c), step.load);
  const auto bound = c.digits.bound == PressureModel::parabolic ? TractionBound::parabolic : TractionBound::elliptic;
  const auto pressure = [&](double x, double y) {
    if (!p.is_line()) return traction_bound(bound, shape.a, shape.b, shape.normal_force, 1, x, y);
    return std::abs(y) > shape.b ? 0 : line_traction_bound(bound, shape.a, shape.normal_force / (2 * shape.b), 1, x);
  };
  GivenPressure given{{}, shape.approach, shape.normal_force, {}};
  const ElementGrid& grid = step.grid;
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) given.pressure.push_back(pressure(grid.x(i), grid.y(j)));
  return given;
}

/// B = 4.
GivenPressure half_elliptic_pressure(const Case& c, const ElementGrid& grid) {
  const HalfEllipses contact = half_ellipses(*c.potential, c.load.value);
  GivenPressure given{{}, 0, c.load.value, {}};
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) given.pressure.push_back(contact.pressure(grid.x(i), grid.y(j)));
  return given;
}

/// B = 5, 6: KPEC and ANALYN.
GivenPressure approximate_pressure(const Case& c, const ContactStep& step) {
  std::vector<double> gap = step.gap;
  constexpr double never = 1e20; // [m]
  for (std::size_t k = 0; k < step.excluded.size(); ++k)
    if (step.excluded[k]) gap[k] = never;
  const auto method = c.digits.bound == PressureModel::kik_piotrowski ? kik_piotrowski_pressure : analyn_pressure;
  GivenPressure given{method(step.bodies.material, step.grid, gap, step.load.value), step.load.value, 0, {}};
  for (const double p : given.pressure) given.normal_force += p * step.grid.element_area();
  return given;
}

/// B = 1.
GivenPressure sheet_pressure(const Case& c, const ContactStep& step) {
  NormalSolution s = solve_thin_sheet(c.material->sheet_flexibility, step.grid, step.gap, step.load, step.excluded);
  return {std::move(s.pressure), s.approach, s.normal_force, std::move(s.displacement)};
}

/// B: the pressure, unless it is solved for.
std::optional<GivenPressure> given_pressure(const Case& c, const ContactStep& step) {
  switch (c.digits.bound) {
  case PressureModel::half_space:
    break;
  case PressureModel::thin_sheet:
    return sheet_pressure(c, step);
  case PressureModel::elliptic:
  case PressureModel::parabolic:
    return hertzian_pressure(c, step);
  case PressureModel::half_ellipses:
    return half_elliptic_pressure(c, step.grid);
  case PressureModel::kik_piotrowski:
  case PressureModel::analyn:
    return approximate_pressure(c, step);
  }
  return {};
}

void set_hertzian_geometry(const Case& c, ContactStep& step) {
  const PotentialContact& p = *c.potential;
  const GapCurvatures gap = *gap_curvatures(c);
  step.grid =
      require_memory(ContactProblem::normal, hertzian_grid(p, shape_of(p, step.bodies.material, gap, c.formed)));
  const ElementGrid& grid = step.grid;
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) {
      const double x = grid.x(i), y = grid.y(j);
      step.gap.push_back(gap.x * x * x + gap.y * y * y);
    }
}

/// The law in force, with a set of its numbers.
FrictionLaw friction_law(Law law, const std::vector<double>& set) {
  if (set.empty()) return FrictionLaw();
  if (law == Law::coulomb || law == Law::thermal) return FrictionLaw::coulomb(set[0]);
  constexpr double least_velocity = 1e-7; // [m/s], where a file says 0
  const auto term = [&](std::size_t k) {
    return FrictionTerm{.drop = set[k], .half_velocity = std::max(set[k + 1], least_velocity)};
  };
  if (law == Law::linear) return FrictionLaw::linear(set[0], term(1), term(3));
  if (law == Law::rational) return FrictionLaw::rational(set[0], term(1), term(3));
  return FrictionLaw::exponential(set[0], term(1), term(3));
}

/// BKTEMP, HEATCP, LAMBDA and DENS.
ThermalBody thermal_body(const std::array<double, 4>& data) {
  return {.bulk_temperature = data[0], .conductivity = data[2], .density = data[3], .heat_capacity = data[1]};
}

/// H > 0 and L = 6, whose sets are FREF, TREF, DFHEAT, DTHEAT, MEMDST, MEM_S0.
void set_temperatures(const Case& c, ContactStep& step) {
  step.thermal = thermal_bodies(c);
  if (!step.thermal || c.friction.law != Law::thermal) return;
  for (const auto& set : c.friction.sets)
    step.temperature_effect.push_back({.change = set[2], .begin = set[1], .range = set[3]});
}

/// Friction by rows; what FX and FY are relative to, over Fn.
double set_friction(const Case& c, ContactStep& step) {
  for (const auto& set : c.friction.sets) step.friction.push_back(friction_law(c.friction.law, set));
  if (c.friction.law == Law::coulomb) return c.friction.by_row ? 1 : step.friction[0].static_coefficient();
  const auto& set = c.friction.sets[0]; // its last two numbers, MEMDST and MEM_S0, hold for all rows
  step.friction_memory = {set[set.size() - 2], set[set.size() - 1]};
  const double begin = c.solver.starts_from_slip() ? c.solver.inislp : 0;
  step.slip_start = begin < 0                                               ? SlipStart::above
                    : begin > 0 || c.digits.iestim == InitialGuess::nothing ? SlipStart::below
                                                                            : SlipStart::given;
  return c.friction.by_row ? 1 : step.friction[0].static_coefficient();
}

/// CONTACT's solvers, except SteadyGS, correct steps that are longer than the elements, as if the edge were at the
/// centre of the element ahead of the contact.
bool corrects_leading_edge(const Case& c, const ContactStep& step) {
  constexpr double rounding = 1e-3;
  return !takes_element_length(c) && step.motion.step > (1 + rounding) * step.grid.dx && rolls_along_x(c) &&
         step.bodies.are_elastic() && !step.bodies.are_coupled() && step.response.is_half_space();
}

StepStart start_of(Continuation digit) {
  switch (digit) {
  case Continuation::previous:
    return StepStart::previous;
  case Continuation::previous_pressure:
    return StepStart::pressure;
  case Continuation::repeated:
    return StepStart::repeated;
  case Continuation::nothing:
    break;
  }
  return StepStart::fresh;
}

void set_motion(const Case& c, ContactStep& step) {
  const Digits& d = c.digits;
  const bool shifts = d.tang == Tangential::shift;
  TangentialInput& motion = step.motion;
  motion.motion = shifts                            ? ContactMotion::shift
                  : d.tang == Tangential::transient ? ContactMotion::transient
                                                    : ContactMotion::steady;
  // With the spin about (x0, y0): w = (xi - phi (y - y0), eta + phi (x - x0)).
  const double xi = slip_of(c.x), eta = slip_of(c.y);
  motion.creepage = {xi + c.phi * c.spin_y, eta - c.phi * c.spin_x, c.phi};
  const double scale = set_friction(c, step);
  if (const auto* force = std::get_if<ForceRatio>(&c.x)) step.force_x = force->value * scale;
  if (const auto* force = std::get_if<ForceRatio>(&c.y)) step.force_y = force->value * scale;
  motion.tolerance = std::clamp(c.solver.eps, 1e-10, 1e-8);
  step.start = start_of(d.pvtime);
  step.warm_start = d.iestim != InitialGuess::nothing;
  if (shifts) return;
  motion.step = takes_element_length(c) ? step.grid.dx : c.rolling->dq;
  motion.spin_offset = c.rolling->facphi;
  if (rolls_along_x(c))
    motion.direction = std::cos(c.rolling->chi) > 0 ? RollingDirection::forward : RollingDirection::backward;
  else
    motion.heading = c.rolling->chi;
  if (corrects_leading_edge(c, step)) motion.leading_edge = LeadingEdge{.theta = 1, .where_possible = true};
  constexpr double any_velocity = mm; // [m/s], of a wheel at rest, which has no creepages
  motion.rolling_speed = c.rolling->veloc != 0 ? c.rolling->veloc : any_velocity;
}

/// E: slip of each element on top of that of the creepages, or against the spin's part of it.
void set_extra_slip(const Case& c, ContactStep& step) {
  if (c.extra == ExtraSlip::none) return;
  const ElementGrid& grid = step.grid;
  const double unit = unit_of_slip(c.digits);
  const bool shifts = c.digits.tang == Tangential::shift;
  const Vec2 ahead = shifts ? Vec2{} : way_of(step.motion, step.motion.spin_offset * signed_step(step.motion, grid));
  step.extra_slip_x.assign(grid.count(), 0);
  step.extra_slip_y.assign(grid.count(), 0);
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) {
      const auto k = static_cast<std::size_t>(j) * grid.mx + i;
      if (c.extra == ExtraSlip::without_spin_y) step.extra_slip_y[k] = -c.phi * (grid.x(i) + ahead.x - c.spin_x);
      if (c.extra == ExtraSlip::without_spin_x) step.extra_slip_x[k] = c.phi * (grid.y(j) + ahead.y - c.spin_y);
      if (c.extra == ExtraSlip::by_element)
        step.extra_slip_x[k] = unit * c.extra_slip[2 * k], step.extra_slip_y[k] = unit * c.extra_slip[2 * k + 1];
    }
}

} // namespace

CombinedMaterial combined_material(const Case& c) {
  const MaterialData& m = *c.material;
  return combine({m.shear1, m.poisson1}, {m.shear2, m.poisson2});
}

namespace {

/// GG3, LAYTHK, TAU_C0, K_TAU; no yield stress means that the layer does not yield.
InterfaceLayer interface_layer(const std::vector<double>& v) {
  InterfaceLayer layer{.flexibility = v[1] / v[0]};
  if (v[2] > 0) layer.yield_stress = v[2];
  layer.hardening = v[3];
  return layer;
}

} // namespace

Bodies bodies_of(const Case& c) {
  const MaterialData& m = *c.material;
  const Material body1 = {m.shear1, m.poisson1}, body2 = {m.shear2, m.poisson2};
  Bodies elastic = combine(body1, body2);
  if (c.digits.mater == Bulk::layer) elastic.layer = interface_layer(m.model_data);
  if (c.digits.mater != Bulk::viscoelastic) return elastic;
  return viscoelastic(body1, creep_of(c, 0), body2, creep_of(c, 1), rolling_velocity(c));
}

MaterialCreep creep_of(const Case& c, std::size_t body) {
  const auto& data = c.material->model_data; // FG1, FG2, TC1, TC2
  return {data[body], data[2 + body]};
}

std::optional<ThermalBodies> thermal_bodies(const Case& c) {
  if (c.digits.heat == Heat::none || c.digits.tang != Tangential::steady) return {};
  return ThermalBodies{thermal_body(c.heat->body1), thermal_body(c.heat->body2)};
}

double rolling_velocity(const Case& c) {
  return c.rolling->veloc * (std::cos(c.rolling->chi) > 0 ? 1 : -1);
}

bool takes_element_length(const Case& c) {
  const Digits& d = c.digits;
  return (d.tang == Tangential::steady && c.solver.method != SolverChoice::convex_gs) ||
         (d.rolls() && d.mater == Bulk::layer);
}

bool rolls_along_x(const Case& c) {
  return std::abs(std::sin(c.rolling->chi)) <= 0.01;
}

std::optional<HertzianShape> hertzian_shape(const Case& c, const ContactStep& step) {
  if (!c.potential->is_hertzian()) return {};
  return shape_of(*c.potential, step.bodies.material, *gap_curvatures(c), step.load);
}

std::optional<GapCurvatures> gap_curvatures(const Case& c) {
  if (c.potential->is_hertzian()) return gap_of(*c.potential, combined_material(c), c.formed);
  const Geometry& g = c.geometry;
  if (g.base != Base::quadratic || g.planform != Planform::all) return {};
  const auto& b = g.values;
  if (b[1] != 0 || b[3] != 0 || b[4] != 0 || b[5] != 0) return {};
  return GapCurvatures{b[0], b[2]};
}

namespace {

using Angles = std::vector<std::pair<double, double>>;

/// The straight line through angles over y by least squares, at a y.
double on_straight_line(const Angles& angles, double y) {
  double mean_y = 0, mean = 0, square = 0, mixed = 0;
  const auto n = static_cast<double>(angles.size());
  for (const auto& [at, angle] : angles) mean_y += at / n, mean += angle / n;
  for (const auto& [at, angle] : angles) square += (at - mean_y) * (at - mean_y), mixed += (at - mean_y) * angle;
  return mean + mixed / square * (y - mean_y);
}

/// Straight lines between angles, the outer ones of which go on beyond them.
double between(const Angles& angles, double y) {
  std::size_t k = 1;
  while (k + 1 < angles.size() && y >= angles[k].first) ++k;
  const auto& [y0, angle0] = angles[k - 1];
  const auto& [y1, angle1] = angles[k];
  return angle0 + (y - y0) / (y1 - y0) * (angle1 - angle0);
}

/// C = 4.
RowInclination row_inclination(const AngleCorrection& correction, const ElementGrid& grid) {
  constexpr double all = 1, none = 0, half = 0.5;
  RowInclination inclination;
  inclination.traction_share = correction.variant == 3 ? none : correction.variant == 4 ? half : all;
  inclination.plane_along_x = correction.variant == 2;
  for (int j = 0; j < grid.my; ++j) {
    const double y = grid.y(j);
    inclination.angle.push_back(correction.method == 0 ? on_straight_line(correction.angles, y)
                                                       : between(correction.angles, y));
  }
  return inclination;
}

} // namespace

ContactStep contact_step(const Case& c) {
  ContactStep step;
  step.bodies = bodies_of(c);
  step.load = c.load;
  if (c.potential->is_hertzian()) {
    set_hertzian_geometry(c, step);
  } else {
    step.grid = require_memory(ContactProblem::normal, given_grid(*c.potential));
    set_given_geometry(c.geometry, step);
  }
  step.response.table = c.material->table;
  if (c.material->coefficients == Coefficients::angle_corrected)
    step.response.inclination = row_inclination(c.material->correction, step.grid);
  if (!c.potential->is_hertzian() && c.geometry.planform == Planform::sub_patches)
    step.response.patches = weighted_patches(c.geometry, step.grid);
  check(step.response, step.grid);
  if (c.material->coefficients == Coefficients::bilinear) step.grid.shape = ElementShape::bilinear;
  step.given = given_pressure(c, step);
  step.frictionless = !c.digits.has_friction();
  if (!step.frictionless) {
    set_motion(c, step);
    set_extra_slip(c, step);
    set_temperatures(c, step);
  }
  return step;
}

} // namespace microslip::contact_program
