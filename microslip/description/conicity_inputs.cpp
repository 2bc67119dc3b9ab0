#include "microslip/description/input_lines.hpp"
#include "microslip/railway/geometry/conicity.hpp"
#include "microslip/railway/geometry/track.hpp"
#include "microslip/railway/geometry/wheelset.hpp"

namespace microslip::description {
namespace {

constexpr double gauges[] = {Track{}.gauge};
constexpr double amplitudes[] = {1e-3, 7e-3, 1e-4};

/// Input of cases of wheels, with a default.
Input of_wheels(std::string_view section, std::string_view key, std::optional<double> missing) {
  Input input = *wheel_inputs().find(section, key);
  input.section = "", input.missing = missing, input.is_needed = false;
  return input;
}

std::vector<Input> all_inputs() {
  constexpr Wheelset wheelset;
  Input gauge = of_wheels("track", "gauge", {});
  gauge.kind = InputKind::numbers, gauge.missing_numbers = gauges;
  gauge.text = "distance of the gauge points of both rails; several make a map";
  return {
      gauge,
      of_wheels("track", "gauge_height", Track{}.gauge_height),
      of_wheels("track", "cant", Track{}.cant),
      of_wheels("wheelset", "nominal_radius", wheelset.nominal_radius),
      of_wheels("wheelset", "tape_circle", {}),
      of_wheels("wheelset", "flange_back_distance", wheelset.flange_back_distance),
      of_wheels("wheelset", "flange_back_position", wheelset.flange_back_position),
      number("contact_distance", "m", positive, WheelsetBase{}.contact_distance,
             "distance e of the contacts of both wheels"),
      word("roll", roll_rules, "equilibrium",
           "roll of the wheelset: so that both wheels touch, or none as in EN 15302"),
      numbers("amplitudes", "m", positive, amplitudes,
              "first and last amplitude of the lateral displacement, and their step"),
      number("curve_radius", "m", positive, "radius of a curve, for the radial steering index at the last amplitude"),
  };
}

} // namespace

const InputTable& conicity_inputs() {
  static const InputTable table(all_inputs(), {});
  return table;
}

} // namespace microslip::description
