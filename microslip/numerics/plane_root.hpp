#pragma once

#include "microslip/vec2.hpp"

#include <functional>

namespace microslip {

/// Common root of two functions of two unknowns.
struct PlaneRoot {
  Vec2 at;         ///< the best point found
  double size = 0; ///< |f| there
  bool found = false;
};

/// Newton's method for f(v) = 0 from `start` on, until |f| <= tolerance; for functions that are continuous and
/// piecewise smooth. `scale` says how large changes of the unknowns are that matter; derivatives come from differences
/// over 1e-7 of it. Steps are halved until |f| falls, and until the derivatives do not vanish: a plateau is not
/// entered. Nothing is found where no such step is left, or after 100 steps. Cost: 3 evaluations of f for a step or
/// half of one.
PlaneRoot find_plane_root(const std::function<Vec2(Vec2)>& f, Vec2 start, Vec2 scale, double tolerance);

} // namespace microslip
