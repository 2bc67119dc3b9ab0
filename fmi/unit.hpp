#pragma once

#include "fmi/fmi2.h"
#include "fmi/variables.hpp"

#include <memory>
#include <optional>
#include <string>

namespace microslip::fmi {

/// Where an instance stands in the standard's order of calls (FMI 2.0, section 4.2.4).
enum class Stage { instantiated, initialization, stepping, terminated, error };

/// An instance of the functional mock-up unit: variables, and the law that joins them.
class Unit {
public:
  Unit(std::string name, const fmi2CallbackFunctions& functions, bool logging)
      : name_(std::move(name)), functions_(functions), logging_(logging) {}

  Stage stage = Stage::instantiated;
  Variables variables;
  double time = 0;

  void set_logging(bool on) { logging_ = on; }
  /// Tells the importer and leaves the instance unusable until it is reset.
  fmi2Status fail(const char* text);

  /// The variables have been set: results are found when they are next asked for.
  void parameters_changed() { law_.reset(), evaluated_ = false; }
  void inputs_changed() { evaluated_ = false; }
  /// Finds the results. Throws Error for a variable out of range.
  void evaluate();
  /// As TangentialLaw.
  std::array<std::array<double, 5>, 3> differentiate() { return law().differentiate(variables.input()); }
  void reset();

private:
  TangentialLaw& law();

  std::string name_;
  fmi2CallbackFunctions functions_;
  bool logging_;
  std::optional<TangentialLaw> law_; ///< made again when parameters change
  bool evaluated_ = false;
};

} // namespace microslip::fmi
