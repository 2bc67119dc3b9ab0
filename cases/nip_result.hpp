#pragma once

#include "cases/stored_number.hpp"
#include "io/case_file.hpp"
#include "microslip/progress.hpp"
#include "microslip/rolling/nip.hpp"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace microslip::cases {

/// What users of rollers ask of a case of bodies with layers.
struct NipResult {
  Nip nip = {};
  /// Each roller without torque under the same load; none where the approach is given.
  std::optional<FreeRoller> free1 = {}, free2 = {};
};

RollerRadii roller_radii(const io::RollingCase& input);

/// Returns whether a case's solution has a nip: steady rolling of bodies with layers that touch, with status ok.
bool has_nip(const io::RollingCase& input, const ContactSolution& solution);

/// The nip of a case that has_nip, and its rollers without torque by the case's solver, which cost two to four solves
/// each. Throws Stopped if `progress` returns false.
NipResult nip_result(const io::RollingCase& input, const ContactSolution& solution, Solver& solver,
                     const Progress& progress);

/// A number of a nip as result files and sweeps have it.
struct NipQuantity {
  std::string_view path, unit, description; ///< "nip/width"
  double (*value)(const Nip& nip);
  bool (*applies)(const Nip& nip);
};
std::span<const NipQuantity> nip_quantities();

/// Those that apply, and nip/speed_ratio1 and nip/speed_ratio2.
std::vector<StoredNumber> nip_numbers(const NipResult& result);

} // namespace microslip::cases
