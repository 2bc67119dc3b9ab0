#pragma once

#include "io/case_inputs.hpp"

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace microslip::fit {

/// Coordinate in which a parameter is fitted: the logarithm of its size, or log(p/(1 - p)) of a share in (0, 1).
enum class ParameterScale { log, logit };

/// Parameter of a creep curve.
struct CurveParameter {
  std::string name; ///< path of the input of case files that it is or, of friction and of formulas, is made into
  std::string unit;
  ParameterScale scale = ParameterScale::log;
  double start = 1; ///< where the fit begins, and its value where the data do not identify it
  /// Whether only measurements at several speeds identify it; otherwise it stays at `start`.
  bool needs_speeds = false;
  double sign = 1; ///< of its values, that of `start`: -1 only for the hardening of a layer that gets softer

  double to_working(double value) const;
  double from_working(double working) const;
};

/// What makes the creep curve less steep than that of clean bodies, and how friction falls.
enum class CurveShape {
  clean,               ///< nothing
  reduced_slope,       ///< one slope reduction, solution.slope_reduction.initial
  falling_slope,       ///< Spiryagin, Polach & Cole 2013 with k0 = 1: at_infinity, decay
  elastic_layer,       ///< a layer that stays elastic
  plastic_layer,       ///< one that yields and does not harden
  hardening_layer,     ///< one without elasticity that yields and hardens
  polach_formula,      ///< Polach's formula 2005 with k_a = 2.5 k_s, the ratio of his dry set
  polach_formula_free, ///< the same with k_a and k_s free
};

/// A model of creep curves: parameters, and the case that has them. The first parameter is friction.static_coefficient,
/// which every run has for itself.
class CurveModel {
public:
  /// `law`: of friction, "coulomb", "linear", "rational" or "polach", which is the exponential one. Starting values
  /// that `base` has are taken from there. Throws Error for a word that is none of these.
  CurveModel(CurveShape shape, std::string_view law, const io::CaseInputs& base);

  const std::string& name() const { return name_; }
  CurveShape shape() const { return shape_; }
  /// Returns whether its curve is a formula, which no case file solves by.
  bool is_formula() const { return shape_ >= CurveShape::polach_formula; }
  const std::vector<CurveParameter>& parameters() const { return parameters_; }
  /// Begins elsewhere. Parameters that the model does not have are left out.
  void start_from(std::span<const std::pair<std::string_view, double>> values);

  /// The case with these values of the parameters. Throws Error for values out of range.
  io::CaseInputs inputs(std::span<const double> values) const;
  /// Polach's k_a and k_s of these values. Only for a formula.
  std::pair<double, double> polach_factors(std::span<const double> values) const;

private:
  double value_of(std::string_view name, std::span<const double> values) const;

  CurveShape shape_;
  std::string law_, name_;
  std::vector<CurveParameter> parameters_;
  io::CaseInputs base_; ///< without what the parameters set
};

/// Words of the shapes, in their order: names of models. Those of clean bodies have the law's.
inline constexpr std::string_view shape_names[] = {"clean",          "reduced_slope",      "falling_slope",
                                                   "elastic_layer",  "plastic_layer",      "hardening_layer",
                                                   "polach_formula", "polach_formula_free"};

/// Models that a case can be fitted with: by its theory, with all friction laws on clean bodies and Polach's law on
/// the others. Throws Error for a case that is not of two bodies.
std::vector<CurveModel> curve_models(const io::CaseInputs& base);

/// Published parameters to begin with; none of them predicts what other measurements will be.
struct StartingValues {
  std::string_view name, source;
  std::vector<std::pair<std::string_view, double>> values;
};
const std::vector<StartingValues>& starting_values();

} // namespace microslip::fit
