#pragma once

#include "fmi/model.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace microslip::fmi {

/// Stage of an instance in the standard's order of calls: `stepping` in co-simulation (FMI 2.0, section 4.2.4; FMI 3.0,
/// section 4.2), `event` and `continuous` time in model exchange (FMI 2.0, section 3.2; FMI 3.0, section 3.2).
enum class Stage { instantiated, initialization, stepping, event, continuous, terminated, error };

/// Returns true where inputs only may change, and results follow or have followed them.
constexpr bool is_running(Stage stage) {
  return stage == Stage::stepping || stage == Stage::event || stage == Stage::continuous;
}

enum class Interface { co_simulation, model_exchange };

/// The folder of a URI as fmi2Instantiate gets it, file:///tmp/unit/resources; empty if there is none.
std::filesystem::path folder_of(const char* uri);

using ValueReference = unsigned int;

/// Messages of a unit to the importer. The categories of the descriptions' LogCategories.
enum class Severity { warning, error };
constexpr const char* category_of(Severity severity) {
  return severity == Severity::error ? "logStatusError" : "logStatusWarning";
}
using Log = std::function<void(Severity severity, const char* text)>;

/// An instance of a functional mock-up unit: its variables, and the model that joins them.
class Unit {
public:
  Unit(ModelInfo info, Interface interface, std::filesystem::path resources, Log log, bool logging);

  /// Contents of a saved state.
  struct Saved {
    Stage stage;
    double time;
    Values values;
    std::vector<double> memory; ///< of the model
  };

  Stage stage = Stage::instantiated;
  double time = 0;
  Values values;

  /// Throws std::invalid_argument unless the reference is that of a variable of this kind.
  const Variable& variable(ValueReference reference, Kind kind) const;
  std::size_t variable_count() const { return info_.variables.size(); }

  void set_logging(bool on) { logging_ = on; }
  /// Tells the importer and leaves the instance unusable until it is reset.
  void fail(const char* text);
  /// Tells the importer that inputs are out of range: as before once they are others.
  void discard(const char* text);

  /// A variable has been set: results are found when they are next asked for.
  void changed(Causality causality);
  /// Finds the results. Throws Error for a variable out of range.
  void evaluate();
  /// Goes on by a step [s] of co-simulation and finds the results at its end. Throws likewise.
  void advance(double step);
  /// Ends the initialization.
  void start();
  /// Results that are whole numbers are held in continuous time and follow at events, as the standard wants of discrete
  /// variables. Returns whether others than those held are due.
  bool wants_event();
  /// An integer variable as the importer may see it.
  int integer(ValueReference reference) const;
  void enter_continuous_time();
  /// Derivative of a real output by a real input. The references must be those of such.
  double derivative(ValueReference of, ValueReference by) const;
  /// Finds what derivative() gives. Throws as evaluate.
  void differentiate();
  void reset();
  Saved save() const { return {stage, time, values, kept_ ? *kept_ : model_->memory()}; }
  void restore(const Saved& saved);

private:
  void log(Severity severity, const char* text) const;
  /// Throws another exception than Error, which is for inputs.
  void apply_parameters();
  /// The model with the parameters as they are now.
  Model& model();
  bool has_parameters_of(const Values& other) const;

  ModelInfo info_;
  std::filesystem::path resources_;
  Log log_;
  bool logging_;
  std::unique_ptr<Model> model_;
  std::optional<Values> applied_;                ///< of which the model has the parameters
  std::optional<std::vector<double>> kept_ = {}; ///< what the model has to remember once it has its parameters
  Interface interface_;
  std::vector<int> held_;                ///< whole numbers in continuous time
  std::vector<std::size_t> place_;       ///< of a real output or input among those of its part
  std::size_t inputs_ = 0, outputs_ = 0; ///< real ones of a part
  std::span<const double> derivatives_;
  bool parameters_changed_ = true, evaluated_ = false;
};

} // namespace microslip::fmi
