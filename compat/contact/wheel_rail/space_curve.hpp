#pragma once

#include "microslip/railway/geometry/frame.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace microslip::contact_program {

/// A cubic spline through points in space, natural in each of the sections between its cuts.
class SpaceCurve {
public:
  /// `s` ascending; `cuts` are indices of inner points.
  SpaceCurve(std::vector<double> s, std::vector<Vec3<double>> points, std::span<const std::size_t> cuts);

  /// The lowest point, with the largest z, that has this y; none beyond the curve.
  std::optional<Vec3<double>> at_y(double y) const;

private:
  Vec3<double> at(std::size_t piece, double t) const;

  std::vector<double> s_;
  std::vector<Vec3<double>> points_;
  std::array<std::vector<double>, 3> second_; ///< of each point for the piece before it,
  std::array<std::vector<double>, 3> after_;  ///< and for the one behind it
};

} // namespace microslip::contact_program
