#include "validation/measurements_fits.hpp"

#include "fit/curve_evaluator.hpp"
#include "fit/curve_fit.hpp"
#include "microslip/batch/batch.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

using fit::CurveFit;
using fit::CurveFitter;
using fit::CurveModel;
using fit::CurveShape;

/// The wheel of CONTACT's user guide: R = 625 mm, a/b = 0.5, 106.7 kN, 10 m/s.
constexpr const char* contact = R"([body1]
shear_modulus = "82 GPa"
poisson_ratio = 0.28
[body2]
shear_modulus = "82 GPa"
poisson_ratio = 0.28
[ellipse]
a = "6.304 mm"
b = "12.608 mm"
[load]
normal_force = "106.7 kN"
[friction]
coefficient = 0.3
[motion]
rolling_speed = 10.0
[solution]
theory = )";

constexpr double noise = 0.025; // standard deviation, that of the measured curve of the Eurosprinter

struct Truth {
  CurveShape shape;
  const char* theory;
  std::vector<double> values;
  int points;
};

CurveModel model_of(const Truth& truth) {
  return {truth.shape, "polach", io::CaseInputs::read(fmt::format("{}\"{}\"\n", contact, truth.theory), "synthetic")};
}

/// Points of the truth from one creepage to another, evenly over the logarithm, without noise.
io::MeasuredCurves exact_points(const Truth& truth, const CurveModel& model, double least, double largest,
                                int elements) {
  io::MeasuredCurves curves{.runs = {""}};
  for (int i = 0; i < truth.points; ++i)
    curves.points.push_back(
        {.creepage = least * std::pow(largest / least, i / (truth.points - 1.)), .speed = 10, .normal_force = 106.7e3});
  std::vector<double> coefficients(curves.points.size());
  fit::CurveEvaluator(model, curves, elements).evaluate(truth.values, coefficients);
  for (std::size_t i = 0; i < coefficients.size(); ++i) curves.points[i].coefficient = coefficients[i];
  return curves;
}

io::MeasuredCurves with_noise(io::MeasuredCurves curves, std::size_t seed) {
  std::mt19937 random(static_cast<unsigned>(1000 + seed));
  std::normal_distribution<double> normal(0, noise);
  for (auto& point : curves.points) point.coefficient += normal(random);
  return curves;
}

/// Fits of so many synthetic curves with their intervals; none if progress asked to stop.
std::vector<CurveFit> fits_of(const Truth& truth, double least, double largest, std::size_t sets, int elements,
                              const StudyOptions& options) {
  const CurveModel model = model_of(truth);
  const io::MeasuredCurves points = exact_points(truth, model, least, largest, elements);
  std::vector<CurveFit> fits(sets, CurveFit{.model = model});
  const BatchOptions batch{.threads = options.threads, .progress = options.progress};
  const BatchReport done = run_batch(sets, batch, [&] {
    return [&](std::size_t set, std::size_t, const Progress&) {
      const io::MeasuredCurves curves = with_noise(points, set);
      const CurveFitter fitter(curves, {.elements = elements});
      CurveFit fit = fitter.fit({model}).front();
      if (fit.is_solved()) fitter.find_intervals(fit);
      fits[set] = std::move(fit);
    };
  });
  if (!done.complete) fits.clear();
  return fits;
}

/// How many intervals of a hundred hold the truth.
bool report_coverage(Report& report, const Truth& truth, int elements, const StudyOptions& options) {
  constexpr std::size_t sets = 300;
  const auto fits = fits_of(truth, 3.66e-3, 0.21, sets, elements, options);
  if (fits.empty()) return false;
  report.heading(fmt::format("{}, {}: {} curves of {} points, 95 % intervals that hold the truth, in 100",
                             fits.front().model.name(), truth.theory, sets, truth.points));
  for (const std::size_t j : fits.front().free) {
    std::size_t holding = 0;
    for (const CurveFit& fit : fits)
      holding +=
          fit.is_solved() && fit.parameters[j].lower <= truth.values[j] && truth.values[j] <= fit.parameters[j].upper;
    const double share = 100. * static_cast<double>(holding) / static_cast<double>(sets);
    report.figure(fits.front().parameters[j].parameter.name, fmt::format("{:.1f}", share), "90 to 98",
                  share >= 90 && share <= 98);
  }
  return true;
}

/// How often the parameter with an index is named as not identified, of a hundred curves.
bool report_unidentified(Report& report, const char* name, const Truth& truth, double least, double largest,
                         std::size_t parameter, const StudyOptions& options) {
  const auto fits = fits_of(truth, least, largest, 100, 16, options);
  if (fits.empty()) return false;
  report.count(
      name,
      std::count_if(fits.begin(), fits.end(),
                    [&](const CurveFit& fit) { return fit.is_solved() && !fit.parameters[parameter].is_identified; }),
      100);
  return true;
}

/// The measured curve of the Eurosprinter, of which CONTACT's own two models leave 0.0284 and 0.0259.
void report_eurosprinter(Report& report) {
  report.heading("measured curve of the Eurosprinter, 149 points: rms of fits with four parameters");
  const std::string path = MICROSLIP_REFERENCE_DATA "/creep-curves/eurosprinter_measured.csv";
  std::ifstream file(path);
  if (!file) return report.line(path + " is not there");
  std::string line;
  std::getline(file, line); // its names are others
  std::stringstream text;
  text << "creepage_longitudinal [%],adhesion_coefficient\n" << file.rdbuf();
  const auto curves = io::read_measured_curves(text.str(), path, {.speed = 10, .normal_force = 106.7e3});
  for (const auto& [shape, theory] :
       {std::pair(CurveShape::falling_slope, "fastsim2"), {CurveShape::hardening_layer, "exact"}}) {
    const CurveFit fit = CurveFitter(curves, {}).fit({model_of({shape, theory, {}, 0})}).front();
    report.bounded(fmt::format("{}, {}", fit.model.name(), theory), "{:.5f}", fit.rms, "<= 0.0248");
  }
}

} // namespace

bool report_creep_curve_fits(Report& report, const StudyOptions& options) {
  report_eurosprinter(report);
  report.heading("parameters of which the points say nothing, 100 curves each: named as not identified");
  const Truth clean{CurveShape::clean, "fastsim2", {0.35, 0.4, 0.5}, 40},
      reduced{CurveShape::reduced_slope, "fastsim2", {0.35, 0.4, 0.5, 0.5}, 40};
  if (!report_unidentified(report, "decay, points to 0.15 % creepage", clean, 1e-4, 1.5e-3, 2, options) ||
      !report_unidentified(report, "reduced slope, points from 5 % creepage", reduced, 0.05, 0.5, 3, options))
    return false;
  if (!options.thorough) return true;
  const Truth formula{CurveShape::polach_formula, "fastsim2", {0.359, 0.4, 0.59, 0.36}, 149},
      falling{CurveShape::falling_slope, "fastsim2", {0.357, 0.4, 0.61, 0.027, 0.88}, 149},
      layer{CurveShape::hardening_layer, "exact", {0.334, 0.4, 0.48, 105e6, 0.87e12}, 149};
  return report_coverage(report, formula, 16, options) && report_coverage(report, falling, 16, options) &&
         report_coverage(report, layer, 8, options);
}

} // namespace microslip::validation
