#include "microslip/exact/fitted/fitted_operator.hpp"

#include "microslip/exact/fitted/fitted_tables.hpp"
#include "microslip/exact/fitted/grid_kernel.hpp"
#include "microslip/numerics/precision.hpp"

#include <tuple>
#include <utility>
#include <vector>

namespace microslip {
template <class Real>
RollingPreconditioner<Real> rolling_preconditioner(const FittedContact& contact, const TransformPlans& plans) {
  std::vector<RollingElement> elements;
  for (std::size_t k = 0; k < contact.elements.size(); ++k)
    elements.push_back({k, contact.elements[k].cell, contact.elements[k].leads});
  return {contact.grid, RollingDirection::forward, elements, plans};
}

template RollingPreconditioner<double> rolling_preconditioner(const FittedContact&, const TransformPlans&);
template RollingPreconditioner<float> rolling_preconditioner(const FittedContact&, const TransformPlans&);

FittedOperator::FittedOperator(const CombinedMaterial& material, const FittedContact& contact, const Progress& progress,
                               const TransformPlans& plans)
    : plans_(plans) {
  make_preconditioner(contact, plans);
  make_product(material, contact, progress, plans);
}

void FittedOperator::renew(const CombinedMaterial& material, const FittedContact& contact, const Progress& progress,
                           const TransformPlans& plans) {
  make_preconditioner(contact, plans);
  make_product(material, contact, progress, plans);
}

void FittedOperator::make_preconditioner(const FittedContact& contact, const TransformPlans& plans) {
  elements_ = contact.elements.size();
  preconditioner_.reset(), rough_preconditioner_.reset();
  if (is_large())
    rough_preconditioner_.emplace(rolling_preconditioner<float>(contact, plans));
  else
    preconditioner_.emplace(rolling_preconditioner<double>(contact, plans));
}

void FittedOperator::apply_roughly(std::span<const double> px, std::span<const double> py, std::span<double> sx,
                                   std::span<double> sy) {
  if (!rough_) rough_.emplace(*product_, shear_modulus_, plans_);
  auto& [x, y, slip_x, slip_y] = rough_fields_;
  for (auto* field : {&x, &y, &slip_x, &slip_y}) field->resize(elements_);
  convert(px, 1, x), convert(py, 1, y);
  rough_->apply(x, y, slip_x, slip_y);
  convert(slip_x, 1 / shear_modulus_, sx), convert(slip_y, 1 / shear_modulus_, sy);
}

/// Makes the product, in the memory of the one before.
void FittedOperator::make_product(const CombinedMaterial& material, const FittedContact& contact,
                                  const Progress& progress, const TransformPlans& plans) {
  const FittedContact used = without_spare_elements(contact);
  const GridKernel kernel(material.poisson_ratio, used.grid, progress);
  FittedProduct<double>::Tables memory;
  std::optional<SymmetricToeplitz<double>> transform;
  if (product_) std::tie(memory, transform) = product_->take_apart();
  transform = kernel.transform(plans, std::move(transform));
  memory = fitted_tables(material.poisson_ratio, used, kernel, progress, std::move(memory));
  product_.emplace(std::move(memory), std::move(*transform), 1 / material.shear_modulus);
  rough_.reset();
  diagonal_ = kernel.diagonal();
  dx_ = contact.grid.dx, shear_modulus_ = material.shear_modulus;
}

void FittedOperator::rescale(double dx, double shear_modulus) {
  dx_ = dx, shear_modulus_ = shear_modulus;
  product_->set_compliance(1 / shear_modulus);
}

std::vector<double> FittedOperator::in_metres(std::span<const double> displacement) const {
  std::vector<double> u(displacement.begin(), displacement.begin() + static_cast<std::ptrdiff_t>(elements_));
  for (double& value : u) value *= dx_ / shear_modulus_;
  return u;
}

} // namespace microslip
