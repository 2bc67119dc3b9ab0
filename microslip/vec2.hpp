#pragma once

namespace microslip {

/// A vector in the contact plane: x along the rolling direction, y lateral.
struct Vec2 {
  double x = 0;
  double y = 0;
};

} // namespace microslip
