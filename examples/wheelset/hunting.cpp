#include "hunting.hpp"

#include "integrate.hpp"
#include "sign_change.hpp"

#include <algorithm>
#include <cmath>

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

History<Wheelset::states> run(const WheelsetParameters& parameters, double displacement, double duration, double step) {
  Wheelset wheelset(parameters);
  Radau<Wheelset::states> integrator({1e-3, 1e-3, 1e-2, 1e-2, 1e-2});
  return integrate(wheelset, integrator, Wheelset::State{displacement}, duration, step, [](double) {});
}

double critical_speed_of_runs(const WheelsetParameters& parameters) {
  const double linear = critical_speed(parameters);
  return sign_change(0.95 * linear, 1.05 * linear, 1e-3, [&](double speed) {
    WheelsetParameters at = parameters;
    at.speed = speed;
    return run(at, 1e-6, 3).growth_rate(1);
  });
}
