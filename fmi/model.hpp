#pragma once

#include <filesystem>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace microslip::fmi {

enum class Kind { real, integer, text };
enum class Causality { parameter, input, output, local };

/// A variable of a unit. Its value reference is its index in the table, whatever its kind.
struct Variable {
  std::string name, description;
  Kind kind = Kind::real;
  Causality causality = Causality::input;
  std::string unit = {}; ///< of real ones, as in the tables of quantities: "-", "N m", "m^2"
  double start = 0;      ///< of inputs and parameters that are numbers
  std::string start_text = {};
  double min = -std::numeric_limits<double>::infinity(), max = std::numeric_limits<double>::infinity();
  std::size_t part = 0; ///< of the unit: an output depends on the inputs of its own part only
};

/// The values of all variables by their value references; of each kind only those entries count that are of it.
struct Values {
  std::vector<double> real;
  std::vector<int> integer;
  std::vector<std::string> text;

  /// Start values.
  explicit Values(std::span<const Variable> variables);
};

/// Description of a unit. All parts have as many real inputs, and as many real outputs.
struct ModelInfo {
  std::string name, identifier, description;
  std::vector<Variable> variables;
  bool remembers = false; ///< steps change what follows: a unit for co-simulation alone
};

/// Relation of the variables of a unit: results follow from the inputs at once, and from what it remembers.
class Model {
public:
  virtual ~Model() = default;

  /// Called before all else and when parameters were changed. Returns what the user should look at. Throws Error.
  virtual std::vector<std::string> set_parameters(const Values& values) = 0;
  /// Finds outputs and local variables. Throws Error for an input out of range. Takes no memory if the inputs are
  /// valid.
  virtual void evaluate(Values& values) = 0;
  /// Derivatives of the real outputs (rows) by the real inputs (columns) of the same part, both in the order of the
  /// table, row by row, one part after another; they last until the next call. Throws and takes no memory as evaluate.
  virtual std::span<const double> differentiate(const Values& values) = 0;

  /// Goes on by a step [s] of co-simulation, in which the inputs are these. Throws and takes no memory as evaluate.
  virtual void advance(const Values&, double) {}
  /// What it remembers, and back, with the same parameters.
  virtual std::vector<double> memory() const { return {}; }
  virtual void set_memory(std::span<const double>) {}
};

// Each unit defines these.

ModelInfo model_info();
/// `resources` is the folder of the unit's files, empty if the importer gives none.
std::unique_ptr<Model> make_model(const std::filesystem::path& resources);

} // namespace microslip::fmi
