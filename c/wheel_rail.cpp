#include "c/problem.hpp"
#include "io/wheel_rail_case.hpp"
#include "microslip/description/words.hpp"
#include "microslip/railway/geometry/conicity.hpp"
#include "microslip/railway/geometry/wheelset_contact_quantities.hpp"
#include "microslip/railway/rows/row_contact.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <string_view>

using namespace microslip;
using namespace microslip::c;

struct microslip_wheel_rail {
  WheelRail solver;
  io::LoadedWheelState first; ///< of the case file
  WheelRailSolution solution = {};
  WheelRailDerivatives derivatives = {};
  std::unique_ptr<io::WheelRailCase> input;
  bool is_solved = false;                             ///< a state was
  std::unique_ptr<WheelsetSearch> wheelset = nullptr; ///< made when it is first asked for
  mutable InUse in_use = false;
};

namespace {

constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

/// The first `width` numbers of a row by their table.
template <class Table, class Of> void store(const Table& table, const Of& from, std::size_t width, double* row) {
  for (std::size_t k = 0; k < width; ++k) row[k] = table[k].value(from);
}

/// A state of a solver, and the vertical force if that is given.
io::LoadedWheelState read_state(std::size_t width, const double* row) noexcept {
  io::LoadedWheelState read;
  for (std::size_t k = 0; k < width; ++k) {
    const StateQuantity* const of_state = wheel_inputs()[k].of_state;
    if (of_state)
      of_state->of(read.state) = row[k];
    else if (row[k] != 0)
      read.vertical_force = row[k];
  }
  return read;
}

void write_state(const io::LoadedWheelState& from, std::size_t width, double* row) {
  for (std::size_t k = 0; k < width; ++k) {
    const StateQuantity* const of_state = wheel_inputs()[k].of_state;
    row[k] = of_state ? of_state->value(from.state) : from.vertical_force.value_or(0);
  }
}

/// Checks that rows which a caller gives or wants exist and are no longer than their list.
microslip_code check_rows(std::size_t count, std::size_t width, const double* rows, std::size_t longest) noexcept {
  if (width > longest) return MICROSLIP_WRONG_SIZE;
  return count > 0 && width > 0 && !rows ? MICROSLIP_NULL_POINTER : MICROSLIP_OK;
}

/// The arrays of calls that solve states.
struct StateRows {
  std::size_t count, state_width;
  const double* states;
  std::size_t result_width;
  double* results;
  int* status; ///< or none

  microslip_code check() const noexcept {
    const microslip_code code = check_rows(count, state_width, states, wheel_inputs().size());
    return code == MICROSLIP_OK ? check_rows(count, result_width, results, wheel_results().size()) : code;
  }
  io::LoadedWheelState state(std::size_t k) const noexcept { return read_state(state_width, states + k * state_width); }
  void write(std::size_t k, const WheelRailSolution& solution) const noexcept {
    store(wheel_results(), solution, result_width, results + k * result_width);
    if (status) status[k] = code_of(solution.status);
  }
};

/// Marks states as unsolved for a reason that is not in their numbers, such as a lack of memory.
void leave_unsolved(microslip_wheel_rail& handle) noexcept {
  WheelRailSolution& solution = handle.solution;
  solution.patches.clear(), solution.fields.clear();
  solution.force = solution.moment = {};
  solution.vertical = not_given;
  solution.residual = 1;
  solution.iterations = 0;
  solution.y_over_q = solution.nadal_limit = {};
  solution.warnings = {};
  solution.status = Status::not_converged;
  handle.derivatives = {};
}

/// The largest magnitude of a number of a wheel's state.
double limit_of(std::string_view name) {
  return std::ranges::find(state_quantities(), name, &StateQuantity::name)->limit;
}

/// Returns true for an amplitude of lateral motion; contacts are searched for up to 1 m from the track's middle.
bool is_amplitude(double value) noexcept {
  return value > 0 && value <= 0.9;
}

WheelsetSearch& wheelset_of(microslip_wheel_rail& wheel_rail) {
  const io::WheelRailCase& input = *wheel_rail.input;
  for (const io::PlacedProfile* profile : {&input.rail, &input.wheel})
    io::require_one_section(profile->report, profile->surface, "a search for the contacts of a wheelset");
  const WheelsetSearch::Side side{input.rail.profile, input.wheel.profile};
  if (!wheel_rail.wheelset)
    wheel_rail.wheelset = std::make_unique<WheelsetSearch>(input.track, input.wheelset, side, side);
  return *wheel_rail.wheelset;
}

void write_no_contact(double lateral, std::size_t width, double* row) noexcept {
  std::fill_n(row, width, not_given);
  if (width > 0) row[0] = lateral;
}

void write_contact(const io::WheelRailCase& input, const WheelsetContact& found, std::size_t width, double* row) {
  if (found.status == Status::no_contact) return write_no_contact(found.lateral, width, row);
  const WheelsetSearch::Side side{input.rail.profile, input.wheel.profile};
  for (std::size_t k = 0; k < width; ++k) row[k] = wheelset_contact_quantities()[k].value(found, side, side);
}

/// Runs a call on each of many items; `solve` fills in the k-th result and returns its status, `leave_unsolved` fills
/// it in where that has thrown. The code of the first that is not ok.
template <class Solve, class LeaveUnsolved>
microslip_code for_each(std::size_t count, const Solve& solve, const LeaveUnsolved& leave_unsolved) noexcept {
  microslip_code code = MICROSLIP_OK;
  for (std::size_t k = 0; k < count; ++k) {
    const microslip_code status = guarded(nullptr, [&] { return solve(k); });
    if (status >= MICROSLIP_NULL_POINTER) leave_unsolved(k);
    if (code == MICROSLIP_OK) code = status;
  }
  return code;
}

/// Solves states by `solve`, which fills in the handle's solution, and hands each to `write` besides.
template <class Solve, class Write>
microslip_code solve_states(microslip_wheel_rail& handle, const StateRows& rows, const Solve& solve,
                            const Write& write) noexcept {
  const auto written = [&](std::size_t k) {
    rows.write(k, handle.solution);
    write(k);
    handle.is_solved = true;
    return code_of(handle.solution.status);
  };
  return for_each(
      rows.count,
      [&](std::size_t k) {
        solve(rows.state(k));
        return written(k);
      },
      [&](std::size_t k) {
        leave_unsolved(handle);
        written(k);
      });
}

/// Start of a state's solution.
enum class Start { anew, from_last };

microslip_code solve_rows(microslip_wheel_rail* wheel_rail, const StateRows& rows, Start start) noexcept {
  if (const microslip_code code = rows.check(); code != MICROSLIP_OK) return code;
  return with_handle(wheel_rail, [&] {
    const auto solve = [&](const io::LoadedWheelState& given) {
      if (start == Start::anew) wheel_rail->solver.reset();
      wheel_rail->solver.solve(given.state, given.vertical_force, wheel_rail->solution);
    };
    return solve_states(*wheel_rail, rows, solve, [](std::size_t) {});
  });
}

} // namespace

microslip_code microslip_wheel_rail_create(const microslip_problem* problem, microslip_wheel_rail** wheel_rail,
                                           microslip_error* error) {
  return guarded_use(error, "problem", problem, [&] {
    *require_pointer("wheel_rail", wheel_rail) = nullptr;
    if (problem->inputs.kind() != description::case_kinds[MICROSLIP_WHEEL])
      throw Error("problem: is none of a wheel on a rail");
    const io::WheelRailCase input = io::read_wheel_rail_case(problem->inputs.root());
    std::unique_ptr<microslip_wheel_rail> made(
        new microslip_wheel_rail{.solver = WheelRail(io::bodies_of(input), input.method),
                                 .first = input.states.front(),
                                 .input = std::make_unique<io::WheelRailCase>(input)});
    made->solution.patches.reserve(most_patches); // solving takes no memory then
    *wheel_rail = made.release();
  });
}

void microslip_wheel_rail_destroy(microslip_wheel_rail* wheel_rail) {
  delete wheel_rail;
}

microslip_code microslip_wheel_rail_state(const microslip_wheel_rail* wheel_rail, size_t width, double* state) {
  if (!wheel_rail) return MICROSLIP_NULL_POINTER;
  const microslip_code code = check_rows(1, width, state, wheel_inputs().size());
  if (code == MICROSLIP_OK) write_state(wheel_rail->first, width, state);
  return code;
}

microslip_code microslip_wheel_rail_solve(microslip_wheel_rail* wheel_rail, size_t count, size_t state_width,
                                          const double* states, size_t result_width, double* results, int* status) {
  return solve_rows(wheel_rail, {count, state_width, states, result_width, results, status}, Start::anew);
}

microslip_code microslip_wheel_rail_continue(microslip_wheel_rail* wheel_rail, size_t count, size_t state_width,
                                             const double* states, size_t result_width, double* results, int* status) {
  return solve_rows(wheel_rail, {count, state_width, states, result_width, results, status}, Start::from_last);
}

// NOLINTNEXTLINE(readability-function-size): arrays with their sizes
microslip_code microslip_wheel_rail_differentiate(microslip_wheel_rail* wheel_rail, size_t count, size_t state_width,
                                                  const double* states, size_t result_width, double* results,
                                                  int* status, size_t row_count, size_t column_count,
                                                  double* jacobian) {
  const StateRows rows{count, state_width, states, result_width, results, status};
  if (const microslip_code code = rows.check(); code != MICROSLIP_OK) return code;
  if (column_count > wheel_inputs().size()) return MICROSLIP_WRONG_SIZE;
  const microslip_code code = check_rows(column_count > 0 ? count : 0, row_count, jacobian, wheel_derivatives().size());
  if (code != MICROSLIP_OK) return code;
  return with_handle(wheel_rail, [&] {
    const auto solve = [&](const io::LoadedWheelState& given) {
      wheel_rail->solver.reset();
      wheel_rail->solver.differentiate(given.state, given.vertical_force, wheel_rail->solution,
                                       wheel_rail->derivatives);
    };
    const auto write = [&](std::size_t k) {
      double* value = jacobian + k * row_count * column_count;
      for (std::size_t row = 0; row < row_count; ++row)
        for (const WheelInput& column : wheel_inputs().first(column_count))
          *value++ = wheel_rail->derivatives.at(row, column.variable);
    };
    return solve_states(*wheel_rail, rows, solve, write);
  });
}

microslip_code microslip_wheel_rail_patches(const microslip_wheel_rail* wheel_rail, size_t width, size_t capacity,
                                            double* values, size_t* count, microslip_error* error) {
  return guarded_use(error, "wheel_rail", wheel_rail, [&] {
    require_pointer("count", count);
    require_at_most("width", width, patch_results().size());
    if (!wheel_rail->is_solved) throw Refusal(MICROSLIP_NO_RESULT, "microslip_wheel_rail_solve was not called yet");
    const auto& patches = wheel_rail->solution.patches;
    *count = patches.size();
    if (!values) return;
    if (patches.size() > capacity)
      throw Refusal(MICROSLIP_WRONG_SIZE, "capacity = " + std::to_string(capacity) + ": there are " +
                                              std::to_string(patches.size()) + " patches");
    for (std::size_t k = 0; k < patches.size(); ++k) store(patch_results(), patches[k], width, values + k * width);
  });
}

// NOLINTNEXTLINE(readability-function-size): arrays with their sizes
microslip_code microslip_wheelset_contacts(microslip_wheel_rail* wheel_rail, int roll, double yaw, size_t count,
                                           const double* lateral, size_t width, double* contacts, int* status,
                                           microslip_error* error) {
  return guarded_use(error, "wheel_rail", wheel_rail, [&] {
    require_at_most("width", width, wheelset_contact_quantities().size());
    if (count > 0) require_pointer("lateral", lateral);
    if (count > 0 && width > 0) require_pointer("contacts", contacts);
    const auto rule = choice<RollRule>("roll", roll, 2);
    require_between("yaw", yaw, "rad", -limit_of("yaw"), limit_of("yaw"));
    WheelsetSearch& search = wheelset_of(*wheel_rail);
    const auto written = [&](std::size_t k, microslip_code code) {
      if (status) status[k] = code;
      return code;
    };
    const auto leave = [&](std::size_t k, microslip_code code) {
      write_no_contact(lateral[k], width, contacts + k * width);
      return written(k, code);
    };
    const auto solve = [&](std::size_t k) {
      if (!(std::abs(lateral[k]) <= limit_of("lateral"))) return leave(k, MICROSLIP_INVALID_INPUT);
      const WheelsetContact found = search.solve(lateral[k], yaw, rule);
      write_contact(*wheel_rail->input, found, width, contacts + k * width);
      return written(k, code_of(found.status));
    };
    const microslip_code code = for_each(count, solve, [&](std::size_t k) { leave(k, MICROSLIP_NOT_CONVERGED); });
    return report(error, code, code == MICROSLIP_OK ? "" : microslip_code_text(code));
  });
}

microslip_code microslip_equivalent_conicity(microslip_wheel_rail* wheel_rail, int roll, double contact_distance,
                                             size_t count, const double* amplitudes, double* conicity,
                                             microslip_error* error) {
  return guarded_use(error, "wheel_rail", wheel_rail, [&] {
    if (count == 0) return;
    require_pointer("amplitudes", amplitudes), require_pointer("conicity", conicity);
    const auto rule = choice<RollRule>("roll", roll, 2);
    const WheelsetBase base{require_positive("contact_distance", contact_distance, "m"),
                            wheel_rail->input->wheelset.nominal_radius};
    std::fill_n(conicity, count, not_given);
    double largest = 0;
    for (std::size_t k = 0; k < count; ++k)
      if (is_amplitude(amplitudes[k])) largest = std::max(largest, amplitudes[k]);
    if (largest > 0) {
      const RollingRadiusDifference difference(curve_of_amplitudes(wheelset_of(*wheel_rail), largest, true, rule));
      for (std::size_t k = 0; k < count; ++k) {
        if (!is_amplitude(amplitudes[k])) continue;
        const auto motion = kinematic_oscillation(difference, amplitudes[k], base);
        if (motion) conicity[k] = motion->conicity;
      }
    }
    const double* const bad = std::find_if_not(amplitudes, amplitudes + count, is_amplitude);
    if (bad != amplitudes + count)
      throw Refusal(MICROSLIP_INVALID_INPUT, Error("amplitude", *bad, "m", "above 0, up to 0.9").what());
  });
}
