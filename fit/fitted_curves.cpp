#include "fit/fitted_curves.hpp"

#include "io/case_file.hpp"
#include "io/option_words.hpp"
#include "microslip/batch/batch.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

namespace microslip::fit {
namespace {

/// Six digits of a number, far more than the data give.
double rounded(double value) {
  const double scale = std::pow(10, 5 - std::floor(std::log10(std::abs(value))));
  return std::round(value * scale) / scale;
}

io::Json numbers(double lower, double upper) {
  return io::Json::array({io::json_number(lower), io::json_number(upper)});
}

io::Json parameters_document(const CurveFit& fit) {
  io::Json document = io::Json::object();
  for (const FittedParameter& one : fit.parameters)
    document[name_of(one)] = {{"value", io::json_number(one.value)},
                              {"interval", numbers(one.lower, one.upper)},
                              {"unit", one.parameter.unit},
                              {"held", one.is_held},
                              {"identified", one.is_identified}};
  return document;
}

/// Correlations of the free parameters in their working coordinates, by the sandwich covariance.
io::Json correlations_document(const CurveFit& fit, const io::MeasuredCurves& curves) {
  const std::size_t k = fit.free.size();
  const std::vector<double> covariance = covariances_of(fit, curves).robust;
  io::Json rows = io::Json::object();
  for (std::size_t p = 0; p < k; ++p)
    for (std::size_t q = 0; q < k; ++q)
      rows[name_of(fit.parameters[fit.free[p]])][name_of(fit.parameters[fit.free[q]])] =
          io::json_number(covariance[p * k + q] / std::sqrt(covariance[p * k + p] * covariance[q * k + q]));
  return rows;
}

io::Json models_document(const std::vector<CurveFit>& fits) {
  io::Json models = io::Json::array();
  for (const CurveFit& fit : fits) {
    io::Json one = {{"model", fit.model.name()}, {"solved", fit.is_solved()}};
    if (fit.is_solved()) {
      one["free_parameters"] = fit.free.size();
      one["rms"] = io::json_number(fit.rms);
      one["aicc"] = io::json_number(fit.aicc);
    }
    models.push_back(std::move(one));
  }
  return models;
}

io::Json curves_document(const FittedCurves& fitted) {
  const auto quantity = [](const DerivedQuantity& one) {
    return io::Json{{"value", io::json_number(one.value)}, {"interval", numbers(one.lower, one.upper)}};
  };
  io::Json curves = io::Json::array();
  for (const CurveBand& band : fitted.bands)
    curves.push_back({{"run", fitted.curves.runs[band.conditions.run]},
                      {"rolling_speed", band.conditions.speed},
                      {"normal_force", band.conditions.normal_force},
                      {"largest_coefficient", quantity(band.peak)},
                      {"creepage_at_largest", quantity(band.creepage_at_peak)},
                      {"last_coefficient", quantity(band.last)},
                      {"first_slope", quantity(band.slope)}});
  return curves;
}

} // namespace

std::string name_of(const FittedParameter& one) {
  return one.run.empty() ? one.parameter.name : one.parameter.name + " of " + one.run;
}

double FittedCurves::bias() const {
  double sum = 0;
  for (std::size_t i = 0; i < curves.points.size(); ++i) sum += best.coefficients[i] - curves.points[i].coefficient;
  return sum / static_cast<double>(curves.points.size());
}

std::optional<io::CaseInputs> FittedCurves::inputs() const {
  if (best.model.is_formula()) return std::nullopt;
  std::vector<double> values(best.model.parameters().size());
  // The friction of the runs comes first, that of the first run before the others, which may have a blank name.
  for (const FittedParameter& one : best.parameters)
    if (one.of_model > 0 || &one == &best.parameters.front()) values[one.of_model] = rounded(one.value);
  return best.model.inputs(values);
}

FittedCurves fit_creep_curves(io::MeasuredCurves curves, const std::vector<CurveModel>& models,
                              const FitOptions& options) {
  const CurveFitter fitter(curves, options);
  std::vector<CurveFit> fits = fitter.fit(models);
  const std::size_t taken = preferred(fits);
  CurveFit full = fits[taken];
  fitter.find_intervals(full);
  CurveFit best = fitter.hold_unidentified(full);
  Collinearity collinearity = collinearity_of(full);
  auto others = not_told_apart(fits, taken);
  std::vector<CurveBand> bands;
  std::optional<FurtherMeasurement> further;
  std::optional<LargestDifference> difference;
  double of_case = 0;
  const std::function<void()> tasks[] = {
      [&] { further = further_measurement(fitter, best, full.free, curves, options.elements); },
      [&] { bands = curve_bands(fitter.freed(best, full.free), curves, options.elements); },
      [&] { of_case = rms_of_case(best, curves); },
      [&] {
        if (!others.empty()) difference = largest_difference(best, fits[others.front()], curves, options.elements);
      }};
  const auto report = run_batch(std::size(tasks), {.threads = options.threads, .progress = options.progress}, [&] {
    return [&](std::size_t first, std::size_t, const Progress&) { tasks[first](); };
  });
  if (!report.complete) throw Stopped();
  return {.curves = std::move(curves),
          .fits = std::move(fits),
          .taken = taken,
          .full = std::move(full),
          .best = std::move(best),
          .collinearity = std::move(collinearity),
          .bands = std::move(bands),
          .others = std::move(others),
          .difference = difference,
          .further = further,
          .rms_of_case = of_case};
}

io::Json fitted_document(const FittedCurves& fitted) {
  io::Json document;
  document["points"] = fitted.curves.points.size();
  document["runs"] = fitted.curves.runs;
  document["model"] = fitted.best.model.name();
  document["rms"] = io::json_number(fitted.best.rms);
  document["rms_of_case"] = io::json_number(fitted.rms_of_case);
  document["bias"] = io::json_number(fitted.bias());
  document["aicc"] = io::json_number(fitted.best.aicc);
  document["parameters"] = parameters_document(fitted.best);
  document["correlations"] = correlations_document(fitted.best, fitted.curves);
  document["curves"] = curves_document(fitted);
  document["models"] = models_document(fitted.fits);
  io::Json& collinear = document["collinearity"];
  collinear = {{"index", io::json_number(fitted.collinearity.index)}, {"parameters", io::Json::array()}};
  for (const std::size_t j : fitted.collinearity.parameters)
    collinear["parameters"].push_back(name_of(fitted.full.parameters[j]));
  document["not_told_apart"] = io::Json::array();
  for (const std::size_t k : fitted.others) document["not_told_apart"].push_back(fitted.fits[k].model.name());
  if (const auto& further = fitted.further)
    document["further_measurement"] = {{"parameter", name_of(fitted.best.parameters[further->parameter])},
                                       {"points", further->points},
                                       {"creepage", numbers(further->least_creepage, further->largest_creepage)},
                                       {"rolling_speed", further->speed},
                                       {"relative_width", io::json_number(further->width)}};
  return document;
}

io::MeasuringConditions conditions_of(const io::CaseInputs& base) {
  const io::RollingCase input = io::read_case(base.root());
  if (input.problem.motion.kind != ContactMotion::steady) throw Error("motion.kind: must be steady for creep curves");
  if (input.problem.load.given != NormalLoad::Given::force)
    throw Error("load.approach: creep curves need load.normal_force");
  return {.speed = input.problem.motion.rolling_speed, .normal_force = input.problem.load.value};
}

std::vector<CurveModel> chosen_models(const io::CaseInputs& base, const std::string& model, const std::string& start) {
  std::vector<CurveModel> models = curve_models(base);
  if (!model.empty()) {
    std::vector<std::string_view> names;
    names.reserve(models.size());
    for (const CurveModel& one : models) names.push_back(one.name());
    io::require_word("model", model, names);
    models = {models[static_cast<std::size_t>(std::find(names.begin(), names.end(), model) - names.begin())]};
  }
  if (start.empty()) return models;
  std::vector<std::string_view> sets;
  for (const StartingValues& set : starting_values()) sets.push_back(set.name);
  io::require_word("start", start, sets);
  for (const StartingValues& set : starting_values())
    if (set.name == start)
      for (CurveModel& one : models) one.start_from(set.values);
  return models;
}

} // namespace microslip::fit
