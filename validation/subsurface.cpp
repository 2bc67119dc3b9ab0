#include "validation/studies.hpp"

#include "io/output_file.hpp"
#include "io/result_file.hpp"
#include "microslip/interior/interior_peak.hpp"
#include "validation/clock.hpp"
#include "validation/hertzian_solve.hpp"
#include "validation/hertzian_stress.hpp"
#include "validation/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

using Values = std::vector<double>;

/// The largest difference of two stress tensors' components.
double difference(const Stress& a, const Stress& b) {
  return std::max({std::abs(a.xx - b.xx), std::abs(a.yy - b.yy), std::abs(a.zz - b.zz), std::abs(a.xy - b.xy),
                   std::abs(a.xz - b.xz), std::abs(a.yz - b.yz)});
}

// --- CONTACT's example

constexpr int columns = 8;
/// What CONTACT prints below the square's middle: z, then ux, uz, hydrostatic and von Mises' stress, xx, yy, zz, xz.
struct PrintedRow {
  double depth;
  std::array<double, columns> values;
};
constexpr PrintedRow printed[] = {
    {0, {.482073, .403982, -.853264, 1.74426, -.779815, -.779977, -1.000000, -.998999}},
    {0.1, {.383274, .379552, -.702110, 1.34868, -.555944, -.556100, -.994287, -.736402}},
    {0.2, {.307159, .351264, -.564562, 1.06686, -.366593, -.366719, -.960374, -.511760}},
    {0.5, {.175332, .265146, -.284416, .676093, -.076184, -.076223, -.700842, -.149363}},
    {1.0, {.094955, .170498, -.109379, .342630, .003977, .003971, -.336086, -.024183}},
    {2.5, {.038692, .075855, -.020899, .076086, .004458, .004458, -.071611, -.000927}},
    {5.0, {.019385, .038600, -.005379, .020110, .001325, .001324, -.018785, -.000062}},
};
/// A unit square with pn = 1 and px = 0.999, G = 1, seen a little beside its middle.
std::array<double, columns> below_square(double depth) {
  constexpr double pn = 1, px = 0.999;
  const ElementGrid square{1, 1, 1e-4, 2e-4, 1, 1};
  const InteriorField field({1, 0.28}, Body::first, square, {{&px, 1}, {}, {&pn, 1}});
  const InteriorState s = field.at({1e-5, 1e-5, depth});
  return {s.ux, s.uz, hydrostatic(s.stress), von_mises(s.stress), s.stress.xx, s.stress.yy, s.stress.zz, s.stress.xz};
}

void compare_with_contact(Report& report) {
  report.heading(
      "CONTACT's example, pressure 1 and traction 0.999 on a unit square: G = 1, nu = 0.28, below its middle");
  report.line("   z          ux          uz  hydrostatic  von Mises          xx          yy          zz          xz");
  double worst = 0;
  for (const PrintedRow& row : printed) {
    const auto values = below_square(row.depth);
    std::string line = fmt::format("{:4.1f}", row.depth);
    for (int c = 0; c < columns; ++c) {
      line += fmt::format("  {:>+10.6f}", values[c]);
      const double digit = std::abs(row.values[c]) >= 1 ? 1e-5 : 1e-6;
      worst = std::max(worst, std::abs(values[c] - row.values[c]) / digit);
    }
    report.line(line);
  }
  report.figure("largest difference in CONTACT's last digit", fmt::format("{:.2f}", worst), "<= 1", worst <= 1.001);
}

// --- Hertz

constexpr Material ball{80e9, 0.3};
constexpr double radius = 1e-3; ///< of the contact

/// A ball on a plane by the normal problem, tractions in units of Hertz's p0.
struct Ball {
  ElementGrid grid;
  Values pn;

  explicit Ball(int across) : grid(ElementGrid::across_ellipse(radius, radius, across, 2)) {
    const CombinedMaterial both = combine(ball, ball);
    const HertzContact exact = hertz_from_ellipse(radius, radius, both, 1000);
    pn = HertzianSolve(both, grid, exact.gap, exact.normal_force).normal().pressure;
    for (double& p : pn) p /= exact.peak_pressure;
  }
  InteriorField field() const { return InteriorField(ball, Body::first, grid, {{}, {}, pn}); }
};

Values evenly(double first, double last, int count) {
  Values all(count);
  for (int k = 0; k < count; ++k) all[k] = first + (last - first) * k / (count - 1);
  return all;
}

/// The largest shear stress on the axis by the closed form: a fine scan.
std::pair<double, double> exact_peak() {
  std::pair<double, double> best{0, 0};
  for (const double z : evenly(0.3, 0.7, 40001))
    if (const double shear = tresca(stress_below_sphere(ball.poisson_ratio, 0, z)) / 2; shear > best.first)
      best = {shear, z};
  return best;
}

void compare_with_hertz(Report& report) {
  report.heading("A ball on a plane, nu = 0.3, pressures from the normal problem; in units of p0 and a");
  report.line("across  largest shear  at depth  largest error on the axis  elsewhere  (from z = 0.1 on)");
  const auto [shear, depth] = exact_peak();
  double found_shear = 0, found_depth = 0, error = 0, before = 0, ratio = 0;
  for (const int across : {12, 24, 48, 96}) {
    const Ball contact(across);
    InteriorLayers layers(contact.field());
    const InteriorPeak peak = find_largest(layers, evenly(0.2 * radius, radius, 9), tresca);
    double on_axis = 0, elsewhere = 0;
    for (const double z : evenly(0.1, 3, 30))
      for (const double x : {0.0, 0.35, 0.7, 1.0, 1.3}) {
        const Stress s = layers.field().at({x * radius, 0, z * radius}).stress;
        double& worst = x == 0 ? on_axis : elsewhere;
        worst = std::max(worst, difference(s, stress_below_sphere(ball.poisson_ratio, x, z)));
      }
    found_shear = peak.value / 2;
    found_depth = peak.point.depth / radius;
    before = error;
    error = on_axis;
    ratio = before / error;
    report.line(fmt::format("{:>6}  {:>13.5f}  {:>8.4f}  {:>25.1e}  {:>9.1e}", across, found_shear, found_depth,
                            on_axis, elsewhere));
  }
  report.near("largest shear stress, textbooks", "{:.4f}", found_shear, "0.31", 0.005);
  report.near("its depth, textbooks", "{:.4f}", found_depth, "0.48", 0.005);
  report.near("largest shear stress, closed form", "{:.5f}", found_shear, "{:.5f}", shear, 1e-4);
  report.near("its depth, closed form", "{:.4f}", found_depth, "{:.4f}", depth, 1e-3);
  report.figure("order of the error on the axis, last halving", fmt::format("{:.2f}", std::log2(ratio)), "2",
                std::log2(ratio) >= 1.5);
}

// --- near the surface

/// Where a point lies in its element.
struct Spot {
  const char* name;
  double off; ///< along x and y, in elements
};
constexpr Spot spots[] = {{"centres", 0}, {"between", 0.25}, {"edges", 0.5}};
constexpr double near_depths[] = {0, 0.1, 0.25, 0.5, 0.75, 1, 2, 4};

/// Errors of von Mises' stress below a ball's exact pressure, and of sigma_xx below a cylinder's exact traction.
struct NearErrors {
  double pressed = 0, pulled = 0;
};

class NearSurface {
public:
  explicit NearSurface(int across)
      : ball_grid_(ElementGrid::across_ellipse(1, 1, across)), line_grid_(ElementGrid::across_line(1, across)),
        ball_(field_of(ball_grid_, false)), line_(field_of(line_grid_, true)) {}

  /// The largest ones within 0.9 a, at a depth [elements].
  NearErrors errors(double depth, const Spot& spot) const {
    NearErrors worst;
    const double size = ball_grid_.dx, off = spot.off * size, y = ball_grid_.y(ball_grid_.my / 2) + off;
    // Closed forms hold below the surface.
    const double z = depth * size, below = std::max(z, 1e-9);
    for (int i = ball_grid_.mx / 2; std::hypot(ball_grid_.x(i) + off, y) <= 0.9; ++i) {
      const double x = ball_grid_.x(i) + off;
      const Stress pressed = stress_below_sphere(ball.poisson_ratio, std::hypot(x, y), below);
      worst.pressed = std::max(worst.pressed, std::abs(von_mises(ball_.at({x, y, z}).stress) - von_mises(pressed)));
      const double pulled = stress_below_pulled_cylinder(ball.poisson_ratio, x, below).xx;
      worst.pulled = std::max(worst.pulled, std::abs(line_.at({x, 0, z}).stress.xx - pulled));
    }
    return worst;
  }

private:
  static InteriorField field_of(const ElementGrid& grid, bool pulled) {
    Values p(grid.count());
    for (std::size_t k = 0; k < p.size(); ++k) {
      const double x = grid.x(static_cast<int>(k % grid.mx)), y = grid.y(static_cast<int>(k / grid.mx));
      p[k] = std::sqrt(std::max(0.0, 1 - x * x - y * y));
    }
    return pulled ? InteriorField(ball, Body::first, grid, {p, {}, {}})
                  : InteriorField(ball, Body::first, grid, {{}, {}, p});
  }

  ElementGrid ball_grid_, line_grid_;
  InteriorField ball_, line_;
};

void measure_near_surface(Report& report) {
  report.heading("Near the surface: 50 elements across, largest errors over p0 within 0.9 a, by depth in elements");
  report.line("         von Mises below a ball, pressed       sigma_xx below a cylinder, pulled");
  std::string head = " depth ";
  for (int twice = 0; twice < 2; ++twice) {
    for (const Spot& spot : spots) head += fmt::format("  {:>8}", spot.name);
    head += "      ";
  }
  report.line(head);
  const NearSurface fields(50);
  NearErrors worst_deep, worst_centre;
  for (const double depth : near_depths) {
    std::string pressed, pulled;
    for (const Spot& spot : spots) {
      const NearErrors e = fields.errors(depth, spot);
      pressed += fmt::format("  {:>8.4f}", e.pressed);
      pulled += fmt::format("  {:>8.4f}", e.pulled);
      for (NearErrors* worst : {depth >= 0.75 ? &worst_deep : nullptr, spot.off == 0 ? &worst_centre : nullptr})
        if (worst != nullptr) *worst = {std::max(worst->pressed, e.pressed), std::max(worst->pulled, e.pulled)};
    }
    report.line(fmt::format("{:6.2f} {}      {}", depth, pressed, pulled));
  }
  report.bounded("from 0.75 elements on, anywhere: von Mises", "{:.4f}", worst_deep.pressed, "<= 0.002");
  report.bounded("from 0.75 elements on, anywhere: sigma_xx", "{:.4f}", worst_deep.pulled, "<= 0.005");
  report.bounded("at centres, at any depth: von Mises", "{:.4f}", worst_centre.pressed, "<= 0.002");
  report.remark("at centres, at any depth: sigma_xx", fmt::format("{:.4f}", worst_centre.pulled), "",
                "first order in the elements' size");
}

// --- cost

void measure_cost(Report& report) {
  report.heading("Cost: px, py and pn on all elements, wall times; sums extrapolated from 300 points");
  report.line("elements      points  a plane by transforms [ms]  us a point  by sums [ms]  largest difference");
  double worst = 0;
  for (const int across : {25, 50, 100, 200}) {
    const auto grid = ElementGrid::across_ellipse(radius, radius, across);
    Values p(grid.count());
    for (std::size_t k = 0; k < p.size(); ++k) p[k] = std::sin(double(k));
    InteriorLayers layers(InteriorField(ball, Body::first, grid, {p, p, p}));
    std::vector<InteriorState> plane;
    const double depth = 0.3 * radius, transforms = seconds([&] { plane = layers.at_depth(depth); });
    std::vector<InteriorPoint> sample;
    std::vector<std::size_t> index;
    for (std::size_t k = 0; k < grid.count(); k += std::max<std::size_t>(1, grid.count() / 300)) {
      index.push_back(k);
      sample.push_back({grid.x(static_cast<int>(k % grid.mx)), grid.y(static_cast<int>(k / grid.mx)), depth});
    }
    std::vector<InteriorState> sums;
    const double direct =
        seconds([&] { sums = layers.field().at(sample); }) * double(grid.count()) / double(index.size());
    double most = 0;
    for (std::size_t k = 0; k < index.size(); ++k)
      most = std::max(most, difference(sums[k].stress, plane[index[k]].stress));
    worst = std::max(worst, most);
    report.line(fmt::format("{:>8}  {:>10}  {:>26.1f}  {:>10.1f}  {:>12.0f}  {:>18.1e}", grid.count(), grid.count(),
                            1e3 * transforms, 1e6 * transforms / double(grid.count()), 1e3 * direct, most));
  }
  report.bounded("largest difference of both, tractions of size 1", "{:.1e}", worst, "<= 1e-12");
}

// --- wheel and rail

constexpr Material steel{82e9, 0.28};
constexpr double semi_axis_a = 6e-3, semi_axis_b = 4e-3, friction = 0.4;
constexpr int wheel_elements = 49, section_margin = 13;

struct RollingCase {
  std::string group, name;
  double traction; ///< Fx over mu Fn on the wheel, which drives
};
const std::array<RollingCase, 3> rolling_cases = {
    {{"free", "no traction", 0}, {"partial", "partial slip", 0.7}, {"full", "full sliding", 1}}};

/// Von Mises' stress over p0 in a body: in the plane y = 0, index depth, x, and the largest one.
struct BodyOutcome {
  Values section;
  InteriorPeak peak;
  double at_surface = 0; ///< the largest one at the elements' centres
};
struct RollingOutcome {
  BodyOutcome wheel, rail;
};

struct Section {
  Values x, depth;

  Section() = default; ///< no points
  explicit Section(const ElementGrid& grid) {
    for (int i = -section_margin; i < grid.mx + section_margin; ++i) x.push_back(grid.x(i));
    const double step = 0.75 * grid.dx;
    for (int k = 0; k * step <= 1.5 * semi_axis_a; ++k) depth.push_back(k * step);
  }
  std::vector<InteriorPoint> points() const {
    std::vector<InteriorPoint> all;
    for (const double z : depth)
      for (const double at : x) all.push_back({at, 0, z});
    return all;
  }
};

Values von_mises_of(const std::vector<InteriorState>& states) {
  Values values;
  for (const InteriorState& s : states) values.push_back(von_mises(s.stress));
  return values;
}

BodyOutcome inside(Body body, const ElementGrid& grid, const SurfaceTractions& tractions, const Section& section) {
  InteriorLayers layers(InteriorField(steel, body, grid, tractions));
  BodyOutcome outcome;
  outcome.section = von_mises_of(layers.field().at(section.points()));
  outcome.peak = find_largest(layers, evenly(0.75 * grid.dx, semi_axis_b, 12), von_mises);
  for (const double value : von_mises_of(layers.at_depth(0))) outcome.at_surface = std::max(outcome.at_surface, value);
  return outcome;
}

RollingOutcome below_rolling(HertzianSolve& contact, double p0, const RollingCase& rolling, const Section& section) {
  Values pn = contact.normal().pressure, px(pn.size()), py(pn.size());
  if (rolling.traction == 1) {
    px = contact.bound(friction);
  } else if (rolling.traction > 0) {
    TangentialInput input;
    input.force_x = rolling.traction * friction * contact.normal().normal_force;
    const ContactSolution s = contact.solve(friction, input);
    px = s.fields.traction.x;
    py = s.fields.traction.y;
  }
  for (Values* p : {&px, &py, &pn})
    for (double& value : *p) value /= p0;
  const SurfaceTractions tractions{px, py, pn};
  return {inside(Body::first, contact.grid(), tractions, section),
          inside(Body::second, contact.grid(), tractions, section)};
}

void report_rolling(Report& report, const std::vector<RollingOutcome>& outcomes) {
  report.heading("Driving wheel, a = 6 mm, b = 4 mm, mu = 0.4, 49 elements across: von Mises in units of p0");
  report.line("case          Fx/(mu Fn)  body   largest   at x, y, depth [b]        at the surface, centres");
  for (std::size_t c = 0; c < outcomes.size(); ++c)
    for (const auto& [name, body] : {std::pair{"wheel", &outcomes[c].wheel}, {"rail", &outcomes[c].rail}}) {
      const InteriorPoint& at = body->peak.point;
      report.line(fmt::format("{:<12}  {:>10.1f}  {:<5}  {:>7.4f}   {:>+7.3f} {:>+7.3f} {:>7.3f}  {:>7.4f}",
                              rolling_cases[c].name, rolling_cases[c].traction, name, body->peak.value,
                              at.x / semi_axis_b, at.y / semi_axis_b, at.depth / semi_axis_b, body->at_surface));
    }
}

/// How the largest values settle as the elements become smaller. Full sliding, with Hertz's pressure.
void report_refinement(Report& report) {
  report.heading("The same, full sliding, by elements across");
  report.line("across  largest   at x, depth [b]   at the surface, centres");
  for (const int across : {25, 49, 97}) {
    const auto grid = ElementGrid::across_ellipse(semi_axis_a, semi_axis_b, across);
    Values pn(grid.count()), px(grid.count());
    for (std::size_t k = 0; k < pn.size(); ++k) {
      const double x = grid.x(static_cast<int>(k % grid.mx)) / semi_axis_a;
      const double y = grid.y(static_cast<int>(k / grid.mx)) / semi_axis_b;
      pn[k] = std::sqrt(std::max(0.0, 1 - x * x - y * y));
      px[k] = friction * pn[k];
    }
    const BodyOutcome wheel = inside(Body::first, grid, {px, {}, pn}, Section());
    report.line(fmt::format("{:>6}  {:>7.4f}   {:>+7.3f} {:>7.3f}  {:>7.4f}", across, wheel.peak.value,
                            wheel.peak.point.x / semi_axis_b, wheel.peak.point.depth / semi_axis_b, wheel.at_surface));
  }
}

/// With tractions that are even in x one body is the other turned by half a turn about the y axis.
double rail_is_turned_wheel(const RollingOutcome& outcome, const Section& section) {
  double most = 0;
  const std::size_t width = section.x.size();
  for (std::size_t d = 0; d < section.depth.size(); ++d)
    for (std::size_t i = 0; i < width; ++i)
      most = std::max(
          most, std::abs(outcome.rail.section[d * width + i] - outcome.wheel.section[d * width + (width - 1 - i)]));
  return most;
}

void write(const StudyOptions& options, const Section& section, double p0,
           const std::vector<RollingOutcome>& outcomes) {
  io::create_folder(options.output);
  io::ResultFile file(options.output / "subsurface.h5", {.kind = "subsurface",
                                                         .title = "stresses below a rolling contact",
                                                         .command_line = "microslip validate subsurface"});
  file.scalar("a", semi_axis_a, "m", "semi-axis along x");
  file.scalar("b", semi_axis_b, "m", "semi-axis along y");
  file.scalar("peak_pressure", p0, "Pa", "Hertz's p0");
  file.scalar("friction", friction, "-", "mu");
  file.array("x", section.x, "m", "along the rolling direction, y = 0");
  file.array("depth", section.depth, "m", "below the surface of either body");
  for (std::size_t c = 0; c < outcomes.size(); ++c) {
    const std::string group = rolling_cases[c].group + "/";
    file.scalar(group + "traction", rolling_cases[c].traction, "-", "Fx/(mu Fn) on the wheel");
    for (const auto& [name, body] : {std::pair{"wheel", &outcomes[c].wheel}, {"rail", &outcomes[c].rail}}) {
      const InteriorPoint& at = body->peak.point;
      file.array(group + name + "/von_mises", body->section, "-", "over p0, in the plane y = 0",
                 {section.depth.size(), section.x.size()});
      file.scalar(group + name + "/peak", body->peak.value, "-", "the largest over p0, from 0.75 elements down");
      file.array(group + name + "/peak_point", Values{at.x, at.y, at.depth}, "m", "where: x, y, depth");
    }
  }
  file.commit();
}

} // namespace

bool run_subsurface(const StudyOptions& options, std::ostream& out) {
  io::require_writable_folder(options.output);
  Report report(out, options.figures);
  const auto go_on = [&](double fraction) { return !options.progress || options.progress(fraction); };
  compare_with_contact(report);
  compare_with_hertz(report);
  if (!go_on(0.2)) return false;
  measure_near_surface(report);
  measure_cost(report);
  if (!go_on(0.5)) return false;

  const CombinedMaterial both = combine(steel, steel);
  const HertzContact hertz = hertz_from_ellipse(semi_axis_a, semi_axis_b, both, 50e3);
  const auto grid = ElementGrid::across_ellipse(semi_axis_a, semi_axis_b, wheel_elements, 2);
  HertzianSolve contact(both, grid, hertz.gap, hertz.normal_force);
  const Section section(grid);
  std::vector<RollingOutcome> outcomes;
  for (const RollingCase& rolling : rolling_cases) {
    outcomes.push_back(below_rolling(contact, hertz.peak_pressure, rolling, section));
    if (!go_on(0.5 + 0.5 * double(outcomes.size()) / rolling_cases.size())) return false;
  }
  report_rolling(report, outcomes);
  report_refinement(report);
  double turned = 0;
  for (const std::size_t c : {0, 2}) turned = std::max(turned, rail_is_turned_wheel(outcomes[c], section));
  report.bounded("rail less the wheel turned, without and with sliding", "{:.1e}", turned, "<= 1e-8");
  write(options, section, hertz.peak_pressure, outcomes);
  return report.all_as_stated();
}

} // namespace microslip::validation
