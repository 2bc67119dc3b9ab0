#include "microslip/railway/rows/row_strips.hpp"

#include "microslip/simplified/creepage_coefficients.hpp"

#include <array>
#include <cmath>

namespace microslip {
namespace {

/// Gauss's points cos(k pi/(2 n + 1)), k = 1 to n, and their mirror images, for integrals over -1 to 1 with the weight
/// sqrt(1 - x^2); `half_height` is sin(k pi/(2 n + 1)).
template <int n> struct SemiEllipticPoints { std::array<double, n> place, half_height; };

/// Along a strip; their weights are 4/7 sin^2 of half the load each.
constexpr SemiEllipticPoints<3> along{{0.9009688679024191, 0.6234898018587336, 0.22252093395631445},
                                      {0.4338837391175581, 0.7818314824680298, 0.9749279121818236}};
/// Strips across the ellipse.
constexpr SemiEllipticPoints<6> across{{0.970941817426052, 0.8854560256532099, 0.7485107481711011, 0.5680647467311559,
                                        0.35460488704253557, 0.120536680255323},
                                       {0.23931566428755774, 0.4647231720437685, 0.6631226582407952, 0.8229838658936564,
                                        0.9350162426854148, 0.992708874098054}};

double square(double x) {
  return x * x;
}

} // namespace

RowStrips::RowStrips(const CombinedMaterial& material, const PatchEllipse& ellipse, double capacity)
    : shape_(ellipse), capacity_(capacity) {
  const double ratio = ellipse.a / ellipse.b * square(ellipse.stretch());
  exponent_ = 1.3 + 2 * ratio / (ratio + 5);
  const auto c = creepage_coefficients(ratio, material.poisson_ratio, CreepageTable::computed);
  stiffness_ = material.shear_modulus * ellipse.a * ellipse.b * c.c11;
  double sum = 0, lengths = 0;
  for (const double height : across.half_height) {
    const double part = std::pow(height, exponent_ + 1);
    sum += part, lengths += part * height;
  }
  memory_ = c.c23 / c.c22 * std::sqrt(ellipse.b / ellipse.a) * sum / lengths;
}

double RowStrips::stiffness(const LoadedRow& row) const noexcept {
  return row.width * std::pow(row.half_length / shape_.a, exponent_);
}

/// `scale` is u.
RowForces RowStrips::strip(double scale, double centre, double half_length, const Creepage& creepage,
                           double capacity) const noexcept {
  const double slip_x = scale * creepage.longitudinal, lead = scale * creepage.spin * memory_ * half_length;
  RowForces sum;
  for (std::size_t k = 0; k < along.place.size(); ++k) {
    const double weight = 2.0 / 7 * square(along.half_height[k]) * capacity;
    for (const double side : {-1, 1}) {
      const double x = centre + side * half_length * along.place[k];
      const double rigid = scale * (creepage.lateral + creepage.spin * x);
      const double slip_y = rigid + lead / (1 + square(slip_x) + square(rigid));
      const double part = weight / std::sqrt(1 + square(slip_x) + square(slip_y));
      sum.fx -= part * slip_x, sum.fy -= part * slip_y, sum.mz -= part * slip_y * x;
    }
  }
  return sum;
}

RowForces RowStrips::row(const LoadedRow& row, double sum) const noexcept {
  const double capacity = row.load * row.friction;
  if (!(capacity > 0)) return {};
  const double skew = square(shape_.skewness), gain = 1 + 0.06 * skew / (1 + skew / 4);
  return strip(gain * stiffness_ * stiffness(row) / (sum * capacity), row.centre, row.half_length, row.creepage,
               capacity);
}

RowForces RowStrips::ellipse(const Creepage& at_centre) const noexcept {
  std::array<double, 6> stiff{}, load{};
  double stiffness = 0, loads = 0;
  for (std::size_t k = 0; k < stiff.size(); ++k) {
    const double height = across.half_height[k];
    stiffness += 2 * (stiff[k] = std::pow(height, exponent_ + 1));
    loads += 2 * (load[k] = square(height) * height);
  }
  RowForces sum;
  for (std::size_t k = 0; k < stiff.size(); ++k) {
    const double capacity = capacity_ * load[k] / loads;
    for (const double side : {-1, 1}) {
      const double y = side * shape_.b * across.place[k];
      const RowForces f =
          strip(stiffness_ * stiff[k] / (stiffness * capacity), shape_.slant * y, shape_.a * across.half_height[k],
                {at_centre.longitudinal - at_centre.spin * y, at_centre.lateral, at_centre.spin}, capacity);
      sum.fx += f.fx, sum.fy += f.fy, sum.mz += f.mz - y * f.fx;
    }
  }
  return sum;
}

} // namespace microslip
