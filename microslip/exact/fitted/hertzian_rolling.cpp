#include "microslip/exact/fitted/hertzian_rolling.hpp"

#include "microslip/simplified/fastsim2_creepage.hpp"
#include "microslip/simplified/fastsim2_start.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace microslip {
namespace {

constexpr int smallest_with_coarser = 64; // elements across; below, a coarser grid saves less than it costs

double capacity_of(const EllipticContact& contact) {
  return contact.friction.static_coefficient() * contact.normal_force;
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

HertzianRolling::HertzianRolling(int mx, int my) {
  of_circle_.push_back(fit_ellipse(1, 1, mx, my));
  for (; std::min(mx, my) >= smallest_with_coarser; of_circle_.push_back(fit_ellipse(1, 1, mx, my)))
    mx = (mx + 1) / 2, my = (my + 1) / 2;
}

/// Makes all levels, the coarsest one first.
std::unique_ptr<NestedRolling> HertzianRolling::nested(const Progress& progress) const {
  std::unique_ptr<NestedRolling> rolling;
  for (std::size_t level = of_circle_.size(); level-- > 0;)
    rolling = std::make_unique<NestedRolling>(material_, stretched(of_circle_[level], a_, b_), std::move(rolling),
                                              progress, plans_);
  return rolling;
}

void HertzianRolling::prepare(double a, double b, const CombinedMaterial& material, const Progress& progress) {
  if (rolling_ && a == a_ && b == b_ && material == material_) return;
  const bool scaled = std::abs(b * a_ - b_ * a) <= 4 * std::numeric_limits<double>::epsilon() * b * a_ &&
                      material.poisson_ratio == material_.poisson_ratio;
  std::unique_ptr<NestedRolling> rolling = std::exchange(rolling_, nullptr); // there is none if this is stopped
  a_ = a, b_ = b, material_ = material;
  NestedRolling* on_level = rolling.get();
  for (std::size_t level = 0; rolling && level < of_circle_.size(); ++level, on_level = on_level->coarser()) {
    FittedContact contact = stretched(of_circle_[level], a, b);
    if (scaled)
      on_level->rescale(std::move(contact), material.shear_modulus);
    else
      on_level->renew(material, std::move(contact), progress);
  }
  rolling_ = rolling ? std::move(rolling) : nested(progress);
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

SecondOrderRolling::Responses HertzianRolling::respond(const EllipticContact& contact,
                                                       const SecondOrderSolution& solution, double wavenumber,
                                                       double tolerance, const Progress& progress) {
  return rolling_->respond(capacity_of(contact), solution, wavenumber, tolerance, progress);
}

} // namespace microslip
