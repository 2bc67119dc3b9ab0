#include "stability.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_linalg.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace {

/// Square matrix in rows, as GSL takes it.
struct Matrix {
  std::size_t size;
  std::vector<double> values;
  gsl_matrix_view view() { return gsl_matrix_view_array(values.data(), size, size); }
};

/// Derivatives of f by central differences, which are linear enough over 1e-6 m, rad, m/s: the table of contact
/// geometry has points every 1e-5 m.
Matrix jacobian(const DytsiVehicle& vehicle, State state) {
  const double step = 1e-6;
  const std::size_t size = state.size();
  Matrix result{size, std::vector<double>(size * size)};
  State after(size), before(size);
  for (std::size_t j = 0; j < size; ++j) {
    const double value = state[j];
    state[j] = value + step;
    vehicle.derivative(state, after);
    state[j] = value - step;
    vehicle.derivative(state, before);
    state[j] = value;
    for (std::size_t i = 0; i < size; ++i) result.values[i * size + j] = (after[i] - before[i]) / (2 * step);
  }
  return result;
}

State equilibrium(const DytsiVehicle& vehicle) {
  const std::size_t size = vehicle.size();
  State state(size, 0.0), rate(size);
  const std::unique_ptr<gsl_permutation, void (*)(gsl_permutation*)> order(gsl_permutation_alloc(size),
                                                                           gsl_permutation_free);
  for (int step = 0; step < 10; ++step) {
    vehicle.derivative(state, rate);
    if (std::ranges::all_of(rate, [](double value) { return std::abs(value) < 1e-4; })) return state;
    Matrix matrix = jacobian(vehicle, state);
    gsl_matrix_view view = matrix.view();
    gsl_vector_view change = gsl_vector_view_array(rate.data(), size);
    int sign;
    gsl_linalg_LU_decomp(&view.matrix, order.get(), &sign);
    gsl_linalg_LU_svx(&view.matrix, order.get(), &change.vector);
    for (std::size_t i = 0; i < size; ++i) state[i] -= rate[i];
  }
  throw std::runtime_error("the equilibrium of straight running is not found");
}

/// Runge and Kutta's classical method of fourth order.
class Simulation {
public:
  explicit Simulation(const DytsiVehicle& vehicle)
      : vehicle_(vehicle), rates_(4, State(vehicle.size())), at_(vehicle.size()) {}

  /// Simulates for a time [s] and returns the largest lateral displacement of the first wheelset [m] meanwhile.
  double run(State& state, double time) {
    double amplitude = 0;
    for (long k = std::lround(time / step_); k > 0; --k) {
      step(state);
      amplitude = std::max(amplitude, std::abs(state[vehicle_.first_wheelset()]));
    }
    return amplitude;
  }

private:
  void step(State& state) {
    const double half = step_ / 2;
    vehicle_.derivative(state, rates_[0]);
    vehicle_.derivative(moved(state, rates_[0], half), rates_[1]);
    vehicle_.derivative(moved(state, rates_[1], half), rates_[2]);
    vehicle_.derivative(moved(state, rates_[2], step_), rates_[3]);
    for (std::size_t i = 0; i < state.size(); ++i)
      state[i] += step_ / 6 * (rates_[0][i] + 2 * (rates_[1][i] + rates_[2][i]) + rates_[3][i]);
  }

  const State& moved(const State& state, const State& rate, double time) {
    for (std::size_t i = 0; i < state.size(); ++i) at_[i] = state[i] + time * rate[i];
    return at_;
  }

  static constexpr double step_ = 1e-3;
  const DytsiVehicle& vehicle_;
  std::vector<State> rates_;
  State at_;
};

constexpr double observed = 2;       // time over which an amplitude is taken [s]
constexpr double disturbance = 8e-3; // to begin with [m]: wheels touch their flanges

/// Limit cycles at falling speeds, with the motion that each has left.
class CycleSearch {
public:
  explicit CycleSearch(DytsiVehicle& vehicle) : vehicle_(vehicle), simulation_(vehicle) {}

  /// Simulates for a time [s] at a speed [m/s] and returns whether the motion has not died; if so, keeps it.
  bool lives(double speed, State& state, double time) {
    vehicle_.set_speed(speed);
    double amplitude = 0;
    for (double passed = 0; passed < time; passed += observed) {
      amplitude = simulation_.run(state, observed);
      if (amplitude < least_amplitude) break;
    }
    amplitudes_[speed] = amplitude;
    if (amplitude >= least_amplitude) living_[speed] = state;
    return amplitude >= least_amplitude;
  }

  /// Goes on at the lowest speed and forgets its motion if that dies.
  bool lives_on(double time) {
    const double speed = lowest_speed();
    State state = lowest_state();
    if (lives(speed, state, time)) return true;
    living_.erase(speed);
    return false;
  }

  double lowest_speed() const { return lowest().first; }
  const State& lowest_state() const { return lowest().second; }

  std::vector<LimitCycle> cycles() const {
    std::vector<LimitCycle> result;
    for (const auto& [speed, amplitude] : amplitudes_) result.push_back({speed, amplitude});
    return result;
  }

private:
  const std::pair<const double, State>& lowest() const {
    if (living_.empty()) throw std::runtime_error("no limit cycle lives on");
    return *living_.begin();
  }

  DytsiVehicle& vehicle_;
  Simulation simulation_;
  std::map<double, State> living_;
  std::map<double, double> amplitudes_;
};

} // namespace

Mode hunting_mode(DytsiVehicle& vehicle, double speed) {
  vehicle.set_speed(speed);
  Matrix matrix = jacobian(vehicle, equilibrium(vehicle));
  gsl_matrix_view view = matrix.view();
  const std::unique_ptr<gsl_vector_complex, void (*)(gsl_vector_complex*)> values(gsl_vector_complex_alloc(matrix.size),
                                                                                  gsl_vector_complex_free);
  const std::unique_ptr<gsl_eigen_nonsymm_workspace, void (*)(gsl_eigen_nonsymm_workspace*)> workspace(
      gsl_eigen_nonsymm_alloc(matrix.size), gsl_eigen_nonsymm_free);
  gsl_eigen_nonsymm_params(0, 1, workspace.get()); // balanced: states are displacements and velocities
  gsl_eigen_nonsymm(&view.matrix, values.get(), workspace.get());
  Mode result{-HUGE_VAL, 0};
  for (std::size_t k = 0; k < matrix.size; ++k) {
    const gsl_complex value = gsl_vector_complex_get(values.get(), k);
    const Mode mode{GSL_REAL(value), GSL_IMAG(value) / (2 * std::numbers::pi)};
    if (mode.frequency > 1 && mode.frequency < 7 && mode.growth > result.growth) result = mode;
  }
  if (result.frequency == 0) throw std::runtime_error("no oscillation between 1 and 7 Hz");
  return result;
}

LinearCriticalSpeed linear_critical_speed(DytsiVehicle& vehicle, double low, double high) {
  const auto growth = [&](double speed) { return hunting_mode(vehicle, speed).growth; };
  const double least = growth(low), largest = growth(high);
  if (least > 0 || largest < 0)
    throw std::runtime_error("the linear critical speed does not lie within the speeds given");
  const auto close = [](double one, double other) { return std::abs(one - other) < 1e-3; };
  std::uintmax_t calls = 50;
  const auto [below, above] = boost::math::tools::toms748_solve(growth, low, high, least, largest, close, calls);
  const double speed = (below + above) / 2;
  return {speed, hunting_mode(vehicle, speed).frequency};
}

std::vector<LimitCycle> limit_cycles(DytsiVehicle& vehicle, double highest_speed) {
  CycleSearch search(vehicle);
  State state = vehicle.displaced(disturbance);
  double low = highest_speed;
  for (; search.lives(low, state, 6); low -= 5) {
  }
  for (double speed = search.lowest_speed(); !search.lives_on(20); speed = search.lowest_speed()) low = speed;
  while (search.lowest_speed() - low > 0.1) {
    const double middle = (low + search.lowest_speed()) / 2;
    state = search.lowest_state();
    if (!search.lives(middle, state, 20)) low = middle;
  }
  return search.cycles();
}
