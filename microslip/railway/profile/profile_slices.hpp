#pragma once

#include "microslip/railway/profile/profile_surface.hpp"

#include <vector>

namespace microslip {

/// The cross-section of a profile that varies at one position, with the features that it shares with the others: edges,
/// ends of arcs, tips.
struct ProfileSlice {
  double u = 0; ///< along the track, or around a wheel [rad]
  Profile profile;
  /// Distances along the profile, ascending, from the end where its file begins: a rail's gauge side, a wheel's field
  /// side. Those that the slice lacks, at the beginning or at the end of the row, are negative; the last one there is
  /// may lie beyond the profile's end. All slices have equally many, none stands for both ends.
  std::vector<double> features = {};
};

/// Interpolation between slices.
struct SliceOptions {
  SliceMethod method = SliceMethod::interpolating;
  std::vector<int> kinks = {}; ///< features, from 0, along which the surface has an edge
  std::vector<ProfileWave> waves = {};
  double spacing = 0.5e-3; ///< greatest distance of the points at which slices are sampled, in their unit of length
};

/// The surface that joins equal features of successive slices by lines of equal v, with the points in between at equal
/// fractions of the length. Each part between two features gets as many points in all slices as its longest one needs.
/// v ascends as the profiles do, from the gauge side to the field side. Throws Error, which names the slice, for
/// features that are fewer than in other slices, do not ascend or leave nothing between them.
ProfileSurface join_slices(const std::vector<ProfileSlice>& slices, const SliceOptions& options);

} // namespace microslip
