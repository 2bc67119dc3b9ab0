#pragma once

namespace microslip {

/// Prescribed load or approach in the normal direction.
struct NormalLoad {
  enum class Given { approach, force };
  Given given = Given::force;
  double value = 0; ///< approach delta [m] or normal force Fn [N]
};

} // namespace microslip
