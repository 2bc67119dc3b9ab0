#pragma once

#include "microslip/contact/element_grid.hpp"
#include "microslip/elasticity/material.hpp"

#include <span>
#include <vector>

namespace microslip {

/// Approximate pressures for contacts that are not quite Hertzian, by virtual penetration: from the interpenetration of
/// the undeformed bodies at a given approach, without solving the normal problem. For one region of contact with one
/// interval in each row.
///
/// `gap` is the undeformed distance h of the elements [m], `approach` delta [m]. Each returns p_n of the elements [Pa],
/// all zero where the bodies do not reach each other; its sum is the normal force. Cost O(elements). Both throw Error
/// for sizes that do not match, an approach that is not finite, a grid of less than 3 x 3 elements, and where the
/// gap is smallest at the grid's border, where its curvature cannot be evaluated.

/// Kik and Piotrowski's method with the correction of an ellipse's shape (KPEC), in CONTACT's form, (H14). Curvatures
/// A, B from the region with at least half of the deepest interpenetration d, Hertz's ellipse for A, B and d, and from
/// it for each row the share eps(y) = (A a^2 - (A a^2 - B b^2) (y - y_m)^2/b^2)/d, within 0 to 1, that deformation
/// takes away: contact is where the interpenetration is at least (1 - eps) d. In rows p_n is semi-elliptic, as high as
/// the row is long, and scaled so that the half-space is pressed in by d at the deepest point.
std::vector<double> kik_piotrowski_pressure(const CombinedMaterial& material, const ElementGrid& grid,
                                            std::span<const double> gap, double approach);

/// Sichani, Enblom and Berg's ANALYN, in CONTACT's form, (H15). For each row, with the position x_c of its smallest
/// gap, g above the smallest of all, and local curvatures A, B: Hertz's ellipse for A, B and the deepest
/// interpenetration d gives the local depth d' = d - g d/(B b^2), the half length sqrt(d' A a^2/(d A)) and, with d',
/// the peak of a semi-elliptic pressure.
std::vector<double> analyn_pressure(const CombinedMaterial& material, const ElementGrid& grid,
                                    std::span<const double> gap, double approach);

} // namespace microslip
