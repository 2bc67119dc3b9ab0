#include "microslip/railway/geometry/wheelset.hpp"

#include "microslip/error.hpp"
#include "microslip/railway/profile/profile_dimensions.hpp"

#include <cmath>
#include <vector>

namespace microslip {
namespace {

/// z where the profile has the lateral coordinate y.
double height_at(const Profile& profile, double y) {
  const std::vector<double> places = crossings(profile, &ProfilePoint::y, y);
  if (places.empty()) throw Error("tape_circle", y, "m", "within the wheel's profile");
  const double height = profile.at(places.front()).value.z;
  for (const double s : places)
    if (std::abs(profile.at(s).value.z - height) > 1e-12)
      throw Error("tape_circle", y, "m", "where the profile has one height");
  return height;
}

} // namespace

WheelPlace place_wheel(const Wheelset& wheelset, const Profile& wheel) {
  require_positive("flange_back_distance", wheelset.flange_back_distance, "m");
  require_finite("flange_back_position", wheelset.flange_back_position, "m");
  require_positive("nominal_radius", wheelset.nominal_radius, "m");
  WheelPlace place{wheelset.flange_back_distance / 2 - wheelset.flange_back_position, wheelset.nominal_radius};
  if (wheelset.tape_circle) {
    require_finite("tape_circle", *wheelset.tape_circle, "m");
    place.radius += height_at(wheel, *wheelset.tape_circle);
  }
  for (const ProfilePiece& piece : wheel.pieces())
    for (const double s : {piece.start, piece.start + piece.length})
      if (!(piece.at(s).value.z < place.radius))
        throw Error("nominal_radius", wheelset.nominal_radius, "m",
                    "more than the greatest height of the wheel's profile");
  return place;
}

} // namespace microslip
