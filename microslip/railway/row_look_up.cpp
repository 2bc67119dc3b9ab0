#include "microslip/railway/row_look_up.hpp"

#include "microslip/simplified/load_moments.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace microslip {
namespace {

struct SemiAxes {
  double a, b;
};

/// Of the ellipse that stands for rows of whose loads a patch has these shares. Sheppard's correction takes the spread
/// within rows of the load's means; the share of the squared half-lengths is exact then.
SemiAxes semi_axes_of(std::span<const LoadedRow> rows, std::span<const double> share,
                      const detail::LoadMoments& moments) {
  double inertia = 0, least = 0, squares = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const LoadedRow& row = rows[k];
    const double y = row.y - moments.centre.y, own = row.width * row.width / 12, part = share[k] * row.load;
    inertia += part * (y * y - own), least += part * own;
    if (row.load > 0) squares += share[k] * row.width * row.half_length * row.half_length;
  }
  const double b = std::sqrt(5 * std::max(inertia, least) / moments.load);
  return {std::sqrt(0.75 * squares / b), b};
}

} // namespace

RowLookUp::RowLookUp(std::shared_ptr<const CreepForceTable> table, std::size_t most_rows)
    : table_(std::move(table)), share_(most_rows), share_before_(most_rows), in_range_(most_rows, 1) {}

/// The contact that stands for a row's patch; its shares are found.
EllipticContact RowLookUp::contact_of(const CombinedMaterial& material, std::span<const LoadedRow> rows,
                                      std::size_t row, const HertzianEllipse& hertz) const noexcept {
  const std::span<const double> shares(share_.data(), rows.size());
  const detail::LoadMoments moments(rows, shares);
  SemiAxes axes = semi_axes_of(rows, shares, moments);
  if (row >= hertz.first && row < hertz.first + hertz.count) {
    axes.a += hertz.share * (hertz.a - axes.a);
    axes.b += hertz.share * (hertz.b - axes.b);
  }
  return {.a = axes.a,
          .b = axes.b,
          .shear_modulus = material.shear_modulus,
          .poisson_ratio = material.poisson_ratio,
          .normal_force = moments.load,
          .friction = FrictionLaw::coulomb(moments.capacity / moments.load),
          .creepage = moments.creepage};
}

void RowLookUp::solve(const CombinedMaterial& material, std::span<const LoadedRow> rows, const HertzianEllipse& hertz,
                      double side, std::span<RowForces> forces) noexcept {
  const std::span<double> shares(share_.data(), rows.size()), before(share_before_.data(), rows.size());
  const auto is_hertzian = [&](std::size_t k) { return k >= hertz.first && k < hertz.first + hertz.count; };
  ContactForces found;
  double load = 0, area = 0;
  std::size_t last = rows.size(); // the last row that was looked up
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const LoadedRow& row = rows[k];
    forces[k] = {}, in_range_[k] = 1;
    if (!(row.load > 0)) continue;
    detail::find_shares(rows, k, shares);
    // Rows of one hump have the same shares.
    if (last == rows.size() || is_hertzian(k) != is_hertzian(last) ||
        !std::equal(shares.begin(), shares.end(), before.begin())) {
      EllipticContact contact = contact_of(material, rows, k, hertz);
      contact.creepage.longitudinal *= side, contact.creepage.spin *= side;
      found = table_->solve(contact);
      found.fx *= side, found.mz *= side;
      load = contact.normal_force, area = found.adhesion_area + found.slip_area;
    }
    std::copy(shares.begin(), shares.end(), before.begin());
    last = k;
    const double part = row.load / load;
    forces[k] = {part * found.fx, part * found.fy, part * (found.mz + row.centre * found.fy),
                 2 * row.half_length * row.width * (area > 0 ? found.slip_area / area : 0)};
    in_range_[k] = found.status == Status::ok;
  }
}

} // namespace microslip
