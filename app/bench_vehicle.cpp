#include "app/exit_code.hpp"
#include "app/json_document.hpp"
#include "app/machine.hpp"
#include "app/studies.hpp"
#include "validation/vehicle_speeds.hpp"

#include <fmt/format.h>

namespace microslip::app {

int bench_vehicle(bool json) {
  const auto speeds = validation::vehicle_speeds();
  if (json) {
    io::Json document = json_document("bench");
    document["machine"] = machine();
    document["rows"] = io::Json::array();
    for (const auto& row : speeds)
      document["rows"].push_back({{"name", row.name},
                                  {"wheels", row.wheels},
                                  {"threads", row.threads},
                                  {"real_time", row.real_time},
                                  {"real_time_elapsed", row.real_time_elapsed},
                                  {"contact_share", row.contact_share},
                                  {"seconds_a_wheel", row.seconds_a_wheel},
                                  {"evaluations_a_step", row.evaluations_a_step}});
    print_json(document);
    return ExitCode::done;
  }
  fmt::print("{}\n\n{:<28}{:>8}{:>17}{:>12}{:>12}{:>15}{:>14}\n{:<28}{:>8}{:>17}{:>12}{:>12}{:>15}{:>14}\n", machine(),
             "steps of 1 ms", "wheels", "times real time", "of elapsed", "share of", "processor time", "evaluations",
             "", "", "of the processor", "time", "contacts", "a wheel [us]", "a step");
  for (const auto& row : speeds)
    fmt::print("{:<28}{:>8}{:>17.2f}{:>12.2f}{:>11.0f}%{:>15.1f}{:>14.2f}\n", row.name, row.wheels, row.real_time,
               row.real_time_elapsed, 100 * row.contact_share, 1e6 * row.seconds_a_wheel, row.evaluations_a_step);
  return ExitCode::done;
}

} // namespace microslip::app
