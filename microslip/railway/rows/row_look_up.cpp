#include "microslip/railway/rows/row_look_up.hpp"

#include "microslip/simplified/load_moments.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace microslip {
namespace {

/// Ellipse that stands for rows of whose loads a patch has these shares. Sheppard's correction takes the spread
/// within rows of the load's means; the share of the squared half-lengths is exact then.
PatchEllipse ellipse_of(std::span<const LoadedRow> rows, std::span<const double> share,
                        const detail::LoadMoments& moments) {
  double inertia = 0, least = 0, squares = 0, product = 0, third = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const LoadedRow& row = rows[k];
    const double y = row.y - moments.centre.y, own = row.width * row.width / 12, part = share[k] * row.load;
    inertia += part * (y * y - own), least += part * own;
    product += part * y * (row.centre - moments.centre.x), third += part * y * y * y;
    if (row.load > 0) squares += share[k] * row.width * row.half_length * row.half_length;
  }
  inertia = std::max(inertia, least);
  const double radius = std::sqrt(inertia / moments.load), b = std::sqrt(5.0) * radius;
  return {std::sqrt(0.75 * squares / b), b, product / inertia, third / (moments.load * radius * radius * radius)};
}

/// The mirror image in x.
LoadedRow mirrored(LoadedRow row) {
  row.centre = -row.centre;
  row.creepage.longitudinal = -row.creepage.longitudinal, row.creepage.spin = -row.creepage.spin;
  return row;
}

} // namespace

RowLookUp::RowLookUp(std::shared_ptr<const CreepForceTable> table, std::size_t most_rows)
    : table_(std::move(table)), share_(most_rows), share_before_(most_rows), strip_(most_rows), patch_of_(most_rows) {
  rows_.reserve(most_rows);
  patches_.reserve(most_rows + 1);
  patches_.resize(1);
}

/// The patch that a row sees; the shares that it has of the rows are found.
RowLookUp::Patch RowLookUp::patch_of(const CombinedMaterial& material, std::span<const LoadedRow> rows,
                                     std::size_t row) const noexcept {
  const std::span<const double> shares(share_.data(), rows.size());
  const detail::LoadMoments moments(rows, shares);
  const PatchEllipse ellipse = ellipse_of(rows, shares, moments);
  Patch patch;
  patch.row = row, patch.load = moments.load, patch.capacity = moments.capacity;
  const double stretch = ellipse.stretch();
  patch.table = table_->solve({.a = ellipse.a * stretch,
                               .b = ellipse.b / stretch,
                               .shear_modulus = material.shear_modulus,
                               .poisson_ratio = material.poisson_ratio,
                               .normal_force = moments.load,
                               .friction = FrictionLaw::coulomb(moments.capacity / moments.load),
                               .creepage = moments.creepage});
  patch.strips = RowStrips(material, ellipse, moments.capacity);
  patch.ellipse = patch.strips.ellipse(moments.creepage);
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (shares[k] * rows[k].load > 0) patch.strip_stiffness += shares[k] * patch.strips.stiffness(rows[k]);
  return patch;
}

/// The patches of all rows, and the forces of their strips.
void RowLookUp::find_patches(const CombinedMaterial& material) noexcept {
  const std::span<double> shares(share_.data(), rows_.size()), before(share_before_.data(), rows_.size());
  patches_.resize(1);
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    patch_of_[k] = 0, strip_[k] = {};
    if (!(rows_[k].load > 0)) continue;
    detail::find_shares(rows_, k, shares);
    // Rows of one hump have the same shares.
    if (patches_.size() == 1 || !std::equal(shares.begin(), shares.end(), before.begin()))
      patches_.push_back(patch_of(material, rows_, k));
    std::copy(shares.begin(), shares.end(), before.begin());
    const Patch& patch = patches_.back();
    patch_of_[k] = patches_.size() - 1;
    strip_[k] = patch.strips.row(rows_[k], patch.strip_stiffness);
  }
}

/// The strips may make a patch's force larger than the table's, which is below mu Fn: of what is left to mu Fn they
/// take x/(1 + x^4)^(1/4), x what they would take of it.
double RowLookUp::bound_of(std::size_t index) noexcept {
  if (index == 0) return 1;
  const Patch& patch = patches_[index];
  const std::span<double> shares(share_.data(), rows_.size());
  detail::find_shares(rows_, patch.row, shares);
  double fx = patch.table.fx - patch.ellipse.fx, fy = patch.table.fy - patch.ellipse.fy;
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    fx += shares[k] * strip_[k].fx, fy += shares[k] * strip_[k].fy;
  }
  const double before = std::hypot(patch.table.fx, patch.table.fy), length = std::hypot(fx, fy),
               left = patch.capacity - before;
  if (!(length > before && left > 0)) return length > before ? before / length : 1;
  const double x = (length - before) / left;
  return (before + left * x / std::sqrt(std::sqrt(1 + x * x * x * x))) / length;
}

void RowLookUp::solve(const CombinedMaterial& material, std::span<const LoadedRow> rows, double side,
                      std::span<RowForces> forces) noexcept {
  rows_.resize(rows.size());
  std::transform(rows.begin(), rows.end(), rows_.begin(),
                 [side](const LoadedRow& row) { return side < 0 ? mirrored(row) : row; });
  find_patches(material);
  for (std::size_t k = 0; k < patches_.size(); ++k) patches_[k].bound = bound_of(k);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const LoadedRow& row = rows_[k];
    forces[k] = {};
    if (!(row.load > 0)) continue;
    const Patch& patch = patches_[patch_of_[k]];
    const ContactForces& table = patch.table;
    const double part = row.load / patch.load;
    const double fx = part * (table.fx - patch.ellipse.fx) + strip_[k].fx;
    const double fy = part * (table.fy - patch.ellipse.fy);
    const double mz = part * (table.mz - patch.ellipse.mz) + row.centre * fy + strip_[k].mz;
    const double area = table.adhesion_area + table.slip_area;
    forces[k] = {side * patch.bound * fx, patch.bound * (fy + strip_[k].fy), side * patch.bound * mz,
                 2 * row.half_length * row.width * (area > 0 ? table.slip_area / area : 0)};
  }
}

} // namespace microslip
