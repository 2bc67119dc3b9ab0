#include "microslip/exact/surface_response.hpp"

#include "microslip/elasticity/influence.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace microslip {
namespace {

/// Calls at(place, x, y) for the offsets of a grid's kernels in the order that ToeplitzTransform wants.
template <class At> void for_offsets(const ElementGrid& grid, At at) {
  std::size_t place = 0;
  for (int j = 1 - grid.my; j < grid.my; ++j)
    for (int i = 1 - grid.mx; i < grid.mx; ++i) at(place++, i * grid.dx, j * grid.dy);
}
/// The influence of an element on a point at an offset, of endless strips for a line contact.
Influence influence_at(const CombinedMaterial& material, const ElementGrid& grid, double x, double y) {
  if (!grid.line) return influence(material, grid.dx, grid.dy, x, y);
  return line_influence(material, grid.dx, x, grid.mx * grid.dx);
}

std::size_t offsets(const ElementGrid& grid) {
  return (2 * std::size_t(grid.mx) - 1) * (2 * std::size_t(grid.my) - 1);
}

} // namespace

NormalResponse::NormalResponse(const CombinedMaterial& material, const ElementGrid& grid)
    : transform_(grid.mx, grid.my, 1) {
  check(grid);
  std::vector<double> zz(offsets(grid));
  for_offsets(grid, [&](std::size_t k, double x, double y) { zz[k] = influence_at(material, grid, x, y).zz; });
  zz_ = transform_.kernel_spectrum(zz);
}

void NormalResponse::apply(std::span<const double> pressure, std::span<double> displacement) {
  transform_.load(std::array{pressure});
  transform_.apply(std::array<const ToeplitzTransform::Spectrum*, 1>{&zz_}, std::array{displacement});
}

/// `kernel` gives the influence at an offset.
template <class Kernel>
TangentialResponse::TangentialResponse(const ElementGrid& grid, Kernel kernel) : transform_(grid.mx, grid.my, 2) {
  check(grid);
  std::vector<double> xx(offsets(grid)), xy(xx), yy(xx);
  for_offsets(grid, [&](std::size_t k, double x, double y) {
    const Influence a = kernel(x, y);
    xx[k] = a.xx;
    xy[k] = a.xy;
    yy[k] = a.yy;
  });
  diagonal_ = (xx[xx.size() / 2] + yy[yy.size() / 2]) / 2;
  xx_ = transform_.kernel_spectrum(xx);
  xy_ = transform_.kernel_spectrum(xy);
  yy_ = transform_.kernel_spectrum(yy);
}

TangentialResponse TangentialResponse::displacement(const CombinedMaterial& material, const ElementGrid& grid,
                                                    double shift, double length) {
  return {grid, [&](double x, double y) {
            const Influence a = influence_at(material, grid, x + shift, y);
            return Influence{a.xx / length, a.xy / length, a.yy / length, 0, 0, 0};
          }};
}

TangentialResponse TangentialResponse::growth(const CombinedMaterial& material, const ElementGrid& grid, double step) {
  return {grid, [&](double x, double y) {
            const Influence now = influence_at(material, grid, x, y);
            const Influence before = influence_at(material, grid, x + step, y);
            const double rate = 1 / std::abs(step);
            return Influence{
                (now.xx - before.xx) * rate, (now.xy - before.xy) * rate, (now.yy - before.yy) * rate, 0, 0, 0};
          }};
}

void TangentialResponse::apply(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                               std::span<double> uy) {
  transform_.load(std::array{px, py});
  transform_.apply(std::array<const ToeplitzTransform::Spectrum*, 4>{&xx_, &xy_, &xy_, &yy_}, std::array{ux, uy});
}

} // namespace microslip
