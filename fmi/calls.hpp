#pragma once

#include "fmi/unit.hpp"
#include "microslip/error.hpp"

#include <cstddef>
#include <exception>
#include <initializer_list>
#include <stdexcept>
#include <string>

/// Calls of both versions of the interface: they differ in names, types and what else they must have.
namespace microslip::fmi {

using Stages = std::initializer_list<Stage>;
constexpr Stages anywhere = {Stage::instantiated, Stage::initialization, Stage::stepping,
                             Stage::event,        Stage::continuous,     Stage::terminated};
constexpr Stages anywhere_or_failed = {Stage::instantiated, Stage::initialization, Stage::stepping, Stage::event,
                                       Stage::continuous,   Stage::terminated,     Stage::error};
constexpr Stages readable = {Stage::initialization, Stage::stepping, Stage::event, Stage::continuous,
                             Stage::terminated};
constexpr Stages writable = {Stage::instantiated, Stage::initialization, Stage::stepping, Stage::event,
                             Stage::continuous};
constexpr Stages running = {Stage::stepping, Stage::event, Stage::continuous};

/// Refusals of arguments leave by this.
inline void require(bool condition, const char* text) {
  if (!condition) throw std::invalid_argument(text);
}

/// How a call ended: `discarded` leaves the unit as it was, for the importer to step back and try other inputs.
enum class Outcome { done, discarded, failed };

/// Runs a call that is allowed in some stages and may throw. While it runs, when no parameter can change, an Error is
/// that of an input out of its range.
template <class Body> Outcome run(Unit& unit, const char* call, Stages stages, const Body& body) noexcept {
  try {
    for (const Stage stage : stages)
      if (unit.stage == stage) {
        body(unit);
        return Outcome::done;
      }
    unit.fail((std::string(call) + " is not allowed at this stage").c_str());
  } catch (const Error& error) {
    if (is_running(unit.stage)) {
      unit.discard(error.what());
      return Outcome::discarded;
    }
    unit.fail(error.what());
  } catch (const std::exception& error) {
    unit.fail(error.what());
  }
  return Outcome::failed;
}

/// Values of variables of a kind; `store(values, reference, k)` puts one into the caller's k-th element. In
/// initialization mode and in model exchange results follow the inputs; while stepping they stand from the last step.
template <class Store>
void get(Unit& unit, Kind kind, const ValueReference vr[], std::size_t count, const Store& store) {
  for (std::size_t k = 0; k < count; ++k) unit.variable(vr[k], kind);
  if (unit.stage == Stage::initialization || unit.stage == Stage::event || unit.stage == Stage::continuous)
    unit.evaluate();
  for (std::size_t k = 0; k < count; ++k) store(unit, vr[k], k);
}

/// Sets variables of a kind likewise.
template <class Store>
void set(Unit& unit, Kind kind, const ValueReference vr[], std::size_t count, const Store& store) {
  for (std::size_t k = 0; k < count; ++k) {
    const Causality causality = unit.variable(vr[k], kind).causality;
    require(causality == Causality::input || causality == Causality::parameter, "an output cannot be set");
    require(causality == Causality::input || !is_running(unit.stage), "a parameter cannot be set after initialization");
    store(unit.values, vr[k], k);
    unit.changed(causality);
  }
}

/// Finds the derivatives of real outputs by real inputs.
inline void differentiate(Unit& unit, const ValueReference unknowns[], std::size_t unknown_count,
                          const ValueReference knowns[], std::size_t known_count) {
  for (std::size_t k = 0; k < unknown_count; ++k)
    require(unit.variable(unknowns[k], Kind::real).causality == Causality::output,
            "derivatives are those of real outputs");
  for (std::size_t k = 0; k < known_count; ++k)
    require(unit.variable(knowns[k], Kind::real).causality == Causality::input, "derivatives are those by real inputs");
  unit.differentiate();
}

/// result[r] = sum over c of entry(r, c) weights[c].
template <class Entry>
void multiply(std::size_t rows, std::size_t columns, const Entry& entry, const double weights[], double result[]) {
  for (std::size_t r = 0; r < rows; ++r) {
    result[r] = 0;
    for (std::size_t c = 0; c < columns; ++c) result[r] += entry(r, c) * weights[c];
  }
}

/// Changes of outputs by changes of inputs.
inline void directional_derivative(Unit& unit, const ValueReference unknowns[], std::size_t unknown_count,
                                   const ValueReference knowns[], std::size_t known_count, const double changes[],
                                   double result[]) {
  differentiate(unit, unknowns, unknown_count, knowns, known_count);
  const auto entry = [&](std::size_t i, std::size_t k) { return unit.derivative(unknowns[i], knowns[k]); };
  multiply(unknown_count, known_count, entry, changes, result);
}

/// The transpose: by inputs, of a sum of outputs with weights.
inline void adjoint_derivative(Unit& unit, const ValueReference unknowns[], std::size_t unknown_count,
                               const ValueReference knowns[], std::size_t known_count, const double weights[],
                               double result[]) {
  differentiate(unit, unknowns, unknown_count, knowns, known_count);
  const auto entry = [&](std::size_t k, std::size_t i) { return unit.derivative(unknowns[i], knowns[k]); };
  multiply(known_count, unknown_count, entry, weights, result);
}

/// Keeps the unit's state in new memory, or in that of an older one.
inline void save(Unit& unit, void** state) {
  if (*state)
    *static_cast<Unit::Saved*>(*state) = unit.save();
  else
    *state = new Unit::Saved(unit.save());
}

inline void restore(Unit& unit, void* state) {
  require(state != nullptr, "there is no state to set");
  unit.restore(*static_cast<Unit::Saved*>(state));
}

inline void forget(void** state) {
  if (!state) return;
  delete static_cast<Unit::Saved*>(*state);
  *state = nullptr;
}

} // namespace microslip::fmi
