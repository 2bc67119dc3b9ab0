#include "microslip/exact/fitted/hertzian_rolling.hpp"

#include "microslip/simplified/fastsim2_creepage.hpp"
#include "microslip/simplified/fastsim2_start.hpp"

#include <algorithm>
#include <utility>

namespace microslip {
namespace {

constexpr int smallest_with_coarser = 64; // elements across; below, a coarser grid saves less than it costs

double capacity_of(const EllipticContact& contact) {
  return contact.friction.static_coefficient() * contact.normal_force;
}

std::unique_ptr<NestedRolling> nested(double a, double b, const CombinedMaterial& material, int mx, int my,
                                      const Progress& progress) {
  std::unique_ptr<NestedRolling> coarser;
  if (std::min(mx, my) >= smallest_with_coarser) coarser = nested(a, b, material, (mx + 1) / 2, (my + 1) / 2, progress);
  return std::make_unique<NestedRolling>(material, fit_ellipse(a, b, mx, my), std::move(coarser), progress);
}

VectorField from_fastsim2(const EllipticContact& contact, const FittedContact& fitted, std::span<const double> bound) {
  std::vector<double> grid_bound(fitted.grid.count());
  for (std::size_t k = 0; k < bound.size(); ++k) grid_bound[fitted.elements[k].cell] = bound[k];
  const VectorField on_grid = start_from_fastsim2(contact, fitted.grid, grid_bound, RollingDirection::forward);
  VectorField start;
  for (const FittedElement& e : fitted.elements) {
    start.x.push_back(on_grid.x[e.cell]);
    start.y.push_back(on_grid.y[e.cell]);
  }
  return start;
}

} // namespace

HertzianRolling::HertzianRolling(double a, double b, const CombinedMaterial& material, int mx, int my,
                                 const Progress& progress)
    : rolling_(nested(a, b, material, mx, my, progress)) {}

std::vector<double> HertzianRolling::bound(const EllipticContact& contact) const {
  return rolling_->bound(capacity_of(contact));
}

SecondOrderSolution HertzianRolling::solve(const EllipticContact& contact, std::optional<double> force_x,
                                           std::optional<double> force_y, double tolerance, const Progress& progress) {
  const RollingEstimate estimate{
      .tractions =
          [&](const FittedContact& fitted, std::span<const double> bound, const Creepage& creepage) {
            EllipticContact at_creepage = contact;
            at_creepage.creepage = creepage;
            return from_fastsim2(at_creepage, fitted, bound);
          },
      .creepage = [&] { return creepage_from_fastsim2(contact, force_x, force_y); },
      .stiffness = contact.shear_modulus * contact.a * contact.b};
  return rolling_->solve(capacity_of(contact),
                         {.creepage = contact.creepage,
                          .force_x = force_x,
                          .force_y = force_y,
                          .start = {},
                          .progress = progress,
                          .tolerance = tolerance},
                         estimate);
}

SecondOrderRolling::Derivatives HertzianRolling::differentiate(const EllipticContact& contact,
                                                               const SecondOrderSolution& solution, double tolerance,
                                                               const Progress& progress) {
  return rolling_->differentiate(capacity_of(contact), solution, tolerance, progress);
}

} // namespace microslip
