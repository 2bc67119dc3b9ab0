#include "microslip/exact/surface_response.hpp"

#include "microslip/exact/offset_kernel.hpp"

#include <array>

namespace microslip {

NormalResponse::NormalResponse(const CombinedMaterial& material, const ElementGrid& grid)
    : zz_((check(grid), grid.mx), grid.my, [&](int i, int j) { return normal_coefficient(material, grid, i, j); }),
      diagonal_(normal_coefficient(material, grid, 0, 0)) {}

TangentialResponse::TangentialResponse(const TangentialKernel& kernel)
    : transform_(kernel.xx.mx(), kernel.xx.my(), 2), xx_(transform_.kernel_spectrum(kernel.xx.values())),
      xy_(transform_.kernel_spectrum(kernel.xy.values())), yy_(transform_.kernel_spectrum(kernel.yy.values())),
      diagonal_(kernel.diagonal()) {}

TangentialResponse TangentialResponse::displacement(const CombinedMaterial& material, const ElementGrid& grid,
                                                    double shift, double length) {
  return TangentialResponse(TangentialKernel::displacement(material, grid, shift, length));
}

TangentialResponse TangentialResponse::growth(const CombinedMaterial& material, const ElementGrid& grid, double step) {
  return TangentialResponse(TangentialKernel::growth(material, grid, step));
}

void TangentialResponse::apply(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                               std::span<double> uy) {
  transform_.load(std::array{px, py});
  transform_.apply(std::array<const ToeplitzTransform::Spectrum*, 4>{&xx_, &xy_, &xy_, &yy_}, std::array{ux, uy});
}

} // namespace microslip
