#pragma once

#include "compat/contact/interior.hpp"
#include "compat/contact/totals.hpp"
#include "compat/contact/wheel_rail/wheel_outcome.hpp"
#include "microslip/exact/classical/contact_sequence.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace microslip::contact_program {

/// Parameters of FASTSIM and FaStrip, as CONTACT prints it.
struct PrintedSprings {
  std::array<double, 3> flexibilities = {}; ///< FLX1, FLX2, FLX3 [mm3/N]
  double slope = 1;                         ///< K_EFF, by which they are stiffer [-]
};

/// d(FN, FX/(FSTAT FN), FY/(FSTAT FN), MZ)/d(approach, xi, eta, phi) in CONTACT's units: [output][input]; 0 where it is
/// not available.
using Sensitivities = std::array<std::array<double, 4>, 4>;

/// Outcome of a case.
struct Outcome {
  enum class Kind { solved, skipped, refused };
  Kind kind = Kind::solved;
  std::vector<std::string> reasons = {}; ///< why it was refused
  bool is_unsupported = false;           ///< it was refused for what it asks for
  std::vector<std::string> notes = {};   ///< what was left out or done differently
  bool misses_force = false;             ///< it does not bear what is prescribed, as its status and a note say
  ContactStep step = {};                 ///< the rest for cases that are solved
  ContactStepSolution solution = {};
  std::optional<PrintedSprings> springs = {}; ///< of the simplified theory
  std::vector<InteriorBlock> interior = {};   ///< at the points that are asked for, S > 0
  PrintedTotals totals = {};
  std::optional<Sensitivities> sensitivities = {}; ///< where they were asked for
  std::optional<Vec3<double>> damping = {};        ///< with M2 > 0: damping force on body 1, no part of the totals [N]
  std::optional<WheelOutcome> wheel = {};          ///< of module 1, whose patches have all of the above but the kind

  bool has_temperatures() const { return !solution.fields.temperature1.empty(); } ///< if asked for, H > 0
};

/// State of an element of a solved case: 0 exterior, 1 adhesion, 2 slip, 3 plastic deformation of a layer.
int element_state(const Outcome& outcome, std::size_t element);

} // namespace microslip::contact_program
