#include "microslip/friction/friction_table.hpp"

#include "microslip/decimal.hpp"
#include "microslip/error.hpp"
#include "microslip/friction/friction_law.hpp"

#include <string>
#include <utility>

namespace microslip {
namespace {

std::string numbered(const char* field, std::size_t i) {
  return field + ("." + std::to_string(i + 1));
}

/// An axis with finite numbers in [least, largest] that ascend.
void check(const char* field, const std::vector<double>& axis, const char* unit, double least, double largest) {
  for (std::size_t i = 0; i < axis.size(); ++i) {
    require_between(numbered(field, i), axis[i], unit, least, largest);
    if (i > 0 && !(axis[i] > axis[i - 1]))
      throw Error(numbered(field, i), axis[i], unit, "above the one before, " + shortest_text(axis[i - 1]));
  }
}

void check(const FrictionGrid& grid) {
  const auto& [velocities, pressures, temperatures, mu] = grid;
  if (velocities.size() < 2) throw Error("slip_velocities: must be at least 2 numbers");
  check("slip_velocities", velocities, "m/s", 0, FrictionTable::largest_velocity);
  check("pressures", pressures, "Pa", 0, FrictionTable::largest_pressure);
  check("temperatures", temperatures, "deg C", FrictionTable::lowest_temperature, FrictionTable::highest_temperature);
  const std::size_t curves = std::max(std::size_t{1}, pressures.size()) * std::max(std::size_t{1}, temperatures.size());
  if (mu.size() != curves * velocities.size())
    throw Error("coefficients: must be " + std::to_string(curves * velocities.size()) + " numbers, one for each of " +
                (curves == 1 ? "slip_velocities" : "the grid's nodes") + ", not " + std::to_string(mu.size()));
  for (std::size_t i = 0; i < mu.size(); ++i)
    require_between(numbered("coefficients", i), mu[i], "-", 0, FrictionLaw::largest_coefficient);
}

struct Chord {
  double length, slope;
};

/// The slope between two chords: none where the values have an extremum, else the weighted harmonic mean.
double slope_between(const Chord& one, const Chord& two) {
  if (!(one.slope * two.slope > 0)) return 0;
  const double weight1 = 2 * two.length + one.length, weight2 = two.length + 2 * one.length;
  return (weight1 + weight2) / (weight1 / one.slope + weight2 / two.slope);
}

/// The slope at an end, of the parabola through three values as far as it leaves the cubic monotone.
double slope_at_end(const Chord& last, const Chord& next) {
  const double slope =
      ((2 * last.length + next.length) * last.slope - last.length * next.slope) / (last.length + next.length);
  if (!(slope * last.slope > 0)) return 0;
  if (last.slope * next.slope <= 0 && std::abs(slope) > 3 * std::abs(last.slope)) return 3 * last.slope;
  return slope;
}

std::vector<double> slopes_of(const std::vector<Chord>& chords) {
  if (chords.size() == 1) return {chords[0].slope, chords[0].slope};
  std::vector<double> slopes = {slope_at_end(chords[0], chords[1])};
  for (std::size_t i = 1; i < chords.size(); ++i) slopes.push_back(slope_between(chords[i - 1], chords[i]));
  slopes.push_back(slope_at_end(chords.back(), chords[chords.size() - 2]));
  return slopes;
}

/// mu(v) as it is sampled.
struct Samples {
  const std::function<double(double)>& function;
  std::vector<double> v = {}, mu = {};

  void add(double at) {
    const double value = function(at);
    if (!(value >= 0 && value <= FrictionLaw::largest_coefficient))
      require_between("coefficient at slip_velocity = " + shortest_text(at) + " m/s", value, "-", 0,
                      FrictionLaw::largest_coefficient);
    v.push_back(at);
    mu.push_back(value);
  }
};

/// The samples, and more in all places where the cubics between them are not accurate enough.
Samples refined(const Samples& coarse, double accuracy) {
  constexpr std::size_t most = 100'000;
  constexpr double closest = 1e-12; // of the velocities
  const FrictionTable table(coarse.v, coarse.mu);
  Samples fine{coarse.function};
  for (std::size_t i = 0; i + 1 < coarse.v.size(); ++i) {
    const double from = coarse.v[i], step = coarse.v[i + 1] - from;
    fine.v.push_back(from);
    fine.mu.push_back(coarse.mu[i]);
    Samples between{coarse.function};
    bool is_accurate = true;
    for (const double share : {0.25, 0.5, 0.75}) {
      between.add(from + share * step);
      is_accurate &= std::abs(between.mu.back() - table.coefficient(between.v.back())) <= accuracy;
    }
    if (is_accurate) continue;
    if (step < closest * coarse.v.back())
      throw Error("coefficient: must not jump, as it does at slip_velocity = " + shortest_text(from) + " m/s");
    fine.v.insert(fine.v.end(), between.v.begin(), between.v.end());
    fine.mu.insert(fine.mu.end(), between.mu.begin(), between.mu.end());
    if (fine.v.size() > most)
      throw Error("accuracy = " + shortest_text(accuracy) +
                  " [-]: needs more than 100,000 samples of this coefficient");
  }
  fine.v.push_back(coarse.v.back());
  fine.mu.push_back(coarse.mu.back());
  return fine;
}

} // namespace

FrictionTable::FrictionTable(std::vector<double> slip_velocities, std::vector<double> coefficients)
    : FrictionTable(
          FrictionGrid{.slip_velocities = std::move(slip_velocities), .coefficients = std::move(coefficients)}) {}

FrictionTable::FrictionTable(FrictionGrid grid) : grid_(std::move(grid)) {
  check(grid_);
  const std::vector<double>& v = grid_.slip_velocities;
  for (std::size_t first = 0; first < grid_.coefficients.size(); first += v.size()) {
    const double* mu = grid_.coefficients.data() + first;
    std::vector<Chord> chords;
    for (std::size_t i = 0; i + 1 < v.size(); ++i)
      chords.push_back({v[i + 1] - v[i], (mu[i + 1] - mu[i]) / (v[i + 1] - v[i])});
    const std::vector<double> slopes = slopes_of(chords);
    for (std::size_t i = 0; i < chords.size(); ++i) {
      const auto& [length, slope] = chords[i];
      const double begin = slopes[i], end = slopes[i + 1];
      cubics_.push_back({.slope = begin,
                         .square = (3 * slope - 2 * begin - end) / length,
                         .cube = (begin + end - 2 * slope) / (length * length)});
      if (!std::isfinite(cubics_.back().cube))
        throw Error(numbered("slip_velocities", i + 1), v[i + 1], "m/s", "farther from the one before");
    }
  }
}

double FrictionTable::largest(double pressure) const {
  const std::size_t n = grid_.slip_velocities.size(), curves = grid_.coefficients.size() / n;
  const auto largest_of = [&](std::size_t curve) {
    const double* mu = grid_.coefficients.data() + curve * n;
    return *std::max_element(mu, mu + n);
  };
  const Place<double> at = place(grid_.pressures, pressure);
  double all = 0;
  for (std::size_t k = at.node; k < curves; k += std::max(std::size_t{1}, grid_.pressures.size()))
    all = std::max(all, at.share > 0 ? (1 - at.share) * largest_of(k) + at.share * largest_of(k + 1) : largest_of(k));
  return all;
}

FrictionTable FrictionTable::at(double pressure, double temperature) const {
  std::vector<double> mu;
  for (const double v : grid_.slip_velocities) mu.push_back(coefficient(v, pressure, temperature));
  return {grid_.slip_velocities, std::move(mu)};
}

FrictionTable FrictionTable::sampled(const std::function<double(double)>& coefficient, double fastest,
                                     double accuracy) {
  require_between("fastest", fastest, "m/s", 1e-6, largest_velocity);
  require_positive("accuracy", accuracy, "-");
  constexpr int octaves = 20; // from a millionth of the fastest on
  Samples samples{coefficient};
  samples.add(0);
  for (int k = octaves; k >= 0; --k) samples.add(std::ldexp(fastest, -k));
  while (true) {
    Samples fine = refined(samples, accuracy);
    if (fine.v.size() == samples.v.size()) return {std::move(fine.v), std::move(fine.mu)};
    samples.v = std::move(fine.v), samples.mu = std::move(fine.mu);
  }
}

} // namespace microslip
