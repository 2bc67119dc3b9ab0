#include "microslip/exact/halfspace/surface_operator.hpp"

#include "microslip/exact/halfspace/offset_kernel.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace microslip {
namespace {

/// A kernel at the offsets 0 .. mx - 1, 0 .. my - 1.
std::vector<double> quadrant(const OffsetTable& kernel) {
  std::vector<double> values;
  for (int j = 0; j < kernel.my(); ++j)
    for (int i = 0; i < kernel.mx(); ++i) values.push_back(kernel.at(i, j));
  return values;
}

/// Of A_zz, along both axes.
double even_part(const InfluenceTable& table, int i, int j) {
  return (table.find(i, j).zz + table.find(-i, j).zz + table.find(i, -j).zz + table.find(-i, -j).zz) / 4;
}

/// Part of the kernel that is even along x; a kernel of retarded deformation has another one.
std::vector<double> even_part(const OffsetTable& kernel) {
  std::vector<double> values;
  for (int j = 0; j < kernel.my(); ++j)
    for (int i = 0; i < kernel.mx(); ++i) values.push_back((kernel.at(i, j) + kernel.at(-i, j)) / 2);
  return values;
}

/// Of a kernel's even part; half of the inverse's period may be a little more than the grid.
EvenToeplitz inverse_of_even_part(const OffsetTable& kernel) {
  return EvenToeplitz::circulant_inverse(
      kernel.mx(), kernel.my(), [even = even_part(kernel), &kernel](int j, std::span<double> entries) {
        const double* row = &even[static_cast<std::size_t>(std::min(j, kernel.my() - 1)) * kernel.mx()];
        for (std::size_t k = 0; k < entries.size(); ++k)
          entries[k] = row[std::min(static_cast<int>(k), kernel.mx() - 1)];
      });
}

} // namespace

NormalOperator::NormalOperator(const CombinedMaterial& material, const ElementGrid& grid, const Progress& progress,
                               const TransformPlans& plans)
    : zz_((check(grid), grid.mx), grid.my,
          [&, rows = NormalRows(material, grid)](int j, std::span<double> entries) mutable {
            go_on(progress, 0);
            rows.find(j, entries);
          },
          plans),
      diagonal_(normal_coefficient(material, grid, 0, 0)) {}

NormalOperator::NormalOperator(const InfluenceTable& table, const ElementGrid& grid)
    : zz_((check(grid), grid.mx), grid.my,
          [&](int j, std::span<double> entries) {
            const int row = std::min(j, table.my() - 1); // the near inverse's period may be a little longer
            for (std::size_t k = 0; k < entries.size(); ++k)
              entries[k] = even_part(table, std::min(static_cast<int>(k), table.mx() - 1), row);
          }),
      diagonal_(table.find(0, 0).zz) {}

TangentialOperator::TangentialOperator(const TangentialKernel& kernel)
    : transform_(kernel.xx.mx(), kernel.xx.my(), 2), xx_(transform_.kernel_spectrum(kernel.xx.values())),
      xy_(transform_.kernel_spectrum(kernel.xy.values())), yy_(transform_.kernel_spectrum(kernel.yy.values())),
      diagonal_(kernel.diagonal()) {}

TangentialOperator TangentialOperator::displacement(const Bodies& bodies, const ElementGrid& grid, Vec2 shift,
                                                    double length, const Progress& progress) {
  return TangentialOperator(TangentialKernel::displacement(bodies, grid, shift, length, progress));
}

TangentialOperator TangentialOperator::difference(const Bodies& bodies, const ElementGrid& grid, Vec2 step,
                                                  const Progress& progress) {
  return TangentialOperator(TangentialKernel::difference(bodies, grid, step, progress));
}

void TangentialOperator::apply(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                               std::span<double> uy) {
  transform_.load(std::array{px, py});
  transform_.apply(std::array<const ToeplitzTransform::Spectrum*, 4>{&xx_, &xy_, &xy_, &yy_}, std::array{ux, uy});
}

CoupledOperator::CoupledOperator(const CoupledKernel& kernel, const ElementGrid& grid, const WeightedPatches& patches)
    : grid_(grid), patches_(patches), slip_diagonal_(kernel.slip.diagonal()), normal_diagonal_(kernel.zz.at(0, 0)),
      slip_scale_(slip_diagonal_), normal_scale_(normal_diagonal_), normal_inverse_(inverse_of_even_part(kernel.zz)) {
  transform(kernel);
  normal_scale_ = middle_eigenvalue(even_part(kernel.zz), grid.mx);
  if (!kernel.is_displacement) return;
  const auto xx = even_part(kernel.slip.xx), xy = quadrant(kernel.slip.xy), yy = even_part(kernel.slip.yy);
  slip_inverse_ = NearInverse::near_inverse(grid.mx, grid.my, {xx, xy, yy});
  slip_scale_ = (middle_eigenvalue(xx, grid.mx) + middle_eigenvalue(yy, grid.mx)) / 2;
}

void CoupledOperator::transform(const CoupledKernel& kernel) {
  const TangentialKernel& slip = kernel.slip;
  if (kernel.symmetric_over) {
    length_ = *kernel.symmetric_over;
    const auto displacement = [&](const OffsetTable& of) {
      std::vector<double> values = quadrant(of);
      for (double& value : values) value *= length_;
      return values;
    };
    symmetric_.emplace(grid_.mx, grid_.my,
                       CoupledToeplitz::Kernels{displacement(slip.xx), displacement(slip.xy), displacement(slip.yy),
                                                displacement(kernel.xz), displacement(kernel.yz), quadrant(kernel.zz)});
    return;
  }
  transform_.emplace(grid_.mx, grid_.my, 3);
  const auto spectrum = [&](const OffsetTable& of) { return transform_->kernel_spectrum(of.values()); };
  xx_ = spectrum(slip.xx), xy_ = spectrum(slip.xy), yy_ = spectrum(slip.yy);
  if (kernel.yx) yx_ = spectrum(*kernel.yx);
  xz_ = spectrum(kernel.xz), yz_ = spectrum(kernel.yz);
  zx_ = spectrum(kernel.zx), zy_ = spectrum(kernel.zy), zz_ = spectrum(kernel.zz);
}

CoupledOperator CoupledOperator::displacement(const Bodies& bodies, const ElementGrid& grid, Vec2 shift, double length,
                                              const Progress& progress, const ElementResponse& response) {
  check(response, grid);
  CoupledOperator made(response.table ? CoupledKernel::displacement(*response.table, grid, shift, length)
                                      : CoupledKernel::displacement(bodies, grid, shift, length, progress),
                       grid, response.patches);
  if (!response.inclination.is_flat())
    made.inclined_.emplace(InclinedKernel::displacements(bodies, grid, shift, length, progress), grid,
                           response.inclination);
  return made;
}

CoupledOperator CoupledOperator::difference(const Bodies& bodies, const ElementGrid& grid, Vec2 step,
                                            const Progress& progress, const ElementResponse& response) {
  check(response, grid);
  CoupledOperator made(response.table ? CoupledKernel::difference(*response.table, grid, step)
                                      : CoupledKernel::difference(bodies, grid, step, progress),
                       grid, response.patches);
  if (response.table && step.y == 0)
    made.table_rolling_.emplace(*response.table, grid, std::abs(step.x) * made.slip_scale_);
  if (!response.inclination.is_flat())
    made.inclined_.emplace(InclinedKernel::difference(bodies, grid, step, progress), grid, response.inclination);
  return made;
}

void CoupledOperator::expect_contact(std::span<const double> pressure, RollingDirection direction) {
  if (table_rolling_)
    table_rolling_->expect_contact(pressure, direction);
  else
    rolling_.emplace(grid_, pressure, direction);
}

void CoupledOperator::precondition_tractions(std::span<const double> px, std::span<const double> py,
                                             std::span<double> qx, std::span<double> qy) {
  if (slip_inverse_) return slip_inverse_->apply(px, py, slip_scale_, qx, qy);
  std::copy(px.begin(), px.end(), qx.begin());
  std::copy(py.begin(), py.end(), qy.begin());
  if (table_rolling_) table_rolling_->precondition(px, py, qx, qy);
  if (rolling_) rolling_->precondition(px, py, qx, qy);
}

void CoupledOperator::precondition_pressure(std::span<const double> pressure, std::span<double> q) {
  normal_inverse_.apply_circulant_inverse(pressure, q);
  for (double& value : q) value *= normal_scale_;
}

void CoupledOperator::apply(const Fields& p, std::span<const std::span<double>> out) {
  apply_alike(p, out);
  constexpr std::size_t normal = 2;
  if (patches_.count == 1 || out.size() <= normal) return;
  for (int patch = 0; patch < patches_.count; ++patch) add_weight_of(patch, p[normal], out[normal]);
}

/// Applies the operator without the patches' factors.
void CoupledOperator::apply_alike(const Fields& p, std::span<const std::span<double>> out) {
  if (inclined_) return inclined_->apply(p, out);
  if (symmetric_) {
    symmetric_->apply({p[0], p[1], p[2]}, {out[0], out[1], out.size() > 2 ? out[2] : std::span<double>()});
    for (std::size_t c = 0; c < 2 && length_ != 1; ++c)
      for (double& s : out[c]) s /= length_;
    return;
  }
  transform_->load(p);
  const std::array<const ToeplitzTransform::Spectrum*, 9> kernels = {
      &xx_, &xy_, &xz_, yx_.empty() ? &xy_ : &yx_, &yy_, &yz_, &zx_, &zy_, &zz_};
  transform_->apply(std::span(kernels).first(3 * out.size()), out);
}

/// Adds what the factors change of the normal displacement that a patch's pressure causes.
void CoupledOperator::add_weight_of(int patch, std::span<const double> pressure, std::span<double> displacement) {
  const auto for_rows = [&](auto function) {
    for (int j = 0; j < grid_.my; ++j)
      function(patches_.patch_of_row[static_cast<std::size_t>(j)], static_cast<std::size_t>(j) * grid_.mx);
  };
  const auto mx = static_cast<std::size_t>(grid_.mx);
  const std::vector<double> none(grid_.count());
  std::vector<double> own(grid_.count());
  std::array<std::vector<double>, 3> response;
  for (auto& field : response) field.resize(grid_.count());
  for_rows([&](int row_patch, std::size_t k) {
    if (row_patch == patch) std::copy_n(pressure.begin() + std::ptrdiff_t(k), mx, own.begin() + std::ptrdiff_t(k));
  });
  apply_alike({none, none, own}, std::array{std::span(response[0]), std::span(response[1]), std::span(response[2])});
  for_rows([&](int row_patch, std::size_t k) {
    const double factor = patches_.factors[static_cast<std::size_t>(row_patch) * patches_.count + patch];
    for (std::size_t i = k; i < k + mx; ++i) displacement[i] += (factor - 1) * response[2][i];
  });
}

} // namespace microslip
