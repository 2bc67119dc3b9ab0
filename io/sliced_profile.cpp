#include "io/sliced_profile.hpp"

#include "microslip/error.hpp"
#include "microslip/railway/profile/profile_slices.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace microslip::io {

namespace {

PreparedProfile read_slice(const std::filesystem::path& slices, const std::string& file,
                           const ProfileFileOptions& options) {
  try {
    return read_profile(file, options);
  } catch (const Error& error) {
    throw Error(slices.string() + ": " + error.what());
  }
}

} // namespace

SlicedProfile read_sliced_profile(const std::filesystem::path& path, ProfileFileOptions options) {
  constexpr double mm = 1e-3;
  SlicesFile file = read_slices(path);
  if (options.role && *options.role != file.role)
    throw Error(path.string() + ": holds slices of a " + std::string(to_string(file.role)));
  options.role = file.role;
  const double unit_of_u = file.role == ProfileRole::wheel ? 1 : mm;
  std::vector<PreparedProfile> prepared;
  std::vector<ProfileSlice> slices;
  for (const SliceEntry& entry : file.slices) {
    prepared.push_back(read_slice(path, entry.file, options));
    slices.push_back({unit_of_u * entry.u, prepared.back().profile, entry.features});
    for (double& feature : slices.back().features)
      if (feature > 0) feature *= mm;
  }
  SliceOptions joined{file.method, file.kinks, file.waves};
  for (ProfileWave& wave : joined.waves) {
    wave.amplitude *= -mm; // z is positive downwards in the file
    wave.wavenumber /= unit_of_u;
  }
  try {
    return {std::move(file), std::move(prepared), join_slices(slices, joined)};
  } catch (const Error& error) {
    throw Error(path.string() + ": " + error.what());
  }
}

void require_one_section(const ProfileReport& report, const std::shared_ptr<const ProfileSurface>& surface,
                         std::string_view what) {
  if (surface)
    throw Error(report.source + ": " + std::string(what) +
                " needs the same profile all along, not slices of one that varies");
}

PlacedProfile read_placed_profile(const std::filesystem::path& path, const ProfileFileOptions& options) {
  if (!names_slices(path)) return {read_profile(path, options), {}};
  SlicedProfile sliced = read_sliced_profile(path, options);
  PlacedProfile profile{std::move(sliced.slices.front()),
                        std::make_shared<const ProfileSurface>(std::move(sliced.surface))};
  profile.report.source = path.string();
  profile.report.warnings.insert(profile.report.warnings.begin(), sliced.file.warnings.begin(),
                                 sliced.file.warnings.end());
  for (const PreparedProfile& slice : sliced.slices)
    for (const std::string& warning : slice.report.warnings)
      if (auto& all = profile.report.warnings; std::find(all.begin(), all.end(), warning) == all.end())
        all.push_back(warning);
  return profile;
}

const PlacedProfile& ProfileFiles::get(const std::filesystem::path& path, const ProfileFileOptions& options) {
  constexpr std::size_t most = 4; // of both sides
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const Entry& e) { return e.path == path && e.options == options; });
  if (found != entries_.end())
    std::rotate(found, found + 1, entries_.end());
  else
    entries_.push_back({path, options, read_placed_profile(path, options)});
  if (entries_.size() > most) entries_.erase(entries_.begin());
  return entries_.back().profile;
}

} // namespace microslip::io
