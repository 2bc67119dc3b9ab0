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

namespace {

using Of = const Nip&;

bool always(Of) {
  return true;
}
bool has_cover1(Of nip) {
  return nip.body1.cover > 0;
}
bool has_cover2(Of nip) {
  return nip.body2.cover > 0;
}

constexpr NipQuantity quantities_of_nips[] = {
    {"nip/width", "m", "width of the nip", [](Of n) { return n.width; }, always},
    {"nip/indentation", "m", "indentation of both rollers", [](Of n) { return n.indentation; }, always},
    {"nip/traction", "N", "traction", [](Of n) { return n.traction; }, always},
    {"nip/traction_capacity", "N", "traction capacity", [](Of n) { return n.traction_capacity; }, always},
    {"nip/utilisation", "-", "traction over its capacity", [](Of n) { return n.utilisation; }, always},
    {"nip/hysteresis_power", "W", "power lost to hysteresis", [](Of n) { return n.hysteresis_power; }, always},
    {"nip/slip_power", "W", "power lost to slip", [](Of n) { return n.slip_power; }, always},
    {"nip/rolling_resistance", "N", "rolling resistance", [](Of n) { return n.rolling_resistance; }, always},
    {"nip/drive1", "N", "drive of body 1, torque over radius", [](Of n) { return n.body1.drive; }, always},
    {"nip/drive2", "N", "drive of body 2, torque over radius", [](Of n) { return n.body2.drive; }, always},
    {"nip/cover1", "m", "thickness of the cover of body 1", [](Of n) { return n.body1.cover; }, has_cover1},
    {"nip/strain1", "-", "strain of the cover of body 1", [](Of n) { return n.body1.strain; }, has_cover1},
    {"nip/cover2", "m", "thickness of the cover of body 2", [](Of n) { return n.body2.cover; }, has_cover2},
    {"nip/strain2", "-", "strain of the cover of body 2", [](Of n) { return n.body2.strain; }, has_cover2},
};

} // namespace

std::span<const NipQuantity> nip_quantities() {
  return quantities_of_nips;
}

std::vector<StoredNumber> nip_numbers(const NipResult& result) {
  std::vector<StoredNumber> all;
  for (const auto& [path, unit, description, value, applies] : quantities_of_nips)
    if (applies(result.nip))
      all.push_back({std::string(path), value(result.nip), unit.data(), std::string(description)});
  const auto add_ratio = [&](const std::optional<FreeRoller>& free, const char* path, const char* description) {
    if (free) all.push_back({path, free->speed_ratio, "-", description});
  };
  add_ratio(result.free1, "nip/speed_ratio1", "speed of body 1 over that of body 2, body 1 without torque");
  add_ratio(result.free2, "nip/speed_ratio2", "speed of body 2 over that of body 1, body 2 without torque");
  return all;
}

} // namespace microslip::cases
