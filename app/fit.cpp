#include "app/commands.hpp"

#include "app/command_line.hpp"
#include "app/exit_code.hpp"
#include "app/interrupt.hpp"
#include "app/json_document.hpp"
#include "app/measured_points.hpp"
#include "app/pictures.hpp"
#include "app/progress_bar.hpp"
#include "app/quantity_table.hpp"
#include "fit/fitted_curves.hpp"
#include "io/case_file.hpp"
#include "io/output_file.hpp"
#include "io/result_file.hpp"
#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace microslip::app {
namespace {

namespace fs = std::filesystem;

struct FitArguments {
  fs::path points, case_file, folder;
  std::string model, start;
  int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  bool huber = false, no_pictures = false, json = false;
};

using fit::name_of;

fit::FittedCurves find_fit(const FitArguments& arguments, const io::CaseInputs& base) {
  require_count("--threads", arguments.threads, 1, most_threads);
  const std::vector<fit::CurveModel> models = fit::chosen_models(base, arguments.model, arguments.start);
  io::MeasuredCurves curves = io::read_measured_curves(io::read_case_text(arguments.points), arguments.points.string(),
                                                       fit::conditions_of(base));
  ProgressBar bar("fit");
  const fit::FitOptions options{
      .huber = arguments.huber, .threads = arguments.threads, .progress = [&](double fraction) {
        bar.update(fraction);
        return !InterruptGuard::interrupted();
      }};
  try {
    return fit::fit_creep_curves(std::move(curves), models, options);
  } catch (const Stopped&) {
    InterruptGuard::throw_if_interrupted();
    throw;
  }
}

/// Values and ends of an interval in a unit that is easily read; an open end says so.
std::vector<std::string> interval_texts(const fit::FittedParameter& one, const PrintedUnit& unit) {
  const auto text = [&](double value) { return fmt::format("{:.4g}", value * unit.factor); };
  if (one.is_held) return {text(one.value), "held"};
  const bool is_share = one.parameter.scale == fit::ParameterScale::logit, is_negative = one.parameter.sign < 0;
  const bool open_below = is_negative ? std::isinf(one.lower) : one.lower <= 0;
  const bool open_above = is_negative ? one.upper >= 0 : std::isinf(one.upper) || (is_share && one.upper >= 1);
  return {text(one.value),
          fmt::format("{} to {}", open_below ? "open" : text(one.lower), open_above ? "open" : text(one.upper))};
}

void print_models(const fit::FittedCurves& run) {
  double best = std::numeric_limits<double>::infinity();
  for (const fit::CurveFit& fit : run.fits)
    if (fit.is_solved()) best = std::min(best, fit.aicc);
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < run.fits.size(); ++k)
    if (run.fits[k].is_solved()) order.push_back(k);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return run.fits[a].aicc < run.fits[b].aicc; });
  fmt::print("Models                parameters     rms    AICc above the best\n");
  for (const std::size_t k : order)
    fmt::print("  {:<20} {:>5} {:>13.5f} {:>10.1f}{}\n", run.fits[k].model.name(), run.fits[k].free.size(),
               run.fits[k].rms, run.fits[k].aicc - best, k == run.taken ? "  taken" : "");
  for (const fit::CurveFit& fit : run.fits)
    if (!fit.is_solved()) fmt::print("  {:<20} could not be fitted\n", fit.model.name());
}

void print_parameters(const fit::CurveFit& fit) {
  fmt::print("\nParameters of {}                       95 % interval\n", fit.model.name());
  for (const fit::FittedParameter& one : fit.parameters) {
    const PrintedUnit unit = readable_unit(one.parameter.unit, {one.value});
    const auto texts = interval_texts(one, unit);
    fmt::print("  {:<40} {:>9}  {:<20} {}\n", name_of(one), texts[0], texts[1], unit.name);
  }
}

void print_derived(const fit::FittedCurves& run) {
  for (const fit::CurveBand& band : run.bands) {
    const std::string& name = run.curves.runs[band.conditions.run];
    fmt::print("\nCurve{} at {:.4g} m/s, {:.4g} kN                95 % interval\n", name.empty() ? "" : " of " + name,
               band.conditions.speed, band.conditions.normal_force * 1e-3);
    const auto line = [](const char* what, const fit::DerivedQuantity& one, double factor, const char* unit) {
      fmt::print("  {:<36} {:>9.4g}  {:.4g} to {:.4g} {}\n", what, one.value * factor, one.lower * factor,
                 one.upper * factor, unit);
    };
    line("largest adhesion coefficient", band.peak, 1, "");
    line("creepage there", band.creepage_at_peak, 100, "%");
    line(fmt::format("coefficient at {:.4g} %", 100 * band.creepage.back()).c_str(), band.last, 1, "");
    line(fmt::format("slope at {:.4g} %", 100 * band.creepage.front()).c_str(), band.slope, 0.01, "1/%");
  }
}

/// What the data do not tell, a line each.
std::vector<std::string> findings(const fit::FittedCurves& run) {
  std::vector<std::string> texts;
  for (std::size_t j = 0; j < run.full.parameters.size(); ++j) {
    const fit::FittedParameter &one = run.full.parameters[j], &after = run.best.parameters[j];
    if (one.is_identified) continue;
    const PrintedUnit unit = readable_unit(one.parameter.unit, {one.value});
    texts.push_back(fmt::format("{}: {}{}, {}", name_of(one), interval_texts(one, unit)[1],
                                unit.name == "-" ? "" : " " + std::string(unit.name),
                                after.is_held ? fmt::format("held at {:.4g}", after.value * unit.factor)
                                              : "fitted with others held"));
  }
  constexpr double most = 15; // of an index that is no matter
  if (run.collinearity.index > most) {
    std::vector<std::string> names;
    for (const std::size_t j : run.collinearity.parameters) names.push_back(name_of(run.full.parameters[j]));
    texts.push_back(fmt::format("{} from each other, collinearity index {:.0f}", fmt::join(names, " and "),
                                run.collinearity.index));
  }
  if (!run.others.empty()) {
    std::vector<std::string> names;
    for (const std::size_t k : run.others) names.push_back(run.fits[k].model.name());
    const auto& [creepage, first, second] = *run.difference;
    texts.push_back(fmt::format("{} from {}, which differ most at {:.2g} % creepage: {:.3f} and {:.3f}",
                                run.best.model.name(), fmt::join(names, " and "), 100 * creepage, first, second));
  }
  return texts;
}

/// What further points would help most; empty if none would much.
std::string advice(const fit::FittedCurves& run) {
  if (!run.further) return "";
  const fit::FurtherMeasurement& further = *run.further;
  return fmt::format("{} points more at {:.2g} to {:.2g} % creepage and {:.4g} m/s: interval of {} x {:.2f}",
                     further.points, 100 * further.least_creepage, 100 * further.largest_creepage, further.speed,
                     name_of(run.best.parameters[further.parameter]), further.width);
}

void print_text(const fit::FittedCurves& run) {
  fmt::print("{} points, {}\n\n", run.curves.points.size(),
             run.curves.runs.size() == 1 ? "one run" : fmt::format("{} runs", run.curves.runs.size()));
  print_models(run);
  print_parameters(run.best);
  print_derived(run);
  fmt::print("\nrms {:.5f}, bias {:.1e}\n", run.best.rms, run.bias());
  if (std::abs(run.rms_of_case - run.best.rms) > 1e-6) // other elements
    fmt::print("rms {:.5f} on the elements of the case\n", run.rms_of_case);
  if (const auto texts = findings(run); !texts.empty())
    fmt::print("\nWhat the data do not tell\n  {}\n", fmt::join(texts, "\n  "));
  if (const std::string text = advice(run); !text.empty()) fmt::print("\nWhat would help most\n  {}\n", text);
}

void print_document(const FitArguments& arguments, const fit::FittedCurves& run,
                    const std::vector<std::string>& files) {
  io::Json document = json_document("creep_curve_fit");
  document["points_file"] = arguments.points.string();
  document["case_file"] = arguments.case_file.string();
  document.update(fit::fitted_document(run));
  document["files"] = files;
  print_json(document);
}

void write_result(const FitArguments& arguments, const std::string& case_text, const fit::FittedCurves& run,
                  const fs::path& path) {
  io::ResultFile file(path, {.kind = "creep_curve_fit",
                             .title = arguments.points.filename().string() + ", " + run.best.model.name(),
                             .command_line = command_line(),
                             .case_file = arguments.case_file.string(),
                             .case_text = case_text});
  write_points(file, run.curves, run.best.coefficients);
  for (std::size_t k = 0; k < run.bands.size(); ++k) {
    const fit::CurveBand& band = run.bands[k];
    const std::string group = fmt::format("curve_{}/", k);
    file.array(group + "creepage", band.creepage, "-", "magnitude of the creepage");
    file.array(group + "coefficient", band.coefficient, "-", "fitted adhesion coefficient");
    file.array(group + "half_width", band.half_width, "-", "of the 95 % band of the curve");
    file.array(group + "least_point", band.least_point, "-", "lower end of the 95 % band of further points");
    file.array(group + "largest_point", band.largest_point, "-", "upper end of the 95 % band of further points");
    file.scalar(group + "simultaneous", band.simultaneous, "-", "half widths of the band that holds the whole curve");
    file.scalar(group + "run", static_cast<double>(band.conditions.run), "-", "number of the run");
    file.scalar(group + "rolling_speed", band.conditions.speed, "m/s", "rolling speed");
    file.scalar(group + "normal_force", band.conditions.normal_force, "N", "normal force");
  }
  for (const fit::FittedParameter& one : run.best.parameters) {
    const std::string group = "parameters/" + name_of(one) + "/";
    file.scalar(group + "value", one.value, one.parameter.unit, "fitted value");
    file.scalar(group + "lower", one.lower, one.parameter.unit, "lower end of the 95 % interval");
    file.scalar(group + "upper", one.upper, one.parameter.unit, "upper end of the 95 % interval, inf where it is open");
  }
  file.scalar("curves", static_cast<double>(run.bands.size()), "-", "number of the groups curve_0, curve_1 and so on");
  file.scalar("rms", run.best.rms, "-", "of the deviations of the points");
  file.commit();
}

std::vector<std::string> write_files(const FitArguments& arguments, const std::string& case_text,
                                     const fit::FittedCurves& run) {
  if (arguments.folder.empty()) return {};
  io::create_folder(arguments.folder);
  std::vector<std::string> files;
  if (const auto inputs = run.inputs()) {
    const fs::path path = arguments.folder / "case.toml";
    io::OutputFile file(path);
    file.write(inputs->text());
    file.commit();
    files.push_back(path.string());
  }
  const fs::path result = arguments.folder / io::result_name;
  write_result(arguments, case_text, run, result);
  InterruptGuard::throw_if_interrupted();
  files.push_back(result.string());
  if (!arguments.no_pictures)
    for (const auto& picture : draw_pictures(result, arguments.folder)) files.push_back(picture);
  return files;
}

void run(const FitArguments& arguments) {
  if (!arguments.folder.empty()) io::require_writable_file_in(arguments.folder, io::result_name);
  const std::string text = io::read_case_text(arguments.case_file);
  const fit::FittedCurves found = find_fit(arguments, io::CaseInputs::read(text, arguments.case_file.string()));
  if (!arguments.json) print_text(found);
  const auto files = write_files(arguments, text, found);
  if (arguments.json) {
    print_document(arguments, found, files);
  } else if (!files.empty()) {
    fmt::print("\nWritten\n");
    for (const auto& file : files) fmt::print("  {}\n", file);
  }
}

std::string footer() {
  std::string text = R"(POINTS.csv has a line of names and then the points: creepage_longitudinal or creepage_lateral,
adhesion_coefficient or force, and if wanted rolling_speed, normal_force, run and sigma, each with any unit behind it:
creepage_longitudinal [%]. Speed and load are otherwise the case's. Every run has a friction of its own.

The models are fitted by the theory of the case: friction laws coulomb, linear, rational, polach on clean bodies;
with polach's law reduced_slope and falling_slope (FASTSIM, FASTSIM2), or elastic_layer, plastic_layer and
hardening_layer (exact theory); and Polach's formula, polach_formula and polach_formula_free, which no case solves by.

Published parameters to start from, none of them a prediction:
)";
  for (const fit::StartingValues& set : fit::starting_values())
    text += fmt::format("  {:<22} {}\n", set.name, set.source);
  return text + "\nExample:\n  microslip fit examples/creep_curve.csv --case examples/creep_curve.toml -o fitted";
}

} // namespace

void add_fit_command(Command& program) {
  Command command = program.add_subcommand("fit", "Fit friction and layers to measured creep curves", footer());
  FitArguments& arguments = command.arguments(run);
  command.add_option("POINTS.csv", arguments.points, "measured creep curves").required();
  command.add_option("--case CASE.toml", arguments.case_file, "the contact, two bodies, and the theory to fit with")
      .required();
  command.add_option("--model NAME", arguments.model,
                     "model to fit; default: all, and the simplest of the best is taken");
  command.add_option("--start NAME", arguments.start, "published parameters to start from; default: those of the case");
  command.add_flag("--huber", arguments.huber, "let single points far from the curve count less (Huber's loss)");
  command.add_option("--threads COUNT", arguments.threads,
                     "threads, 1 to 1024; results do not depend on it; default: one for each processor");
  command.add_option("-o,--output FOLDER", arguments.folder,
                     "folder for case.toml, result.h5 and the picture; default: none is written");
  command.add_flag("--no-pictures", arguments.no_pictures, "write case.toml and result.h5 only");
  add_json_flag(command, arguments.json);
}

} // namespace microslip::app
