#pragma once

#include "microslip/simplified/row_solver.hpp"

#include <functional>
#include <optional>

namespace microslip {

/// Forces on body 1 that are prescribed [N]; where there is none the creepage is.
struct PrescribedForces {
  std::optional<double> x = {}, y = {};
};

/// Creepages that belong to prescribed forces.
struct FoundCreepage {
  Creepage creepage;
  /// Misfit of the forces, over the capacity [-]; for a force beyond it the excess.
  double residual = 0;
  /// not_converged: no creepages found; no_solution: the force is not below what friction carries, so that all slides
  /// in its direction and the creepages are not known.
  Status status = Status::ok;
};

/// Finds the creepages at which a solver of the simplified theory has prescribed forces: Newton's method from zero
/// creepage on, with finite-difference derivatives, see find_plane_root. `forces` are those at given creepages, to be
/// continuous and piecewise smooth in them; `given` has the spin and the creepages that are prescribed. `capacity` is
/// what friction carries [N], `creepage_scale` the size of creepages that matter, as mu Fn/(G A) for an area A;
/// `tolerance` is relative to the capacity. Cost: 3 solutions for a step.
FoundCreepage find_creepage(const std::function<ContactForces(const Creepage&)>& forces,
                            const PrescribedForces& prescribed, const Creepage& given, double capacity,
                            double creepage_scale, double tolerance);

/// Creepages found with FASTSIM or FASTSIM2 for an ellipse; the creepages of the contact are those that are prescribed.
FoundCreepage find_creepage(RowSolver& solver, const EllipticContact& contact, const PrescribedForces& prescribed,
                            double tolerance = 1e-9);

} // namespace microslip
