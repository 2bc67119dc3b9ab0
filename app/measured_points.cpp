#include "app/measured_points.hpp"

#include "app/pictures.hpp"
#include "io/output_file.hpp"
#include "io/result_file.hpp"
#include "microslip/error.hpp"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace microslip::app {
namespace {

constexpr const char* file_name = "measured_points.h5";

io::Provenance provenance_of_points(io::Provenance provenance) {
  provenance.kind = "measured_points";
  return provenance;
}

std::vector<std::string> drawn(const std::filesystem::path& path, bool with_picture) {
  std::vector<std::string> files{path.string()};
  if (with_picture)
    for (const auto& picture : draw_pictures(path, path.parent_path())) files.push_back(picture);
  return files;
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

fit::MeasuredComparison compare_with_points(const io::RollingCase& input, const std::filesystem::path& points) {
  if (input.problem.load.given != NormalLoad::Given::force)
    throw Error("load.approach: creep curves need load.normal_force");
  return fit::compare_with_measured(input, io::read_measured_curves(io::read_case_text(points), points.string(),
                                                                    {.speed = input.problem.motion.rolling_speed,
                                                                     .normal_force = input.problem.load.value}));
}

std::vector<std::string> write_comparison(const fit::MeasuredComparison& comparison, const io::Provenance& of,
                                          const std::filesystem::path& folder, bool with_picture) {
  io::create_folder(folder);
  const std::filesystem::path path = folder / file_name;
  io::ResultFile file(path, provenance_of_points(of));
  write_points(file, comparison.curves, comparison.coefficients);
  write_deviations(file, comparison.rms, comparison.bias);
  file.commit();
  return drawn(path, with_picture);
}

std::vector<std::string> write_comparison(const std::vector<campaign::SweepCurve>& curves, const io::Provenance& of,
                                          const std::filesystem::path& folder) {
  io::create_folder(folder);
  const std::filesystem::path path = folder / file_name;
  io::ResultFile file(path, provenance_of_points(of));
  io::MeasuredCurves all;
  std::vector<double> computed;
  double sum = 0, squares = 0;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const campaign::SweepCurve& curve = curves[k];
    const std::string group = fmt::format("curve_{}/", k);
    file.array(group + "creepage", curve.creepage, "-", "magnitude of the creepage");
    file.array(group + "coefficient", curve.coefficient, "-", "computed adhesion coefficient");
    write_deviations(file, curve.rms, curve.bias, group);
    for (io::MeasuredPoint point : curve.points) {
      point.run = k;
      all.points.push_back(point);
    }
    all.runs.push_back(curve.name);
    computed.insert(computed.end(), curve.computed.begin(), curve.computed.end());
    const auto count = static_cast<double>(curve.points.size());
    sum += count * curve.bias, squares += count * curve.rms * curve.rms;
  }
  write_points(file, all, computed);
  file.scalar("curves", static_cast<double>(curves.size()), "-", "number of curves, each beside the run of its number");
  const auto count = static_cast<double>(computed.size());
  write_deviations(file, std::sqrt(squares / count), sum / count);
  file.commit();
  return drawn(path, true);
}

io::Json comparison_document(const fit::MeasuredComparison& comparison) {
  return {{"points", comparison.curves.points.size()},
          {"rms", io::json_number(comparison.rms)},
          {"bias", io::json_number(comparison.bias)}};
}

std::string comparison_text(const fit::MeasuredComparison& comparison) {
  return fmt::format("{} measured points: rms {:.5f}, bias {:.5f}", comparison.curves.points.size(), comparison.rms,
                     comparison.bias);
}

io::Json comparison_document(const std::vector<campaign::SweepCurve>& curves) {
  io::Json all = io::Json::array();
  for (const campaign::SweepCurve& curve : curves)
    all.push_back({{"name", curve.name},
                   {"points", curve.points.size()},
                   {"rms", io::json_number(curve.rms)},
                   {"bias", io::json_number(curve.bias)}});
  return all;
}

std::string comparison_text(const std::vector<campaign::SweepCurve>& curves) {
  std::vector<std::string> lines;
  for (const campaign::SweepCurve& curve : curves)
    lines.push_back(fmt::format("{}{} measured points: rms {:.5f}, bias {:.5f}",
                                curve.name.empty() ? "" : curve.name + ": ", curve.points.size(), curve.rms,
                                curve.bias));
  return fmt::format("{}", fmt::join(lines, "\n"));
}

} // namespace microslip::app
