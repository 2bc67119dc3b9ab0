#pragma once

namespace microslip {

/// Along which axis of the contact's frame the bodies roll. The forces' frame stays as it is.
enum class RollingDirection {
  forward,  ///< along +x: particles enter at large x
  backward, ///< along -x: particles enter at small x
};

/// Kind of motion of the bodies over each other.
enum class ContactMotion {
  shift,     ///< a rigid shift without rolling; creepages are shifts [m] and a rotation [rad], slip is in m
  transient, ///< one step of rolling, the contact moving over the bodies
  steady,    ///< steady rolling, solved directly
};

} // namespace microslip
