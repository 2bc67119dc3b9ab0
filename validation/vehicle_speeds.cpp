#include "validation/vehicle_speeds.hpp"

#include "io/creep_table_file.hpp"
#include "microslip/table/creep_force_table.hpp"
#include "runs.hpp"

#include <chrono>
#include <ctime>

namespace microslip::validation {
namespace {

using Kind = VehicleParameters::Kind;

VehicleSpeed speed_of(const char* name, Kind kind, const WheelRailMethod& method, int threads) {
  constexpr double warm_up = 0.5, duration = 1.5; // [s]
  VehicleParameters parameters;
  parameters.kind = kind;
  ::Run run(parameters, measured_profiles(MICROSLIP_EXAMPLES "/profiles", parameters),
            std::make_shared<TrackLine>(std::vector<TrackLine::Knot>{{0, 0, 0}}, std::make_shared<Irregularity>(1)),
            {.method = method, .threads = threads});
  run.integrator.step_to(warm_up);
  run.integrator.clear_counts(), run.vehicle.contacts().clear_counts();
  const std::clock_t before = std::clock();
  const auto begin = std::chrono::steady_clock::now();
  run.integrator.step_to(warm_up + duration);
  const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(),
               seconds = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
  const auto& contacts = run.vehicle.contacts().counts();
  return {.name = name,
          .wheels = 2 * static_cast<int>(run.vehicle.wheelsets()),
          .threads = threads,
          .real_time = duration / seconds,
          .real_time_elapsed = duration / elapsed,
          .contact_share = contacts.seconds / seconds,
          .seconds_a_wheel = contacts.seconds / static_cast<double>(contacts.wheels),
          .evaluations_a_step = run.integrator.counts().iterations_a_step()};
}

} // namespace

std::vector<VehicleSpeed> vehicle_speeds() {
  const WheelRailMethod fastsim2;
  const WheelRailMethod table{
      .theory = Theory::table,
      .table = std::make_shared<const CreepForceTable>(io::read_creep_table(io::shipped_creep_table()), 0.28)};
  return {speed_of("wheelset, fastsim2", Kind::wheelset, fastsim2, 1),
          speed_of("bogie, fastsim2", Kind::bogie, fastsim2, 1), speed_of("car, fastsim2", Kind::car, fastsim2, 1),
          speed_of("car, table", Kind::car, table, 1), speed_of("car, fastsim2, two threads", Kind::car, fastsim2, 2)};
}

} // namespace microslip::validation
