#include "validation/studies.hpp"

#include "microslip/elasticity/hertz.hpp"
#include "microslip/elasticity/interior_response.hpp"
#include "microslip/elasticity/layered_response.hpp"
#include "microslip/exact/classical/contact_sequence.hpp"
#include "microslip/exact/halfspace/layered_influence.hpp"
#include "microslip/interior/layered_interior.hpp"
#include "validation/clock.hpp"
#include "validation/draw.hpp"
#include "validation/interior_integral.hpp"
#include "validation/layer_on_half_space.hpp"
#include "validation/layered_accuracy.hpp"
#include "validation/layered_cost.hpp"
#include "validation/layered_energy.hpp"
#include "validation/layered_integral.hpp"
#include "validation/layered_random_contacts.hpp"
#include "validation/report.hpp"
#include "validation/rollers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr Material rigid = {std::numeric_limits<double>::infinity(), 0};
const LayeredBody rigid_body = {{}, {rigid}};
const Material steel = Material::from_young(210e9, 0.3);

SurfaceResponse<double> response_of(const LayeredBody& body, double k) {
  return response(instantaneous_stack(body), k);
}

std::vector<double> wavenumbers() { // of layers of a millimetre: k h from 0.001 to 100
  std::vector<double> k;
  for (int n = 0; n <= 50; ++n) k.push_back(std::pow(10, 0.1 * n));
  return k;
}

double equal_layers() {
  const LayeredBody layers = {{{1e-3, {steel}}, {2e-3, {steel}}, {0.3e-3, {steel}}}, {steel}};
  const SurfaceResponse<double> half = response_of({{}, {steel}}, 1);
  double largest = 0;
  for (const double k : wavenumbers()) {
    const SurfaceResponse<double> r = response_of(layers, k);
    largest = std::max({largest, std::abs(r.nn / half.nn - 1), std::abs(r.ll / half.ll - 1),
                        std::abs(r.tt / half.tt - 1), std::abs(r.ln / half.ln - 1)});
  }
  return largest;
}

double beside_closed_form() {
  const YoungMaterial hard = {200e9, 0.25}, middle = {100e9, 0.3}, soft = {3e9, 0.48};
  double largest = 0;
  for (const auto& [layer, base] : {std::pair{middle, hard}, {hard, middle}, {soft, hard}, {hard, soft}})
    for (const double k : wavenumbers()) {
      const LayeredBody body = {{{1e-3, {Material::from_young(layer.young_modulus, layer.poisson_ratio)}}},
                                {Material::from_young(base.young_modulus, base.poisson_ratio)}};
      largest = std::max(largest, std::abs(response_of(body, k).nn / layer_on_half_space(layer, 1e-3, base, k) - 1));
    }
  return largest;
}

void report_responses(Report& report) {
  report.heading("Responses to waves with k h from 0.001 to 100: largest relative differences");
  report.bounded("three equal layers from a half-space", "{:.1e}", equal_layers(), "<= 1e-12");
  report.bounded("a layer on a half-space from Li and others' formula", "{:.1e}", beside_closed_form(), "<= 1e-9");
  const double h = 1e-3, k = 0.01, nu = 0.3, g = steel.shear_modulus;
  const SurfaceResponse<double> springs = response_of({{{h, {steel}}}, {rigid}}, k);
  report.bounded("on a rigid core: h (1 - 2 nu)/(2 G (1 - nu))", "{:.1e}",
                 std::abs(springs.nn / k / (h * (1 - 2 * nu) / (2 * g * (1 - nu))) - 1), "<= 1e-8");
  report.bounded("  along the surface: h/G", "{:.1e}",
                 std::max(std::abs(springs.ll / k / (h / g) - 1), std::abs(springs.tt / k / (h / g) - 1)), "<= 1e-8");
}

constexpr ElementSides sides = {0.2, 0.3}, tents = {0.2, 0.3, {}, ElementShape::bilinear};

/// Largest difference of influence numbers from double integrals, over the element's own.
double integral_error(const LayeredBody& body, double speed, const ElementSides& elements = sides) {
  double largest = 0;
  for (const auto& [i, j] : {std::pair{0, 0}, {1, 0}, {-1, 1}, {3, 4}}) {
    InfluenceRows rows(std::abs(i) + 1, j + 1);
    RolledLayers(body).add(speed, elements, {}, rows);
    const Influence found = rows.at(i, j),
                    exact = layered_integral(body, speed, elements, i, j, speed == 0 ? 600 : 400);
    for (const auto part :
         {&Influence::xx, &Influence::xy, &Influence::yy, &Influence::zz, &Influence::xz, &Influence::yz})
      largest = std::max(largest, std::abs(found.*part - exact.*part));
  }
  return largest / LayeredInfluence({body, rigid_body, speed}, elements, 1, 1).at(0, 0).zz;
}

void report_influence(Report& report) {
  report.heading("Influence numbers of elements of 0.2 x 0.3: largest differences from double integrals");
  const Material soft = {1, 0.4}, hard = {10, 0.3}, very_soft = {1e-4, 0.5};
  const auto on = [](double h, const Material& layer, const Material& substrate) {
    return LayeredBody{{{h, {layer}}}, {substrate}};
  };
  LayeredBody graded = {{}, {{100, 0.3}}};
  for (int n = 0; n < 10; ++n) graded.layers.push_back({0.1, {{std::exp2(-n), 0.3}}});
  const PronySeries slow = {{0.3, 3}}, quick = {{0.5, 1}, {0.2, 0.1}};
  const LayeredBody polymer = {{{0.5, {soft, quick, PronySeries{}}}}, {hard, slow}};
  const std::pair<const char*, LayeredBody> elastic[] = {
      {"h = 1, ten times softer than the substrate", on(1, soft, hard)},
      {"h = 0.2 on a rigid core", on(0.2, soft, rigid)},
      {"h = 0.3 on a rigid core, incompressible", on(0.3, {1, 0.5}, rigid)},
      {"h = 0.05, ten times stiffer", on(0.05, hard, soft)},
      {"sandwich with a core ten thousand times softer", {{{0.2, {soft}}, {0.2, {very_soft}}, {0.2, {soft}}}, {soft}}},
      {"ten layers, each half as stiff as the one above", graded},
  };
  for (const auto& [name, body] : elastic) report.bounded(name, "{:.1e}", integral_error(body, 0), "<= 1e-7");
  for (const double speed : {0.05, 0.5})
    report.bounded(fmt::format("viscoelastic, h = 0.5, V = {}", speed), "{:.1e}", integral_error(polymer, speed),
                   "<= 1e-7");
  report.line("  of bilinear elements");
  for (const auto& [name, body] : elastic) report.bounded(name, "{:.1e}", integral_error(body, 0, tents), "<= 1e-7");
  for (const double speed : {0.05, 0.5})
    report.bounded(fmt::format("viscoelastic, h = 0.5, V = {}", speed), "{:.1e}", integral_error(polymer, speed, tents),
                   "<= 1e-7");
  const auto report_time = [&](const char* name, const LayeredBody& body) {
    const double time = seconds([&] { LayeredInfluence({body, rigid_body, 0.5}, {0.2, 0.2}, 256, 256); });
    report.line(fmt::format("  256 x 256 elements, {}: {:.2f} s", name, time));
  };
  report_time("one layer", elastic[0].second);
  report_time("ten layers", graded);
  report_time("viscoelastic", polymer);
}

double largest_difference(const InteriorState& a, const InteriorState& b, double displacement) {
  return std::max(
      {std::abs(a.ux - b.ux) / displacement, std::abs(a.uy - b.uy) / displacement, std::abs(a.uz - b.uz) / displacement,
       std::abs(a.stress.xx - b.stress.xx), std::abs(a.stress.yy - b.stress.yy), std::abs(a.stress.zz - b.stress.zz),
       std::abs(a.stress.xy - b.stress.xy), std::abs(a.stress.xz - b.stress.xz), std::abs(a.stress.yz - b.stress.yz)});
}

/// Largest difference of states below an element from double integrals, stresses over the traction, displacements over
/// the surface's under the element. `memory` is how far layers remember [m]; with it and depth the number of directions
/// grows that the integrals need.
double interior_error(const LayeredBody& body, double speed, double memory, const std::vector<double>& depths) {
  const ElementGrid grid = {.mx = 1, .my = 1, .x0 = 0, .y0 = 0, .dx = sides.dx, .dy = sides.dy};
  const std::vector<double> one = {1};
  const InteriorField along(body, Body::first, grid, {one, {}, {}}, speed),
      across(body, Body::first, grid, {{}, one, {}}, speed), normal(body, Body::first, grid, {{}, {}, one}, speed);
  const double displacement = LayeredInfluence({body, rigid_body, speed}, sides, 1, 1).at(0, 0).zz;
  double largest = 0;
  for (const double depth : depths)
    for (const auto& [x, y] : {std::pair{-0.05, 0.02}, {0.3, 0.2}}) {
      const double distance = std::hypot(x, y) + std::hypot(sides.dx, sides.dy) / 2;
      const int directions = 64 + static_cast<int>(40 * (distance + memory) / depth);
      const InteriorInfluence exact = interior_integral(body, speed, sides, x, y, depth, directions);
      largest = std::max({largest, largest_difference(along.at({x, y, depth}), exact.px, displacement),
                          largest_difference(across.at({x, y, depth}), exact.py, displacement),
                          largest_difference(normal.at({x, y, depth}), exact.pn, displacement)});
    }
  return largest;
}

/// Largest jump of tractions across a body's interfaces under an element with all three tractions.
double interface_error(const LayeredBody& body) {
  const ElementGrid grid = {.mx = 1, .my = 1, .x0 = 0, .y0 = 0, .dx = sides.dx, .dy = sides.dy};
  const std::vector<double> one = {1};
  const InteriorField field(body, Body::first, grid, {one, one, one});
  double largest = 0;
  for (std::size_t n = 0; n < body.layers.size(); ++n)
    for (const double x : {0.0, 0.17, 1.3}) {
      const double depth = bottoms_of(body)[n];
      const Stress above = field.at({x, 0.04, depth}).stress, below = field.at({x, 0.04, depth * (1 + 1e-10)}).stress;
      largest = std::max(
          {largest, std::abs(above.xz - below.xz), std::abs(above.yz - below.yz), std::abs(above.zz - below.zz)});
    }
  return largest;
}

/// Largest error of states in random stacks, at a depth of a random layer.
double random_interior_error(int stacks) {
  Draw draw(7);
  double largest = 0;
  for (int n = 0; n < stacks; ++n) {
    LayeredBody body = {{}, {{draw.power(1, 1e6), draw.number(0, 0.5)}}};
    const int layers = draw.count(1, 4);
    for (int k = 0; k < layers; ++k)
      body.layers.push_back(
          {draw.power(0.05, 1), {{draw.power(1, 1e6), draw.chance(0.3) ? 0.5 : draw.number(0, 0.5)}}});
    if (draw.chance(0.3)) body.substrate = {rigid};
    const auto bottom = static_cast<std::size_t>(draw.count(0, layers - 1));
    largest = std::max(largest, interior_error(body, 0, 0, {bottoms_of(body)[bottom]}));
  }
  return largest;
}

void report_inside(Report& report) {
  report.heading("States below an element of 0.2 x 0.3: largest differences from double integrals");
  const Material soft = {1, 0.4}, hard = {10, 0.3};
  const LayeredBody skin = {{{0.05, {hard}}, {0.4, {soft}}}, {{3, 0.2}}}, roller = {{{0.2, {{1, 0.5}}}}, {rigid}},
                    bond = {{{0.2, {soft}}, {0.05, {{1e-4, 0.5}}}, {0.4, {hard}}}, {soft}},
                    polymer = {{{0.5, {soft, {{0.5, 1}, {0.2, 0.1}}, PronySeries{}}}}, {hard, {{0.3, 3}}}};
  const auto figure = [&](const char* name, const LayeredBody& body, double speed, const std::vector<double>& depths) {
    constexpr double longest_time = 4.3; // of the polymer's substrate, retarded
    report.bounded(name, "{:.1e}", interior_error(body, speed, speed * longest_time, depths), "<= 1e-7");
  };
  figure("a stiff skin of 0.05 on a soft layer", skin, 0, {0.05, 0.2, 0.45, 0.7});
  figure("incompressible, h = 0.2 on a rigid core", roller, 0, {0.1, 0.2});
  figure("two layers with a bond ten thousand times softer", bond, 0, {0.1, 0.2, 0.23, 0.5, 1});
  figure("viscoelastic, h = 0.5, V = 0.05", polymer, 0.05, {0.3, 0.5, 0.7});
  figure("viscoelastic, h = 0.5, V = 0.5", polymer, 0.5, {0.5, 0.7});
  report.bounded("20 random stacks, moduli over six decades", "{:.1e}", random_interior_error(20), "<= 1e-7");
  report.bounded("jump of tractions between the stiff skin and below", "{:.1e}", interface_error(skin), "<= 1e-7");
  report.bounded("  between the layers with a soft bond", "{:.1e}", interface_error(bond), "<= 1e-7");
}

/// Influence of an element of the side 1 on itself, of a thin layer on a rigid core, beside that of springs: h (1 - 2
/// nu)/(2 G (1 - nu)) inwards and h/G along the surface. Differences over the larger one, h/G.
double difference_from_springs(double thickness, double nu) {
  const LayeredBody body = {{{thickness, {{1, nu}}}}, {rigid}};
  const Influence a = LayeredInfluence({rigid_body, body}, {1, 1}, 1, 1).at(0, 0);
  return std::max(std::abs(a.xx / thickness - 1), std::abs(a.zz / thickness - (1 - 2 * nu) / (2 * (1 - nu))));
}

void report_thin_influence(Report& report) {
  report.heading(
      "Influence on itself of an element on a thin layer on a rigid core: differences from springs, over h/G");
  for (const double nu : {0.3, 0.5})
    for (const double thickness : {0.01, 1e-3})
      report.bounded(fmt::format("nu = {}, h = dx/{:.0f}", nu, 1 / thickness), "{:.1e}",
                     difference_from_springs(thickness, nu), "<= 1e-7");
}

/// Square elements around the origin, an odd number along each side.
ElementGrid square(double half_side, int n) {
  const double d = 2 * half_side / n;
  return {n, n, -(n - 1) * d / 2, -(n - 1) * d / 2, d, d};
}

/// A rigid sphere on a layered body, pressed by a force.
ContactStep sphere_on(const LayeredBody& body, const ElementGrid& grid, double radius, double force) {
  ContactStep step;
  step.grid = grid;
  step.bodies = combine(rigid, body.substrate.is_rigid() ? body.top().instantaneous : body.substrate.instantaneous);
  step.response.table = layered_table({rigid_body, body}, grid);
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i)
      step.gap.push_back((grid.x(i) * grid.x(i) + grid.y(j) * grid.y(j)) / (2 * radius));
  step.load = {NormalLoad::Given::force, force};
  step.motion.tolerance = 1e-8;
  return step;
}

/// The radius at which the squared pressure, a smooth function of the squared distance from the middle, falls to zero:
/// by the straight line of least squares through the elements with a tenth to four tenths of the largest pressure.
double contact_radius(const ElementGrid& grid, const std::vector<double>& pressure, double peak) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) {
      const double share = pressure[static_cast<std::size_t>(j) * grid.mx + i] / peak, squared = share * share;
      if (share < 0.1 || share > 0.4) continue;
      const double distance = grid.x(i) * grid.x(i) + grid.y(j) * grid.y(j);
      n += 1, x += distance, y += squared, xx += distance * distance, xy += distance * squared;
    }
  const double slope = (n * xy - x * y) / (n * xx - x * x);
  return std::sqrt((x - y / slope) / n);
}

/// Yu, Wang & Wang (2014), figure 6: two layers of half the radius of contact on steel, of other Young's moduli.
void report_coated_sphere(Report& report, const char* name, double surface, double below, double peak, double radius,
                          double half_side) {
  constexpr double a0 = 1e-3, sphere = 0.2, young = 210e9, nu = 0.3;
  const double force = 4.0 / 3 * young / (1 - nu * nu) * std::pow(a0, 3) / sphere;
  const double p0 = 1.5 * force / (std::numbers::pi * a0 * a0);
  const auto layer = [](double share) { return BodyLayer{a0 / 2, {Material::from_young(share * young, nu)}}; };
  const LayeredBody body = {{layer(surface), layer(below)}, {steel}};
  ContactStep step = sphere_on(body, square(half_side * a0, 201), sphere, force);
  step.frictionless = true;
  const ContactStepSolution s = ContactSequence().solve(step);
  const double found = s.totals.peak_pressure / p0;
  if (peak > 0)
    report.near(fmt::format("{}: largest pressure [p0]", name), "{:.4f}", found, "{:.3f}", peak, 5e-3 * peak);
  else
    report.remark(fmt::format("{}: largest pressure [p0]", name), fmt::format("{:.4f}", found), "almost 2", "in words");
  report.near("  radius of contact [a0]", "{:.4f}",
              contact_radius(step.grid, s.normal.pressure, s.totals.peak_pressure) / a0, "{:.3f}", radius,
              5e-3 * radius);
}

/// A sphere's pressure on two equal layers, whose largest von Mises stress Hertz's theory has, and on others.
void report_peaks(Report& report) {
  report.heading("Largest stresses under a rigid sphere on two layers of a0/2 on steel, 48 x 48 elements");
  constexpr double a0 = 1e-3, sphere = 0.2, young = 210e9, nu = 0.3;
  const double force = 4.0 / 3 * young / (1 - nu * nu) * std::pow(a0, 3) / sphere;
  const double p0 = 1.5 * force / (std::numbers::pi * a0 * a0);
  const auto peaks_on = [&](double surface, double below, double half_side) {
    const auto layer = [](double share) { return BodyLayer{a0 / 2, {Material::from_young(share * young, nu)}}; };
    const LayeredBody body = {{layer(surface), layer(below)}, {steel}};
    ContactStep step = sphere_on(body, square(half_side * a0, 48), sphere, force);
    step.frictionless = true;
    const ContactStepSolution s = ContactSequence().solve(step);
    return layered_peaks({rigid_body, body}, step.grid, {{}, {}, s.normal.pressure});
  };
  const LayeredPeaks equal = peaks_on(1, 1, 1.2);
  report.near("E and E: von Mises in the layer of the maximum [p0]", "{:.4f}", equal.layers[0].von_mises / p0, "{:.3f}",
              0.620, 2e-3);
  report.near("  in the depth [a0]", "{:.3f}", equal.layers[0].place.depth / a0, "{:.3f}", 0.481, 5e-3);
  const auto lines = [&](const char* name, const LayeredPeaks& peaks) {
    for (const LayerPeak& peak : peaks.layers)
      report.line(fmt::format("  {}: von Mises in layer {} {:.3f} p0, in the depth {:.3f} a0", name, peak.layer,
                              peak.von_mises / p0, peak.place.depth / a0));
    for (const InterfacePeak& peak : peaks.interfaces)
      report.line(fmt::format("  {}: below layer {} shear {:.3f} p0, tension {:.4f} p0", name, peak.layer,
                              peak.shear / p0, peak.tension / p0));
  };
  lines("E/4 on E/2", peaks_on(0.25, 0.5, 1.6));
  lines("4 E on 2 E", peaks_on(4, 2, 0.9));
}

/// Slope of the force on a ball by the longitudinal creepage, nearly without slip, on an elastic layer on a rigid core;
/// over that on a bed of springs with the flexibility h/G, 8 a^3 G/(3 h).
double slope_over_springs(Report& report, double thickness_over_a) {
  const Material layer = {1e9, 0.3};
  constexpr double a = 4e-3, sphere = 1, creepage = 1e-4;
  const double thickness = thickness_over_a * a;
  ContactStep step = sphere_on({{{thickness, {layer}}}, {rigid}}, square(1.15 * a, 47), sphere, 0);
  step.load = {NormalLoad::Given::approach, a * a / (2 * sphere)};
  step.friction = {FrictionLaw::coulomb(10)};
  ContactSequence sequence;
  double difference = 0, radius = 0;
  for (const double sign : {1.0, -1.0}) { // the pressure displaces the surface along it, too
    step.motion.creepage = {sign * creepage, 0, 0};
    const ContactStepSolution s = sequence.solve(step);
    if (s.report.status != Status::ok) report.figure("  status", to_string(s.report.status), "ok", false);
    difference -= sign * s.totals.fx;
    radius = std::sqrt(s.contact_elements * step.grid.element_area() / std::numbers::pi);
  }
  return difference / (2 * creepage) / (8 * std::pow(radius, 3) * layer.shear_modulus / (3 * thickness));
}

void report_thin_layers(Report& report) {
  report.heading("Steady rolling on a layer on a rigid core: slope of the force over that on a bed of springs");
  double before = 0, here = 0;
  for (const double thickness : {0.2, 0.1, 0.05}) {
    before = std::exchange(here, slope_over_springs(report, thickness));
    report.line(fmt::format("  h = {} a                                                 {:.4f}", thickness, here));
  }
  report.near("of no thickness, extrapolated", "{:.4f}", 2 * here - before, "1", 1e-2);
}

/// A ball that rolls without friction on a viscoelastic layer of half the radius of contact, with the approach given.
ContactStepSolution roll_on_polymer(const ElementGrid& grid, const ViscoelasticMaterial& layer, double speed) {
  const LayeredBody body = {{{0.5e-3, layer}}, {steel}};
  ContactStep step = sphere_on({{{0.5e-3, {layer.instantaneous}}}, {steel}}, grid, 0.1, 200);
  step.response.table = layered_table({rigid_body, body, speed}, grid);
  step.frictionless = true;
  return ContactSequence().solve(step);
}

/// How far ahead of the middle the pressure's resultant lies [m].
double lead_of(const ElementGrid& grid, const ContactStepSolution& s) {
  double moment = 0;
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i)
      moment += s.normal.pressure[static_cast<std::size_t>(j) * grid.mx + i] * grid.x(i);
  return moment * grid.element_area() / s.normal_force;
}

void report_viscoelastic_layer(Report& report) {
  report.heading("A ball on a viscoelastic layer of 0.5 mm on steel, G = 1 GPa, relaxed 0.4 GPa, two relaxation times");
  const PronySeries series = {{0.4, 1e-3}, {0.2, 1e-2}};
  const ViscoelasticMaterial polymer = {{1e9, 0.4}, series}, relaxed = {{0.4e9, 0.4}}, instantaneous = {{1e9, 0.4}};
  const ElementGrid grid = square(2.2e-3, 45);
  const double soft = roll_on_polymer(grid, relaxed, 1).normal.approach,
               stiff = roll_on_polymer(grid, instantaneous, 1).normal.approach;
  const auto figure = [&](double speed, const char* name, double limit) {
    const double approach = roll_on_polymer(grid, polymer, speed).normal.approach;
    report.near(fmt::format("V = {} m/s: approach over that {}", speed, name), "{:.5f}", approach / limit, "1", 1e-3);
  };
  figure(1e-6, "relaxed", soft);
  figure(1e5, "of stiff layers", stiff);
  for (const double speed : {0.01, 0.1, 1.0, 10.0}) {
    const ContactStepSolution s = roll_on_polymer(grid, polymer, speed);
    report.line(fmt::format("  V = {:5} m/s: approach {:.4f} mm, the pressure's resultant lies {:.4f} mm ahead", speed,
                            1e3 * s.approach, 1e3 * lead_of(grid, s)));
  }
}

/// A thin layer that relaxes by one term, as springs side by side.
struct ViscoelasticSprings {
  double stiffness, share, length; ///< M0/h [Pa/m], M0 the modulus without lateral strain; g; V tau [m]

  /// Pressure [Pa] at x behind the front edge x = a of a row pressed in by (a^2 - x^2)/(2 R): the integral of
  /// M(time)/h over what each particle was pressed in.
  double pressure(double x, double a, double radius) const {
    const double l = length, remembered = l * (x + l) - l * (a + l) * std::exp(-(a - x) / l);
    return stiffness * ((1 - share) * (a * a - x * x) / 2 + share * remembered) / radius;
  }
};

struct BallOnLayer {
  double force, lead; ///< [N]; how far ahead of the middle it acts [m]
};

/// A ball pressed in by a^2/(2 R).
BallOnLayer ball_on_springs(const ViscoelasticSprings& springs, double a, double radius) {
  constexpr int n = 1000;
  double force = 0, moment = 0;
  const double d = 2 * a / n;
  for (int j = 0; j < n; ++j) {
    const double y = (j + 0.5) * d - a, front = std::sqrt(a * a - y * y), dx = 2 * front / n;
    for (int i = 0; i < n; ++i) {
      const double x = front - (i + 0.5) * dx, p = springs.pressure(x, front, radius);
      if (p <= 0) break; // the particle has left the ball
      force += p * dx * d, moment += p * dx * d * x;
    }
  }
  return {force, moment / force};
}

void report_thin_viscoelastic_layers(Report& report) {
  report.heading("Rolling without friction on thin viscoelastic layers on a rigid core, V tau = a: over springs");
  constexpr double a = 4e-3, radius = 1, speed = 2, share = 0.6, nu = 0.3;
  const ViscoelasticMaterial material = {{1e9, nu}, {{share, a / speed}}};
  const double modulus = material.instantaneous.shear_modulus * 2 * (1 - nu) / (1 - 2 * nu);
  BallOnLayer before{}, here{};
  for (const double thickness : {0.2, 0.1, 0.05}) {
    const double h = thickness * a;
    const BallOnLayer springs = ball_on_springs({modulus / h, share, a}, a, radius);
    ContactStep step = sphere_on({{{h, {material.instantaneous}}}, {rigid}}, square(1.15 * a, 93), radius, 0);
    step.load = {NormalLoad::Given::approach, a * a / (2 * radius)};
    step.response.table = layered_table({rigid_body, {{{h, material}}, {rigid}}, speed}, step.grid);
    step.frictionless = true;
    const ContactStepSolution s = ContactSequence().solve(step);
    if (s.report.status != Status::ok) report.figure("  status", to_string(s.report.status), "ok", false);
    before = std::exchange(here, {s.normal_force / springs.force, lead_of(step.grid, s) / springs.lead});
    report.line(
        fmt::format("  h = {:4} a: force {:.4f}, how far ahead it acts {:.4f}", thickness, here.force, here.lead));
  }
  report.near("of no thickness, extrapolated: force", "{:.4f}", 2 * here.force - before.force, "1", 1e-2);
  report.near("  how far ahead it acts: the rolling resistance", "{:.4f}", 2 * here.lead - before.lead, "1", 1e-2);
}

} // namespace

bool run_layers(const StudyOptions& options, std::ostream& out) {
  Report report(out, options.figures);
  report_responses(report);
  report_influence(report);
  report_inside(report);
  report_thin_influence(report);
  report.heading("A rigid sphere on two layers of a0/2 on steel, 201 x 201 elements: computed, published");
  report_coated_sphere(report, "E and E", 1, 1, 1, 1, 1.1);
  report_coated_sphere(report, "E/4 on E/2", 0.25, 0.5, 0.582, 1.373, 1.5);
  report_coated_sphere(report, "4 E on 2 E", 4, 2, 0, 0.695, 0.8);
  report_peaks(report);
  if (options.progress && !options.progress(0.05)) return false;
  report_thin_layers(report);
  if (options.progress && !options.progress(0.06)) return false;
  report_viscoelastic_layer(report);
  report_thin_viscoelastic_layers(report);
  report_rollers(report);
  report_layered_cost(report);
  report_energy(report);
  try {
    report_layered_accuracy(report, part(options.progress, 0.06, 0.1));
    report_random_contacts(report, part(options.progress, 0.1, 1));
  } catch (const Stopped&) {
    return false;
  }
  return report.all_as_stated();
}

} // namespace microslip::validation
