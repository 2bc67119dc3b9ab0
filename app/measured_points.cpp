#include "app/measured_points.hpp"

#include "app/pictures.hpp"
#include "io/output_file.hpp"
#include "io/result_file.hpp"
#include "microslip/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace microslip::app {

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
  const std::filesystem::path path = folder / "measured_points.h5";
  io::Provenance provenance = of;
  provenance.kind = "measured_points";
  io::ResultFile file(path, provenance);
  write_points(file, comparison.curves, comparison.coefficients);
  file.scalar("rms", comparison.rms, "-", "of the computed less the measured coefficients");
  file.scalar("bias", comparison.bias, "-", "mean of the computed less the measured coefficients");
  file.commit();
  std::vector<std::string> files{path.string()};
  if (with_picture)
    for (const auto& picture : draw_pictures(path, folder)) files.push_back(picture);
  return files;
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

} // namespace microslip::app
