#include "fmi/fmi2.h"

#include "fmi/description.hpp"
#include "fmi/unit.hpp"

#include <cmath>
#include <exception>
#include <initializer_list>
#include <new>
#include <string>

using namespace microslip::fmi;

namespace {

/// Runs a call that is allowed in some stages: `body` may throw, and returns a status or nothing.
template <class Body>
fmi2Status in_stage(fmi2Component instance, const char* call, std::initializer_list<Stage> stages, Body body) noexcept {
  if (!instance) return fmi2Error;
  Unit& unit = *static_cast<Unit*>(instance);
  try {
    for (const Stage stage : stages)
      if (unit.stage == stage) {
        body(unit);
        return fmi2OK;
      }
    return unit.fail((std::string(call) + " is not allowed at this stage").c_str());
  } catch (const std::exception& error) {
    return unit.fail(error.what());
  }
}

/// Refusals of arguments leave by this.
void require(bool condition, const char* text) {
  if (!condition) throw std::invalid_argument(text);
}

constexpr std::initializer_list<Stage> readable = {Stage::initialization, Stage::stepping, Stage::terminated};
constexpr std::initializer_list<Stage> writable = {Stage::instantiated, Stage::initialization, Stage::stepping};

/// Values of variables of a kind; `store(unit, reference, k)` puts one into the caller's k-th place. In initialization
/// mode results follow the inputs; while stepping they stand from the last step.
template <class Store>
fmi2Status get(fmi2Component instance, const char* call, Kind kind, const fmi2ValueReference vr[], size_t count,
               const Store& store) {
  return in_stage(instance, call, readable, [&](Unit& unit) {
    for (size_t k = 0; k < count; ++k) unit.variable(vr[k], kind);
    if (unit.stage == Stage::initialization) unit.evaluate();
    for (size_t k = 0; k < count; ++k) store(unit.values, vr[k], k);
  });
}

/// Sets variables of a kind likewise.
template <class Store>
fmi2Status set(fmi2Component instance, const char* call, Kind kind, const fmi2ValueReference vr[], size_t count,
               const Store& store) {
  return in_stage(instance, call, writable, [&](Unit& unit) {
    for (size_t k = 0; k < count; ++k) {
      const Causality causality = unit.variable(vr[k], kind).causality;
      require(causality == Causality::input || causality == Causality::parameter, "an output cannot be set");
      require(causality == Causality::input || unit.stage != Stage::stepping,
              "a parameter cannot be set after initialization");
      store(unit.values, vr[k], k);
      unit.changed(causality);
    }
  });
}

/// There are no variables of this type.
fmi2Status none_of_this_type(fmi2Component instance, const char* call, size_t count) {
  return in_stage(instance, call, {Stage::instantiated, Stage::initialization, Stage::stepping, Stage::terminated},
                  [&](Unit&) { require(count == 0, "there are no Boolean variables"); });
}

fmi2Status refuse(fmi2Component instance, const char* why) {
  return instance ? static_cast<Unit*>(instance)->fail(why) : fmi2Error;
}

fmi2Status discard(fmi2Component instance) {
  return instance ? fmi2Discard : fmi2Error;
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
  if (!name || !*name || !guid || !functions || type != fmi2CoSimulation) return nullptr;
  try {
    const ModelInfo info = model_info();
    auto unit = std::make_unique<Unit>(name, info, folder_of(resources), *functions, logging != fmi2False);
    if (guid == microslip::fmi::guid(info)) return unit.release();
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
  return in_stage(instance, __func__, {Stage::initialization}, [](Unit& unit) {
    unit.evaluate();
    unit.stage = Stage::stepping;
  });
}

fmi2Status fmi2Terminate(fmi2Component instance) {
  return in_stage(instance, __func__, {Stage::stepping}, [](Unit& unit) { unit.stage = Stage::terminated; });
}

fmi2Status fmi2Reset(fmi2Component instance) {
  if (!instance) return fmi2Error;
  static_cast<Unit*>(instance)->reset();
  return fmi2OK;
}

fmi2Status fmi2GetReal(fmi2Component instance, const fmi2ValueReference vr[], size_t count, fmi2Real values[]) {
  return get(instance, __func__, Kind::real, vr, count,
             [&](const Values& from, size_t reference, size_t k) { values[k] = from.real[reference]; });
}
fmi2Status fmi2GetInteger(fmi2Component instance, const fmi2ValueReference vr[], size_t count, fmi2Integer values[]) {
  return get(instance, __func__, Kind::integer, vr, count,
             [&](const Values& from, size_t reference, size_t k) { values[k] = from.integer[reference]; });
}
fmi2Status fmi2GetString(fmi2Component instance, const fmi2ValueReference vr[], size_t count, fmi2String values[]) {
  return get(instance, __func__, Kind::text, vr, count,
             [&](const Values& from, size_t reference, size_t k) { values[k] = from.text[reference].c_str(); });
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
  return in_stage(instance, __func__, {Stage::instantiated, Stage::initialization, Stage::stepping, Stage::terminated},
                  [&](Unit& unit) {
                    if (*state)
                      *static_cast<Unit::Saved*>(*state) = unit.save();
                    else
                      *state = new Unit::Saved(unit.save());
                  });
}

fmi2Status fmi2SetFMUstate(fmi2Component instance, fmi2FMUstate state) {
  return in_stage(instance, __func__,
                  {Stage::instantiated, Stage::initialization, Stage::stepping, Stage::terminated, Stage::error},
                  [&](Unit& unit) {
                    require(state != nullptr, "there is no state to set");
                    unit.restore(*static_cast<Unit::Saved*>(state));
                  });
}

fmi2Status fmi2FreeFMUstate(fmi2Component instance, fmi2FMUstate* state) {
  if (!instance) return fmi2Error;
  if (!state) return fmi2OK;
  delete static_cast<Unit::Saved*>(*state);
  *state = nullptr;
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
    for (size_t k = 0; k < unknown_count; ++k)
      require(unit.variable(unknowns[k], Kind::real).causality == Causality::output,
              "derivatives are those of real outputs");
    for (size_t k = 0; k < known_count; ++k)
      require(unit.variable(knowns[k], Kind::real).causality == Causality::input,
              "derivatives are those by real inputs");
    unit.differentiate();
    for (size_t i = 0; i < unknown_count; ++i) {
      unknown_changes[i] = 0;
      for (size_t k = 0; k < known_count; ++k)
        unknown_changes[i] += unit.derivative(unknowns[i], knowns[k]) * known_changes[k];
    }
  });
}

fmi2Status fmi2SetRealInputDerivatives(fmi2Component instance, const fmi2ValueReference[], size_t, const fmi2Integer[],
                                       const fmi2Real[]) {
  return refuse(instance, "inputs are not interpolated");
}
fmi2Status fmi2GetRealOutputDerivatives(fmi2Component instance, const fmi2ValueReference[], size_t, const fmi2Integer[],
                                        fmi2Real[]) {
  return refuse(instance, "outputs have no derivatives to time");
}

fmi2Status fmi2DoStep(fmi2Component instance, fmi2Real time, fmi2Real step, fmi2Boolean) {
  return in_stage(instance, __func__, {Stage::stepping}, [&](Unit& unit) {
    require(std::isfinite(time) && step >= 0 && std::isfinite(step), "the step is not a positive number");
    unit.evaluate();
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
