#pragma once

#include "microslip/contact/contact_solution.hpp"
#include "microslip/simplified/options.hpp"
#include "microslip/simplified/rows.hpp"

#include <memory>
#include <span>

namespace microslip {

/// Integration of a step from one cell centre to the next.
enum class MarchingScheme {
  fastsim,           ///< backward Euler with a full first step and w at the new centre (F16)
  fastsim_half_step, ///< backward Euler with a half first step and w in the middle of the step
  fastsim2,          ///< trapezoidal rule with tracked boundaries (F35)-(F40)
};

/// Marches particles through the contact, row by row: what FASTSIM and FASTSIM2 have in common. All memory is taken in
/// the constructor. The calls marked noexcept allocate nothing, take no lock, do no input or output, and their work is
/// bounded. Distinct objects may be used from distinct threads.
class RowSolver {
public:
  /// Throws Error if an option is out of range or the instruction set is not available.
  RowSolver(MarchingScheme scheme, const SimplifiedOptions& options);
  RowSolver(const RowSolver& other);
  RowSolver(RowSolver&&) noexcept;
  RowSolver& operator=(RowSolver other) noexcept;
  ~RowSolver();

  const SimplifiedOptions& options() const;
  MarchingScheme scheme() const;

  /// Forces of one contact; of many contacts, which is faster per contact. Input out of range gives
  /// Status::invalid_input and NaN. Full sliding gives mu Fn to rounding on every grid. Cost O(mx my).
  ContactForces solve(const EllipticContact& contact) noexcept;
  void solve(std::span<const EllipticContact> contacts, std::span<ContactForces> forces) noexcept;

  /// Forces and their derivatives with respect to the creepages and the load, by forward differentiation of the same
  /// code.
  ContactDerivatives differentiate(const EllipticContact& contact) noexcept;
  void differentiate(std::span<const EllipticContact> contacts, std::span<ContactDerivatives> derivatives) noexcept;

  /// Forces with the tractions, slip, bound and state of every cell.
  ContactSolution fields(const EllipticContact& contact);
  /// Solves a patch of any outline; only mx is taken from the patch, and the weights are the cells' areas.
  /// Throws Error if the patch is invalid.
  ContactSolution fields(const PatchRows& patch, const PatchMotion& motion);

private:
  struct Workspace;
  std::unique_ptr<Workspace> workspace_;
};

} // namespace microslip
