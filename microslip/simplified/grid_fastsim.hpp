#pragma once

#include "microslip/contact/contact_solution.hpp"
#include "microslip/simplified/flexibility.hpp"
#include "microslip/vec2.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace microslip {

/// Rolling motion of the bodies, for the simplified theory on a grid.
struct GridRolling {
  Creepage creepage = {}; ///< xi [-], eta [-], phi [1/m]: w = (xi - phi (y - yc), eta + phi (x - xc))
  Vec2 spin_centre{};     ///< (xc, yc) [m]
  bool spin_in_x = true;  ///< whether the spin counts in wx
  bool spin_in_y = true;  ///< and in wy
  /// Slip of each element on top of that [-]; empty: none.
  std::span<const double> extra_x = {}, extra_y = {};
  Vec2 ahead{}; ///< from an element's centre to the point at which its rigid slip is taken [m]
  RollingDirection direction = RollingDirection::forward;
  double rolling_speed = 1; ///< V [m/s], for the frictional power
  /// One step of transient rolling: the displacements of the elements' particles before it [m], empty: none; null:
  /// steady rolling.
  const VectorField* before = nullptr;
  double step = 0; ///< dq [m] > 0 of transient rolling; steady rolling takes the elements' length
};

/// Elements of a row next to each other that are in contact: columns first to first + count - 1.
struct ElementRun {
  int row = 0, first = 0, count = 0;
};

/// FASTSIM (Kalker 1982) on the rows of a grid of elements, for any shape of the contact and any pressure: backward
/// Euler (F16) from element to element of each run in contact, u + s dq = u' + w dq, |p| <= g, with u = L p and u' that
/// of the element ahead in steady rolling, that of its particle before the step in transient rolling. First order in
/// the elements' length. In w the spin's parts are scaled by L1/L3 and L2/L3 to the flexibilities.
class GridFastsim {
public:
  /// `pressure` is p_n of the elements [Pa]; the contact is where it is positive. Throws Error for a grid without
  /// elements and for another number of pressures.
  GridFastsim(const ElementGrid& grid, std::span<const double> pressure);

  const ElementGrid& grid() const { return elements_.grid; }
  /// Rows ascending, in each columns ascending.
  const std::vector<ElementRun>& runs() const { return runs_; }
  double contact_area() const; ///< [m^2]
  /// Friction limit [N]. `friction` is mu of each row [-]; one: the same for all.
  double capacity(std::span<const double> friction) const;
  /// The ellipse with the contact's area and its ratio of length to width, for flexibilities: a, b [m].
  Vec2 equivalent_axes() const;

  /// The fields are without pressures. Throws Error for flexibilities that are not positive, and for numbers of
  /// friction coefficients and fields that do not fit the grid. Cost O(elements).
  ContactSolution solve(const Flexibilities& flexibilities, std::span<const double> friction,
                        const GridRolling& rolling) const;
  /// All of the contact sliding in one direction (a unit vector), the tractions at their bound; the slip is not known,
  /// and zero here.
  ContactSolution slide(const Flexibilities& flexibilities, std::span<const double> friction, Vec2 direction) const;

private:
  void check_friction(std::span<const double> friction) const;
  double friction_of(int row, std::span<const double> friction) const;
  ContactSolution empty_solution(std::span<const double> friction) const;

  Elements elements_;
  std::vector<double> pressure_;
  std::vector<ElementRun> runs_;
};

/// Fills in what follows from tractions, slip and states: the displacements of the springs u = L p, the creepages about
/// the frame's origin, the totals.
void find_totals(const Flexibilities& flexibilities, const GridRolling& rolling, ContactSolution& solution);

} // namespace microslip
