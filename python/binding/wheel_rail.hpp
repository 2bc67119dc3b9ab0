#pragma once

#include "binding/arrays.hpp"
#include "binding/creep_table.hpp"
#include "binding/long_work.hpp"
#include "binding/profile.hpp"
#include "io/wheel_rail_case.hpp"
#include "microslip/error.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace microslip::python {

inline constexpr std::string_view force_name = "vertical_force";

/// A description as a sentence with the shape of arrays and the unit.
std::string text_of(std::string_view description, std::string_view unit, const std::string& shape = "");

/// Gives a class a property for each number of a table: `get(value)` makes what Python calls of its function, `shape`
/// stands in the texts.
template <class Class, class Table, class Get>
void show_quantities(Class& of, const Table& table, const Get& get, const std::string& shape = "") {
  for (const auto& q : table)
    of.def_property_readonly(std::string(q.name).c_str(), get(q.value), text_of(q.description, q.unit, shape).c_str());
}

/// The index of a name among others. Throws Error that has the nearest one.
std::size_t index_of(const std::string& name, const std::vector<std::string_view>& names, const char* what);
pybind11::tuple tuple_of(const std::vector<std::string_view>& names);

/// A number, or a pair of arrays: angles and coefficients.
std::vector<InclinedFriction> inclined_friction_from(const pybind11::object& friction);
/// Bodies of a left wheel, both of one material below their layers.
WheelRailBodies bodies_from(const Track& track, const ProfileValue& rail, const Wheelset& wheelset,
                            const ProfileValue& wheel, const Material& material, const pybind11::object& friction,
                            const SurfaceStrength& strength, const io::WheelRailLayers& layers);
/// Method; theory "table" without a table takes the built-in one, for the bodies' Poisson's ratio.
WheelRailMethod method_from(const std::string& theory, const std::optional<std::string>& shape, int grid,
                            double tolerance, bool fields, const std::optional<CreepForceTable>& table,
                            double poisson_ratio);

/// Numbers of the state by their names, as arrays that broadcast. Keeps them alive.
class StateArrays {
public:
  /// Throws Error for names that are unknown, for arrays that are no real numbers or whose shapes do not match, and
  /// unless there is either a height or a force.
  StateArrays(const pybind11::kwargs& given, double nominal_radius);

  /// Reads a single state, for calls that take numbers. Throws Error for arrays.
  std::pair<WheelState<double>, std::optional<double>> single(const char* call) const {
    if (!shape_.empty())
      throw Error(std::string(call) + " takes numbers; " + std::string(call) + "_batch takes arrays");
    return (*this)[0];
  }
  const Shape& shape() const { return shape_; }
  std::size_t count() const { return count_; }

  /// Needs no Python.
  std::pair<WheelState<double>, std::optional<double>> operator[](std::size_t i) const {
    WheelState<double> state;
    std::optional<double> force;
    for (const Column& column : columns_) {
      if (column.quantity != nullptr)
        column.quantity->of(state) = column.data[i];
      else
        force = column.data[i];
    }
    if (!pitch_is_given_) state.pitch_velocity = state.forward_velocity / nominal_radius_;
    return {state, force};
  }

private:
  struct Column {
    const StateQuantity* quantity; ///< none for the force
    RealArray values;
    const double* data;
  };

  bool has(std::string_view name) const {
    return std::any_of(columns_.begin(), columns_.end(), [&](const Column& column) {
      return column.quantity != nullptr ? column.quantity->name == name : name == force_name;
    });
  }

  double nominal_radius_;
  bool pitch_is_given_ = false;
  Shape shape_;
  std::size_t count_ = 1;
  std::vector<Column> columns_;
};

/// A wheel on its rail with what makes another one, for other threads.
struct PythonWheelRail {
  WheelRailBodies bodies;
  WheelRailMethod method;
  OneAtATime<WheelRail> solver;

  PythonWheelRail(WheelRailBodies given, const WheelRailMethod& how)
      : bodies(std::move(given)), method(how), solver(bodies, method) {}

  /// Calls `solve` with a solver and the index of each state, on many threads without Python's lock. Ctrl-C ends it.
  void
  for_batch(const StateArrays& states, int threads,
            const std::function<void(WheelRail& solver, std::size_t index, const Progress& progress)>& solve) const;
};

/// Solutions of many states without fields.
struct SolvedStates {
  Shape shape;
  std::vector<WheelRailSolution> solutions;
  pybind11::dict inputs = {}; ///< the numbers of the states by name, as given

  std::size_t most_patches() const {
    std::size_t most = 0;
    for (const WheelRailSolution& s : solutions) most = std::max(most, s.patches.size());
    return most;
  }
};

/// WheelRail.differentiate and differentiate_batch.
void bind_wheel_rail_derivatives(pybind11::module_& module, pybind11::class_<PythonWheelRail>& wheel_rail);

} // namespace microslip::python
