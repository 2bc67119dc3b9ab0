#include "fit/curve_model.hpp"

#include "io/option_words.hpp"
#include "microslip/contact/theory.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace microslip::fit {
namespace {

constexpr std::string_view laws[] = {"coulomb", "linear", "rational", "polach"};
constexpr std::string_view at_rest = "friction.static_coefficient", ratio = "friction.ratio", decay = "friction.decay",
                           half_velocity = "friction.half_velocity", initial = "solution.slope_reduction.initial",
                           at_infinity = "solution.slope_reduction.at_infinity",
                           slope_decay = "solution.slope_reduction.decay", modulus = "layer.shear_modulus",
                           thickness = "layer.thickness", yield_stress = "layer.yield_stress",
                           hardening = "layer.hardening", k_a = "polach_formula.k_a", k_s = "polach_formula.k_s";

/// Ratio of k_a and k_s in Polach's dry set (1.00 and 0.40).
constexpr double polach_ratio = 2.5;

/// Parameters with their units and starting values, which lie between those that are published for rails.
const std::vector<CurveParameter>& known_parameters() {
  static const std::vector<CurveParameter> all = {
      {std::string(at_rest), "-", ParameterScale::log, 0.35},
      {std::string(ratio), "-", ParameterScale::logit, 0.4, true},
      {std::string(decay), "s/m", ParameterScale::log, 0.5},
      {std::string(half_velocity), "m/s", ParameterScale::log, 1.4},
      {std::string(initial), "-", ParameterScale::logit, 0.5},
      {std::string(at_infinity), "-", ParameterScale::logit, 0.03},
      {std::string(slope_decay), "-", ParameterScale::log, 0.6},
      {std::string(modulus), "Pa", ParameterScale::log, 8.2e9},
      {std::string(yield_stress), "Pa", ParameterScale::log, 120e6},
      {std::string(hardening), "Pa/m", ParameterScale::log, 1.6e12},
      {std::string(k_a), "-", ParameterScale::log, 0.8},
      {std::string(k_s), "-", ParameterScale::log, 0.3},
  };
  return all;
}

/// Inputs that parameters set, or that hide them.
constexpr std::string_view replaced[] = {"friction.law",
                                         "friction.coefficient",
                                         "friction.kinetic_coefficient",
                                         "friction.drop",
                                         "friction.half_velocity",
                                         "friction.second_drop",
                                         "friction.second_half_velocity",
                                         "friction.static_coefficient",
                                         "friction.ratio",
                                         "friction.decay",
                                         "layer.shear_modulus",
                                         "layer.thickness",
                                         "layer.yield_stress",
                                         "layer.hardening",
                                         "solution.slope_reduction.initial",
                                         "solution.slope_reduction.at_infinity",
                                         "solution.slope_reduction.decay"};

std::vector<std::string_view> parameters_of(CurveShape shape) {
  switch (shape) {
  case CurveShape::clean:
    return {};
  case CurveShape::reduced_slope:
    return {initial};
  case CurveShape::falling_slope:
    return {at_infinity, slope_decay};
  case CurveShape::elastic_layer:
    return {modulus};
  case CurveShape::plastic_layer:
    return {modulus, yield_stress};
  case CurveShape::hardening_layer:
    return {yield_stress, hardening};
  case CurveShape::polach_formula:
    return {k_s};
  case CurveShape::polach_formula_free:
    return {k_a, k_s};
  }
  return {};
}

std::vector<std::string_view> parameters_of(std::string_view law) {
  if (law == "coulomb") return {at_rest};
  return {at_rest, ratio, law == "polach" ? decay : half_velocity};
}

/// A number of a case; none where it has none or another kind of value.
std::optional<double> number_of(const io::CaseInputs& base, std::string_view path) {
  const auto value = base.get(path);
  return value && std::holds_alternative<double>(*value) ? std::optional(std::get<double>(*value)) : std::nullopt;
}

Theory theory_of(const io::CaseInputs& base) {
  return io::from_word<Theory>("solution.theory", std::get<std::string>(base.get("solution.theory").value()));
}

} // namespace

double CurveParameter::to_working(double value) const {
  constexpr double end = 1e-6; // of shares, whose ends are infinitely far
  if (scale == ParameterScale::log) return std::log(sign * value);
  const double share = std::clamp(value, end, 1 - end);
  return std::log(share / (1 - share));
}

double CurveParameter::from_working(double working) const {
  return scale == ParameterScale::log ? sign * std::exp(working) : 1 / (1 + std::exp(-working));
}

CurveModel::CurveModel(CurveShape shape, std::string_view law, const io::CaseInputs& base)
    : shape_(shape), law_(law), base_(base) {
  io::require_word("friction.law", law, laws);
  name_ = std::string(shape_names[static_cast<std::size_t>(shape)]) + (law == "polach" ? "" : ", " + law_);
  if (shape == CurveShape::clean) name_ = law_;
  for (const auto& names : {parameters_of(law), parameters_of(shape)})
    for (const auto name : names)
      for (const CurveParameter& one : known_parameters())
        if (one.name == name) parameters_.push_back(one);
  std::vector<std::pair<std::string_view, double>> of_case;
  for (const CurveParameter& one : parameters_)
    if (const auto given = one.name.starts_with("polach") ? std::nullopt : number_of(base, one.name);
        given && (one.name == hardening ? *given != 0 : *given > 0) && (one.scale == ParameterScale::log || *given < 1))
      of_case.emplace_back(one.name, *given);
  start_from(of_case);
  const double given_thickness = number_of(base, thickness).value_or(1.25e-3); // that of CONTACT's user guide
  for (const auto path : replaced) base_.unset(path);
  base_.set("friction.law", law_);
  if (shape == CurveShape::elastic_layer || shape == CurveShape::plastic_layer) base_.set(thickness, given_thickness);
  if (shape == CurveShape::hardening_layer) { // so thin that its elasticity is nothing
    base_.set(thickness, 1e-9);
    base_.set(modulus, 8.2e9);
  }
}

void CurveModel::start_from(std::span<const std::pair<std::string_view, double>> values) {
  for (const auto& [name, value] : values)
    for (CurveParameter& one : parameters_)
      if (one.name == name) one.start = value, one.sign = value < 0 ? -1 : 1;
}

double CurveModel::value_of(std::string_view name, std::span<const double> values) const {
  for (std::size_t k = 0; k < parameters_.size(); ++k)
    if (parameters_[k].name == name) return values[k];
  throw Error(name_ + ": has no parameter " + std::string(name));
}

io::CaseInputs CurveModel::inputs(std::span<const double> values) const {
  io::CaseInputs inputs = base_;
  for (std::size_t k = 0; k < parameters_.size(); ++k)
    if (const std::string& name = parameters_[k].name; !name.starts_with("friction") && !name.starts_with("polach"))
      inputs.set(name, values[k]);
  const double coefficient = values.front();
  if (law_ == "coulomb") {
    inputs.set("friction.coefficient", coefficient);
  } else if (law_ == "polach") {
    inputs.set(at_rest, coefficient);
    inputs.set(ratio, value_of(ratio, values));
    inputs.set(decay, value_of(decay, values));
  } else {
    const double kinetic = coefficient * value_of(ratio, values);
    inputs.set("friction.kinetic_coefficient", kinetic);
    inputs.set("friction.drop", coefficient - kinetic);
    inputs.set(half_velocity, value_of(half_velocity, values));
  }
  return inputs;
}

std::pair<double, double> CurveModel::polach_factors(std::span<const double> values) const {
  const double slip = value_of(k_s, values);
  return {shape_ == CurveShape::polach_formula_free ? value_of(k_a, values) : polach_ratio * slip, slip};
}

std::vector<CurveModel> curve_models(const io::CaseInputs& base) {
  if (base.kind() != "bodies")
    throw Error(
        "needs a case of two bodies, [body1] and [body2], not of a wheel and a rail with profiles, whose creepage "
        "differs from patch to patch: give the radii, or an [ellipse] of a patch's area, and its load");
  std::vector<CurveModel> models;
  for (const auto law : {"coulomb", "linear", "rational", "polach"}) models.emplace_back(CurveShape::clean, law, base);
  const auto add = [&](std::initializer_list<CurveShape> shapes) {
    for (const CurveShape shape : shapes) models.emplace_back(shape, "polach", base);
  };
  const Theory theory = theory_of(base);
  if (theory == Theory::exact)
    add({CurveShape::elastic_layer, CurveShape::plastic_layer, CurveShape::hardening_layer});
  else if (theory != Theory::table)
    add({CurveShape::reduced_slope, CurveShape::falling_slope});
  add({CurveShape::polach_formula, CurveShape::polach_formula_free});
  return models;
}

const std::vector<StartingValues>& starting_values() {
  static constexpr std::string_view spiryagin = "Spiryagin, Polach & Cole 2013", polach_2005 = "Polach 2005",
                                    hou = "Hou, Kalousek & Magel 1997, at 900 MPa",
                                    guide = "CONTACT user guide, Eurosprinter with a layer";
  static const std::vector<StartingValues> all = {
      {"polach_dry", polach_2005, {{at_rest, 0.55}, {ratio, 0.4}, {decay, 0.6}, {k_a, 1.0}, {k_s, 0.4}}},
      {"polach_wet", polach_2005, {{at_rest, 0.30}, {ratio, 0.4}, {decay, 0.2}, {k_a, 0.3}, {k_s, 0.1}}},
      {"eurosprinter",
       spiryagin,
       {{at_rest, 0.36}, {ratio, 0.38}, {decay, 0.7}, {at_infinity, 0.02}, {slope_decay, 0.64}}},
      {"eurosprinter_layer", guide, {{at_rest, 0.33}, {ratio, 0.424}, {decay, 0.5545}, {modulus, 8.2e9}}},
      {"clay", hou, {{yield_stress, 200e6}, {hardening, 400e9}}},
      {"molybdenum_disulphide", hou, {{yield_stress, 20e6}, {hardening, 20e9}}},
      {"magnetite", hou, {{yield_stress, 560e6}}}, // it does not harden: a parameter is not 0
      {"sand", hou, {{yield_stress, 400e6}, {hardening, -200e9}}},
  };
  return all;
}

} // namespace microslip::fit
