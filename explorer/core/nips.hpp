#pragma once

#include "io/case_file.hpp"
#include "io/json.hpp"
#include "microslip/rolling/solver.hpp"

namespace microslip::explorer {

/// Nips: rollers with layers in steady rolling. Elements and influence numbers, which take most of the time, stay from
/// one case to the next as long as bodies, speed and load do.
class Nips {
public:
  /// The contact as the case has it, `given`, with its fields, and the same as it rolls without a longitudinal force,
  /// `free`: a JSON object. Both have all quantities, and the speed ratio: the surface speed of the undeformed body 1
  /// over that of body 2, with the creepage xi (2 - xi)/(2 + xi) in rolling along +x.
  /// `cover` has the stiffness of body 2's surface as moduli and as hardness.
  /// Throws Error for a case without layers, not about steady rolling or without friction, and for a force beyond it.
  io::Json solve(const io::RollingCase& input);

  /// The longitudinal force over the longitudinal creepage, at `count` points: from free rolling to either side three
  /// times as far as it takes to half of the largest force. A JSON object.
  /// Throws Error as `solve`, and where creepages under those forces are not found.
  io::Json curve(const io::RollingCase& input, int count);

private:
  /// The case's solver, which keeps what it has while the method stays.
  Solver& solver_for(const io::RollingCase& input);

  Solver solver_;
};

} // namespace microslip::explorer
