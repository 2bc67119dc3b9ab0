#include "microslip/exact/halfspace/surface_operator.hpp"

#include "microslip/exact/halfspace/offset_kernel.hpp"

#include <array>

namespace microslip {

NormalOperator::NormalOperator(const CombinedMaterial& material, const ElementGrid& grid, const Progress& progress,
                               const TransformPlans& plans)
    : zz_((check(grid), grid.mx), grid.my,
          [&, rows = NormalRows(material, grid)](int j, std::span<double> entries) mutable {
            go_on(progress, 0);
            rows.find(j, entries);
          },
          plans),
      diagonal_(normal_coefficient(material, grid, 0, 0)) {}

TangentialOperator::TangentialOperator(const TangentialKernel& kernel)
    : transform_(kernel.xx.mx(), kernel.xx.my(), 2), xx_(transform_.kernel_spectrum(kernel.xx.values())),
      xy_(transform_.kernel_spectrum(kernel.xy.values())), yy_(transform_.kernel_spectrum(kernel.yy.values())),
      diagonal_(kernel.diagonal()) {}

TangentialOperator TangentialOperator::displacement(const Bodies& bodies, const ElementGrid& grid, Vec2 shift,
                                                    double length, const Progress& progress) {
  return TangentialOperator(TangentialKernel::displacement(bodies, grid, shift, length, progress));
}

TangentialOperator TangentialOperator::difference(const Bodies& bodies, const ElementGrid& grid, double step,
                                                  const Progress& progress) {
  return TangentialOperator(TangentialKernel::difference(bodies, grid, step, progress));
}

void TangentialOperator::apply(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                               std::span<double> uy) {
  transform_.load(std::array{px, py});
  transform_.apply(std::array<const ToeplitzTransform::Spectrum*, 4>{&xx_, &xy_, &xy_, &yy_}, std::array{ux, uy});
}

CoupledOperator::CoupledOperator(const CoupledKernel& kernel)
    : transform_(kernel.zz.mx(), kernel.zz.my(), 3), xx_(transform_.kernel_spectrum(kernel.slip.xx.values())),
      xy_(transform_.kernel_spectrum(kernel.slip.xy.values())),
      yy_(transform_.kernel_spectrum(kernel.slip.yy.values())), xz_(transform_.kernel_spectrum(kernel.xz.values())),
      yz_(transform_.kernel_spectrum(kernel.yz.values())), zx_(transform_.kernel_spectrum(kernel.zx.values())),
      zy_(transform_.kernel_spectrum(kernel.zy.values())), zz_(transform_.kernel_spectrum(kernel.zz.values())),
      slip_diagonal_(kernel.slip.diagonal()), normal_diagonal_(kernel.zz.at(0, 0)) {}

CoupledOperator CoupledOperator::displacement(const Bodies& bodies, const ElementGrid& grid, Vec2 shift, double length,
                                              const Progress& progress) {
  return CoupledOperator(CoupledKernel::displacement(bodies, grid, shift, length, progress));
}

CoupledOperator CoupledOperator::difference(const Bodies& bodies, const ElementGrid& grid, double step,
                                            const Progress& progress) {
  return CoupledOperator(CoupledKernel::difference(bodies, grid, step, progress));
}

void CoupledOperator::apply(const Fields& p, std::span<const std::span<double>> out) {
  transform_.load(p);
  const std::array<const ToeplitzTransform::Spectrum*, 9> kernels = {&xx_, &xy_, &xz_, &xy_, &yy_,
                                                                     &yz_, &zx_, &zy_, &zz_};
  transform_.apply(std::span(kernels).first(3 * out.size()), out);
}

} // namespace microslip
