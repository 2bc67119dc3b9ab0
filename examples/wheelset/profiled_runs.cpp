#include "profiled_runs.hpp"

#include "integrate.hpp"
#include "sign_change.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

using Integrator = Radau<ProfiledWheelset::states>;

/// Below these changes nothing is to be seen: 1e-9 m of y, 1e-11 m of the height.
Integrator integrator() {
  return Integrator({1e-3, 1e-5, 1e-5, 1e-3, 1e-2, 1e-3, 1e-3, 1e-2, 1e-2}, 1e-6);
}

} // namespace

SmallMotion small_motion(const microslip::WheelRailBodies& bodies, ProfiledParameters parameters, double speed) {
  parameters.speed = speed;
  ProfiledWheelset wheelset(bodies, parameters);
  ProfiledWheelset::State rate;
  ProfiledWheelset::Jacobian jacobian;
  wheelset.rates(wheelset.standing(0), rate, jacobian);
  constexpr double slow = 2 * std::numbers::pi * 50; // the wheelset on the stiffness of its contacts swings faster
  const auto values = eigenvalues(jacobian);
  const auto fastest =
      std::ranges::max_element(values, {}, [](const auto& s) { return std::abs(s.imag()) < slow ? s.real() : -1e300; });
  return {fastest->real(), std::abs(fastest->imag())};
}

double critical_speed(const microslip::WheelRailBodies& bodies, const ProfiledParameters& parameters, double low,
                      double high) {
  return sign_change(low, high, 1e-3, [&](double speed) { return small_motion(bodies, parameters, speed).rate; });
}

ProfiledHistory run(const microslip::WheelRailBodies& bodies, const ProfiledParameters& parameters, double displacement,
                    double duration, double step) {
  ProfiledWheelset wheelset(bodies, parameters);
  return run(wheelset, wheelset.standing(displacement), duration, step);
}

ProfiledHistory run(ProfiledWheelset& wheelset, const ProfiledWheelset::State& start, double duration, double step) {
  Integrator steps = integrator();
  return integrate(wheelset, steps, start, duration, step, [](double) {});
}

std::vector<double> amplitudes(const microslip::WheelRailBodies& bodies, ProfiledParameters parameters, double start,
                               std::span<const double> speeds, double duration) {
  constexpr double least = 1e-4, step = 1e-3;
  ProfiledWheelset wheelset(bodies, parameters);
  ProfiledWheelset::State z = {};
  std::vector<double> found;
  for (const double speed : speeds) {
    z[ProfiledWheelset::rotation] *= speed / parameters.speed;
    parameters.speed = speed;
    wheelset.set(parameters);
    const double left = found.empty() ? 0 : found.back();
    if (left < least) z = wheelset.standing(found.empty() ? start : least);
    Integrator steps = integrator();
    const auto history = integrate(wheelset, steps, z, duration, step, [](double) {});
    z = history.states.back();
    found.push_back(history.amplitude(1));
  }
  return found;
}

ProfiledHistory enter_curve(const microslip::WheelRailBodies& bodies, const ProfiledParameters& parameters,
                            double duration, double step) {
  ProfiledParameters now = parameters;
  now.curvature = now.cant_deficiency = 0;
  ProfiledWheelset wheelset(bodies, now);
  Integrator steps = integrator();
  return integrate(wheelset, steps, wheelset.standing(0), duration, step, [&](double time) {
    const double part = std::clamp(6 * (time + step) / duration - 1, 0.0, 1.0);
    now.curvature = part * parameters.curvature, now.cant_deficiency = part * parameters.cant_deficiency;
    wheelset.set(now);
  });
}

ProfiledParameters in_curve(double radius, double cant_deficiency, double cant) {
  ProfiledParameters p;
  p.curvature = 1 / radius, p.cant_deficiency = cant_deficiency;
  p.speed = std::sqrt(radius * 9.81 * (cant + cant_deficiency) / 1.5);
  return p;
}

double flange_ratio(const microslip::WheelRailSolution& wheel, double side) {
  return -side * wheel.force.y / wheel.force.z;
}
