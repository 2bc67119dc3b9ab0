#include "io/profile_writer.hpp"
#include "microslip/error.hpp"
#include "microslip/railway/profile/profile_dimensions.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

namespace {

using namespace microslip;

void require(bool condition) {
  if (!condition) std::abort();
}

/// What the first byte chooses: the file's name, and options beside it.
struct Choice {
  std::string name;
  io::ProfileFileOptions options;
};

Choice choice_of(std::uint8_t byte) {
  constexpr const char* names[] = {"name.prr", "name.prw",   "name.ban", "name.whl",
                                   "rail",     "name_wheel", "name.mpt", "name"};
  Choice choice{names[byte & 7], {}};
  if ((byte & 8) != 0) choice.options.treatment.smoothing_length = 3e-3;
  if ((byte & 16) != 0) choice.options.section = 2;
  if ((byte & 32) != 0) choice.options.role = ProfileRole::wheel;
  if ((byte & 64) != 0) choice.options.y_axis = io::LateralSense::gauge;
  if ((byte & 128) != 0) choice.options.treatment.y_min = -0.02;
  return choice;
}

void check(const PreparedProfile& prepared) {
  const auto& profile = prepared.profile;
  require(profile.length() > 0 && profile.length() < 10 && prepared.report.points == profile.pieces().size() + 1);
  require(prepared.measured.size() == prepared.report.points && profile.kinks().size() == prepared.report.kinks.size());
  for (const auto& piece : profile.pieces())
    require(std::isfinite(piece.c[3].y) && std::isfinite(piece.c[3].z) && piece.length > 0);
  require(std::isfinite(prepared.report.noise.curvature));
  if (profile.role() == ProfileRole::wheel)
    wheel_dimensions(profile, default_tape_line(profile));
  else
    require(std::isfinite(gauge_point(profile).point.y));
}

} // namespace

/// Any text after a first byte that chooses options is either the file of a sound profile, which can be written and
/// read again, or refused with a message that begins with the file's name or an option.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const auto [name, options] = choice_of(data[0]);
  std::optional<PreparedProfile> prepared;
  try {
    prepared = io::parse_profile({reinterpret_cast<const char*>(data) + 1, size - 1}, name, options);
  } catch (const Error& error) {
    require(std::string_view(error.what()).starts_with(name + ":"));
    return 0;
  }
  check(*prepared);
  const auto role = prepared->profile.role();
  for (const auto format : {io::ProfileFormat::simpack, io::ProfileFormat::columns}) try {
      const auto text = io::profile_text(*prepared, format);
      check(io::parse_profile(text, "again", {.format = format, .role = role, .unit = 1e-3}));
    } catch (const Error& error) { // smoothing may have made it cross itself, and the reader may straighten zig-zags
      require(std::string_view(error.what()).starts_with("again:"));
    }
  return 0;
}
