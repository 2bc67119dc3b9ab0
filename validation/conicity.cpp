#include "validation/studies.hpp"

#include "io/profile_file.hpp"
#include "microslip/railway/geometry/conicity.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

namespace fs = std::filesystem;

const fs::path data = fs::path(MICROSLIP_REFERENCE_DATA) / "en15302";
constexpr WheelsetBase base{1.5, 0.46};

Profile profile_of(ProfileRole role, double width, const std::function<double(double)>& z) {
  std::vector<ProfilePoint> points;
  constexpr int count = 1000;
  for (int k = 0; k <= count; ++k) {
    const double y = width * (2.0 * k / count - 1);
    points.push_back({y, z(y)});
  }
  return Profile(role, points);
}

/// An arc that rises by delta0 where y = 0 and z = 0.
Profile arc(ProfileRole role, double width, double radius, double delta0) {
  const double y0 = radius * std::sin(delta0), z0 = radius * std::cos(delta0);
  return profile_of(role, width, [=](double y) { return std::sqrt(radius * radius - (y - y0) * (y - y0)) - z0; });
}

Track rails_below_the_wheels() {
  Track track;
  track.rail_origin = ProfilePoint{0.75, 0};
  return track;
}

void report_closed_forms(Report& report) {
  report.heading("closed forms, without roll");
  constexpr double inclination = 0.025;
  const Profile rail = arc(ProfileRole::rail, 0.035, 0.3, 0);
  const Profile cone = profile_of(ProfileRole::wheel, 0.06, [](double y) { return inclination * y; });
  WheelsetSearch cones(rails_below_the_wheels(), {}, {rail, cone}, {rail, cone});
  const RollingRadiusDifference of_cones(wheelset_curve(cones, -0.0071, 0.0071, RollRule::none));
  double worst = 0;
  for (int k = 1; k <= 7; ++k) {
    const auto motion = kinematic_oscillation(of_cones, k * 1e-3, base);
    worst = std::max(worst, motion ? std::abs(motion->conicity - inclination) : 1);
  }
  report.bounded("conicity of a cone 1:40 less 0.025, 1 to 7 mm", "{:.1e}", worst, "<= 1e-7");

  // sin delta = sin delta0 +- y/(Rw - Rr), dr = Rw (cos delta of the right less that of the left wheel)
  constexpr double rw = 0.4, rr = 0.25, delta0 = 0.04;
  const Profile hollow = arc(ProfileRole::wheel, 0.05, rw, delta0), head = arc(ProfileRole::rail, 0.035, rr, delta0);
  WheelsetSearch arcs(rails_below_the_wheels(), {}, {head, hollow}, {head, hollow});
  worst = 0;
  for (int k = -25; k <= 25; ++k) {
    const double y = k * 1e-4;
    const auto angle = [&](double side) { return std::asin(std::sin(delta0) + side * y / (rw - rr)); };
    const double expected = rw * (std::cos(angle(-1)) - std::cos(angle(1)));
    worst = std::max(worst, std::abs(arcs.solve(y, 0, RollRule::none).rolling_radius_difference() - expected));
  }
  report.bounded("arcs on arcs: rolling radius difference, largest error [m]", "{:.1e}", worst, "<= 1e-10");
}

struct Row {
  double amplitude, conicity, narrow_high, narrow_low, wide_high, wide_low;
};

/// CPU time [us] of a search on one side, and how many points it finds, over 401 lateral displacements and three yaw
/// angles.
void report_search(Report& report, const Profile& rail, const Profile& wheel, const Track& track) {
  ContactSearch search(rail, wheel);
  const NominalPlacement nominal = nominal_placement(track, rail, {}, wheel);
  std::size_t states = 0, places = 0;
  const std::clock_t start = std::clock();
  for (int k = -200; k <= 200; ++k)
    for (const double yaw : {0.0, 0.01, 0.03}) {
      WheelState<double> state;
      state.lateral = k * 4e-5;
      state.yaw = yaw;
      places += search.find(place(nominal, state), 3e-4).size();
      ++states;
    }
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  report.remark("contact search, CPU time of a state [us]",
                fmt::format("{:.1f}", 1e6 * seconds / static_cast<double>(states)), "-",
                fmt::format("{:.2f} points within 0.3 mm", static_cast<double>(places) / static_cast<double>(states)));
}

std::vector<Row> rows(char wheel) {
  std::ifstream file(data / fmt::format("equivalent_conicity_{}.dat", wheel));
  std::vector<Row> rows;
  for (Row r; file >> r.amplitude >> r.conicity >> r.narrow_high >> r.narrow_low >> r.wide_high >> r.wide_low;)
    rows.push_back(r);
  return rows;
}

Profile read(const std::string& name, ProfileRole role) {
  io::ProfileFileOptions options;
  options.unit = 1e-3;
  options.role = role;
  options.y_axis = io::LateralSense::field;
  options.z_axis = io::VerticalSense::up;
  return io::read_profile(data / name, options).profile;
}

/// The rolling radius differences that the standard prints, every 0.1 mm of displacement.
RollingRadiusDifference printed_difference(char wheel) {
  std::ifstream file(data / fmt::format("rolling_radius_difference_{}.dat", wheel));
  std::vector<double> millimetres;
  for (double value = 0; file >> value;) millimetres.push_back(value);
  std::vector<RollingRadiusDifference::Value> points;
  const std::size_t middle = millimetres.size() / 2;
  for (std::size_t k = 0; k < millimetres.size(); ++k)
    points.push_back({1e-4 * (static_cast<double>(k) - static_cast<double>(middle)), 1e-3 * millimetres[k]});
  return RollingRadiusDifference(points);
}

/// Amplitudes up to which the standard's differences are smooth enough for its three digits of conicity.
void report_printed_differences(Report& report) {
  report.heading("EN 15302, annex E: conicity from the printed rolling radius differences, less the printed conicity");
  for (const auto& [name, largest] : {std::pair{'a', 6.55e-3}, {'b', 2.55e-3}}) {
    const RollingRadiusDifference difference = printed_difference(name);
    double worst = 0;
    for (const Row& row : rows(name))
      if (row.amplitude * 1e-3 < largest) {
        const auto motion = kinematic_oscillation(difference, row.amplitude * 1e-3, base);
        worst = std::max(worst, motion ? std::abs(motion->conicity - row.conicity) : 1);
      }
    report.bounded(fmt::format("wheel {}, amplitudes up to {:.1f} mm, largest", static_cast<char>(name - 'a' + 'A'),
                               largest * 1e3 - 0.05),
                   "{:.5f}", worst, "<= 0.001");
  }
}

void report_wheel(Report& report, const Profile& rail, char name) {
  const Profile wheel = read(fmt::format("wheel_{}.dat", name), ProfileRole::wheel);
  Track track;
  track.gauge = 1.43516;
  WheelsetSearch search(track, {}, {rail, wheel}, {rail, wheel});
  const RollingRadiusDifference without(wheelset_curve(search, -0.0076, 0.0076, RollRule::none));
  const RollingRadiusDifference with(wheelset_curve(search, -0.0076, 0.0076));
  report.heading(fmt::format("EN 15302, wheel {}", static_cast<char>(name - 'a' + 'A')));
  report.line("amplitude [mm]   standard   no roll   with roll");
  const auto all = rows(name);
  std::size_t narrow = 0, wide = 0;
  double worst = 0;
  for (const Row& row : all) {
    const auto conicity = [&](const RollingRadiusDifference& difference) {
      const auto motion = kinematic_oscillation(difference, row.amplitude * 1e-3, base);
      return motion ? motion->conicity : 0;
    };
    const double gamma = conicity(without);
    narrow += gamma <= row.narrow_high && gamma >= row.narrow_low;
    wide += gamma <= row.wide_high && gamma >= row.wide_low;
    worst = std::max(worst, std::abs(gamma - row.conicity));
    if (std::abs(row.amplitude * 2 - std::round(row.amplitude * 2)) < 1e-6)
      report.line(
          fmt::format("{:>14.1f} {:>10.3f} {:>9.4f} {:>11.4f}", row.amplitude, row.conicity, gamma, conicity(with)));
  }
  const auto of_all = [&](std::size_t count) { return fmt::format("{} of {}", count, all.size()); };
  report.figure("amplitudes within the narrow band", of_all(narrow), of_all(all.size()), narrow == all.size());
  report.figure("amplitudes within the wide band", of_all(wide), of_all(all.size()), wide == all.size());
  report.remark("largest difference from the standard", fmt::format("{:.4f}", worst), "-", "beside contact jumps");
  report_search(report, rail, wheel, track);
}

} // namespace

bool run_conicity(const StudyOptions& options, std::ostream& out) {
  Report report(out, options.figures);
  report_closed_forms(report);
  if (fs::exists(data / "rail.dat")) {
    const Profile rail = read("rail.dat", ProfileRole::rail);
    report_printed_differences(report);
    for (const char wheel : {'a', 'b'}) report_wheel(report, rail, wheel);
  } else {
    report.line("SKIPPED: the profiles of EN 15302 are not beside MICROSLIP_REFERENCE_DATA");
  }
  return report.all_as_stated();
}

} // namespace microslip::validation
