#include "app/contact_tables.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

namespace microslip::app {
namespace {

using contact_program::Case;
using contact_program::Outcome;

/// Names above values.
class Lines {
public:
  void add(const std::string& name, const std::string& value) {
    const auto width = std::max<std::size_t>(12, std::max(name.size(), value.size()) + 2);
    names_ += fmt::format("{:>{}}", name, width);
    values_ += fmt::format("{:>{}}", value, width);
  }
  void add(const std::string& name, double value) { add(name, fmt::format("{:.5g}", value)); }
  void print() const { fmt::print("{}\n{}\n", names_, values_); }

private:
  std::string names_, values_;
};

const char* motion_name(contact_program::Tangential tang) {
  constexpr const char* names[] = {"without friction", "shift", "transient rolling", "steady rolling"};
  return names[number(tang)];
}

std::string with_unit(const std::string& name) {
  return name.starts_with("SHIFT") ? name + " [mm]" : name;
}

/// Prints totals of two bodies in contact, or of a patch of a wheel; `lateral` is the letter of what lies across.
void print_totals(const Case& c, const Outcome& outcome, char lateral) {
  const contact_program::PrintedTotals& t = outcome.totals;
  Lines forces, damping, relative, counts;
  const char* sum = t.integral_fn ? "BAR_" : ""; // over a curved patch
  forces.add(fmt::format("{}FN [N]", sum), t.fn);
  forces.add(fmt::format("{}FX [N]", sum), t.fx);
  forces.add(fmt::format("{}F{} [N]", sum, lateral), t.fy);
  forces.add(lateral == 'S' ? "MN [N mm]" : "MZ [N mm]", t.mz);
  forces.add("ELAST.EN. [J]", t.elastic_energy);
  forces.add(c.digits.rolls() ? "FRIC.POWER [W]" : "FRIC.WORK [J]", t.friction);
  forces.print();
  if (outcome.damping) {
    damping.add("damping: FN [N]", outcome.damping->z);
    damping.add("FX [N]", outcome.damping->x);
    damping.add(fmt::format("F{} [N]", lateral), outcome.damping->y);
    damping.print();
  }
  if (t.integral_fn)
    relative.add("TILDE_FN [N]", *t.integral_fn);
  else
    relative.add("FN/G [mm2]", t.fn_over_g);
  relative.add(with_unit(t.x_name), t.x);
  relative.add(with_unit(t.y_name), t.y);
  relative.add("APPROACH [mm]", t.approach);
  relative.add("PMAX [N/mm2]", t.peak_pressure);
  if (t.temperature) relative.add("MAX(T1,T2)", *t.temperature);
  relative.print();
  counts.add("NPOT", std::to_string(t.potential));
  counts.add("NCON", std::to_string(t.contact));
  counts.add("NADH", std::to_string(t.adhesion));
  counts.add("NSLIP", std::to_string(t.slip));
  if (t.plastic) counts.add("NPLAST", std::to_string(*t.plastic));
  counts.add("residual", fmt::format("{:.1e}", outcome.solution.report.residual));
  counts.add("status", std::string(to_string(outcome.solution.report.status)));
  counts.print();
}

/// Extremes of the stresses at each block of points.
void print_interior(const Outcome& outcome) {
  int number = 0;
  for (const auto& [points, states] : outcome.interior) {
    fmt::print("  points inside the bodies, block {}: {} x {} x {}\n", ++number, points.x.size(), points.y.size(),
               points.z.size());
    for (const auto& [name, value, at] : interior_extremes(states))
      fmt::print("  {:>12} {:>12.5g} N/mm2 at ({:.5g}, {:.5g}, {:.5g}) mm\n", name, value * 1e-6, points.x_of(at) * 1e3,
                 points.y_of(at) * 1e3, points.z_of(at) * 1e3);
  }
}

void print_contact(const Case& c, const Outcome& outcome, char lateral) {
  const ElementGrid& grid = outcome.step.grid;
  fmt::print("{}, {} x {} elements of {:.5g} x {:.5g} mm\n", motion_name(c.digits.tang), grid.mx, grid.my,
             grid.dx * 1e3, grid.dy * 1e3);
  print_totals(c, outcome, lateral);
  print_interior(outcome);
}

std::string in_mm(double length) {
  return fmt::format("{:.4f}", length * 1e3);
}

/// Prints the position of a patch and the bodies' relative motion there.
void print_location(const contact_program::WheelPatch& patch) {
  const auto& [track, rail, wheel, angle, on_rail, on_wheel] = patch.location;
  Lines location, motion;
  location.add("XCP(TR) [mm]", in_mm(track.x));
  location.add("YCP(TR)", in_mm(track.y));
  location.add("ZCP(TR)", in_mm(track.z));
  location.add("DELTCP [rad]", fmt::format("{:.4f}", angle));
  location.add("YCP(R)", in_mm(rail.y));
  location.add("ZCP(R)", in_mm(rail.z));
  location.add("XCP(W)", in_mm(wheel.x));
  location.add("YCP(W)", in_mm(wheel.y));
  location.add("ZCP(W)", in_mm(wheel.z));
  location.print();
  if (!patch.contact.digits.has_friction()) return;
  motion.add("VELOC [mm/s]", patch.contact.rolling->veloc * 1e3);
  motion.add("CKSI", contact_program::in_file(patch.contact.x, patch.contact.digits));
  motion.add("CETA", contact_program::in_file(patch.contact.y, patch.contact.digits));
  motion.add("CPHI [rad/mm]", patch.contact.phi / contact_program::unit_of_spin(patch.contact.digits));
  motion.print();
}

void print_wheel(const Case& c, const Outcome& outcome) {
  const contact_program::WheelOutcome& wheel = *outcome.wheel;
  const auto& digits = c.wheel_rail->digits;
  fmt::print("{} wheel on a {}, {} contact {}\n", digits.is_left() ? "left" : "right",
             digits.is_roller() ? "roller" : "rail", wheel.patches.size(),
             wheel.patches.size() == 1 ? "patch" : "patches");
  Lines totals;
  totals.add("Z_WS [mm]", in_mm(wheel.z));
  totals.add("FX(TR) [N]", wheel.track.force.x);
  totals.add("FY(TR)", wheel.track.force.y);
  totals.add("FZ(TR)", wheel.track.force.z);
  totals.add("FX(WS)", wheel.wheelset.force.x);
  totals.add("FY(WS)", wheel.wheelset.force.y);
  totals.add("FZ(WS)", wheel.wheelset.force.z);
  totals.add("status", std::string(to_string(outcome.solution.report.status)));
  totals.print();
  int number = 0;
  for (const auto& patch : wheel.patches) {
    fmt::print("  patch {}: ", ++number);
    print_contact(patch.contact, *patch.solution, 'S');
    print_location(patch);
  }
}

} // namespace

void print_solution(const Case& c, const Outcome& outcome) {
  if (outcome.wheel)
    print_wheel(c, outcome);
  else
    print_contact(c, outcome, 'Y');
}

} // namespace microslip::app
