#include "compat/contact/input.hpp"
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

/// What holds for every case that the reader hands out.
bool is_sound(const Case& c) {
  if (!c.unreadable.empty()) return c.number > 0;
  if (!c.material || !c.potential || c.friction.sets.empty()) return false;
  const PotentialContact& p = *c.potential;
  const std::size_t count = static_cast<std::size_t>(p.mx) * static_cast<std::size_t>(p.my);
  const bool has_heights = p.is_hertzian() || c.geometry.base != Base::by_element || c.geometry.values.size() == count;
  const bool has_rolling = !c.digits.rolls() || (c.rolling && c.rolling->dq > 0 && c.rolling->veloc > 0);
  return has_heights && has_rolling && c.friction.law != Law::keep && c.extra != ExtraSlip::keep &&
         std::isfinite(c.normal) && std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.phi);
}

/// A case on a small grid is a problem that makes sense, or is refused.
void set_up(const Case& c) {
  constexpr int small = 64;
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
