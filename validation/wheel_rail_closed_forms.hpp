#pragma once

namespace microslip::validation {

class Report;

/// Wheels and rails whose contact is known in closed form: contact points of a sphere on a cylinder and of a cone on a
/// round rail at random yaw and roll, and the loads of ellipsoids at a given height beside Hertz's.
void report_closed_forms(Report& report);

} // namespace microslip::validation
