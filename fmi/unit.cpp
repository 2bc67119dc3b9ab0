#include "fmi/unit.hpp"

namespace microslip::fmi {

fmi2Status Unit::fail(const char* text) {
  stage = Stage::error;
  if (logging_ && functions_.logger)
    functions_.logger(functions_.componentEnvironment, name_.c_str(), fmi2Error, "logStatusError", "%s", text);
  return fmi2Error;
}

TangentialLaw& Unit::law() {
  if (!law_) law_.emplace(variables.parameters());
  return *law_;
}

void Unit::evaluate() {
  if (evaluated_) return;
  variables.set_results(law().evaluate(variables.input()));
  evaluated_ = true;
}

void Unit::reset() {
  stage = Stage::instantiated;
  variables = {};
  time = 0;
  parameters_changed();
}

} // namespace microslip::fmi
