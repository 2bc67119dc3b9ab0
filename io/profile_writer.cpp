#include "io/profile_writer.hpp"

#include "io/profile_formats.hpp"
#include "microslip/decimal.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <string_view>

namespace microslip::io {
namespace {

/// Rows of y and z [mm], with these signs.
std::string rows(const PreparedProfile& prepared, double y_sign, double z_sign, std::string_view separator) {
  std::string text;
  for (const auto& p : prepared.points)
    text.append(shortest_text(y_sign * p.y * 1e3))
        .append(separator)
        .append(shortest_text(z_sign * p.z * 1e3))
        .append("\n");
  return text;
}

std::string on_one_line(std::string text, std::string_view without = "") {
  std::replace_if(
      text.begin(), text.end(),
      [&](char c) { return c == '\n' || c == '\r' || c == '\0' || without.find(c) != std::string_view::npos; }, ' ');
  return text;
}

std::string simpack_text(const PreparedProfile& prepared) {
  return "header.begin\n  version = 1\n  type    = " +
         std::string(prepared.profile.role() == ProfileRole::rail ? "0" : "1") +
         "\nheader.end\nspline.begin\n  comment     = '" + on_one_line(prepared.report.comment, "'\"") +
         "'\n  units.len.f = 1000\n  units.ang.f = 1\n  point.begin\n" + rows(prepared, 1, -1, " ") +
         "  point.end\nspline.end\n";
}

std::string miniprof_text(const PreparedProfile& prepared) {
  const bool is_rail = prepared.profile.role() == ProfileRole::rail;
  const auto count = std::to_string(prepared.points.size());
  return "ProgramName=microslip\nComment=" + on_one_line(prepared.report.comment, "\"!%") + "\n" +
         (is_rail ? "RailGaugePoint=14\n" : "WheelDiameterTaperline=70\n") + "XOffset=0\nYOffset=0\nXYPoints=" + count +
         "\nColumnDef=X,Y\n\n" + rows(prepared, is_rail ? -1 : 1, -1, " ");
}

std::string columns_text(const PreparedProfile& prepared) {
  return "# " + on_one_line(prepared.report.comment) + "\n# " + std::string(to_string(prepared.profile.role())) +
         ": y [mm] to the field side, z [mm] up\n" + rows(prepared, 1, 1, " ");
}

} // namespace

std::string profile_text(const PreparedProfile& profile, ProfileFormat format) {
  switch (format) {
  case ProfileFormat::simpack:
    return simpack_text(profile);
  case ProfileFormat::miniprof:
    return miniprof_text(profile);
  case ProfileFormat::columns:
    break;
  }
  return columns_text(profile);
}

ProfileFormat format_of_ending(const std::filesystem::path& path, ProfileRole role) {
  struct Ending {
    std::string_view text;
    ProfileRole role;
    ProfileFormat format;
  };
  constexpr auto endings = std::to_array<Ending>({{".prr", ProfileRole::rail, ProfileFormat::simpack},
                                                  {".prw", ProfileRole::wheel, ProfileFormat::simpack},
                                                  {".ban", ProfileRole::rail, ProfileFormat::miniprof},
                                                  {".whl", ProfileRole::wheel, ProfileFormat::miniprof}});
  const auto ending = lower_case(path.extension().string());
  for (const auto& known : endings) {
    if (ending != known.text) continue;
    if (known.role != role)
      throw Error(path.string() + ": " + std::string(known.text) + " is for the profile of a " +
                  std::string(to_string(known.role)) + ", this is a " + std::string(to_string(role)));
    return known.format;
  }
  return ProfileFormat::columns;
}

} // namespace microslip::io
