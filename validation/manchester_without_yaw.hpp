#pragma once

namespace microslip {
class Profile;
}

namespace microslip::validation {

class Report;

/// The wheelset of the Manchester benchmark without yaw: where it touches both rails beside independently
/// computed contact points, and the patches under 10 kN on each wheel, which no stored results exist for, at both
/// levels beside each other. Three states with yaw complete the points.
void report_without_yaw(Report& report, const Profile& rail, const Profile& wheel);

} // namespace microslip::validation
