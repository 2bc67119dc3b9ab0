#pragma once

namespace microslip {

/// Leading elements fitted to the edge of contact.
///
/// Near the edge where particles enter, tractions grow like the square root of the distance, which elements of constant
/// traction follow badly: a row that ends at the edge has a force with an error of first order in the element's width
/// h. That error vanishes if the leading element, of the width omega h, ends beta(omega) h inside the edge, the others
/// having the width h. It is understood that slip is taken over the intervals between the centres of successive
/// elements, the last of them ending h/2 beyond the leading element. beta comes from the half-line in full adhesion,
/// (E28) to (E33): docs/theory-second-order.md, section 5, and the study `edge-constants`, which computes the
/// coefficients.
inline constexpr double narrowest_leading_element = 0.4, widest_leading_element = 1.7;

/// beta(omega) [-], from 0.319 to 0.361; the error is below 1e-9. Throws Error unless omega is in [0.4, 1.7].
double edge_inset(double omega);

/// The omega [-] with omega + beta(omega) = distance: the width of the leading element over h when its rear side lies
/// `distance` h from the edge. Grows with the distance. Throws Error unless that is in [edge_distance(0.4),
/// edge_distance(1.7)] = [0.7216, 2.0606]; the edge of any row of elements has such a distance from one of their sides.
double leading_element_width(double distance);

/// omega + beta(omega) [-].
double edge_distance(double omega);

/// Width of the leading element where displacements are taken at the centres of the grid's elements also for the
/// leading one, h/2 and 3 h/2 from its rear side, as in steps of transient rolling: section 10 there. Error below 1e-3.
/// Throws Error unless the distance is in [nearest_edge_of_step, nearest_edge_of_step + 1]: widths of 0.94 to 1.65.
inline constexpr double nearest_edge_of_step = 1.3;
double leading_element_width_of_step(double distance);

} // namespace microslip
