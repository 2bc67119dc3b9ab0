#pragma once

#include "io/profile_file.hpp"
#include "io/slices_file.hpp"

#include <filesystem>
#include <memory>
#include <vector>

namespace microslip::io {

/// A profile that varies, of a file of slices, in the axes and units of a Profile.
struct SlicedProfile {
  SlicesFile file;
  std::vector<PreparedProfile> slices;
  ProfileSurface surface; ///< u in m along the track or in rad around the wheel, z up
};

/// Reads the file and the profiles it names, all with these options; their role is the file's. Features count along the
/// profiles as they are after the treatment. Throws Error with the name of the file that is wrong.
SlicedProfile read_sliced_profile(const std::filesystem::path& path, ProfileFileOptions options = {});

/// A profile of any file, by which it is placed; of one of slices the first of them, with the warnings of all, and the
/// surface.
struct PlacedProfile : PreparedProfile {
  std::shared_ptr<const ProfileSurface> surface = {};
};

/// Reads either kind of file, as read_profile and read_sliced_profile do.
PlacedProfile read_placed_profile(const std::filesystem::path& path, const ProfileFileOptions& options = {});

/// Throws Error for a profile with a surface: it varies along the track or around the wheel, and `what` would see its
/// first slice alone.
void require_one_section(const ProfileReport& report, const std::shared_ptr<const ProfileSurface>& surface,
                         std::string_view what);

/// Profiles by file and options, each read once, for a reader that is called again and again. It keeps the last four.
class ProfileFiles {
public:
  /// Throws Error as read_placed_profile.
  const PlacedProfile& get(const std::filesystem::path& path, const ProfileFileOptions& options);

private:
  struct Entry {
    std::filesystem::path path;
    ProfileFileOptions options;
    PlacedProfile profile;
  };
  std::vector<Entry> entries_; ///< the one that was asked for last stands last
};

} // namespace microslip::io
