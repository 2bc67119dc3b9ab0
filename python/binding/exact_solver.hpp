#pragma once

#include "binding/long_work.hpp"
#include "microslip/rolling/accurate_contact.hpp"
#include "microslip/rolling/solver.hpp"

#include <optional>

namespace microslip::python {

/// What all problems of a solver have in common, whatever their contact.
struct CommonProblem {
  RollingProblem problem = {};       ///< friction but its law, heat, direction of rolling
  std::optional<Bodies> bodies = {}; ///< none: elastic ones with the contact's constants

  /// The problem of a contact. Throws Error if it has another K than the bodies.
  RollingProblem of(const EllipticContact& contact, Motion motion = {}) const;
};

/// Hertzian contacts by the exact theory.
class ExactSolver {
public:
  /// Throws Error for options that do not go together.
  ExactSolver(const CommonProblem& common, const Method& method);

  const Method& method() const { return solver_.method(); }
  bool has_bodies() const { return common_.bodies.has_value(); }
  ExactSolver copy() const { return {common_, method()}; }

  /// What cannot be solved is a status.
  ContactSolution solve(const EllipticContact& contact, const Motion& motion, const Progress& progress);
  ExactDerivatives differentiate(const EllipticContact& contact, const Progress& progress);
  GapValues deformed_gap(const EllipticContact& contact, const Motion& motion, const Progress& progress);

private:
  CommonProblem common_;
  Solver solver_;
};

/// The same to an accuracy.
class AccurateSolver {
public:
  AccurateSolver(const CommonProblem& common, const Method& method) : common_(common), solver_(method) {}

  AccurateContact solve(const EllipticContact& contact, const Motion& motion, const Progress& progress) {
    return solver_.solve(common_.of(contact, motion), progress);
  }

private:
  CommonProblem common_;
  AccurateContactSolver solver_;
};

} // namespace microslip::python
