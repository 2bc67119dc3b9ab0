#include "validation/measurements_smoothing.hpp"

#include "io/creep_table_file.hpp"
#include "microslip/batch/batch.hpp"
#include "microslip/railway/geometry/conicity.hpp"
#include "microslip/railway/profile/profile_noise.hpp"
#include "microslip/railway/profile/profile_preparation.hpp"
#include "microslip/railway/profile/profile_smoothing.hpp"
#include "microslip/railway/wheel_rail.hpp"
#include "microslip/table/creep_force_table.hpp"
#include "validation/draw.hpp"
#include "validation/worn_profiles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr double um = 1e-6;
constexpr double friction = 0.3, speed = 30, radius = 0.46, load = 80e3, yaw = 1e-3;
constexpr std::array laterals = {-3e-3, 0.0, 2e-3, 4.5e-3};
constexpr std::array spacings = {0.1e-3, 0.25e-3, 0.5e-3};
constexpr std::size_t seeds = 8, samples = seeds * spacings.size();

/// How an instrument errs at points `spacing` apart, deviations in m.
struct Errors {
  std::string name;
  double across = 0;      ///< in z
  double along = 0;       ///< in y
  double correlation = 0; ///< distance at which errors of points have 1/e in common
  double rounding = 0;    ///< unit of z
};

/// Points every `spacing` along a profile as they are measured.
std::vector<ProfilePoint> measured(const Profile& profile, const Errors& errors, double spacing, std::uint64_t seed) {
  Draw draw(seed);
  const double shared = errors.correlation > 0 ? std::exp(-spacing / errors.correlation) : 0;
  const double offset = errors.rounding * draw.number(0, 1);
  double error = draw.normal();
  std::vector<ProfilePoint> points;
  for (int k = 0; k * spacing < profile.length(); ++k) {
    ProfilePoint p = profile.at(k * spacing).value;
    p.z += errors.across * error;
    if (errors.along > 0) p.y += errors.along * draw.normal();
    if (errors.rounding > 0) p.z = errors.rounding * std::round((p.z + offset) / errors.rounding) - offset;
    points.push_back(p);
    error = shared * error + std::sqrt(1 - shared * shared) * draw.normal();
  }
  return points;
}

enum class Smoothing { none, wavelength, by_noise };

PreparedProfile prepared(const Profile& profile, const Errors& errors, double spacing, std::uint64_t seed,
                         Smoothing smoothing) {
  const auto points = measured(profile, errors, spacing, seed);
  ProfileTreatment treatment;
  if (smoothing == Smoothing::none) treatment.smoothing_length = 0;
  if (smoothing == Smoothing::wavelength) treatment.smoothing_length = estimate_noise(points).smoothing_length;
  return prepare_profile(profile.role(), points, treatment);
}

struct Result {
  double fx = NAN, fy = NAN, pressure = NAN;
};
using Results = std::array<Result, laterals.size()>;

Results solve(const WheelRailBodies& bodies, const std::shared_ptr<const CreepForceTable>& table) {
  WheelRail contact(bodies, {.theory = Theory::table, .table = table});
  Results results;
  for (std::size_t k = 0; k < laterals.size(); ++k) {
    WheelState<double> state;
    state.lateral = laterals[k], state.yaw = yaw;
    state.forward_velocity = speed, state.pitch_velocity = speed / radius;
    const WheelRailSolution found = contact.solve(state, load);
    if (found.status != Status::ok) continue;
    double pressure = 0;
    for (const WheelRailPatch& patch : found.patches) pressure = std::max(pressure, patch.peak_pressure);
    results[k] = {found.force.x, found.force.y, pressure};
  }
  return results;
}

/// What became of all samples.
struct Tally {
  int states = 0, solved = 0, forces = 0, both = 0;
  double pressure_squares = 0, stated_squares = 0;
  double largest_pressure = 0;
};

void add(const Results& found, const Results& clean, double stated, Tally& tally) {
  constexpr double same_force = 0.03, same_pressure = 0.1;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const double force = std::hypot(found[k].fx - clean[k].fx, found[k].fy - clean[k].fy) / (friction * load);
    const double pressure = found[k].pressure / clean[k].pressure - 1;
    ++tally.states;
    if (!std::isfinite(pressure)) continue;
    ++tally.solved;
    tally.forces += force < same_force;
    tally.both += force < same_force && std::abs(pressure) < same_pressure;
    tally.pressure_squares += pressure * pressure;
    tally.stated_squares += stated * stated;
    tally.largest_pressure = std::max(tally.largest_pressure, std::abs(pressure));
  }
}

/// One pair of profiles as instruments that err this way measure it, and the table for its forces.
class Measurement {
public:
  Measurement(WheelRailBodies bodies, std::shared_ptr<const CreepForceTable> table)
      : bodies_(std::move(bodies)), table_(std::move(table)), clean_(solve(bodies_, table_)) {}

  /// None if progress asked to stop.
  std::optional<Tally> tally(const Errors& errors, Smoothing smoothing, const StudyOptions& options) const {
    std::vector<Tally> parts(samples);
    const BatchReport done =
        run_batch(samples, {.threads = options.threads, .progress = options.progress}, [&]() -> BatchWorker {
          return [&](std::size_t first, std::size_t count, const Progress&) {
            for (std::size_t k = first; k < first + count; ++k) parts[k] = sample(k, errors, smoothing);
          };
        });
    if (!done.complete) return {};
    Tally all;
    for (const Tally& part : parts) {
      all.states += part.states, all.solved += part.solved, all.forces += part.forces, all.both += part.both;
      all.pressure_squares += part.pressure_squares, all.stated_squares += part.stated_squares;
      all.largest_pressure = std::max(all.largest_pressure, part.largest_pressure);
    }
    return all;
  }

  /// Equivalent conicity at 3 mm of a wheelset with this pair on both sides.
  static double conicity(const WheelRailBodies& bodies) {
    WheelsetSearch search(bodies.track, bodies.wheelset, {bodies.rail, bodies.wheel}, {bodies.rail, bodies.wheel});
    const auto motion =
        kinematic_oscillation(RollingRadiusDifference(curve_of_amplitudes(search, 3e-3, true)), 3e-3, {1.5, radius});
    return motion ? motion->conicity : NAN;
  }

  WheelRailBodies measured_bodies(std::size_t k, const Errors& errors, Smoothing smoothing, double& stated) const {
    const double spacing = spacings[k % spacings.size()];
    const auto rail = prepared(bodies_.rail, errors, spacing, 2 * k, smoothing);
    const auto wheel = prepared(bodies_.wheel, errors, spacing, 2 * k + 1, smoothing);
    WheelRailBodies bodies = bodies_;
    bodies.rail = rail.profile, bodies.wheel = wheel.profile;
    stated = std::hypot(rail.report.smoothing.pressure_left, wheel.report.smoothing.pressure_left);
    return bodies;
  }

  const WheelRailBodies& clean() const { return bodies_; }

private:
  Tally sample(std::size_t k, const Errors& errors, Smoothing smoothing) const {
    double stated = 0;
    const auto bodies = measured_bodies(k, errors, smoothing, stated);
    Tally tally;
    add(solve(bodies, table_), clean_, stated, tally);
    return tally;
  }

  WheelRailBodies bodies_;
  std::shared_ptr<const CreepForceTable> table_;
  Results clean_;
};

constexpr const char* columns =
    "errors                                  both of 96    forces   pressure rms   stated   largest";

std::string row(const std::string& name, const Tally& t) {
  const auto percent = [n = t.solved](double squares) { return fmt::format("{:.1f} %", 100 * std::sqrt(squares / n)); };
  return fmt::format("{:38s} {:11d} {:9d} {:>14s} {:>8s} {:7.1f} %", name, t.both, t.forces,
                     percent(t.pressure_squares), t.stated_squares > 0 ? percent(t.stated_squares) : "-",
                     100 * t.largest_pressure);
}

bool report_smoothings(Report& report, const Measurement& measurement, const StudyOptions& options) {
  struct Wanted {
    Errors errors;
    double share; ///< of states with force and pressure
  };
  const std::vector<Wanted> all = {{{"white, 1 um", 1 * um}, 0.97},
                                   {{"white, 4 um", 4 * um}, 0.93},
                                   {{"white, 10 um", 10 * um}, 0.88},
                                   {{"white, 20 um", 20 * um}, 0.75}};
  report.heading("S1002 on 60E1, both measured with white noise in z, points every 0.1, 0.25, 0.5 mm: states with a "
                 "force within 3 % of mu Fz and a peak pressure within 10 %");
  for (const auto& [smoothing, name] : {std::pair(Smoothing::none, "not smoothed"),
                                        {Smoothing::wavelength, "one wavelength"},
                                        {Smoothing::by_noise, "by the noise"}}) {
    report.line(fmt::format("{}, {}", columns, name));
    for (const Wanted& wanted : all) {
      const auto tally = measurement.tally(wanted.errors, smoothing, options);
      if (!tally) return false;
      report.line(row(wanted.errors.name, *tally));
      if (smoothing == Smoothing::by_noise)
        report.bounded(wanted.errors.name + ", part of both", "{:.2f}",
                       static_cast<double>(tally->both) / tally->states, fmt::format(">= {}", wanted.share));
    }
  }
  return true;
}

bool report_other_errors(Report& report, const Measurement& measurement, const StudyOptions& options) {
  report.heading("Other errors, smoothed by the noise");
  report.line(columns);
  const std::vector<Errors> all = {{"y and z, 4 um", 4 * um, 4 * um},
                                   {"y and z, 10 um", 10 * um, 10 * um},
                                   {"0.4 mm in common, 1 um", 1 * um, 0, 0.4e-3},
                                   {"0.4 mm in common, 4 um", 4 * um, 0, 0.4e-3},
                                   {"0.4 mm in common, 10 um", 10 * um, 0, 0.4e-3},
                                   {"rounded to 1 um", 0, 0, 0, 1 * um},
                                   {"rounded to 5 um", 0, 0, 0, 5 * um},
                                   {"rounded to 10 um", 0, 0, 0, 10 * um}};
  for (const Errors& errors : all) {
    const auto tally = measurement.tally(errors, Smoothing::by_noise, options);
    if (!tally) return false;
    report.line(row(errors.name, *tally));
  }
  return true;
}

bool report_worn(Report& report, const std::vector<ProfilePair>& pairs,
                 const std::shared_ptr<const CreepForceTable>& table, const StudyOptions& options) {
  report.heading("Worn profiles with white noise in z, smoothed by the noise where nothing else is said");
  report.line(columns);
  for (const ProfilePair& pair : pairs) {
    if (pair.name == pairs.front().name || pair.name.starts_with("measured")) continue;
    const Measurement measurement(pair.bodies, table);
    for (const double deviation : {4 * um, 10 * um})
      for (const auto& [smoothing, how] :
           {std::pair(Smoothing::wavelength, ", one wavelength"), {Smoothing::by_noise, ""}}) {
        const auto tally = measurement.tally({"", deviation}, smoothing, options);
        if (!tally) return false;
        report.line(row(fmt::format("{}, {:.0f} um{}", pair.name, deviation / um, how), *tally));
      }
  }
  return true;
}

bool report_conicity(Report& report, const Measurement& measurement, const StudyOptions& options) {
  report.heading("Equivalent conicity of S1002 on 60E1 at 3 mm, white noise in z");
  const double clean = Measurement::conicity(measurement.clean());
  for (const double deviation : {1 * um, 4 * um, 10 * um}) {
    std::vector<double> errors(samples);
    const BatchReport done =
        run_batch(samples, {.threads = options.threads, .progress = options.progress}, [&]() -> BatchWorker {
          return [&](std::size_t first, std::size_t count, const Progress&) {
            for (std::size_t k = first; k < first + count; ++k) {
              double stated = 0;
              const auto bodies = measurement.measured_bodies(k, {"", deviation}, Smoothing::by_noise, stated);
              errors[k] = std::abs(Measurement::conicity(bodies) / clean - 1);
            }
          };
        });
    if (!done.complete) return false;
    report.bounded(fmt::format("{:.0f} um, largest of {} errors [%]", deviation / um, samples), "{:.1f}",
                   100 * *std::max_element(errors.begin(), errors.end()), "<= 5");
  }
  return true;
}

} // namespace

bool report_measured_profiles(Report& report, const StudyOptions& options) {
  const auto pairs = worn_pairs();
  const auto table = std::make_shared<const CreepForceTable>(io::read_creep_table(io::shipped_creep_table()),
                                                             pairs.front().bodies.material.poisson_ratio);
  const Measurement measurement(pairs.front().bodies, table);
  return report_smoothings(report, measurement, options) && report_other_errors(report, measurement, options) &&
         report_worn(report, pairs, table, options) && report_conicity(report, measurement, options);
}

} // namespace microslip::validation
