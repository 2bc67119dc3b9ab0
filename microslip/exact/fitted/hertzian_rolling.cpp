#include "microslip/exact/fitted/hertzian_rolling.hpp"

#include "microslip/exact/fitted/coarse_start.hpp"
#include "microslip/simplified/fastsim2_creepage.hpp"
#include "microslip/simplified/fastsim2_start.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace microslip {
namespace {

constexpr int smallest_with_coarser = 64;     // elements across; below, a coarser grid saves less than it costs
constexpr double tolerance_of_coarser = 1e-3; // of the order of the discretisation error between the grids
constexpr double share_of_coarser = 0.2;      // of the work

} // namespace

HertzianRolling::HertzianRolling(double a, double b, const CombinedMaterial& material, int mx, int my,
                                 const Progress& progress)
    : rolling_(material, fit_ellipse(a, b, mx, my), progress) {
  if (std::min(mx, my) >= smallest_with_coarser)
    coarser_ = std::make_unique<HertzianRolling>(a, b, material, (mx + 1) / 2, (my + 1) / 2, progress);
}

std::vector<double> HertzianRolling::bound(const EllipticContact& contact) const {
  std::vector<double> bound = this->contact().load_share;
  for (double& g : bound) g *= contact.friction.static_coefficient() * contact.normal_force;
  return bound;
}

VectorField HertzianRolling::from_fastsim2(const EllipticContact& contact, std::span<const double> bound) const {
  const FittedContact& fitted = this->contact();
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

/// The derivative of FASTSIM2's tractions, `start`, with respect to the longitudinal (0) or lateral (1) creepage.
/// Nothing near full sliding, where it nearly vanishes: such numbers would mislead.
VectorField HertzianRolling::derivative(const EllipticContact& contact, int direction, std::span<const double> bound,
                                        const VectorField& start) const {
  const double stiffness = contact.shear_modulus * contact.a * contact.b; // dF/dxi in adhesion over Kalker's C11
  const double unit = 1e-3 * contact.friction.static_coefficient() * contact.normal_force / stiffness;
  EllipticContact moved = contact;
  (direction == 0 ? moved.creepage.longitudinal : moved.creepage.lateral) += unit;
  VectorField derivative = from_fastsim2(moved, bound);
  const FittedContact& fitted = this->contact();
  double slope = 0;
  for (std::size_t k = 0; k < bound.size(); ++k) {
    derivative.x[k] = (derivative.x[k] - start.x[k]) / unit;
    derivative.y[k] = (derivative.y[k] - start.y[k]) / unit;
    slope += (direction == 0 ? derivative.x[k] : derivative.y[k]) * fitted.elements[k].width() * fitted.grid.dy;
  }
  if (std::abs(slope) < 0.02 * stiffness) return {};
  return derivative;
}

SecondOrderSolution HertzianRolling::solve(const EllipticContact& contact, std::optional<double> force_x,
                                           std::optional<double> force_y, double tolerance, const Progress& progress) {
  const std::vector<double> bound = this->bound(contact);
  const bool force_given = force_x || force_y;
  SecondOrderInput input{.creepage = contact.creepage,
                         .force_x = force_x,
                         .force_y = force_y,
                         .start = {},
                         .progress = part(progress, coarser_ ? share_of_coarser : 0, 1),
                         .tolerance = tolerance};
  EllipticContact at_start = contact; // with creepages near those of the solution
  VectorField start;
  SecondOrderSolution coarse;
  if (coarser_)
    coarse = coarser_->solve(contact, force_x, force_y, std::max(tolerance_of_coarser, tolerance),
                             essential_part(progress, 0, share_of_coarser));
  if (coarser_ && coarse.friction.status == Status::ok) {
    at_start.creepage = coarse.creepage;
    start = start_from_coarser(coarser_->contact(), coarser_->bound(contact), coarse.friction, this->contact(), bound);
  } else {
    const auto creepage = force_given ? creepage_from_fastsim2(contact, force_x, force_y) : contact.creepage;
    if (!creepage) return rolling_.solve(bound, input);
    at_start.creepage = *creepage;
    start = from_fastsim2(at_start, bound);
  }
  input.start = {
      .px = start.x, .py = start.y, .constants = Vec2{at_start.creepage.longitudinal, at_start.creepage.lateral}};
  if (!force_given) return rolling_.solve(bound, input);

  const VectorField fastsim2 = from_fastsim2(at_start, bound);
  const std::array derivatives = {derivative(at_start, 0, bound, fastsim2), derivative(at_start, 1, bound, fastsim2)};
  input.start.by_constants = {TractionsView{derivatives[0].x, derivatives[0].y},
                              TractionsView{derivatives[1].x, derivatives[1].y}};
  return rolling_.solve(bound, input);
}

} // namespace microslip
