/// Critical speeds of DYTSI's bogies with a creep law:
///   critical_speed INPUT.xml LAW [SHEAR_MODULUS [CYCLES.csv]]
/// prints the linear critical speed and, with a file for the limit cycles (speed [m/s], amplitude [m]), the nonlinear
/// one; the slopes of the law's forces in straight running over those of linear theory, with the linear critical speed
/// of a linear law that has them; and the time of a call. LAW is one of creep_law.hpp, or `dytsi`: DYTSI's law,
/// untouched. SHEAR_MODULUS [Pa] replaces DYTSI's; 0: does not. To be run in the folder from which INPUT.xml names its
/// table of contact geometry.

#include "creep_law.hpp"
#include "stability.hpp"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>

namespace {

const double dytsi_shear_modulus = 2.1e11 / (2 * (1 - 0.27)); // E / (2 (1 - nu)), as DYTSI has it [Pa]

/// Wheel that runs straight in the middle of the track: its spin is that of the contact's inclination.
WheelContact straight_running(double shear_modulus) {
  return {5.9519e-3, 6.6526e-3, 4.1246, 3.5631, 1.3703, shear_modulus, 0.15, 66661, 0, 0, 0.0335};
}

/// Time of a call for a wheel that hunts [us].
double call_time(CreepLaw& law, double shear_modulus) {
  WheelContact contact = straight_running(shear_modulus);
  contact.longitudinal = 3e-4;
  contact.lateral = 5e-4;
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  long calls = 0;
  while (Clock::now() - start < std::chrono::milliseconds(300))
    for (int k = 0; k < 10; ++k, ++calls) law.forces(contact);
  return std::chrono::duration<double, std::micro>(Clock::now() - start).count() / static_cast<double>(calls);
}

/// Derivative of a force by a creepage in straight running, by a central difference.
double slope(CreepLaw& law, const WheelContact& contact, double WheelContact::*creepage, double CreepForces::*force,
             double step) {
  WheelContact more = contact, less = contact;
  more.*creepage += step;
  less.*creepage -= step;
  return (law.forces(more).*force - law.forces(less).*force) / (2 * step);
}

/// Derivatives of the forces in straight running over those of linear theory: of the longitudinal force by the
/// longitudinal creepage, of the lateral one by the lateral creepage and by the spin.
struct Slopes {
  double longitudinal, lateral, spin;
};

Slopes slopes(CreepLaw& law, double shear_modulus) {
  const WheelContact contact = straight_running(shear_modulus);
  const double stiffness = -shear_modulus * contact.a * contact.b, c = std::sqrt(contact.a * contact.b);
  const double fx = slope(law, contact, &WheelContact::longitudinal, &CreepForces::longitudinal, 1e-6);
  const double fy = slope(law, contact, &WheelContact::lateral, &CreepForces::lateral, 1e-6);
  const double fy_spin = slope(law, contact, &WheelContact::spin, &CreepForces::lateral, 1e-4);
  return {fx / (stiffness * contact.c11), fy / (stiffness * contact.c22), fy_spin / (stiffness * contact.c23 * c)};
}

/// Linear theory with other slopes, to see what of a law decides where small motions grow.
class LinearLaw : public CreepLaw {
public:
  explicit LinearLaw(const Slopes& slopes) : slopes_(slopes) {}

  CreepForces forces(const WheelContact& contact) override {
    const double stiffness = -contact.shear_modulus * contact.a * contact.b, c = std::sqrt(contact.a * contact.b);
    return {stiffness * slopes_.longitudinal * contact.c11 * contact.longitudinal,
            stiffness *
                (slopes_.lateral * contact.c22 * contact.lateral + slopes_.spin * contact.c23 * c * contact.spin)};
  }

private:
  Slopes slopes_;
};

/// Prints the slopes of a law, the linear critical speed that they alone make, and the time of a call.
void print_law(DytsiVehicle& vehicle, const std::string& name, double shear_modulus) {
  const std::unique_ptr<CreepLaw> law = make_creep_law(name);
  const double modulus = shear_modulus > 0 ? shear_modulus : dytsi_shear_modulus;
  const Slopes found = slopes(*law, modulus);
  use_creep_law(std::make_unique<LinearLaw>(found), modulus);
  std::printf(", %.3f by its slopes %.3f %.3f %.3f, %.2f us a call", linear_critical_speed(vehicle, 40, 180).speed,
              found.longitudinal, found.lateral, found.spin, call_time(*law, modulus));
}

void write_cycles(const std::vector<LimitCycle>& cycles, double linear_critical_speed, const std::string& file) {
  std::ofstream out(file + ".part");
  out << "# linear critical speed " << linear_critical_speed << "\nspeed,amplitude\n";
  for (const LimitCycle& cycle : cycles) out << cycle.speed << ',' << cycle.amplitude << '\n';
  out.close();
  if (!out || std::rename((file + ".part").c_str(), file.c_str()) != 0)
    throw std::runtime_error(file + ": cannot be written");
}

/// Lowest speed at which a limit cycle lives on [m/s].
double lowest_speed(const std::vector<LimitCycle>& cycles) {
  for (const LimitCycle& cycle : cycles)
    if (cycle.lives()) return cycle.speed;
  throw std::runtime_error("no limit cycle");
}

void run(const std::string& input, const std::string& law, double shear_modulus, const char* cycles_file) {
  DytsiVehicle vehicle(input);
  if (law != "dytsi") use_creep_law(make_creep_law(law), shear_modulus);
  const LinearCriticalSpeed linear = linear_critical_speed(vehicle, 40, 180);
  std::printf("%s: linear critical speed %.3f m/s at %.3f Hz", law.c_str(), linear.speed, linear.frequency);
  if (cycles_file != nullptr) {
    const std::vector<LimitCycle> cycles = limit_cycles(vehicle, 110);
    write_cycles(cycles, linear.speed, cycles_file);
    std::printf(", nonlinear %.1f m/s", lowest_speed(cycles));
  }
  if (law != "dytsi") print_law(vehicle, law, shear_modulus);
  std::printf("\n");
}

} // namespace

int main(int count, char** arguments) {
  if (count < 3 || count > 5) {
    std::fprintf(stderr, "critical_speed INPUT.xml LAW [SHEAR_MODULUS [CYCLES.csv]]\n");
    return 2;
  }
  try {
    run(arguments[1], arguments[2], count > 3 ? std::stod(arguments[3]) : 0, count > 4 ? arguments[4] : nullptr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "critical_speed: %s\n", error.what());
    return 1;
  }
}
