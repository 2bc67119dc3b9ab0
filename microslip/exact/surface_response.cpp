#include "microslip/exact/surface_response.hpp"

#include "microslip/exact/offset_kernel.hpp"

#include <array>

namespace microslip {

NormalResponse::NormalResponse(const CombinedMaterial& material, const ElementGrid& grid)
    : transform_(grid.mx, grid.my, 1), zz_(transform_.kernel_spectrum(normal_kernel(material, grid).values())) {}

void NormalResponse::apply(std::span<const double> pressure, std::span<double> displacement) {
  transform_.load(std::array{pressure});
  transform_.apply(std::array<const ToeplitzTransform::Spectrum*, 1>{&zz_}, std::array{displacement});
}

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
