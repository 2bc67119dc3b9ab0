#pragma once

#include "microslip/contact/element_grid.hpp"
#include "microslip/contact/motion.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace microslip {

/// An element of a contact that rolls along +x. All have the length of the grid's but the leading one of a row, which
/// is fitted to the edge (edge_element.hpp), and the only one of a row shorter than an element.
struct FittedElement {
  int row = 0;
  std::uint32_t cell = 0;     ///< of the grid: where results on the grid have it
  double left = 0, right = 0; ///< [m]
  double point = 0;           ///< where its displacement is taken: its centre; in steps, that of the grid's element [m]
  double end = 0;             ///< its slip is that of the path from `point` to here [m]
  bool fitted = false;        ///< is not one of the grid's elements
  bool leads = false;         ///< is the first one that particles enter
  bool trails = false;        ///< is the last one

  double centre() const { return (left + right) / 2; }
  double width() const { return right - left; }
};

/// A contact area covered with elements that are fitted to its leading edge: row after row, in each from the trailing
/// to the leading edge. Elements of a row that follow one another have consecutive indices.
struct FittedContact {
  ElementGrid grid; ///< that the elements are part of, with columns to spare ahead of the contact
  std::vector<FittedElement> elements;
  std::vector<double> load_share; ///< of each element in the integral of the traction bound, over its area [1/m^2]
};

/// n x m elements across Hertz's ellipse. The bound is averaged over the area that an element stands for (E27): what no
/// element covers counts for the nearest one of its row, so that the shares times the areas have the sum 1 to rounding.
/// For steady rolling, or for steps of transient rolling by an element's length: then leading elements have other
/// widths (leading_element_width_of_step).
FittedContact fit_ellipse(double a, double b, int n, int m, ContactMotion motion = ContactMotion::steady);

/// Elements with x stretched by `along` and y by `across`: fit_ellipse(a, b, n, m) is fit_ellipse(1, 1, n,
/// m) stretched by a and b, up to rounding. Throws Error where the elements' sizes underflow or overflow.
FittedContact stretched(FittedContact contact, double along, double across);

/// n elements across a Hertzian line contact of half-width a; forces are counted for `length` [m]. As fit_ellipse.
FittedContact fit_line(double a, int n, double length = 1);

/// Any contact area, from the pressure [Pa] of the normal problem at a grid's elements (only its shape matters); the
/// edges by contact_runs. Every run of elements in contact is a separate row, as in contacts of several patches. The
/// bound has along a run the shape sqrt((x - x_t)(x_l - x)) times a factor that is the pressure's (its mean over the
/// element, E38) 2 elements or more inside, and passes into a straight line from there to 1 element from the edges,
/// where the pressures of elements are bad; a run's share of the load is the normal problem's, so that the shares times
/// the areas have the sum 1 to rounding. An element that would overlap the leading element of a run behind is left out
/// and its load counts for the next one: across a gap shorter than an element or two the bodies are discretised, but
/// not at second order.
///
/// Throws Error for pressures below zero or not finite, without any contact, for bilinear elements, and unless the grid
/// has three columns to spare ahead of the contact and one behind.
FittedContact fit_contact(const ElementGrid& grid, std::span<const double> pressure);

/// The elements of fit_contact(grid, `before`) for another pressure, so near that as many do: leading elements follow
/// their edges, and the bound is the other pressure's. A run that is not there any more keeps its elements, with no
/// bound.
FittedContact refitted(FittedContact contact, std::span<const double> before, std::span<const double> pressure);

} // namespace microslip
