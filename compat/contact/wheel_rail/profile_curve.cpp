#include "compat/contact/wheel_rail/profile_curve.hpp"

#include "microslip/numerics/cubic_roots.hpp"

#include <algorithm>
#include <cmath>

namespace microslip::contact_program {
namespace {

bool is_monotone(const std::vector<ProfilePoint>& points) {
  for (std::size_t k = 1; k < points.size(); ++k)
    if (!(points[k].y > points[k - 1].y)) return false;
  return true;
}

/// The polygon's length where y = 0 if y ascends, else at the point next to the origin.
double origin_of(const Profile& profile, const std::vector<ProfilePoint>& points) {
  const auto pieces = profile.pieces();
  const auto length_to = [&](std::size_t k) { return k < pieces.size() ? pieces[k].start : profile.length(); };
  if (!is_monotone(points)) {
    const auto near = std::min_element(points.begin(), points.end(), [](const auto& a, const auto& b) {
      return std::hypot(a.y, a.z) < std::hypot(b.y, b.z);
    });
    return length_to(static_cast<std::size_t>(near - points.begin()));
  }
  std::size_t k = 0; // straight lines between the points, the outer ones of which go on
  while (k + 2 < points.size() && points[k + 1].y < 0) ++k;
  const double share = -points[k].y / (points[k + 1].y - points[k].y);
  return length_to(k) + share * (length_to(k + 1) - length_to(k));
}

} // namespace

ProfileCurve::ProfileCurve(ProfileRole role, const std::vector<ProfilePoint>& points,
                           const std::vector<std::size_t>& kinks)
    : role_(role), points_(points), kinks_(kinks), profile_(role, points, kinks), origin_(origin_of(profile_, points)) {
  const auto [left, right] =
      std::minmax_element(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
  least_y_ = left->y;
  greatest_y_ = right->y;
  find_branches();
}

double ProfileCurve::s_of(std::size_t point) const {
  return (point < profile_.pieces().size() ? profile_.pieces()[point].start : profile_.length()) - origin_;
}

ProfileCurve ProfileCurve::moved(double angle, double dy, double dz) const {
  const double c = std::cos(angle), s = std::sin(angle);
  std::vector<ProfilePoint> points;
  for (const auto& p : points_) points.push_back({dy + c * p.y - s * p.z, dz + s * p.y + c * p.z});
  ProfileCurve curve(role_, points, kinks_);
  curve.origin_ = origin_;
  return curve;
}

/// Cuts the spline where dy/ds changes its sign.
void ProfileCurve::find_branches() {
  std::vector<double> cuts = {0};
  const auto pieces = profile_.pieces();
  double last = pieces[0].c[1].y;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const auto& c = pieces[k].c;
    if (k > 0 && c[1].y * last < 0) cuts.push_back(pieces[k].start); // at a kink
    for (const double extremum : cubic_roots({c[1].y, 2 * c[2].y, 3 * c[3].y, 0}, 0, pieces[k].length))
      if (extremum > 0 && extremum < pieces[k].length) cuts.push_back(pieces[k].start + extremum);
    last = pieces[k].at(pieces[k].start + pieces[k].length).first.y;
  }
  cuts.push_back(profile_.length());
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const Branch branch{cuts[k], cuts[k + 1], profile_.at(cuts[k]).value.y, profile_.at(cuts[k + 1]).value.y};
    if (branch.y0 != branch.y1) branches_.push_back(branch);
  }
}

/// By bisection of the pieces; the end that is nearer where rounding leaves no root within the piece.
double ProfileCurve::s_in(const Branch& branch, double y) const {
  const double sign = branch.y1 > branch.y0 ? 1 : -1;
  const auto pieces = profile_.pieces();
  std::size_t low = profile_.piece_at(branch.s0), high = profile_.piece_at(branch.s1);
  while (low < high) {
    const std::size_t middle = (low + high + 1) / 2;
    if (sign * (pieces[middle].c[0].y - y) <= 0)
      low = middle;
    else
      high = middle - 1;
  }
  const ProfilePiece& piece = pieces[low];
  const auto& c = piece.c;
  const double from = std::max(branch.s0 - piece.start, 0.0), to = std::min(branch.s1 - piece.start, piece.length);
  const CubicRoots roots = cubic_roots({c[0].y - y, c[1].y, c[2].y, c[3].y}, from, to);
  if (roots.count > 0) return piece.start + roots.value[0];
  const auto off = [&](double t) { return std::abs(piece.at(piece.start + t).value.y - y); };
  return piece.start + (off(from) < off(to) ? from : to);
}

std::optional<double> ProfileCurve::s_at_y(double y) const {
  std::optional<double> found;
  double height = 0;
  for (const Branch& branch : branches_) {
    if (y < std::min(branch.y0, branch.y1) || y > std::max(branch.y0, branch.y1)) continue;
    const double s = s_in(branch, y), z = profile_.at(s).value.z;
    const bool is_seen = !found || (role_ == ProfileRole::rail ? z < height : z > height);
    if (!is_seen) continue;
    found = s - origin_;
    height = z;
  }
  return found;
}

double ProfileCurve::nearest_s_at_y(double y) const {
  if (const auto s = s_at_y(std::clamp(y, least_y_, greatest_y_))) return *s;
  const bool is_left = y < 0.5 * (least_y_ + greatest_y_);
  return is_left ? start() : end();
}

} // namespace microslip::contact_program
