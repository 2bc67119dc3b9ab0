#include "fmi/fmi2.h"

#include "fmi/calls.hpp"
#include "fmi/description.hpp"

#include <cmath>
#include <memory>

using namespace microslip::fmi;

namespace {

constexpr fmi2Status status_of(Outcome outcome) {
  return outcome == Outcome::done ? fmi2OK : outcome == Outcome::discarded ? fmi2Discard : fmi2Error;
}

/// Runs a call that is allowed in some stages: `body` may throw.
template <class Body>
fmi2Status in_stage(fmi2Component instance, const char* call, Stages stages, const Body& body) noexcept {
  return instance ? status_of(run(*static_cast<Unit*>(instance), call, stages, body)) : fmi2Error;
}

/// Values of variables of a kind.
template <class Store>
fmi2Status get(fmi2Component instance, const char* call, Kind kind, const fmi2ValueReference vr[], size_t count,
               const Store& store) {
  return in_stage(instance, call, readable, [&](Unit& unit) { microslip::fmi::get(unit, kind, vr, count, store); });
}

/// Sets variables of a kind.
template <class Store>
fmi2Status set(fmi2Component instance, const char* call, Kind kind, const fmi2ValueReference vr[], size_t count,
               const Store& store) {
  return in_stage(instance, call, writable, [&](Unit& unit) { microslip::fmi::set(unit, kind, vr, count, store); });
}

/// There are no variables of this type.
fmi2Status none_of_this_type(fmi2Component instance, const char* call, size_t count) {
  return in_stage(instance, call, anywhere, [&](Unit&) { require(count == 0, "there are no Boolean variables"); });
}

fmi2Status refuse(fmi2Component instance, const char* why) {
  if (instance) static_cast<Unit*>(instance)->fail(why);
  return fmi2Error;
}

fmi2Status discard(fmi2Component instance) {
  return instance ? fmi2Discard : fmi2Error;
}

/// Log of a unit, as the importer's logger takes it.
Log log_of(const std::string& name, const fmi2CallbackFunctions& functions) {
  return [name, functions](Severity severity, const char* text) {
    if (functions.logger)
      functions.logger(functions.componentEnvironment, name.c_str(),
                       severity == Severity::error ? fmi2Error : fmi2Warning, category_of(severity), "%s", text);
  };
}

} // namespace

const char* fmi2GetTypesPlatform(void) {
  return "default";
}

const char* fmi2GetVersion(void) {
  return "2.0";
}

fmi2Status fmi2SetDebugLogging(fmi2Component instance, fmi2Boolean on, size_t, const fmi2String[]) {
  if (!instance) return fmi2Error;
  static_cast<Unit*>(instance)->set_logging(on != fmi2False);
  return fmi2OK;
}

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                              const fmi2CallbackFunctions* functions, fmi2Boolean, fmi2Boolean logging) {
  if (!name || !*name || !guid || !functions || (type != fmi2CoSimulation && type != fmi2ModelExchange)) return nullptr;
  try {
    const ModelInfo info = model_info();
    auto unit =
        std::make_unique<Unit>(info, type == fmi2CoSimulation ? Interface::co_simulation : Interface::model_exchange,
                               folder_of(resources), log_of(name, *functions), logging != fmi2False);
    if (info.remembers && type == fmi2ModelExchange)
      unit->fail("the unit is for co-simulation");
    else if (guid == microslip::fmi::guid(info, Version::fmi2))
      return unit.release();
    else
      unit->fail("the guid is not that of modelDescription.xml");
  } catch (const std::exception&) { // no memory
  }
  return nullptr;
}

void fmi2FreeInstance(fmi2Component instance) {
  delete static_cast<Unit*>(instance);
}

fmi2Status fmi2SetupExperiment(fmi2Component instance, fmi2Boolean, fmi2Real, fmi2Real start, fmi2Boolean has_stop,
                               fmi2Real stop) {
  return in_stage(instance, __func__, {Stage::instantiated}, [&](Unit& unit) {
    require(std::isfinite(start), "the start time is not finite");
    require(!has_stop || stop >= start, "the stop time is before the start time");
    unit.time = start;
  });
}

fmi2Status fmi2EnterInitializationMode(fmi2Component instance) {
  return in_stage(instance, __func__, {Stage::instantiated}, [](Unit& unit) { unit.stage = Stage::initialization; });
}

fmi2Status fmi2ExitInitializationMode(fmi2Component instance) {
  return in_stage(instance, __func__, {Stage::initialization}, [](Unit& unit) { unit.start(); });
}

fmi2Status fmi2Terminate(fmi2Component instance) {
  return in_stage(instance, __func__, running, [](Unit& unit) { unit.stage = Stage::terminated; });
}

fmi2Status fmi2Reset(fmi2Component instance) {
  return in_stage(instance, __func__, anywhere_or_failed, [](Unit& unit) { unit.reset(); });
}

fmi2Status fmi2GetReal(fmi2Component instance, const fmi2ValueReference vr[], size_t count, fmi2Real values[]) {
  return get(instance, __func__, Kind::real, vr, count,
             [&](const Unit& from, size_t reference, size_t k) { values[k] = from.values.real[reference]; });
}
fmi2Status fmi2GetInteger(fmi2Component instance, const fmi2ValueReference vr[], size_t count, fmi2Integer values[]) {
  return get(instance, __func__, Kind::integer, vr, count,
             [&](const Unit& from, ValueReference reference, size_t k) { values[k] = from.integer(reference); });
}
fmi2Status fmi2GetString(fmi2Component instance, const fmi2ValueReference vr[], size_t count, fmi2String values[]) {
  return get(instance, __func__, Kind::text, vr, count,
             [&](const Unit& from, size_t reference, size_t k) { values[k] = from.values.text[reference].c_str(); });
}

fmi2Status fmi2SetReal(fmi2Component instance, const fmi2ValueReference vr[], size_t count, const fmi2Real values[]) {
  return set(instance, __func__, Kind::real, vr, count,
             [&](Values& to, size_t reference, size_t k) { to.real[reference] = values[k]; });
}
fmi2Status fmi2SetInteger(fmi2Component instance, const fmi2ValueReference vr[], size_t count,
                          const fmi2Integer values[]) {
  return set(instance, __func__, Kind::integer, vr, count,
             [&](Values& to, size_t reference, size_t k) { to.integer[reference] = values[k]; });
}
fmi2Status fmi2SetString(fmi2Component instance, const fmi2ValueReference vr[], size_t count,
                         const fmi2String values[]) {
  return set(instance, __func__, Kind::text, vr, count, [&](Values& to, size_t reference, size_t k) {
    require(values[k] != nullptr, "a string is NULL");
    to.text[reference] = values[k];
  });
}

fmi2Status fmi2GetBoolean(fmi2Component instance, const fmi2ValueReference[], size_t count, fmi2Boolean[]) {
  return none_of_this_type(instance, __func__, count);
}
fmi2Status fmi2SetBoolean(fmi2Component instance, const fmi2ValueReference[], size_t count, const fmi2Boolean[]) {
  return none_of_this_type(instance, __func__, count);
}

fmi2Status fmi2GetFMUstate(fmi2Component instance, fmi2FMUstate* state) {
  return in_stage(instance, __func__, anywhere, [&](Unit& unit) { save(unit, state); });
}

fmi2Status fmi2SetFMUstate(fmi2Component instance, fmi2FMUstate state) {
  return in_stage(instance, __func__,
                  {Stage::instantiated, Stage::initialization, Stage::stepping, Stage::terminated, Stage::error},
                  [&](Unit& unit) { restore(unit, state); });
}

fmi2Status fmi2FreeFMUstate(fmi2Component instance, fmi2FMUstate* state) {
  if (!instance) return fmi2Error;
  forget(state);
  return fmi2OK;
}

fmi2Status fmi2SerializedFMUstateSize(fmi2Component instance, fmi2FMUstate, size_t*) {
  return refuse(instance, "states cannot be serialized");
}
fmi2Status fmi2SerializeFMUstate(fmi2Component instance, fmi2FMUstate, fmi2Byte[], size_t) {
  return refuse(instance, "states cannot be serialized");
}
fmi2Status fmi2DeSerializeFMUstate(fmi2Component instance, const fmi2Byte[], size_t, fmi2FMUstate*) {
  return refuse(instance, "states cannot be serialized");
}

fmi2Status fmi2GetDirectionalDerivative(fmi2Component instance, const fmi2ValueReference unknowns[],
                                        size_t unknown_count, const fmi2ValueReference knowns[], size_t known_count,
                                        const fmi2Real known_changes[], fmi2Real unknown_changes[]) {
  return in_stage(instance, __func__, readable, [&](Unit& unit) {
    directional_derivative(unit, unknowns, unknown_count, knowns, known_count, known_changes, unknown_changes);
  });
}

// Model exchange: a law without states and event indicators.

namespace {

/// There are no continuous states and no event indicators.
fmi2Status no_numbers(fmi2Component instance, const char* call, size_t count) {
  return in_stage(instance, call, {Stage::initialization, Stage::event, Stage::continuous},
                  [&](Unit&) { require(count == 0, "the unit has no continuous states and no event indicators"); });
}

} // namespace

fmi2Status fmi2EnterEventMode(fmi2Component instance) {
  return in_stage(instance, __func__, {Stage::event, Stage::continuous}, [](Unit& unit) { unit.stage = Stage::event; });
}
fmi2Status fmi2NewDiscreteStates(fmi2Component instance, fmi2EventInfo* info) {
  return in_stage(instance, __func__, {Stage::event}, [&](Unit& unit) {
    require(info != nullptr, "there is no place for the event's data");
    unit.evaluate();
    *info = {fmi2False, fmi2False, fmi2False, fmi2False, fmi2False, 0};
  });
}
fmi2Status fmi2EnterContinuousTimeMode(fmi2Component instance) {
  return in_stage(instance, __func__, {Stage::event}, [](Unit& unit) { unit.enter_continuous_time(); });
}
fmi2Status fmi2CompletedIntegratorStep(fmi2Component instance, fmi2Boolean, fmi2Boolean* enter_event_mode,
                                       fmi2Boolean* terminate) {
  return in_stage(instance, __func__, {Stage::continuous}, [&](Unit& unit) {
    require(enter_event_mode && terminate, "there is no place for the answers");
    *terminate = fmi2False; // a contact law does not end a simulation
    *enter_event_mode = unit.wants_event() ? fmi2True : fmi2False;
  });
}
fmi2Status fmi2SetTime(fmi2Component instance, fmi2Real time) {
  return in_stage(instance, __func__, {Stage::event, Stage::continuous}, [&](Unit& unit) {
    require(std::isfinite(time), "the time is not finite");
    unit.time = time;
  });
}
fmi2Status fmi2SetContinuousStates(fmi2Component instance, const fmi2Real[], size_t count) {
  return no_numbers(instance, __func__, count);
}
fmi2Status fmi2GetDerivatives(fmi2Component instance, fmi2Real[], size_t count) {
  return no_numbers(instance, __func__, count);
}
fmi2Status fmi2GetEventIndicators(fmi2Component instance, fmi2Real[], size_t count) {
  return no_numbers(instance, __func__, count);
}
fmi2Status fmi2GetContinuousStates(fmi2Component instance, fmi2Real[], size_t count) {
  return no_numbers(instance, __func__, count);
}
fmi2Status fmi2GetNominalsOfContinuousStates(fmi2Component instance, fmi2Real[], size_t count) {
  return no_numbers(instance, __func__, count);
}

fmi2Status fmi2SetRealInputDerivatives(fmi2Component instance, const fmi2ValueReference[], size_t, const fmi2Integer[],
                                       const fmi2Real[]) {
  return refuse(instance, "inputs are not interpolated");
}
fmi2Status fmi2GetRealOutputDerivatives(fmi2Component instance, const fmi2ValueReference[], size_t, const fmi2Integer[],
                                        fmi2Real[]) {
  return refuse(instance, "outputs have no derivatives with respect to time");
}

fmi2Status fmi2DoStep(fmi2Component instance, fmi2Real time, fmi2Real step, fmi2Boolean) {
  return in_stage(instance, __func__, {Stage::stepping}, [&](Unit& unit) {
    require(std::isfinite(time) && step >= 0 && std::isfinite(step), "the step is not a positive number");
    unit.advance(step);
    unit.time = time + step;
  });
}

fmi2Status fmi2CancelStep(fmi2Component instance) {
  return refuse(instance, "no step is pending");
}

fmi2Status fmi2GetStatus(fmi2Component instance, fmi2StatusKind, fmi2Status*) {
  return discard(instance);
}
fmi2Status fmi2GetRealStatus(fmi2Component instance, fmi2StatusKind kind, fmi2Real* value) {
  if (!instance || kind != fmi2LastSuccessfulTime) return discard(instance);
  *value = static_cast<Unit*>(instance)->time;
  return fmi2OK;
}
fmi2Status fmi2GetIntegerStatus(fmi2Component instance, fmi2StatusKind, fmi2Integer*) {
  return discard(instance);
}
fmi2Status fmi2GetBooleanStatus(fmi2Component instance, fmi2StatusKind kind, fmi2Boolean* value) {
  if (!instance || kind != fmi2Terminated) return discard(instance);
  *value = fmi2False; // a contact law does not end a simulation
  return fmi2OK;
}
fmi2Status fmi2GetStringStatus(fmi2Component instance, fmi2StatusKind, fmi2String*) {
  return discard(instance);
}
