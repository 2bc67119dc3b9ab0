#pragma once

#include "microslip/railway/profile/profile_surface.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace microslip::io {

/// A slice that a file names.
struct SliceEntry {
  double u = 0;     ///< along the track [mm], or around the wheel [rad], with the file's offset and scale
  std::string file; ///< its profile's, with the folder of the slices' file
  /// Distances [mm] of the features from the beginning of its profile's file, < 0 where it lacks them; empty if the
  /// file has none.
  std::vector<double> features = {};
};

/// A file of the program CONTACT that makes a profile vary by slices: `.slcs` of a rail along the track, `.slcw` of a
/// wheel around its axle.
struct SlicesFile {
  ProfileRole role = ProfileRole::rail;
  std::vector<SliceEntry> slices;
  SliceMethod method = SliceMethod::interpolating;
  std::vector<int> kinks = {}, accelerations = {}; ///< features, from 0, where direction or curvature may jump
  std::vector<ProfileWave> waves = {};             ///< amplitudes in mm, wavenumbers in rad/mm or orders
  std::vector<std::string> warnings = {};          ///< of what it leaves out

  std::size_t features() const { return slices.front().features.size(); }
};

/// Returns whether a name ends in .slcs or .slcw.
bool names_slices(const std::filesystem::path& path);

/// Reads the text of a slices file; `path` is that of the file, for the role, the folder of the slices and messages.
/// Throws Error with file, line, field, value and range.
SlicesFile parse_slices(std::string_view text, const std::filesystem::path& path);

/// Reads a file of at most 16 MiB. The profiles that it names are not opened.
SlicesFile read_slices(const std::filesystem::path& path);

} // namespace microslip::io
