#include "profiled_wheelset.hpp"

#include <microslip/railway/profile/profile_preparation.hpp>

#include <chrono>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

constexpr double rail_distance = 1.5; // between the contacts, that cant deficiency is measured over [m]

constexpr std::array<std::pair<std::size_t, microslip::WheelsetVariable>, ProfiledWheelset::states> variables = {
    {{ProfiledWheelset::lateral, microslip::WheelsetVariable::lateral},
     {ProfiledWheelset::height, microslip::WheelsetVariable::vertical},
     {ProfiledWheelset::roll, microslip::WheelsetVariable::roll},
     {ProfiledWheelset::yaw, microslip::WheelsetVariable::yaw},
     {ProfiledWheelset::lateral_rate, microslip::WheelsetVariable::lateral_velocity},
     {ProfiledWheelset::height_rate, microslip::WheelsetVariable::vertical_velocity},
     {ProfiledWheelset::roll_rate, microslip::WheelsetVariable::roll_velocity},
     {ProfiledWheelset::yaw_rate, microslip::WheelsetVariable::yaw_velocity},
     {ProfiledWheelset::rotation, microslip::WheelsetVariable::pitch_velocity}}};

/// e of the axle of a wheelset turned by yaw and then by roll, times v.
double along_axle(double roll, double yaw, const microslip::Vec3<double>& v) {
  return -std::sin(yaw) * v.x + std::cos(yaw) * (std::cos(roll) * v.y + std::sin(roll) * v.z);
}

double sign(double x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}

} // namespace

microslip::Profile read_profile(const std::filesystem::path& file, microslip::ProfileRole role) {
  std::ifstream text(file);
  std::vector<microslip::ProfilePoint> points;
  bool inside = false;
  for (std::string line; std::getline(text, line);) {
    if (line.find("point.end") != std::string::npos) inside = false;
    if (double y = 0, z = 0; inside && std::sscanf(line.c_str(), "%lf %lf", &y, &z) == 2)
      points.push_back({1e-3 * y, -1e-3 * z});
    if (line.find("point.begin") != std::string::npos) inside = true;
  }
  if (points.empty()) throw std::runtime_error(file.string() + ": no points of a Simpack profile");
  return microslip::prepare_profile(role, points).profile;
}

microslip::WheelRailBodies bodies_from(const std::filesystem::path& profiles, double friction, double cant,
                                       double gauge) {
  const auto steel = microslip::Material::from_young(210e9, 0.28);
  return {.rail = read_profile(profiles / "60e1.prr", microslip::ProfileRole::rail),
          .wheel = read_profile(profiles / "s1002.prw", microslip::ProfileRole::wheel),
          .track = {.gauge = gauge, .rail_origin = {}, .cant = cant},
          .wheelset = {.nominal_radius = 0.46, .tape_circle = {}},
          .material = microslip::combine(steel, steel),
          .friction = {{0, friction}}};
}

ProfiledWheelset::ProfiledWheelset(const microslip::WheelRailBodies& bodies, const ProfiledParameters& parameters,
                                   const microslip::WheelRailMethod& method)
    : p_(parameters), contact_(bodies, method) {}

microslip::WheelsetState ProfiledWheelset::wheelset_state(const State& z) const {
  microslip::WheelsetState all;
  microslip::WheelState<double>& s = all.left;
  s.lateral = z[lateral], s.vertical = z[height], s.roll = z[roll], s.yaw = z[yaw];
  s.forward_velocity = p_.speed, s.lateral_velocity = z[lateral_rate], s.vertical_velocity = z[height_rate];
  s.roll_velocity = z[roll_rate], s.yaw_velocity = z[yaw_rate], s.pitch_velocity = z[rotation];
  s.curvature = p_.curvature;
  return all;
}

template <class Solve> void ProfiledWheelset::solve_contacts(const Solve& solve) {
  const auto before = std::chrono::steady_clock::now();
  solve();
  contact_seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  contacts_ += 2;
  if (found_.status != microslip::Status::ok && found_.status != microslip::Status::no_contact)
    throw std::runtime_error("the contacts are " + std::string(to_string(found_.status)) + ": " +
                             std::string(to_string(found_.reason)));
}

ProfiledWheelset::State ProfiledWheelset::standing(double displacement) {
  State z = {};
  z[lateral] = displacement, z[rotation] = 0;
  solve_contacts([&] {
    contact_.solve(wheelset_state(z), {.vertical = microslip::AxleLoad{p_.axle_load}, .axle_torque = 0.0}, found_);
  });
  z[height] = found_.vertical, z[roll] = found_.roll, z[rotation] = found_.pitch_velocity;
  return z;
}

microslip::WheelsetSolution ProfiledWheelset::contacts_in(const State& z) {
  return contact_.solve(wheelset_state(z));
}

ProfiledWheelset::State ProfiledWheelset::without_derivatives(const State& z) const {
  State rate = {};
  for (std::size_t k = 0; k < 4; ++k) rate[k] = z[lateral_rate + k];
  const auto &force = found_.force, &moment = found_.moment;
  const double unbalanced = p_.axle_load * p_.cant_deficiency / rail_distance * sign(p_.curvature);
  const double spin = p_.rolling_inertia * z[rotation];
  rate[lateral_rate] = (force.y - p_.lateral_stiffness * z[lateral] - unbalanced) / p_.mass;
  rate[height_rate] = (force.z - p_.axle_load) / p_.mass;
  rate[roll_rate] = (moment.x + spin * (z[yaw_rate] + p_.speed * p_.curvature)) / p_.roll_inertia;
  rate[yaw_rate] = (moment.z - spin * z[roll_rate] - p_.yaw_stiffness * (z[yaw] + p_.half_wheelbase * p_.curvature)) /
                   p_.roll_inertia;
  rate[rotation] = along_axle(z[roll], z[yaw], moment) / p_.rolling_inertia;
  return rate;
}

void ProfiledWheelset::rates(const State& z, State& rate) {
  solve_contacts([&] { contact_.solve(wheelset_state(z), {}, found_); });
  rate = without_derivatives(z);
}

void ProfiledWheelset::rates(const State& z, State& rate, Jacobian& jacobian) {
  solve_contacts([&] { contact_.differentiate(wheelset_state(z), {}, found_, derivatives_); });
  rate = without_derivatives(z);
  jacobian = {};
  for (std::size_t k = 0; k < 4; ++k) jacobian[k][lateral_rate + k] = 1;
  for (const auto& [column, variable] : variables) {
    const auto force = derivatives_.force(static_cast<std::size_t>(variable)),
               moment = derivatives_.moment(static_cast<std::size_t>(variable));
    jacobian[lateral_rate][column] = force.y / p_.mass;
    jacobian[height_rate][column] = force.z / p_.mass;
    jacobian[roll_rate][column] = moment.x / p_.roll_inertia;
    jacobian[yaw_rate][column] = moment.z / p_.roll_inertia;
    // The direction of the axle changes as well, but the moment about other axes is small.
    jacobian[rotation][column] = along_axle(z[roll], z[yaw], moment) / p_.rolling_inertia;
  }
  const double spin = p_.rolling_inertia / p_.roll_inertia;
  jacobian[lateral_rate][lateral] -= p_.lateral_stiffness / p_.mass;
  jacobian[roll_rate][yaw_rate] += spin * z[rotation];
  jacobian[roll_rate][rotation] += spin * (z[yaw_rate] + p_.speed * p_.curvature);
  jacobian[yaw_rate][roll_rate] -= spin * z[rotation];
  jacobian[yaw_rate][rotation] -= spin * z[roll_rate];
  jacobian[yaw_rate][yaw] -= p_.yaw_stiffness / p_.roll_inertia;
}
