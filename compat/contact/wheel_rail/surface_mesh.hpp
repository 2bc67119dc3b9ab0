#pragma once

#include "microslip/railway/geometry/frame.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace microslip::contact_program {

/// Interpolation of z in a quadrangle of a mesh; its position there is found bilinearly. Bicubic: from values and
/// slopes at the corners, these from the differences of their neighbours (Catmull-Rom).
enum class MeshInterpolation { bilinear, bicubic };

/// A surface given by nx x ny points, x fastest, over which z is interpolated in each of its quadrangles.
class SurfaceMesh {
public:
  SurfaceMesh(int nx, int ny, std::vector<Vec3<double>> points,
              MeshInterpolation interpolation = MeshInterpolation::bilinear)
      : nx_(nx), ny_(ny), points_(std::move(points)), interpolation_(interpolation) {}

  /// z over (x, y), by Newton's method from the position that was found last; none off the mesh.
  std::optional<double> height(double x, double y);

  int columns() const { return nx_; }
  /// The least and the greatest x of its points.
  std::pair<double, double> range_of_x() const;

private:
  double bicubic(int i, int j, double u, double v) const;
  const Vec3<double>& point(int i, int j) const { return points_[static_cast<std::size_t>(j) * nx_ + i]; }

  int nx_, ny_;
  std::vector<Vec3<double>> points_;
  MeshInterpolation interpolation_;
  int i_ = -1, j_ = -1; ///< the quadrangle that was found last
};

} // namespace microslip::contact_program
