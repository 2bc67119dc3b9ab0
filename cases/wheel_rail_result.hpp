#pragma once

#include "io/json_result.hpp"
#include "io/result_writer.hpp"
#include "io/wheel_rail_case.hpp"
#include "microslip/interior/layered_interior.hpp"
#include "microslip/progress.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace microslip::cases {

/// All that `microslip solve` computes of a wheel on a rail.
struct WheelRailResult {
  std::vector<WheelRailSolution> solutions;         ///< of each state
  std::vector<std::vector<InteriorState>> interior; ///< of each patch, of all states; empty without points
  std::vector<LayeredPeaks> peaks;                  ///< of each patch of a single state, where the bodies have layers
  Status status = Status::ok;                       ///< the first one that is not ok
  std::string reason;                ///< of it, with the number of states it concerns; empty if all are ok
  std::vector<std::string> warnings; ///< of the profiles, and of results that are not to be trusted
};

/// Kind of such a case's result files.
constexpr const char* kind_of(const io::WheelRailCase&) {
  return "wheel_rail";
}

/// Solves all states. `progress` is called after each, and often within the exact theory and sums inside the bodies.
/// Throws Stopped if it returns false.
WheelRailResult solve_case(const io::WheelRailCase& input, const Progress& progress = {});
/// Method of the case, with fields where its result has them.
WheelRailMethod solving_method(const io::WheelRailCase& input);
/// Solves a case by a solver with this method for the case's bodies, which may have solved other states before.
WheelRailResult solve_case(const io::WheelRailCase& input, WheelRail& solver, const Progress& progress = {});

/// Result of a wheelset.
struct WheelsetResult {
  std::vector<WheelsetSolution> solutions;
  Status status = Status::ok;
  std::string reason;
  std::vector<std::string> warnings;
};
constexpr const char* kind_of(const io::WheelsetCase&) {
  return "wheelset";
}
WheelsetResult solve_case(const io::WheelsetCase& input, const Progress& progress = {});

/// Writes inputs, states, what is found of the wheel and of each patch, profiles, fields, stresses inside.
void write_result(const io::WheelRailCase& input, const WheelRailResult& result, io::ResultWriter& file);
/// Writes it as HDF5. Error if that is impossible.
void write_result(const io::WheelRailCase& input, const WheelRailResult& result, const io::Provenance& provenance,
                  const std::filesystem::path& path);

/// Writes a wheelset's result: `wheelset/`, and `left/` and `right/` with the groups of a wheel.
void write_result(const io::WheelsetCase& input, const WheelsetResult& result, io::ResultWriter& file);
void write_result(const io::WheelsetCase& input, const WheelsetResult& result, const io::Provenance& provenance,
                  const std::filesystem::path& path);

/// Result as a JSON object: what JsonResult makes of it, then `status`, `warnings`, and `interior_extremes` of each
/// patch where there are points inside the bodies.
io::Json case_document(const io::WheelRailCase& input, const WheelRailResult& result, const io::Provenance& provenance,
                       io::JsonFields fields = io::JsonFields::left_out);
io::Json case_document(const io::WheelsetCase& input, const WheelsetResult& result, const io::Provenance& provenance,
                       io::JsonFields fields = io::JsonFields::left_out);

} // namespace microslip::cases
