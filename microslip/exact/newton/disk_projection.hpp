#pragma once

#include <cmath>

namespace microslip {

/// The point of the disk |p| <= radius that is nearest to z is `scale` z.
struct DiskProjection {
  double scale;
  bool outside; ///< z is not on the disk
};

inline DiskProjection project_on_disk(double zx, double zy, double radius) {
  const double size = std::hypot(zx, zy);
  return size > radius ? DiskProjection{radius / size, true} : DiskProjection{1, false};
}

} // namespace microslip
