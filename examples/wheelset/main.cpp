// Hunting of a wheelset: below its critical speed a disturbance dies out, above it grows until the flanges stop it.
//
//   wheelset [FOLDER]     also writes FOLDER/runs.csv and FOLDER/amplitudes.csv, which plot.py draws

#include "hunting.hpp"
#include "table.hpp"

#include <cstdio>
#include <exception>
#include <filesystem>

namespace {

WheelsetParameters at_speed(double speed) {
  WheelsetParameters parameters;
  parameters.speed = speed;
  return parameters;
}

void print_growth(double critical) {
  std::printf("\nSmall disturbances: growth rate [1/s] by eigenvalues and in the nonlinear run\n");
  std::printf("  speed [m/s]  over critical  eigenvalues      run  frequency [Hz]\n");
  for (const double ratio : {0.5, 0.8, 0.95, 1.05, 1.2}) {
    const auto [rate, frequency] = linear_growth({}, ratio * critical);
    std::printf("  %11.2f  %13.2f  %11.4f %8.4f  %14.2f\n", ratio * critical, ratio, rate,
                run(at_speed(ratio * critical), 1e-6, 3).growth_rate(1), frequency / 6.283185307);
  }
}

struct Pair {
  History<Wheelset::states> below, above;
};

/// A run at 0.9 and one at 1.1 of the critical speed.
Pair run_pair(double critical) {
  return {run(at_speed(0.9 * critical), 4e-3, 10), run(at_speed(1.1 * critical), 1e-4, 10)};
}

void print_pair(const Pair& pair, double critical) {
  std::printf("\nFrom 4 mm at %.1f m/s after 10 s: %.2g mm. From 0.1 mm at %.1f m/s after 10 s: %.3f mm.\n",
              0.9 * critical, 1e3 * pair.below.amplitude(1), 1.1 * critical, 1e3 * pair.above.amplitude(1));
  for (const auto* one : {&pair.below, &pair.above})
    std::printf("%s: %.1f ms per simulated second, %.0f %% of it the contact law (%.2f us a contact), %.2f Newton "
                "steps and %.2f Jacobians a step of 1 ms\n",
                one == &pair.below ? "Below" : "Above", one->seconds / 10 * 1e3,
                100 * one->contact_seconds / one->seconds,
                one->contact_seconds / static_cast<double>(one->contacts) * 1e6,
                static_cast<double>(one->newton_iterations) / 10000, static_cast<double>(one->jacobians) / 10000);
}

void write_pair(const std::filesystem::path& folder, const Pair& pair) {
  Table table(folder / "runs.csv");
  std::fprintf(table.file(), "time [s],y below [m],psi below [rad],y above [m],psi above [rad]\n");
  for (std::size_t k = 0; k < pair.below.states.size(); k += 5) {
    const Wheelset::State &below = pair.below.states[k], &above = pair.above.states[k];
    std::fprintf(table.file(), "%.4f,%.6e,%.6e,%.6e,%.6e\n", static_cast<double>(k) * pair.below.step,
                 below[Wheelset::lateral], below[Wheelset::yaw], above[Wheelset::lateral], above[Wheelset::yaw]);
  }
  table.finish();
}

/// What is left of a small and of a large disturbance after 15 s.
void write_amplitudes(const std::filesystem::path& folder, double critical) {
  Table table(folder / "amplitudes.csv");
  std::fprintf(table.file(), "speed over critical speed [-],from 0.1 mm [m],from 7 mm [m]\n");
  for (int percent = 70; percent <= 130; percent += 3) {
    const WheelsetParameters parameters = at_speed(percent / 100.0 * critical);
    std::fprintf(table.file(), "%.2f,%.6e,%.6e\n", percent / 100.0, run(parameters, 1e-4, 15).amplitude(1),
                 run(parameters, 7e-3, 15).amplitude(1));
  }
  table.finish();
}

} // namespace

int main(int count, char** arguments) {
  try {
    const double critical = critical_speed({}), of_runs = critical_speed_of_runs({});
    std::printf("Critical speed: %.3f m/s by eigenvalues, %.3f m/s by nonlinear runs\n", critical, of_runs);
    print_growth(critical);
    const Pair pair = run_pair(critical);
    print_pair(pair, critical);
    if (count > 1) {
      write_pair(arguments[1], pair);
      write_amplitudes(arguments[1], critical);
    }
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "wheelset: %s\n", error.what());
    return 1;
  }
}
