#pragma once

#include "compat/contact/fastsim.hpp"
#include "compat/contact/input.hpp"
#include "compat/contact/interior.hpp"
#include "compat/contact/totals.hpp"
#include "microslip/exact/classical/contact_sequence.hpp"
#include "microslip/thermal/surface_temperature.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace microslip::contact_program {

/// What became of a case.
struct Outcome {
  enum class Kind { solved, skipped, refused };
  Kind kind = Kind::solved;
  std::vector<std::string> reasons = {}; ///< why it was refused
  std::vector<std::string> notes = {};   ///< what was left out or done in another way
  ContactStep step = {};                 ///< the rest for cases that are solved
  ContactStepSolution solution = {};
  std::optional<SurfaceTemperature> temperature = {}; ///< if asked for, H > 0
  std::vector<InteriorBlock> interior = {};           ///< at the points that are asked for, S > 0
  PrintedTotals totals = {};
};

/// Of an element of a solved case: 0 exterior, 1 adhesion, 2 slip.
int element_state(const Outcome& outcome, std::size_t element);

/// Runs the cases of an input file in their order, each with what the ones before it have left. A case that asks for
/// something unsupported is refused, and so is one that goes on from the tractions of a refused one; all others run.
class Run {
public:
  /// `progress` is told of a case's solution; false throws Stopped, and what it throws is passed on. No case can go on
  /// from one that was ended.
  Outcome run(const Case& c, const Progress& progress = {});

private:
  struct Sequence {
    ContactSequence steps;
    InteriorSequence interior;
    int lost = 0; ///< number of the case that could not be run after the last one that was solved
    std::optional<CarriedSprings> springs =
        CarriedSprings(); ///< of the last case if it was FASTSIM's, or without friction
  };

  Outcome solve(const Case& c, Sequence& sequence, const Progress& progress);

  std::map<std::pair<int, int>, Sequence> sequences_;
};

} // namespace microslip::contact_program
