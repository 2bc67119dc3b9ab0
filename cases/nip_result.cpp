#include "cases/nip_result.hpp"

namespace microslip::cases {

RollerRadii roller_radii(const io::RollingCase& input) {
  return {input.body1.rolling_radius, input.body2.rolling_radius};
}

bool has_nip(const io::RollingCase& input, const ContactSolution& solution) {
  return input.problem.layered && input.problem.motion.kind == ContactMotion::steady &&
         solution.report.status == Status::ok && solution.totals.peak_pressure > 0;
}

NipResult nip_result(const io::RollingCase& input, const ContactSolution& solution, Solver& solver,
                     const Progress& progress) {
  const RollerRadii radii = roller_radii(input);
  NipAnalysis analysis;
  NipResult result{.nip = analysis.find(input.problem, solution, radii, progress)};
  if (input.problem.load.given != NormalLoad::Given::force) return result;
  const auto without_torque = [&](Roller driven) -> std::optional<FreeRoller> {
    FreeRoller found = analysis.roll_without_torque(solver, input.problem, radii, driven, progress);
    return found.solution.report.status == Status::ok ? std::optional(std::move(found)) : std::nullopt;
  };
  result.free1 = without_torque(Roller::body1);
  result.free2 = without_torque(Roller::body2);
  return result;
}

std::vector<StoredNumber> nip_quantities(const Nip& nip) {
  std::vector<StoredNumber> all = {
      {"nip/width", nip.width, "m", "width of the nip"},
      {"nip/indentation", nip.indentation, "m", "indentation of both rollers"},
      {"nip/traction", nip.traction, "N", "traction"},
      {"nip/traction_capacity", nip.traction_capacity, "N", "traction capacity"},
      {"nip/utilisation", nip.utilisation, "-", "traction over its capacity"},
      {"nip/hysteresis_power", nip.hysteresis_power, "W", "power lost to hysteresis"},
      {"nip/slip_power", nip.slip_power, "W", "power lost to slip"},
      {"nip/rolling_resistance", nip.rolling_resistance, "N", "rolling resistance"},
      {"nip/drive1", nip.body1.drive, "N", "drive of body 1, torque over radius"},
      {"nip/drive2", nip.body2.drive, "N", "drive of body 2, torque over radius"},
  };
  const auto add_cover = [&](const RollerState& roller, const std::string& number) {
    if (roller.cover == 0) return;
    all.push_back({"nip/cover" + number, roller.cover, "m", "thickness of the cover of body " + number});
    all.push_back({"nip/strain" + number, roller.strain, "-", "strain of the cover of body " + number});
  };
  add_cover(nip.body1, "1");
  add_cover(nip.body2, "2");
  return all;
}

std::vector<StoredNumber> nip_quantities(const NipResult& result) {
  std::vector<StoredNumber> all = nip_quantities(result.nip);
  if (result.free1)
    all.push_back({"nip/speed_ratio1", result.free1->speed_ratio, "-",
                   "speed of body 1 over that of body 2, body 1 without torque"});
  if (result.free2)
    all.push_back({"nip/speed_ratio2", result.free2->speed_ratio, "-",
                   "speed of body 2 over that of body 1, body 2 without torque"});
  return all;
}

} // namespace microslip::cases
