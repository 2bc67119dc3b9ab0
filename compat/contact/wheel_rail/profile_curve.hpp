#pragma once

#include "microslip/railway/profile/profile.hpp"

#include <optional>
#include <vector>

namespace microslip::contact_program {

/// A profile in CONTACT's axes [m]: y to the field side, z down. Its spline is parametrised by the length s of the
/// polygon through the points, with s = 0 where y = 0, and ascends from the gauge side to the field side for rails and
/// wheels alike; CONTACT's wheels descend, so that their s is the negative of ours.
class ProfileCurve {
public:
  /// `kinks` as those of Profile.
  ProfileCurve(ProfileRole role, const std::vector<ProfilePoint>& points, const std::vector<std::size_t>& kinks);

  CurvePoint at(double s) const { return profile_.at(s + origin_); }
  const Profile& profile() const { return profile_; }
  double start() const { return -origin_; }
  double end() const { return profile_.length() - origin_; }
  const std::vector<ProfilePoint>& points() const { return points_; }
  const std::vector<std::size_t>& kinks() const { return kinks_; }
  /// s of the points.
  double s_of(std::size_t point) const;
  /// The least and the greatest y of the points.
  double least_y() const { return least_y_; }
  double greatest_y() const { return greatest_y_; }
  /// A rotation about x by `angle`, and then a shift: the spline of moved points is the moved spline.
  ProfileCurve moved(double angle, double dy, double dz) const;

  /// s where y is the given one, on the part that is seen; nothing beyond the profile. Cost O(log points) for each part
  /// in which y is monotone.
  std::optional<double> s_at_y(double y) const;
  /// The same, with the next end beyond the profile.
  double nearest_s_at_y(double y) const;

private:
  /// A part in which y is monotone.
  struct Branch {
    double s0, s1; ///< in the spline's parameter
    double y0, y1;
  };

  void find_branches();
  double s_in(const Branch& branch, double y) const;

  ProfileRole role_;
  std::vector<ProfilePoint> points_;
  std::vector<std::size_t> kinks_;
  Profile profile_;
  double origin_ = 0; ///< the spline's parameter where s = 0
  double least_y_ = 0, greatest_y_ = 0;
  std::vector<Branch> branches_;
};

} // namespace microslip::contact_program
