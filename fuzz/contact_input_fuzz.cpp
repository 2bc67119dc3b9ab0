#include "compat/contact/input.hpp"
#include "compat/contact/out.hpp"
#include "compat/contact/set_up.hpp"
#include "compat/contact/support.hpp"
#include "microslip/error.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>

namespace {

using namespace microslip;
using namespace microslip::contact_program;

bool is_sound(const Vertical& vertical) {
  const auto* position = std::get_if<VerticalPosition>(&vertical);
  return position ? std::isfinite(position->z) : std::get<VerticalForce>(vertical).fz > 0;
}

/// What holds for every wheel on a rail.
bool is_sound(const WheelRailData& d, const FrictionData& friction) {
  const bool has_stations =
      friction.stations.empty() ? friction.sets.size() == 1 : friction.stations.size() == friction.sets.size();
  return has_stations && d.grid.dx > 0 && d.grid.ds > 0 && d.grid.d_comb <= d.grid.d_sep && !d.rail.file.empty() &&
         !d.wheel.file.empty() && d.wheelset.nominal_radius > 0 && d.search != ContactSearch::keep &&
         d.search != ContactSearch::form && is_sound(d.position.vertical);
}

/// What holds for every case that the reader hands out.
bool is_sound(const Case& c) {
  if (!c.material || c.friction.sets.empty() || c.friction.law == Law::keep) return false;
  if (c.wheel_rail) return is_sound(*c.wheel_rail, c.friction);
  if (!c.potential) return false;
  const PotentialContact& p = *c.potential;
  const std::size_t count = static_cast<std::size_t>(p.mx) * static_cast<std::size_t>(p.my);
  const bool has_heights = p.is_hertzian() || c.geometry.base != Base::by_element || c.geometry.values.size() == count;
  const bool has_rolling = !c.digits.rolls() || (c.rolling && c.rolling->dq > 0 && c.rolling->veloc > 0);
  return has_heights && has_rolling && c.friction.law != Law::keep && c.extra != ExtraSlip::keep &&
         std::isfinite(c.load.value) && std::isfinite(number_of(c.x)) && std::isfinite(number_of(c.y)) &&
         std::isfinite(c.phi);
}

/// A case on a small grid is a problem that makes sense, or is refused.
void set_up(const Case& c) {
  constexpr int small = 64;
  if (c.wheel_rail) { // without its profiles nothing can be solved, but what was read can be printed
    if (!unsupported_of_wheel(c).empty()) return;
    Outcome outcome;
    outcome.wheel.emplace();
    try {
      if (!out_text(c, outcome).starts_with("\n Case")) std::abort();
    } catch (const Error&) {
    }
    return;
  }
  if (!unsupported(c).empty() || c.potential->mx > small || c.potential->my > small) return;
  try {
    const ContactStep step = contact_step(c);
    if (step.gap.size() != step.grid.count()) std::abort();
  } catch (const Error&) {
  }
}

} // namespace

/// Any text is either a row of sound cases or refused with a message that begins with the file's name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream stream(std::string(reinterpret_cast<const char*>(data), size));
  try {
    InputReader reader(stream, "name");
    for (int number = 1; const Case* c = reader.next(); ++number) {
      if (c->number != number || !is_sound(*c)) std::abort();
      set_up(*c);
    }
  } catch (const Error& error) {
    if (!std::string_view(error.what()).starts_with("name:")) std::abort();
  }
  return 0;
}
