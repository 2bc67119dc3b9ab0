#include "app/measured_points.hpp"

#include "campaign/sweep_file.hpp"
#include "fit/measured_comparison.hpp"
#include "io/output_file.hpp"
#include "io/result_attribute.hpp"
#include "io/result_file.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace microslip::app {
namespace {

constexpr const char* file_name = "measured_points.h5";

/// Creepages of a drawn curve; on its logarithmic scale no bend is seen between them.
constexpr std::size_t creepages_of_curve = 61;

using Conditions = std::tuple<std::size_t, double, double>;

Conditions conditions_of(const io::MeasuredPoint& point) {
  return {point.run, point.speed, point.normal_force};
}

/// The points of each run, speed and load, in the order of the table; a run's name, its speed and load if there are
/// several.
std::vector<campaign::ComparedCurve> curves_of_points(const fit::MeasuredComparison& all) {
  std::vector<campaign::ComparedCurve> curves;
  std::map<Conditions, std::size_t> places;
  for (std::size_t i = 0; i < all.coefficients.size(); ++i) {
    const io::MeasuredPoint& point = all.curves.points[i];
    const auto place = places.emplace(conditions_of(point), curves.size()).first->second;
    if (place == curves.size()) {
      curves.push_back({.speed = point.speed, .normal_force = point.normal_force, .measured = all.curves});
      curves.back().measured.points.clear();
    }
    curves[place].measured.points.push_back(point);
    curves[place].computed.push_back(all.coefficients[i]);
  }
  for (campaign::ComparedCurve& curve : curves) {
    curve.find_deviations();
    const std::string& run = curve.measured.runs[curve.measured.points.front().run];
    if (curves.size() > 1)
      curve.name =
          fmt::format("{}{}{:.4g} m/s, {:.4g} kN", run, run.empty() ? "" : ": ", curve.speed, curve.normal_force / 1e3);
  }
  return curves;
}

/// Solves a case at even creepages, on a logarithmic scale, from the least to the largest of each curve's points.
void solve_between_points(const io::RollingCase& input, std::vector<campaign::ComparedCurve>& curves) {
  io::MeasuredCurves even = curves.front().measured;
  even.points.clear();
  for (campaign::ComparedCurve& curve : curves) {
    const auto& points = curve.measured.points;
    const auto [least, largest] = std::minmax_element(
        points.begin(), points.end(), [](const auto& one, const auto& other) { return one.creepage < other.creepage; });
    for (std::size_t k = 0; k < creepages_of_curve; ++k) {
      io::MeasuredPoint point = *least;
      point.creepage *= std::pow(largest->creepage / least->creepage,
                                 static_cast<double>(k) / static_cast<double>(creepages_of_curve - 1));
      curve.creepage.push_back(point.creepage);
      even.points.push_back(point);
    }
  }
  const auto solved = fit::compare_with_measured(input, std::move(even)).coefficients;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const auto first = solved.begin() + static_cast<std::ptrdiff_t>(k * creepages_of_curve);
    curves[k].coefficient.assign(first, first + static_cast<std::ptrdiff_t>(creepages_of_curve));
  }
}

std::string attribute_of(const std::string& result, const char* name) {
  return io::result_attribute(result, name).value_or("");
}

/// Names of results: their titles, or where these are the same or none their files, result.h5 by its folder.
std::vector<std::string> names_of(const std::vector<std::string>& results) {
  std::vector<std::string> titles, files;
  for (const std::string& result : results) {
    const std::filesystem::path path = result;
    titles.push_back(attribute_of(result, "title"));
    files.push_back(path.filename() == io::result_name && path.has_parent_path() ? path.parent_path().string()
                                                                                 : result);
  }
  const std::set<std::string> different(titles.begin(), titles.end());
  return different.size() < titles.size() || different.contains("") ? files : titles;
}

void write_deviations(io::ResultWriter& file, double rms, double bias, const std::string& group = "") {
  file.scalar(group + "rms", rms, "-", "of the computed less the measured coefficients");
  file.scalar(group + "bias", bias, "-", "mean of the computed less the measured coefficients");
}

} // namespace

void write_points(io::ResultWriter& file, const io::MeasuredCurves& curves, const std::vector<double>& computed) {
  const auto column = [&](const std::string& name, auto value, const std::string& unit, const std::string& what) {
    std::vector<double> values;
    for (const io::MeasuredPoint& point : curves.points) values.push_back(value(point));
    file.array("points/" + name, values, unit, what);
  };
  using Point = const io::MeasuredPoint&;
  column(
      "creepage", [](Point p) { return p.creepage; }, "-", "magnitude of the creepage");
  column(
      "coefficient", [](Point p) { return p.coefficient; }, "-", "measured adhesion coefficient");
  column(
      "rolling_speed", [](Point p) { return p.speed; }, "m/s", "rolling speed");
  column(
      "normal_force", [](Point p) { return p.normal_force; }, "N", "normal force");
  column(
      "run", [](Point p) { return static_cast<double>(p.run); }, "-", "number of the run");
  file.array("points/fitted", computed, "-", "computed adhesion coefficient");
  file.text("runs", fmt::format("{}", fmt::join(curves.runs, "\n")), "names of the runs, a line each");
}

Deviations deviations_of(const std::vector<campaign::ComparedCurve>& curves) {
  Deviations all;
  double sum = 0, squares = 0;
  for (const campaign::ComparedCurve& curve : curves) {
    const auto count = static_cast<double>(curve.computed.size());
    all.points += curve.computed.size();
    sum += count * curve.bias, squares += count * curve.rms * curve.rms;
  }
  const auto count = static_cast<double>(all.points);
  all.bias = sum / count, all.rms = std::sqrt(squares / count);
  return all;
}

std::vector<campaign::ComparedCurve> compare_with_points(const io::RollingCase& input,
                                                         const std::filesystem::path& points) {
  if (input.problem.load.given != NormalLoad::Given::force)
    throw Error("load.approach: creep curves need load.normal_force");
  const auto compared =
      fit::compare_with_measured(input, io::read_measured_curves(io::read_case_text(points), points.string(),
                                                                 {.speed = input.problem.motion.rolling_speed,
                                                                  .normal_force = input.problem.load.value}));
  auto curves = curves_of_points(compared);
  solve_between_points(input, curves);
  return curves;
}

std::vector<campaign::ComparedCurve> compare_result(const std::string& result, const std::filesystem::path& points) {
  const std::string kind = attribute_of(result, "kind");
  if (kind == campaign::sweep_kind) return campaign::compare_sweep(result, points);
  if (kind != "rolling_contact") {
    const bool is_rail = kind == "wheel_rail" || kind == "wheelset";
    throw Error(
        result + ": --points is for " +
        (is_rail ? std::string("results of ") + instead_of_wheel : "results of `solve` of two bodies and of `sweep`"));
  }
  const auto input = io::parse_case(attribute_of(result, "case_text"), attribute_of(result, "case_file"));
  return compare_with_points(input, points);
}

std::vector<campaign::ComparedCurve> compare_results(const std::vector<std::string>& results,
                                                     const std::filesystem::path& points) {
  const std::vector<std::string> names = names_of(results);
  std::vector<campaign::ComparedCurve> all;
  for (std::size_t k = 0; k < results.size(); ++k)
    for (campaign::ComparedCurve& curve : compare_result(results[k], points)) {
      curve.name = names[k] + (curve.name.empty() ? "" : ", ") + curve.name;
      all.push_back(std::move(curve));
    }
  return all;
}

std::filesystem::path write_comparison(const std::vector<campaign::ComparedCurve>& curves, io::Provenance of,
                                       const std::filesystem::path& folder) {
  io::create_folder(folder);
  std::filesystem::path path = folder / file_name;
  of.kind = "measured_points";
  io::ResultFile file(path, of);
  io::MeasuredCurves all;
  all.runs = curves.front().measured.runs;
  std::vector<double> computed, numbers;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const campaign::ComparedCurve& curve = curves[k];
    const std::string group = fmt::format("curve_{}/", k);
    file.text(group + "name", curve.name, "what the curve is of");
    file.array(group + "creepage", curve.creepage, "-", "magnitude of the creepage");
    file.array(group + "coefficient", curve.coefficient, "-", "computed adhesion coefficient");
    write_deviations(file, curve.rms, curve.bias, group);
    const auto& points = curve.measured.points;
    all.points.insert(all.points.end(), points.begin(), points.end());
    computed.insert(computed.end(), curve.computed.begin(), curve.computed.end());
    numbers.insert(numbers.end(), points.size(), static_cast<double>(k));
  }
  write_points(file, all, computed);
  file.array("points/curve", numbers, "-", "number of the curve that the point is compared with");
  file.scalar("curves", static_cast<double>(curves.size()), "-", "number of curves");
  const Deviations deviations = deviations_of(curves);
  write_deviations(file, deviations.rms, deviations.bias);
  file.commit();
  return path;
}

io::Json comparison_document(const Deviations& deviations) {
  return {{"points", deviations.points},
          {"rms", io::json_number(deviations.rms)},
          {"bias", io::json_number(deviations.bias)}};
}

std::string comparison_text(const Deviations& deviations) {
  return fmt::format("{} measured points: rms {:.5f}, bias {:.5f}", deviations.points, deviations.rms, deviations.bias);
}

io::Json comparison_document(const std::vector<campaign::ComparedCurve>& curves) {
  io::Json all = io::Json::array();
  for (const campaign::ComparedCurve& curve : curves) {
    all.push_back(comparison_document(Deviations{curve.computed.size(), curve.rms, curve.bias}));
    all.back()["name"] = curve.name;
  }
  return all;
}

std::string comparison_text(const std::vector<campaign::ComparedCurve>& curves) {
  std::vector<std::string> lines;
  lines.reserve(curves.size());
  for (const campaign::ComparedCurve& curve : curves)
    lines.push_back((curve.name.empty() ? "" : curve.name + ": ") +
                    comparison_text(Deviations{curve.computed.size(), curve.rms, curve.bias}));
  return fmt::format("{}", fmt::join(lines, "\n"));
}

} // namespace microslip::app
