#pragma once

#include "compat/contact/wheel_rail/profile_shape.hpp"
#include "compat/contact/wheel_rail/records.hpp"

namespace microslip::contact_program {

/// The profile of a file as CONTACT lays its spline through it: close points and zig-zags out, mirrored and scaled to
/// mm, cut at kinks, smoothed, by ProfileThresholds; then in m. Throws Error, with the file's name, for what cannot be
/// read, for less than two points, a length outside 5 to 500 mm and a polygon that crosses itself.
std::shared_ptr<const ProfileCurve> read_profile_curve(const ProfileRecord& record, ProfileRole role);

/// The same; a file of slices (.slcs, .slcw) names one such profile for each of them, relative to its folder, and the
/// surface joins them.
ProfileShape read_profile_shape(const ProfileRecord& record, ProfileRole role);

/// A profile of points that are given instead of a file: columns of y and z, whose `file` is a name for messages.
/// Zig-zags stay, as in CONTACT.
std::shared_ptr<const ProfileCurve> profile_curve_through(std::vector<ProfilePoint> points, const ProfileRecord& record,
                                                          ProfileRole role);

/// Returns whether a record names slices of a profile that varies, .slcs or .slcw.
bool is_variable(const ProfileRecord& record);

} // namespace microslip::contact_program
