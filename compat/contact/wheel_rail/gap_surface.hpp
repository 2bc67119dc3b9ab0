#pragma once

#include "compat/contact/wheel_rail/gap_regions.hpp"

#include <utility>
#include <vector>

namespace microslip::contact_program {

/// The gap between wheel and rail over the whole of the wheel's lower side, seen from above: CONTACT's search by brute
/// force, on a grid of 1.5 DX, for wheels that are not round 4 DX, by 0.75 DS, or for steep slopes of 0.3 DS.
class GapSurface {
public:
  /// With the wheelset at Z_WS = 0. `rail` in track coordinates, of slices the first one.
  GapSurface(const Placement& placement, const ProfileCurve& rail, const PatchRules& sizes, bool steep);

  bool overlaps() const { return overlaps_; }
  LeastGap least() const;
  /// With the wheelset lower by `depth` [m], from the deepest one on.
  std::vector<GapRegion> regions(double depth) const;
  /// With the wheelset lower by `depth`: the local minima of the gap in [0, farthest), the two least at most.
  std::vector<NearMiss> near_misses(double depth, double farthest) const;

private:
  struct Box {
    int i0, i1, j0, j1;
    bool holds(int i, int j) const { return i >= i0 && i <= i1 && j >= j0 && j <= j1; }
  };

  double gap(int i, int j) const { return gap_[static_cast<std::size_t>(j) * nx_ + i]; }
  struct RailSample {
    double z, angle; ///< z not below no_gap where there is no rail
  };
  const RailSample& rail_at(int i, int j) const {
    const auto row = static_cast<std::size_t>(j);
    return rail_.size() == y_.size() ? rail_[row] : rail_[static_cast<std::size_t>(i) * y_.size() + row];
  }
  void find_roller(const Placement& placement, const ProfileCurve& rail);
  void find_rail(const Placement& placement, const ProfileCurve& rail);
  Box box_around(int i, int j, double depth) const;
  double rail_height(int i, int beyond, int from) const;
  GapRegion region(const Box& box, int i_least, int j_least, double depth) const;

  int nx_ = 0, ny_ = 0;
  double dx_ = 0; ///< of the elements
  std::vector<double> x_, y_;
  std::vector<RailSample> rail_; ///< over y, and if it varies for each x
  std::vector<double> gap_;      ///< x fastest
  bool overlaps_ = false;
};

} // namespace microslip::contact_program
