#include "io/case_file.hpp"
#include "microslip/error.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

/// Any text is either a case that makes a contact or refused with a message that begins with the file's name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace microslip;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  io::RollingCase input;
  try {
    input = io::parse_case(text, "name");
  } catch (const Error& error) {
    if (!std::string_view(error.what()).starts_with("name:")) std::abort();
    return 0;
  }
  const auto contact = elliptic_contact(input.problem);
  if (!std::isfinite(contact.a * contact.b) || !(contact.normal_force > 0)) std::abort();
  const auto coefficient = contact.friction.static_coefficient();
  if (!(coefficient >= 0 && coefficient <= FrictionLaw::largest_coefficient)) std::abort();
  return 0;
}
