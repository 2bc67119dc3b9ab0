#include "hunting.hpp"

#include "radau.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

namespace {

/// Where a function of the speed changes from negative to positive [m/s], to `accuracy`.
template <class Function> double sign_change(double low, double high, double accuracy, Function function) {
  if (!(function(low) < 0 && function(high) > 0)) throw std::runtime_error("no change of stability between the speeds");
  while (high - low > accuracy) {
    const double middle = (low + high) / 2;
    (function(middle) < 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

} // namespace

LinearGrowth linear_growth(WheelsetParameters parameters, double speed) {
  parameters.speed = speed;
  Wheelset::State rate;
  Wheelset::Jacobian jacobian;
  Wheelset(parameters).rates({}, rate, jacobian);
  const auto values = eigenvalues(jacobian);
  const auto fastest = std::ranges::max_element(values, {}, [](const auto& s) { return s.real(); });
  return {fastest->real(), std::abs(fastest->imag())};
}

double critical_speed(const WheelsetParameters& parameters, double low, double high) {
  return sign_change(low, high, 1e-6, [&](double speed) { return linear_growth(parameters, speed).rate; });
}

History run(const WheelsetParameters& parameters, double displacement, double duration, double step) {
  Wheelset wheelset(parameters);
  Radau<Wheelset::states> integrator({1e-3, 1e-3, 1e-2, 1e-2, 1e-2});
  Wheelset::State z = {displacement};
  History out{.step = step, .states = {z}};
  const auto steps = std::lround(duration / step);
  out.states.reserve(static_cast<std::size_t>(steps) + 1);
  const auto before = std::chrono::steady_clock::now();
  for (long k = 0; k < steps; ++k) {
    integrator.advance(z, step,
                       [&](const auto& at, auto& rate, auto& jacobian) { wheelset.rates(at, rate, jacobian); });
    out.states.push_back(z);
  }
  out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  out.contact_seconds = wheelset.contact_seconds();
  out.contacts = wheelset.contacts();
  out.newton_iterations = integrator.iterations();
  return out;
}

std::vector<History::Peak> History::peaks() const {
  std::vector<Peak> found;
  for (std::size_t k = 1; k + 1 < states.size(); ++k) {
    const double before = states[k - 1][Wheelset::lateral], here = states[k][Wheelset::lateral],
                 after = states[k + 1][Wheelset::lateral];
    if ((here - before) * (after - here) > 0 || here == before) continue;
    const double slope = (after - before) / 2, curvature = after - 2 * here + before, shift = -slope / curvature;
    found.push_back({(static_cast<double>(k) + shift) * step, here + slope * shift / 2});
  }
  return found;
}

double History::amplitude(double duration) const {
  const auto count = std::min<std::size_t>(states.size(), static_cast<std::size_t>(duration / step));
  double largest = 0;
  for (std::size_t k = states.size() - count; k < states.size(); ++k)
    largest = std::max(largest, std::abs(states[k][Wheelset::lateral]));
  return largest;
}

double History::growth_rate(double from) const {
  double n = 0, sum_t = 0, sum_l = 0, sum_tt = 0, sum_tl = 0;
  for (const Peak& peak : peaks()) {
    if (peak.time < from) continue;
    const double l = std::log(std::abs(peak.value));
    n += 1, sum_t += peak.time, sum_l += l, sum_tt += peak.time * peak.time, sum_tl += peak.time * l;
  }
  return (n * sum_tl - sum_t * sum_l) / (n * sum_tt - sum_t * sum_t);
}

double critical_speed_of_runs(const WheelsetParameters& parameters) {
  const double linear = critical_speed(parameters);
  return sign_change(0.95 * linear, 1.05 * linear, 1e-3, [&](double speed) {
    WheelsetParameters at = parameters;
    at.speed = speed;
    return run(at, 1e-6, 3).growth_rate(1);
  });
}
