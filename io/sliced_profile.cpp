#include "io/sliced_profile.hpp"

#include "microslip/error.hpp"
#include "microslip/railway/profile_slices.hpp"

#include <string>

namespace microslip {

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
    prepared.push_back(read_profile(entry.file, options));
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

} // namespace microslip
