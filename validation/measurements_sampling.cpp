#include "validation/measurements_sampling.hpp"

#include "campaign/distribution.hpp"
#include "campaign/sample.hpp"
#include "campaign/statistics.hpp"
#include "microslip/rolling/solver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

using campaign::Distribution, campaign::PointSet, campaign::Sample, campaign::SampleAim, campaign::SobolIndex;

constexpr double pi = std::numbers::pi;

/// Shares of the variance of each of three parameters.
struct Shares {
  std::array<double, 3> first, total;
};

std::vector<SobolIndex> indices_of(PointSet set, std::size_t points, const std::vector<std::string>& names,
                                   const std::function<double(const std::function<double(std::size_t)>& part)>& f) {
  const Sample sample(SampleAim::sobol_indices, set, points, 1, names, {});
  std::vector<double> values;
  for (std::size_t i = 0; i < sample.cases(); ++i)
    values.push_back(f([&](std::size_t k) { return sample.part(i, k); }));
  return campaign::sobol_indices(values, names.size());
}

void compare(Report& report, const std::vector<std::string>& names, const std::vector<SobolIndex>& found,
             const Shares& expected, double tolerance) {
  for (std::size_t k = 0; k < names.size(); ++k) {
    report.near(names[k] + ", alone", "{:.4f}", found[k].first, "{:.4f}", expected.first[k], tolerance);
    report.near(names[k] + ", with all others", "{:.4f}", found[k].total, "{:.4f}", expected.total[k], tolerance);
  }
}

/// sin x + 7 sin^2 y + 0.1 z^4 sin x of three angles (Ishigami and Homma 1990), whose shares are closed forms.
void report_ishigami(Report& report) {
  constexpr double a = 7, b = 0.1;
  constexpr std::size_t points = 1 << 14;
  report.heading(fmt::format("Sobol's indices of Ishigami's function, {} points", points));
  const double pi4 = std::pow(pi, 4), v1 = 0.5 * std::pow(1 + b * pi4 / 5, 2), v2 = a * a / 8,
               v13 = b * b * pi4 * pi4 * (1 / 18.0 - 1 / 50.0), v = v1 + v2 + v13;
  const auto found = indices_of(PointSet::sobol, points, {"x", "y", "z"}, [](const auto& part) {
    const auto angle = [&](std::size_t k) { return pi * (2 * part(k) - 1); };
    return std::sin(angle(0)) * (1 + b * std::pow(angle(2), 4)) + a * std::pow(std::sin(angle(1)), 2);
  });
  compare(report, {"x", "y", "z"}, found, {{v1 / v, v2 / v, 0}, {(v1 + v13) / v, v2 / v, v13 / v}}, 0.005);
}

/// A wheel of 0.46 m on a rail's head of 0.3 m under scattered load, friction and creepage, by FASTSIM2.
class ScatteredWheel {
public:
  static std::vector<std::string> names() { return {"load", "friction", "creepage"}; }

  ContactSolution at(const std::array<double, 3>& parts) {
    const Distribution load{.kind = Distribution::Kind::normal, .mean = 80e3, .standard_deviation = 8e3},
        friction{.kind = Distribution::Kind::triangular, .from = 0.15, .to = 0.45, .mode = 0.3},
        creepage{.kind = Distribution::Kind::log_normal, .to = 0.01, .mean = 0.0018, .standard_deviation = 0.0006};
    RollingProblem problem;
    problem.geometry = GapCurvatures{0.5 / 0.46, 0.5 / 0.3};
    problem.bodies = CombinedMaterial{82e9, 0.28, 0};
    problem.load = {NormalLoad::Given::force, load.quantile(parts[0])};
    problem.friction.law = FrictionLaw::coulomb(friction.quantile(parts[1]));
    problem.motion.creepage = {creepage.quantile(parts[2]), 0.0006, 0.4};
    problem.motion.rolling_speed = 30;
    return solver_.solve(problem);
  }

private:
  Solver solver_{Method{.theory = Theory::fastsim2}};
};

/// The variance of the means over what `is_fixed` leaves free: each of `outer` values of the fixed parts, which fill
/// their space evenly, with `inner` random others, less what the scatter of these means adds.
double variance_of_means(const std::function<bool(std::size_t)>& is_fixed, std::size_t outer, std::size_t inner,
                         ScatteredWheel& wheel) {
  const std::vector<std::string> names = {"1", "2", "3"};
  const Sample fixed(SampleAim::quantiles, PointSet::sobol, outer, 5, names, {}),
      others(SampleAim::quantiles, PointSet::random, outer * inner, 6, names, {});
  std::vector<double> means;
  double scatter = 0;
  for (std::size_t i = 0; i < outer; ++i) {
    std::vector<double> values;
    for (std::size_t j = 0; j < inner; ++j) {
      std::array<double, 3> parts{};
      for (std::size_t k = 0; k < 3; ++k) parts[k] = is_fixed(k) ? fixed.part(i, k) : others.part(i * inner + j, k);
      values.push_back(wheel.at(parts).totals.fx);
    }
    const campaign::Spread spread = campaign::spread_of(values, {});
    means.push_back(spread.mean);
    scatter += std::pow(spread.mean_error, 2) / static_cast<double>(outer);
  }
  return std::pow(campaign::spread_of(means, {}).standard_deviation, 2) - scatter;
}

/// Shares by their definition: S_k = V(E(f | x_k))/V, T_k = 1 - V(E(f | all but x_k))/V.
bool report_creep_force(Report& report, const StudyOptions& options) {
  constexpr std::size_t points = 1 << 12, outer = 1 << 12, inner = 24, all = 1 << 16;
  report.heading(fmt::format("Sobol's indices of a creep force: {} points beside {} direct cases for each", points,
                             outer * inner));
  ScatteredWheel wheel;
  const auto force = [&](const auto& part) { return wheel.at({part(0), part(1), part(2)}).totals.fx; };
  const Sample sample(SampleAim::quantiles, PointSet::sobol, all, 9, ScatteredWheel::names(), {});
  std::vector<double> forces;
  for (std::size_t i = 0; i < all; ++i) forces.push_back(force([&](std::size_t k) { return sample.part(i, k); }));
  const double variance = std::pow(campaign::spread_of(forces, {}).standard_deviation, 2);
  Shares expected{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (options.progress && !options.progress(0.1 + 0.25 * static_cast<double>(k))) return false;
    expected.first[k] = variance_of_means([k](std::size_t j) { return j == k; }, outer, inner, wheel) / variance;
    expected.total[k] = 1 - variance_of_means([k](std::size_t j) { return j != k; }, outer, inner, wheel) / variance;
  }
  compare(report, ScatteredWheel::names(), indices_of(PointSet::sobol, points, ScatteredWheel::names(), force),
          expected, 0.02);
  return true;
}

void report_load_spread(Report& report) {
  constexpr std::size_t few = 1024, direct = 100'000;
  constexpr std::array<double, 3> probabilities{0.05, 0.5, 0.95};
  report.heading(
      fmt::format("A load with a spread of 10 %: quantiles by {} points of Sobol's sequence over those of {} "
                  "direct cases",
                  few, direct));
  ScatteredWheel wheel;
  const auto totals = [&](PointSet set, std::size_t count) {
    const Sample sample(SampleAim::quantiles, set, count, 1, {"load"}, {});
    std::vector<double> forces, powers;
    for (std::size_t i = 0; i < count; ++i) {
      const ContactSolution s = wheel.at({sample.part(i, 0), 0.5, 0.5});
      forces.push_back(s.totals.fx);
      powers.push_back(s.totals.frictional_power);
    }
    return std::array{campaign::spread_of(forces, probabilities), campaign::spread_of(powers, probabilities)};
  };
  const auto found = totals(PointSet::sobol, few), expected = totals(PointSet::random, direct);
  for (std::size_t q = 0; q < 2; ++q)
    for (std::size_t k = 0; k < probabilities.size(); ++k)
      report.near(fmt::format("{}, {:.0f} %", q == 0 ? "Fx" : "frictional power", 100 * probabilities[k]), "{:.4f}",
                  found[q].quantiles[k].value / expected[q].quantiles[k].value, "1", 0.01);
}

} // namespace

bool report_sampling(Report& report, const StudyOptions& options) {
  report_ishigami(report);
  if (!report_creep_force(report, options)) return false;
  report_load_spread(report);
  return true;
}

} // namespace microslip::validation
