#include "app/profile_slices.hpp"

#include "app/command_line.hpp"
#include "app/hertz.hpp"
#include "app/json_document.hpp"
#include "app/pictures.hpp"
#include "app/quantity_table.hpp"
#include "cases/sliced_profile_result.hpp"
#include "io/output_file.hpp"
#include "io/result_file.hpp"
#include "io/sliced_profile.hpp"

#include <algorithm>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace microslip::app {
namespace {

namespace fs = std::filesystem;

/// Unit of the positions along a rail [mm], or around a wheel [deg].
struct Along {
  double scale;
  const char* unit;
};

Along along(const io::SlicesFile& file) {
  return file.role == ProfileRole::wheel ? Along{180 / std::numbers::pi, "deg"} : Along{1, "mm"};
}

/// The highest point of a slice [m].
double top_of(const Profile& profile) {
  double top = profile.at(0).value.z;
  for (const ProfilePiece& piece : profile.pieces()) top = std::max(top, piece.at(piece.start + piece.length).value.z);
  return top;
}

void print_table(const io::SlicedProfile& sliced) {
  const io::SlicesFile& file = sliced.file;
  const auto [scale, unit] = along(file);
  const bool through = file.method == SliceMethod::interpolating;
  QuantityTable table(fmt::format("{} of {} slices, {}", to_string(file.role), file.slices.size(),
                                  through ? "interpolated" : "approximated"));
  table.add("first slice", scale * file.slices.front().u, unit);
  table.add("last slice", scale * file.slices.back().u, unit);
  table.add("features", static_cast<double>(file.features()), "-");
  table.add("lines along the surface", static_cast<double>(sliced.surface.last_v() + 1), "-");
  table.add("least y", sliced.surface.least_y() * 1e3, "mm");
  table.add("greatest y", sliced.surface.greatest_y() * 1e3, "mm");
  table.add("waves", static_cast<double>(file.waves.size()), "-");
  table.print();
}

void print_slices(const io::SlicedProfile& sliced) {
  const auto [scale, unit] = along(sliced.file);
  fmt::print("\n{:>14} {:>7} {:>12} {:>12}  file\n", fmt::format("at [{}]", unit), "points", "length [mm]", "top [mm]");
  for (std::size_t k = 0; k < sliced.slices.size(); ++k) {
    const PreparedProfile& slice = sliced.slices[k];
    fmt::print("{:>14.6g} {:>7} {:>12.6g} {:>12.6g}  {}\n", scale * sliced.file.slices[k].u, slice.points.size(),
               slice.profile.length() * 1e3, top_of(slice.profile) * 1e3,
               fs::path(sliced.file.slices[k].file).filename().string());
  }
}

/// Warnings of slices; those they have in common appear once.
std::vector<std::string> warnings_of(const io::SlicedProfile& sliced) {
  struct Warning {
    std::string text, first;
    int count;
  };
  std::vector<Warning> warnings;
  for (std::size_t k = 0; k < sliced.slices.size(); ++k)
    for (const std::string& text : sliced.slices[k].report.warnings) {
      const auto known =
          std::find_if(warnings.begin(), warnings.end(), [&](const Warning& w) { return w.text == text; });
      if (known != warnings.end())
        ++known->count;
      else
        warnings.push_back({text, fs::path(sliced.file.slices[k].file).filename().string(), 1});
    }
  std::vector<std::string> lines = sliced.file.warnings;
  for (const Warning& w : warnings)
    lines.push_back(fmt::format("{} of {} slices, from {} on: {}", w.count, sliced.slices.size(), w.first, w.text));
  return lines;
}

/// Writes the surface and its picture, if there is a folder for them; returns the paths.
std::vector<std::string> write_files(const SlicesArguments& arguments, const io::SlicedProfile& sliced) {
  if (arguments.folder.empty()) return {};
  const double m = sliced.file.role == ProfileRole::wheel ? 1 : 1e-3;
  std::vector<double> slices;
  for (const io::SliceEntry& slice : sliced.file.slices) slices.push_back(m * slice.u);
  const fs::path path = arguments.folder / io::result_name;
  io::create_folder(arguments.folder);
  io::ResultFile file(path, {.kind = "sliced_profile",
                             .title = arguments.file.filename().string(),
                             .command_line = command_line(),
                             .case_file = arguments.file.string()});
  cases::write_result(sliced.surface, sliced.file.role, slices, file);
  file.commit();
  std::vector<std::string> files = {path.string()};
  if (arguments.no_pictures) return files;
  for (const auto& picture : draw_pictures(path, arguments.folder)) files.push_back(picture);
  return files;
}

void print_document(const fs::path& path, const io::SlicedProfile& sliced, const std::vector<std::string>& files) {
  const io::SlicesFile& file = sliced.file;
  const double mm = file.role == ProfileRole::wheel ? 1 : 1e-3;
  auto document = json_document("sliced_profile");
  document["input"] = path.string();
  document["role"] = to_string(file.role);
  document["method"] = file.method == SliceMethod::interpolating ? "interpolating" : "approximating";
  document["features"] = file.features();
  document["lines"] = sliced.surface.last_v() + 1;
  document["least_y"] = io::json_number(sliced.surface.least_y());
  document["greatest_y"] = io::json_number(sliced.surface.greatest_y());
  auto slices = io::Json::array(), waves = io::Json::array();
  for (std::size_t k = 0; k < sliced.slices.size(); ++k)
    slices.push_back({{"u", io::json_number(mm * file.slices[k].u)},
                      {"file", file.slices[k].file},
                      {"points", sliced.slices[k].points.size()},
                      {"length", io::json_number(sliced.slices[k].profile.length())},
                      {"top", io::json_number(top_of(sliced.slices[k].profile))},
                      {"warnings", sliced.slices[k].report.warnings}});
  for (const ProfileWave& wave : file.waves)
    waves.push_back({{"amplitude", io::json_number(1e-3 * wave.amplitude)},
                     {"wavenumber", io::json_number(wave.wavenumber / mm)},
                     {"phase", io::json_number(wave.phase)}});
  document["slices"] = slices;
  document["waves"] = waves;
  document["warnings"] = file.warnings;
  document["files"] = files;
  const bool is_wheel = file.role == ProfileRole::wheel;
  document["units"] = {{"least_y", "m"},
                       {"greatest_y", "m"},
                       {"slices/u", is_wheel ? "rad" : "m"},
                       {"slices/length", "m"},
                       {"slices/top", "m"},
                       {"waves/amplitude", "m"},
                       {"waves/wavenumber", is_wheel ? "1/rad" : "rad/m"},
                       {"waves/phase", "rad"}};
  print_json(document);
}

} // namespace

void show_slices(const SlicesArguments& arguments) {
  if (!arguments.folder.empty()) io::require_writable_file_in(arguments.folder, io::result_name);
  const io::SlicedProfile sliced = io::read_sliced_profile(arguments.file, arguments.options);
  const std::vector<std::string> files = write_files(arguments, sliced);
  if (arguments.json) return print_document(arguments.file, sliced, files);
  print_table(sliced);
  print_slices(sliced);
  if (!files.empty()) fmt::print("\nWritten\n  {}\n", fmt::join(files, "\n  "));
  print_warnings(arguments.file.string(), warnings_of(sliced));
}

} // namespace microslip::app
