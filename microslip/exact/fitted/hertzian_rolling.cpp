#include "microslip/exact/fitted/hertzian_rolling.hpp"

#include "microslip/exact/classical/fastsim2_start.hpp"
#include "microslip/exact/fitted/coarse_start.hpp"
#include "microslip/simplified/fastsim2_creepage.hpp"

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

TangentialState HertzianRolling::from_fastsim2(const EllipticContact& contact, std::span<const double> bound) const {
  const FittedContact& fitted = this->contact();
  std::vector<double> grid_bound(fitted.grid.count());
  for (std::size_t k = 0; k < bound.size(); ++k) grid_bound[fitted.elements[k].cell] = bound[k];
  const TangentialState on_grid = start_from_fastsim2(contact, fitted.grid, grid_bound, RollingDirection::forward);
  TangentialState start;
  for (const FittedElement& e : fitted.elements) {
    start.px.push_back(on_grid.px[e.cell]);
    start.py.push_back(on_grid.py[e.cell]);
  }
  return start;
}

/// By how much FASTSIM2's tractions, `start`, grow with the longitudinal (0) or lateral (1) creepage. Nothing near full
/// sliding, where they hardly do: such numbers would mislead.
TangentialState HertzianRolling::growth(const EllipticContact& contact, int direction, std::span<const double> bound,
                                        const TangentialState& start) const {
  const double stiffness = contact.shear_modulus * contact.a * contact.b; // dF/dxi in adhesion over Kalker's C11
  const double unit = 1e-3 * contact.friction.static_coefficient() * contact.normal_force / stiffness;
  EllipticContact moved = contact;
  (direction == 0 ? moved.creepage.longitudinal : moved.creepage.lateral) += unit;
  TangentialState growth = from_fastsim2(moved, bound);
  const FittedContact& fitted = this->contact();
  double slope = 0;
  for (std::size_t k = 0; k < bound.size(); ++k) {
    growth.px[k] = (growth.px[k] - start.px[k]) / unit;
    growth.py[k] = (growth.py[k] - start.py[k]) / unit;
    slope += (direction == 0 ? growth.px[k] : growth.py[k]) * fitted.elements[k].width() * fitted.grid.dy;
  }
  if (std::abs(slope) < 0.02 * stiffness) return {};
  return growth;
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
  TangentialState start;
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
      .px = start.px, .py = start.py, .constants = Vec2{at_start.creepage.longitudinal, at_start.creepage.lateral}};
  if (!force_given) return rolling_.solve(bound, input);

  const TangentialState fastsim2 = from_fastsim2(at_start, bound);
  const std::array growths = {growth(at_start, 0, bound, fastsim2), growth(at_start, 1, bound, fastsim2)};
  input.start.growth = {FrictionNewton::Tractions{growths[0].px, growths[0].py},
                        FrictionNewton::Tractions{growths[1].px, growths[1].py}};
  return rolling_.solve(bound, input);
}

} // namespace microslip
