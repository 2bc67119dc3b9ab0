#pragma once

#include "microslip/contact/solver_report.hpp"
#include "microslip/contact/vector_field.hpp"
#include "microslip/exact/halfspace/slip_operator.hpp"
#include "microslip/exact/newton/slip_dependent_bound.hpp"
#include "microslip/vec2.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace microslip {

/// The discrete tangential problem in its simplest form, (E2): find p with |p| <= g and, with s = c + D p, p = -g s/|s|
/// where s is not zero. Where a force is given, the constant part of c in that direction is an unknown too. A bound
/// that depends on the slip replaces g.
struct FrictionProblem {
  SlipOperator& slip_operator;                      ///< D
  std::span<const double> bound;                    ///< g [Pa], >= 0; zero outside the contact
  std::span<const double> cx, cy;                   ///< slip without tractions
  double element_area;                              ///< [m^2]
  std::optional<double> force_x = {}, force_y = {}; ///< [N]; where given, cx or cy is known up to a constant ...
  std::span<const double> constant_share = {};      ///< ... times this for each element; empty: times 1
  std::span<const double> area_share = {};          ///< an element's area over element_area; empty: 1
  SlipDependentBound* slip_dependent = nullptr;     ///< instead of the bound, which then is its largest
  std::span<const double> pressure = {};            ///< p_n [Pa], of a slip-dependent bound
};

struct FrictionSolution {
  VectorField traction;      ///< [Pa]
  VectorField slip;          ///< c + D p, with the constants
  std::vector<char> sliding; ///< 1 in slip, 0 in adhesion and outside the contact
  Vec2 constants;            ///< added to cx, cy where a force is given
  SolverReport report;       ///< the residual is |p - P_g(p - rho s)| over |g| (E21), 2-norms over the elements

  FrictionSolution() = default;
  explicit FrictionSolution(std::size_t elements) : traction(elements), slip(elements), sliding(elements) {}
};

/// Tractions that are stored elsewhere [Pa]; empty: zero.
struct TractionsView {
  std::span<const double> px = {}, py = {};
};

/// Start of an iteration.
struct FrictionStart {
  std::span<const double> px = {}, py = {}; ///< tractions [Pa]; empty: zero
  std::optional<Vec2> constants = {};       ///< the unknown ones; none: where the mean slip is zero
  /// Approximate derivatives of the tractions with respect to each constant; empty: unknown. If known for all unknown
  /// constants, the linear systems are solved among tractions that have the forces wanted; the better, the fewer
  /// products it takes.
  std::array<TractionsView, 2> by_constants = {};
};

} // namespace microslip
