#include "microslip/railway/wheelset.hpp"

#include "microslip/error.hpp"
#include "microslip/numerics/cubic_roots.hpp"

namespace microslip {
namespace {

/// z where the profile has the lateral coordinate y.
double height_at(const Profile& profile, double y) {
  std::optional<double> height;
  for (const ProfilePiece& piece : profile.pieces()) {
    const CubicRoots roots = cubic_roots({piece.c[0].y - y, piece.c[1].y, piece.c[2].y, piece.c[3].y}, 0, piece.length);
    for (const double t : roots) {
      const double z = piece.at(piece.start + t).value.z;
      if (height && std::abs(z - *height) > 1e-12)
        throw Error("tape_circle", y, "m", "where the profile has one height");
      height = z;
    }
  }
  if (!height) throw Error("tape_circle", y, "m", "within the wheel's profile");
  return *height;
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
