#include "fmi/fmi3.h"

#include "fmi/calls.hpp"
#include "fmi/description.hpp"

#include <cmath>
#include <memory>

using namespace microslip::fmi;

namespace {

constexpr fmi3Status status_of(Outcome outcome) {
  return outcome == Outcome::done ? fmi3OK : outcome == Outcome::discarded ? fmi3Discard : fmi3Error;
}

/// Runs a call that is allowed in some stages: `body` may throw.
template <class Body>
fmi3Status in_stage(fmi3Instance instance, const char* call, Stages stages, const Body& body) noexcept {
  return instance ? status_of(run(*static_cast<Unit*>(instance), call, stages, body)) : fmi3Error;
}

fmi3Status refuse(fmi3Instance instance, const char* why) {
  if (instance) static_cast<Unit*>(instance)->fail(why);
  return fmi3Error;
}

constexpr const char *no_clocks = "the unit has no clocks", *no_bytes = "states cannot be serialized";

/// All variables are scalars: a value for each.
void require_scalars(size_t count, size_t value_count) {
  require(count == value_count, "there must be as many values as value references: all variables are scalars");
}

template <class Store>
fmi3Status get(fmi3Instance instance, const char* call, Kind kind, const fmi3ValueReference vr[], size_t count,
               size_t value_count, const Store& store) {
  return in_stage(instance, call, readable, [&](Unit& unit) {
    require_scalars(count, value_count);
    microslip::fmi::get(unit, kind, vr, count, store);
  });
}

template <class Store>
fmi3Status set(fmi3Instance instance, const char* call, Kind kind, const fmi3ValueReference vr[], size_t count,
               size_t value_count, const Store& store) {
  return in_stage(instance, call, writable, [&](Unit& unit) {
    require_scalars(count, value_count);
    microslip::fmi::set(unit, kind, vr, count, store);
  });
}

fmi3Status none_of_this_type(fmi3Instance instance, const char* call, size_t count) {
  return in_stage(instance, call, anywhere, [&](Unit&) { require(count == 0, "there are no variables of this type"); });
}

Log log_of(fmi3InstanceEnvironment environment, fmi3LogMessageCallback log) {
  return [environment, log](Severity severity, const char* text) {
    if (log) log(environment, severity == Severity::error ? fmi3Error : fmi3Warning, category_of(severity), text);
  };
}

/// There are no continuous states and no event indicators.
fmi3Status no_numbers(fmi3Instance instance, const char* call, size_t count) {
  return in_stage(instance, call, {Stage::initialization, Stage::event, Stage::continuous},
                  [&](Unit&) { require(count == 0, "the unit has no continuous states and no event indicators"); });
}
fmi3Status no_count(fmi3Instance instance, const char* call, size_t* count) {
  return in_stage(instance, call, anywhere, [&](Unit&) {
    require(count != nullptr, "there is no place for the number");
    *count = 0;
  });
}

/// Says to the importer what a unit is not for.
fmi3Instance refuse_type(fmi3InstanceEnvironment environment, fmi3LogMessageCallback log, const char* why) {
  if (log) log(environment, fmi3Error, category_of(Severity::error), why);
  return nullptr;
}

fmi3Instance instantiate(Interface interface, fmi3String name, fmi3String token, fmi3String resources, bool logging,
                         fmi3InstanceEnvironment environment, fmi3LogMessageCallback log) noexcept {
  if (!name || !*name || !token) return nullptr;
  try {
    const ModelInfo info = model_info();
    const std::filesystem::path folder = resources ? reinterpret_cast<const char8_t*>(resources) : u8"";
    auto unit = std::make_unique<Unit>(info, interface, folder, log_of(environment, log), logging);
    if (info.remembers && interface == Interface::model_exchange)
      unit->fail("the unit is for co-simulation");
    else if (token == guid(info, Version::fmi3))
      return unit.release();
    else
      unit->fail("the instantiation token is not that of modelDescription.xml");
  } catch (const std::exception&) { // no memory
  }
  return nullptr;
}

} // namespace

/// A function of the interface that a unit does not have; what follows `why` are its further arguments.
#define REFUSED(function, why, ...)                                                                                    \
  fmi3Status function(fmi3Instance instance __VA_OPT__(, ) __VA_ARGS__) {                                              \
    return refuse(instance, why);                                                                                      \
  }

const char* fmi3GetVersion(void) {
  return "3.0";
}

fmi3Status fmi3SetDebugLogging(fmi3Instance instance, fmi3Boolean on, size_t, const fmi3String[]) {
  if (!instance) return fmi3Error;
  static_cast<Unit*>(instance)->set_logging(on);
  return fmi3OK;
}

// NOLINTNEXTLINE(readability-function-size): as FMI has it
fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean,
                                         fmi3Boolean logging, fmi3Boolean event_mode, fmi3Boolean,
                                         const fmi3ValueReference[], size_t intermediate_count,
                                         fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
                                         fmi3IntermediateUpdateCallback) {
  if (event_mode) return refuse_type(environment, log, "the unit has no event mode in co-simulation");
  if (intermediate_count > 0) return refuse_type(environment, log, "the unit gives no values within a step");
  return instantiate(Interface::co_simulation, name, token, resources, logging, environment, log);
}

fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean,
                                          fmi3Boolean logging, fmi3InstanceEnvironment environment,
                                          fmi3LogMessageCallback log) {
  return instantiate(Interface::model_exchange, name, token, resources, logging, environment, log);
}
// NOLINTNEXTLINE(readability-function-size): as FMI has it
fmi3Instance fmi3InstantiateScheduledExecution(fmi3String, fmi3String, fmi3String, fmi3Boolean, fmi3Boolean,
                                               fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
                                               fmi3ClockUpdateCallback, fmi3LockPreemptionCallback,
                                               fmi3UnlockPreemptionCallback) {
  return refuse_type(environment, log, "the unit is for co-simulation and model exchange, not for scheduled execution");
}

void fmi3FreeInstance(fmi3Instance instance) {
  delete static_cast<Unit*>(instance);
}

fmi3Status fmi3EnterInitializationMode(fmi3Instance instance, fmi3Boolean, fmi3Float64, fmi3Float64 start,
                                       fmi3Boolean has_stop, fmi3Float64 stop) {
  return in_stage(instance, __func__, {Stage::instantiated}, [&](Unit& unit) {
    require(std::isfinite(start), "the start time is not finite");
    require(!has_stop || stop >= start, "the stop time is before the start time");
    unit.time = start;
    unit.stage = Stage::initialization;
  });
}

fmi3Status fmi3ExitInitializationMode(fmi3Instance instance) {
  return in_stage(instance, __func__, {Stage::initialization}, [](Unit& unit) { unit.start(); });
}

fmi3Status fmi3Terminate(fmi3Instance instance) {
  return in_stage(instance, __func__, running, [](Unit& unit) { unit.stage = Stage::terminated; });
}

fmi3Status fmi3Reset(fmi3Instance instance) {
  return in_stage(instance, __func__, anywhere_or_failed, [](Unit& unit) { unit.reset(); });
}

REFUSED(fmi3EnterConfigurationMode, "the unit has no structural parameters")
REFUSED(fmi3ExitConfigurationMode, "the unit has no structural parameters")

// The independent variable follows those of the table.
fmi3Status fmi3GetFloat64(fmi3Instance instance, const fmi3ValueReference vr[], size_t count, fmi3Float64 values[],
                          size_t value_count) {
  return in_stage(instance, __func__, readable, [&](Unit& unit) {
    require_scalars(count, value_count);
    for (size_t k = 0; k < count; ++k)
      if (vr[k] == unit.variable_count())
        values[k] = unit.time;
      else
        microslip::fmi::get(unit, Kind::real, vr + k, 1, [&](const Unit& from, size_t reference, size_t) {
          values[k] = from.values.real[reference];
        });
  });
}
fmi3Status fmi3GetInt32(fmi3Instance instance, const fmi3ValueReference vr[], size_t count, fmi3Int32 values[],
                        size_t value_count) {
  return get(instance, __func__, Kind::integer, vr, count, value_count,
             [&](const Unit& from, ValueReference reference, size_t k) { values[k] = from.integer(reference); });
}
fmi3Status fmi3GetString(fmi3Instance instance, const fmi3ValueReference vr[], size_t count, fmi3String values[],
                         size_t value_count) {
  return get(instance, __func__, Kind::text, vr, count, value_count,
             [&](const Unit& from, size_t reference, size_t k) { values[k] = from.values.text[reference].c_str(); });
}

fmi3Status fmi3SetFloat64(fmi3Instance instance, const fmi3ValueReference vr[], size_t count,
                          const fmi3Float64 values[], size_t value_count) {
  return set(instance, __func__, Kind::real, vr, count, value_count,
             [&](Values& to, size_t reference, size_t k) { to.real[reference] = values[k]; });
}
fmi3Status fmi3SetInt32(fmi3Instance instance, const fmi3ValueReference vr[], size_t count, const fmi3Int32 values[],
                        size_t value_count) {
  return set(instance, __func__, Kind::integer, vr, count, value_count,
             [&](Values& to, size_t reference, size_t k) { to.integer[reference] = values[k]; });
}
fmi3Status fmi3SetString(fmi3Instance instance, const fmi3ValueReference vr[], size_t count, const fmi3String values[],
                         size_t value_count) {
  return set(instance, __func__, Kind::text, vr, count, value_count, [&](Values& to, size_t reference, size_t k) {
    require(values[k] != nullptr, "a string is NULL");
    to.text[reference] = values[k];
  });
}

#define NO_VARIABLES(Type)                                                                                             \
  fmi3Status fmi3Get##Type(fmi3Instance instance, const fmi3ValueReference[], size_t count, fmi3##Type[], size_t) {    \
    return none_of_this_type(instance, __func__, count);                                                               \
  }                                                                                                                    \
  fmi3Status fmi3Set##Type(fmi3Instance instance, const fmi3ValueReference[], size_t count, const fmi3##Type[],        \
                           size_t) {                                                                                   \
    return none_of_this_type(instance, __func__, count);                                                               \
  }
NO_VARIABLES(Float32)
NO_VARIABLES(Int8)
NO_VARIABLES(UInt8)
NO_VARIABLES(Int16)
NO_VARIABLES(UInt16)
NO_VARIABLES(UInt32)
NO_VARIABLES(Int64)
NO_VARIABLES(UInt64)
NO_VARIABLES(Boolean)
#undef NO_VARIABLES

fmi3Status fmi3GetBinary(fmi3Instance instance, const fmi3ValueReference[], size_t count, size_t[], fmi3Binary[],
                         size_t) {
  return none_of_this_type(instance, __func__, count);
}
fmi3Status fmi3SetBinary(fmi3Instance instance, const fmi3ValueReference[], size_t count, const size_t[],
                         const fmi3Binary[], size_t) {
  return none_of_this_type(instance, __func__, count);
}
fmi3Status fmi3GetClock(fmi3Instance instance, const fmi3ValueReference[], size_t count, fmi3Clock[]) {
  return none_of_this_type(instance, __func__, count);
}
fmi3Status fmi3SetClock(fmi3Instance instance, const fmi3ValueReference[], size_t count, const fmi3Clock[]) {
  return none_of_this_type(instance, __func__, count);
}

REFUSED(fmi3GetNumberOfVariableDependencies, "all variables are scalars: modelDescription.xml has their dependencies",
        fmi3ValueReference, size_t*)
REFUSED(fmi3GetVariableDependencies, "all variables are scalars: modelDescription.xml has their dependencies",
        fmi3ValueReference, size_t[], fmi3ValueReference[], size_t[], fmi3DependencyKind[], size_t)

// NOLINTNEXTLINE(readability-function-size): as FMI has it
fmi3Status fmi3GetDirectionalDerivative(fmi3Instance instance, const fmi3ValueReference unknowns[],
                                        size_t unknown_count, const fmi3ValueReference knowns[], size_t known_count,
                                        const fmi3Float64 seed[], size_t seed_count, fmi3Float64 sensitivity[],
                                        size_t sensitivity_count) {
  return in_stage(instance, __func__, readable, [&](Unit& unit) {
    require_scalars(known_count, seed_count);
    require_scalars(unknown_count, sensitivity_count);
    directional_derivative(unit, unknowns, unknown_count, knowns, known_count, seed, sensitivity);
  });
}
// NOLINTNEXTLINE(readability-function-size): as FMI has it
fmi3Status fmi3GetAdjointDerivative(fmi3Instance instance, const fmi3ValueReference unknowns[], size_t unknown_count,
                                    const fmi3ValueReference knowns[], size_t known_count, const fmi3Float64 seed[],
                                    size_t seed_count, fmi3Float64 sensitivity[], size_t sensitivity_count) {
  return in_stage(instance, __func__, readable, [&](Unit& unit) {
    require_scalars(unknown_count, seed_count);
    require_scalars(known_count, sensitivity_count);
    adjoint_derivative(unit, unknowns, unknown_count, knowns, known_count, seed, sensitivity);
  });
}

fmi3Status fmi3GetFMUState(fmi3Instance instance, fmi3FMUState* state) {
  return in_stage(instance, __func__, anywhere, [&](Unit& unit) { save(unit, state); });
}
fmi3Status fmi3SetFMUState(fmi3Instance instance, fmi3FMUState state) {
  return in_stage(instance, __func__,
                  {Stage::instantiated, Stage::initialization, Stage::stepping, Stage::terminated, Stage::error},
                  [&](Unit& unit) { restore(unit, state); });
}
fmi3Status fmi3FreeFMUState(fmi3Instance instance, fmi3FMUState* state) {
  if (!instance) return fmi3Error;
  forget(state);
  return fmi3OK;
}

REFUSED(fmi3SerializedFMUStateSize, no_bytes, fmi3FMUState, size_t*)
REFUSED(fmi3SerializeFMUState, no_bytes, fmi3FMUState, fmi3Byte[], size_t)
REFUSED(fmi3DeserializeFMUState, no_bytes, const fmi3Byte[], size_t, fmi3FMUState*)

fmi3Status fmi3DoStep(fmi3Instance instance, fmi3Float64 time, fmi3Float64 step, fmi3Boolean, fmi3Boolean* event_needed,
                      fmi3Boolean* terminate, fmi3Boolean* early_return, fmi3Float64* last_time) {
  return in_stage(instance, __func__, {Stage::stepping}, [&](Unit& unit) {
    require(std::isfinite(time) && step > 0 && std::isfinite(step), "the step is not a positive number");
    *event_needed = *terminate = *early_return = false; // a contact law does not end a simulation
    *last_time = unit.time;
    unit.advance(step);
    *last_time = unit.time = time + step;
  });
}
REFUSED(fmi3EnterStepMode, "the unit has no event mode")
REFUSED(fmi3GetOutputDerivatives, "outputs have no derivatives with respect to time", const fmi3ValueReference[],
        size_t, const fmi3Int32[], fmi3Float64[], size_t)

REFUSED(fmi3GetIntervalDecimal, no_clocks, const fmi3ValueReference[], size_t, fmi3Float64[], fmi3IntervalQualifier[])
REFUSED(fmi3GetIntervalFraction, no_clocks, const fmi3ValueReference[], size_t, fmi3UInt64[], fmi3UInt64[],
        fmi3IntervalQualifier[])
REFUSED(fmi3GetShiftDecimal, no_clocks, const fmi3ValueReference[], size_t, fmi3Float64[])
REFUSED(fmi3GetShiftFraction, no_clocks, const fmi3ValueReference[], size_t, fmi3UInt64[], fmi3UInt64[])
REFUSED(fmi3SetIntervalDecimal, no_clocks, const fmi3ValueReference[], size_t, const fmi3Float64[])
REFUSED(fmi3SetIntervalFraction, no_clocks, const fmi3ValueReference[], size_t, const fmi3UInt64[], const fmi3UInt64[])
REFUSED(fmi3SetShiftDecimal, no_clocks, const fmi3ValueReference[], size_t, const fmi3Float64[])
REFUSED(fmi3SetShiftFraction, no_clocks, const fmi3ValueReference[], size_t, const fmi3UInt64[], const fmi3UInt64[])
REFUSED(fmi3ActivateModelPartition, no_clocks, fmi3ValueReference, fmi3Float64)

// Model exchange: a law without states and event indicators.

fmi3Status fmi3EnterEventMode(fmi3Instance instance) {
  return in_stage(instance, __func__, {Stage::event, Stage::continuous}, [](Unit& unit) { unit.stage = Stage::event; });
}
fmi3Status fmi3EvaluateDiscreteStates(fmi3Instance instance) {
  return in_stage(instance, __func__, {Stage::initialization, Stage::event}, [](Unit& unit) { unit.evaluate(); });
}
fmi3Status fmi3UpdateDiscreteStates(fmi3Instance instance, fmi3Boolean* needed, fmi3Boolean* terminate,
                                    fmi3Boolean* nominals_changed, fmi3Boolean* states_changed,
                                    fmi3Boolean* time_defined, fmi3Float64*) {
  return in_stage(instance, __func__, {Stage::event}, [&](Unit& unit) {
    unit.evaluate();
    *needed = *terminate = *nominals_changed = *states_changed = *time_defined = false;
  });
}
fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance instance) {
  return in_stage(instance, __func__, {Stage::event}, [](Unit& unit) { unit.enter_continuous_time(); });
}
fmi3Status fmi3CompletedIntegratorStep(fmi3Instance instance, fmi3Boolean, fmi3Boolean* enter_event_mode,
                                       fmi3Boolean* terminate) {
  return in_stage(instance, __func__, {Stage::continuous}, [&](Unit& unit) {
    *terminate = false; // a contact law does not end a simulation
    *enter_event_mode = unit.wants_event();
  });
}
fmi3Status fmi3SetTime(fmi3Instance instance, fmi3Float64 time) {
  return in_stage(instance, __func__, {Stage::event, Stage::continuous}, [&](Unit& unit) {
    require(std::isfinite(time), "the time is not finite");
    unit.time = time;
  });
}
fmi3Status fmi3SetContinuousStates(fmi3Instance instance, const fmi3Float64[], size_t count) {
  return no_numbers(instance, __func__, count);
}
fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance instance, fmi3Float64[], size_t count) {
  return no_numbers(instance, __func__, count);
}
fmi3Status fmi3GetEventIndicators(fmi3Instance instance, fmi3Float64[], size_t count) {
  return no_numbers(instance, __func__, count);
}
fmi3Status fmi3GetContinuousStates(fmi3Instance instance, fmi3Float64[], size_t count) {
  return no_numbers(instance, __func__, count);
}
fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance instance, fmi3Float64[], size_t count) {
  return no_numbers(instance, __func__, count);
}
fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance instance, size_t* count) {
  return no_count(instance, __func__, count);
}
fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance instance, size_t* count) {
  return no_count(instance, __func__, count);
}

#undef REFUSED
