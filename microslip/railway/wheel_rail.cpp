#include "microslip/railway/wheel_rail.hpp"

#include "microslip/contact/mirrored_solution.hpp"
#include "microslip/error.hpp"
#include "microslip/railway/call_progress.hpp"
#include "microslip/railway/exact/exact_contact.hpp"
#include "microslip/railway/problem/wheel_status.hpp"
#include "microslip/railway/wheel_assessment.hpp"
#include "microslip/railway/wheel_rail_checks.hpp"
#include "microslip/railway/wheel_rail_derivatives.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"
#include "microslip/railway/wheel_theories.hpp"

#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace microslip {
namespace {

bool is_finite(const WheelRailDerivatives& d) {
  return std::isfinite(std::accumulate(d.values.begin(), d.values.end(), 0.0));
}

} // namespace

/// Solves left wheels; right ones in a mirror.
struct WheelRail::Workspace {
  WheelRailBodies bodies;
  WheelRailMethod method;
  const WheelTheory& theory = theory_of(method);
  NominalPlacement nominal = nominal_placement(bodies.track, bodies.rail, bodies.wheelset, bodies.wheel);
  EquivalentContact contact{bodies, method, nominal};
  WheelLimits limits = limits_of(bodies, contact.rows());
  NearbyForces nearby = nearby_forces();
  WheelRailSolution trial{};
  Progress progress = {}; ///< of the call at hand

  Workspace(WheelRailBodies given, const WheelRailMethod& how) : bodies(std::move(given)), method(how) {
    trial.patches.reserve(most_patches);
  }
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  void solve(const WheelState<double>& state, std::optional<double> vertical_force, WheelRailSolution& out) {
    solve_left(left(state), vertical_force, out);
    if (is_right()) mirror(out);
  }

  void differentiate(const WheelState<double>& state, std::optional<double> vertical_force, WheelRailSolution& out,
                     WheelRailDerivatives& derivatives) {
    derivatives = {};
    solve_left(left(state), vertical_force, out);
    if (is_solved(out.status) && !find_derivatives(left(state), vertical_force, out, derivatives)) {
      derivatives = {};
      out.status = Status::not_converged, out.residual = 1, out.reason = Unsolved::derivatives;
    }
    if (is_right()) mirror(out), mirror(derivatives);
  }

  std::vector<FrequencyResponse> respond(const WheelState<double>& state, std::optional<double> vertical_force,
                                         std::span<const double> wavenumbers, WheelRailSolution& out) {
    std::vector<FrequencyResponse> responses;
    solve_left(left(state), vertical_force, out);
    if (out.status == Status::ok) {
      WheelState<double> in_height = left(state);
      in_height.vertical = out.vertical;
      responses = respond_exact(contact.rows(), in_height, bodies, method, wavenumbers, out, progress);
      conclude(out, in_height.vertical, method.solved_tolerance());
      assess(bodies, limits, method.surface(), out);
    }
    if (!is_right()) return responses;
    mirror(out);
    for (FrequencyResponse& of_patch : responses) {
      mirror(of_patch.solution);
      for (ForceResponse& response : of_patch.at) response = mirrored_across(response);
    }
    return responses;
  }

private:
  bool is_right() const { return bodies.side == TrackSide::right; }
  WheelState<double> left(const WheelState<double>& state) const { return is_right() ? state.mirrored() : state; }

  /// No number of a state makes it throw: the state has a status, and others can be solved.
  void solve_left(const WheelState<double>& state, std::optional<double> vertical_force, WheelRailSolution& out) {
    if (theory.by_elements)
      contact.rows().height().reset(); // next to nothing of the cost, and the grids are the same each time
    try {
      if (solve_rows(state, vertical_force, out)) theory.solve(contact, state, method, vertical_force, out, progress);
    } catch (const Error&) {
      out.status = Status::not_converged, out.residual = std::numeric_limits<double>::quiet_NaN();
    }
    conclude(out, state.vertical, method.solved_tolerance());
    if (out.status == Status::not_converged) contact.rows().height().reset(); // it is no start for the next state
    assess(bodies, limits, method.surface(), out);
    if (!theory.by_elements && !method.fields) out.fields.clear(); // they were there for wear
  }

  /// Returns whether there is contact.
  bool solve_rows(const WheelState<double>& state, std::optional<double> vertical_force, WheelRailSolution& out) {
    begin(state, out);
    if (!is_in_range(state) || (vertical_force && !is_vertical_force(*vertical_force))) {
      out.status = Status::invalid_input;
      return false;
    }
    out.status = Status::no_contact;
    if (!contact.move_to(state, vertical_force.has_value())) return false;
    RowContact& rows = contact.rows();
    rows.height().solve(state, vertical_force, out);
    if (out.status == Status::no_contact) return false;
    rows.sum(out);
    return true;
  }

  static void begin(const WheelState<double>& state, WheelRailSolution& out) {
    out.patches.clear(), out.fields.clear();
    out.patches.reserve(most_patches); // for all that come later
    out.force = out.moment = {};
    out.residual = 0, out.iterations = 0, out.warnings = {};
    out.y_over_q.reset(), out.nadal_limit.reset();
    out.vertical = state.vertical, out.reason = Unsolved::none;
  }

  /// False if they are not numbers, or nearby states cannot be solved.
  bool find_derivatives(const WheelState<double>& state, std::optional<double> vertical_force,
                        const WheelRailSolution& found, WheelRailDerivatives& out) {
    try {
      microslip::differentiate(nearby, nominal, contact.varies(), state, vertical_force, found, out);
    } catch (const Error&) {
      return false;
    }
    return is_finite(out);
  }

  Wrench of_rows() {
    const WheelForces forces = contact.rows().forces();
    return {forces.force, forces.moment};
  }

  NearbyForces nearby_forces() {
    NearbyForces forces;
    forces.of_rows = [this](const WheelState<double>& state) {
      solve_rows(state, {}, trial);
      return Wrench::of(trial);
    };
    forces.of_shifted_rows = [this](const WheelState<double>& state) {
      if (contact.rows().height().shift(state)) return of_rows();
      solve_rows(state, {}, trial);
      return Wrench::of(trial);
    };
    forces.of_moving_rows = [this](const WheelState<double>& state) {
      contact.rows().height().move(state);
      return of_rows();
    };
    if (theory.by_elements)
      forces.of_elements = [this](const WheelState<double>& state, std::optional<double> vertical_force) {
        solve_left(state, vertical_force, trial);
        return Wrench::of(trial);
      };
    return forces;
  }
};

WheelRail::WheelRail(WheelRailBodies bodies, const WheelRailMethod& method) {
  require_valid(bodies, method);
  workspace_ = std::make_unique<Workspace>(std::move(bodies), method);
}
WheelRail::WheelRail(WheelRail&&) noexcept = default;
WheelRail& WheelRail::operator=(WheelRail&&) noexcept = default;
WheelRail::~WheelRail() = default;

void WheelRail::solve(const WheelState<double>& state, std::optional<double> vertical_force,
                      WheelRailSolution& solution, const Progress& progress) {
  const CallProgress told(workspace_->progress, progress);
  workspace_->solve(state, vertical_force, solution);
}

WheelRailSolution WheelRail::solve(const WheelState<double>& state, std::optional<double> vertical_force,
                                   const Progress& progress) {
  WheelRailSolution solution;
  solve(state, vertical_force, solution, progress);
  return solution;
}

void WheelRail::reset() {
  workspace_->contact.rows().height().reset();
}

std::vector<FrequencyResponse> WheelRail::respond(const WheelState<double>& state, std::optional<double> vertical_force,
                                                  std::span<const double> wavenumbers, WheelRailSolution& solution,
                                                  const Progress& progress) {
  if (!workspace_->theory.by_elements) throw Error("responses: by the theory exact only");
  if (workspace_->bodies.layered) throw Error("responses: not of bodies with layers");
  require_wavenumbers(wavenumbers);
  const CallProgress told(workspace_->progress, progress);
  return workspace_->respond(state, vertical_force, wavenumbers, solution);
}

void WheelRail::differentiate(const WheelState<double>& state, std::optional<double> vertical_force,
                              WheelRailSolution& solution, WheelRailDerivatives& derivatives,
                              const Progress& progress) {
  const CallProgress told(workspace_->progress, progress);
  workspace_->differentiate(state, vertical_force, solution, derivatives);
}

} // namespace microslip
