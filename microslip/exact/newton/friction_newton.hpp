#pragma once

#include "microslip/exact/fitted/centred_slip.hpp"
#include "microslip/exact/fitted/rolling_preconditioner.hpp"
#include "microslip/exact/halfspace/surface_response.hpp"
#include "microslip/numerics/gmres.hpp"
#include "microslip/progress.hpp"
#include "microslip/status.hpp"
#include "microslip/vec2.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace microslip {

/// The discrete tangential problem in its simplest form: find p with |p| <= g and, with s = c + D p, p = -g s/|s| where
/// s is not zero. Where a force is given, the constant part of c in that direction is an unknown too.
struct FrictionProblem {
  SlipResponse& response;                           ///< D
  std::span<const double> bound;                    ///< g [Pa], >= 0; zero outside the contact
  std::span<const double> cx, cy;                   ///< slip without tractions
  double element_area;                              ///< [m^2]
  std::optional<double> force_x = {}, force_y = {}; ///< [N]; where given, cx or cy is known but for a constant ...
  std::span<const double> constant_share = {};      ///< ... times this for each element; empty: times 1
  std::span<const double> area_share = {};          ///< an element's area over element_area; empty: 1
  RollingPreconditioner<double>* preconditioner = nullptr; ///< for D
  CentredSlip<double>* centred = nullptr;                  ///< moves D p; c is where it is moved to
};

struct FrictionSolution {
  std::vector<double> px, py;            ///< tractions [Pa]
  std::vector<double> sx, sy;            ///< slip c + D p, with the constants
  std::vector<char> sliding;             ///< 1 in slip, 0 in adhesion and outside the contact
  double constant_x = 0, constant_y = 0; ///< added to cx, cy where a force is given
  double residual = 0;                   ///< |p - P_g(p - rho s)| over |g|, 2-norms over the elements
  int newton_steps = 0;
  long products = 0;
  Status status = Status::ok;
};

/// Solves F(p) = p - P_g(p - rho s(p)) = 0, where P_g projects each element's traction on the disk of radius g, by a
/// semi-smooth Newton method, with the derivative of LinearisedFriction.
class FrictionNewton {
public:
  /// Tractions [Pa]; empty: zero.
  struct Tractions {
    std::span<const double> px, py;
  };
  struct Options {
    double tolerance = 1e-6; ///< of FrictionSolution::residual
    /// A step's state before. The residual then falls below `tolerance` times that of these tractions, too, but not
    /// below 1e-12: a step however small is done to its own scale, and nothing of it is lost in the next one.
    std::optional<Tractions> before = {};
    Progress progress = {}; ///< is told after each step; false ends the iteration
    int most_steps = 100;
    int most_inner = 300; ///< products in the linear solver of one step
  };

  /// Where to begin.
  struct Start {
    std::span<const double> px = {}, py = {}; ///< tractions [Pa]; empty: zero
    std::optional<Vec2> constants = {};       ///< the unknown ones; none: where the mean slip is zero
    /// Roughly by how much the tractions grow with a unit of each constant; empty: unknown. If known for all unknown
    /// constants, the linear systems are solved among tractions that have the forces wanted; the better, the fewer
    /// products it takes.
    std::array<Tractions, 2> growth = {};
  };

  FrictionSolution solve(const FrictionProblem& problem, const Options& options, const Start& start);
  FrictionSolution solve(const FrictionProblem& problem, const Options& options) { return solve(problem, options, {}); }

private:
  Gmres<double> gmres_;
};

} // namespace microslip
