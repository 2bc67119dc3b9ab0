#include "compat/contact/damping.hpp"

#include <algorithm>

namespace microslip::contact_program {
namespace {

/// [s]
double time_step(const Case& c, double step) {
  constexpr double least_speed = 1e-13; // [m/s]
  return c.digits.rolls() ? step / std::max(least_speed, c.rolling->veloc) : 1;
}

} // namespace

void ForceHistory::begin(Continuation from) {
  if (from != Continuation::repeated) before_ = carried_force(from, last_);
}

std::optional<Vec3<double>> carried_force(Continuation from, const std::optional<Vec3<double>>& last) {
  if (from == Continuation::nothing || !last) return {};
  if (from == Continuation::previous_pressure) return Vec3<double>{0, 0, last->z};
  return last;
}

std::optional<Vec3<double>> damping_force(const Case& c, double step, const Vec3<double>& force,
                                          const std::optional<Vec3<double>>& before) {
  if (!c.damping) return {};
  if (!before) return Vec3<double>{};
  const auto& [normal, tangential, normal_limit, tangential_limit] = *c.damping;
  const Vec3<double> rate = (1 / time_step(c, step)) * (force - *before);
  const auto limited = [](double value, double limit) { return std::clamp(value, -limit, limit); };
  return Vec3<double>{tangential * limited(rate.x, tangential_limit), tangential * limited(rate.y, tangential_limit),
                      normal * limited(rate.z, normal_limit)};
}

} // namespace microslip::contact_program
