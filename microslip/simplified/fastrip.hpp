#pragma once

#include "microslip/simplified/row_solver.hpp"
#include "microslip/vec2.hpp"

#include <span>

namespace microslip {

/// A row of a contact that FASTSIM has solved: what FaStrip reads, and the tractions and slip that it changes.
struct StripRow {
  double y;                      ///< of its centre line [m]
  double middle, half_length;    ///< of the contact along the row [m]
  std::span<const double> x;     ///< centres of the cells [m], in any order
  std::span<const double> bound; ///< g [Pa]
  std::span<double> px, py;      ///< tractions on body 1 [Pa]
  std::span<double> sx, sy;      ///< relative slip [-]
  std::span<CellState> state;
};

/// Strip theory (Kalker 1967), scaled to Kalker's creepage coefficients: FaStrip's part that is not FASTSIM (Sichani,
/// Enblom & Berg 2016). docs/theory-fastsim2.md, section 11.
class StripTheory {
public:
  /// Theory of an ellipse, with load, material and creepages, and a uniform coefficient of friction [-], > 0.
  StripTheory(const EllipticContact& contact, double friction, RollingDirection direction,
              CreepageTable table = CreepageTable::kalker);

  /// Gives the cells of the row that strip theory finds in adhesion its tractions, which may exceed g near the leading
  /// edge, and no slip; the others slide in the direction that FASTSIM has found. A row whose tractions would exceed
  /// the friction bound of the ellipse's centre is left as FASTSIM has it. Cost O(cells).
  void solve(const StripRow& row) const;

  /// phi' [-], the scaled spin. At 1 and above nothing of strip theory adheres.
  double scaled_spin() const { return spin_; }

private:
  struct Strip;
  Strip strip(const StripRow& row) const;
  Vec2 traction(const Strip& strip, const StripRow& row, std::size_t cell) const;

  double a_, one_less_nu_, peak_; ///< peak of the bound [Pa]
  double mirror_;                 ///< 1 rolling along +x, -1 along -x: the contact is solved in the mirror then
  double longitudinal_, lateral_, lateral_per_metre_, spin_; ///< scaled, in the mirror
};

/// FaStrip as CONTACT modifies it: FASTSIM on the ellipse's grid with the elliptic bound, then strip theory in its
/// rows; tractions above the bound are drawn back to it. The slip of FASTSIM turns into the right direction
/// with blended flexibilities only. Cost some six times FASTSIM's in a batch.
class Fastrip {
public:
  /// The bound must be elliptic, without slope reduction; else, and as RowSolver does, throws Error.
  explicit Fastrip(const SimplifiedOptions& options);

  const SimplifiedOptions& options() const { return fastsim_.options(); }

  /// Input out of range, or friction other than Coulomb's, gives Status::invalid_input and NaN.
  ContactForces solve(const EllipticContact& contact) { return fields(contact).forces(); }
  void solve(std::span<const EllipticContact> contacts, std::span<ContactForces> forces);
  /// Slip is FASTSIM's, and zero where only strip theory slides; so is the frictional power.
  ContactSolution fields(const EllipticContact& contact);

private:
  RowSolver fastsim_;
};

} // namespace microslip
