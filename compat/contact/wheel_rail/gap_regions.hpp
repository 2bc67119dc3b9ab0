#pragma once

#include "compat/contact/wheel_rail/contact_locus.hpp"

#include <utility>
#include <vector>

namespace microslip::contact_program {

/// A region where wheel and rail overlap [m], seen from above.
struct GapRegion {
  double x0 = 0, x1 = 0; ///< its extent along the track,
  double y0 = 0, y1 = 0; ///< across it,
  double z0 = 0, z1 = 0; ///< and the rail's heights there
  double x = 0, y = 0;   ///< its centre, weighted with the overlap,
  double angle = 0;      ///< and the rail's inclination, weighted so
  double weight = 0;
};

/// The least gap anywhere, and what is there.
struct LeastGap {
  double gap = 0, angle = 0;
  double wheel_height = 0; ///< z of the wheel's surface
  double curvature = 0;    ///< of the rail across the track, half the second derivative [1/m]
};

LeastGap least_gap(const GapLine& line);

/// A place where wheel and rail do not touch, but nearly [m].
struct NearMiss {
  double x = 0, y = 0, gap = 0;
};

/// The local minima of the gap in [0, farthest), the two least at most, as in CONTACT.
std::vector<NearMiss> near_misses(const GapLine& line, double farthest);
/// The same of a grid as in local_minima, with the gap less `depth`: their places.
std::vector<std::pair<int, int>> near_misses(const std::vector<double>& gap, int nx, double depth, double farthest);

/// Points of a grid of nx columns, x fastest, at which the gap is below `depth` and less than at their four neighbours,
/// from the least one on; those of a plateau count once.
std::vector<std::pair<int, int>> local_minima(const std::vector<double>& gap, int nx, double depth);

/// The regions of overlap, from the deepest one on. `curvature` is half that of wheel and roller along the track
/// [1/m].
std::vector<GapRegion> find_regions(const GapLine& line, double curvature);

} // namespace microslip::contact_program
