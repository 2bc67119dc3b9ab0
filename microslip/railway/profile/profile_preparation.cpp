#include "microslip/railway/profile/profile_preparation.hpp"

#include "microslip/error.hpp"
#include "microslip/railway/profile/profile_crossing.hpp"
#include "microslip/railway/profile/profile_noise.hpp"
#include "microslip/railway/profile/profile_smoothing.hpp"
#include "microslip/railway/profile/report_text.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace microslip {
namespace {

constexpr std::size_t fewest_points = 4, most_points = 20000;
constexpr double shortest = 5e-3, longest = 0.5; // [m]
constexpr double least_flange = 0.015;           // height above the tread [m]

double distance(const ProfilePoint& a, const ProfilePoint& b) {
  return std::hypot(b.y - a.y, b.z - a.z);
}

double polygon_length(std::span<const ProfilePoint> points) {
  double length = 0;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) length += distance(points[k], points[k + 1]);
  return length;
}

bool less_in_y(const ProfilePoint& a, const ProfilePoint& b) {
  return a.y < b.y;
}

bool less_in_z(const ProfilePoint& a, const ProfilePoint& b) {
  return a.z < b.z;
}

bool is_far_from_ends(std::span<const ProfilePoint> points, const ProfilePoint& p) {
  constexpr double far = 5e-3;
  return distance(p, points.front()) > far && distance(p, points.back()) > far;
}

/// Curvature [1/m] of the polygon at a point that is none of its ends.
double curvature_at(std::span<const ProfilePoint> points, std::size_t k) {
  return 2 * turn_at(points, k) / (distance(points[k - 1], points[k]) + distance(points[k], points[k + 1]));
}

/// Root mean square of the difference of both polygons' curvatures away from kinks.
double curvature_change(std::span<const ProfilePoint> before, std::span<const ProfilePoint> after,
                        std::span<const std::size_t> kinks) {
  double squares = 0;
  std::size_t count = 0;
  for (std::size_t k = 1; k + 1 < before.size(); ++k) {
    if (std::binary_search(kinks.begin(), kinks.end(), k)) continue;
    const double change = curvature_at(after, k) - curvature_at(before, k);
    squares += change * change;
    ++count;
  }
  return count == 0 ? 0 : std::sqrt(squares / static_cast<double>(count));
}

double median_curvature_deviation(const DenoisedPoints& points) {
  auto all = points.curvature_deviation;
  if (all.empty()) return 0;
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::nth_element(all.begin(), middle, all.end());
  return *middle;
}

/// The treatment of one profile's points, step by step.
class Preparation {
public:
  Preparation(ProfileRole role, std::vector<ProfilePoint> points, const ProfileTreatment& treatment,
              ProfileReport report)
      : role_(role), treatment_(treatment), points_(std::move(points)), report_(std::move(report)) {}

  PreparedProfile result() {
    if (report_.points_read == 0) report_.points_read = points_.size();
    check_input();
    sort_if_unsorted();
    drop_duplicates();
    turn_order();
    trim();
    straighten_zigzags();
    check_shape();
    const auto kinks = find_kinks(points_, treatment_.kinks);
    report_.noise = estimate_noise(points_);
    const auto measured = points_;
    smooth(kinks);
    warn();
    report_.points = points_.size();
    Profile profile(role_, points_, kinks);
    list_kinks(profile, kinks);
    return {std::move(profile), std::move(points_), measured, std::move(report_)};
  }

private:
  [[noreturn]] void fail(const std::string& text) const {
    throw Error((report_.source.empty() ? "profile" : report_.source) + ": " + text);
  }

  void check_input() const {
    if (points_.size() < fewest_points)
      fail(counted(points_.size(), "point") + ": a profile needs at least " + std::to_string(fewest_points));
    if (points_.size() > most_points)
      fail(std::to_string(points_.size()) + " points: must be at most " + std::to_string(most_points));
    for (std::size_t k = 0; k < points_.size(); ++k) {
      const auto check = [&](char axis, double value) {
        if (!std::isfinite(value)) {
          const std::string name = std::string(1, axis) + " of point " + std::to_string(k + 1);
          fail(Error(name, value, "m", "finite").what());
        }
      };
      check('y', points_[k].y);
      check('z', points_[k].z);
    }
  }

  /// Points of a table in any order make a polygon much longer than those sorted by y. One that only overhangs becomes
  /// longer by sorting.
  void sort_if_unsorted() {
    auto sorted = points_;
    std::stable_sort(sorted.begin(), sorted.end(), less_in_y);
    if (polygon_length(sorted) > 0.7 * polygon_length(points_)) return;
    points_ = std::move(sorted);
    report_.steps.emplace_back("sorted by y");
    report_.warnings.emplace_back("the points are not in order along the profile; they are sorted by y");
  }

  void drop_duplicates() {
    const std::size_t before = points_.size();
    const auto close = [this](const ProfilePoint& a, const ProfilePoint& b) {
      return distance(a, b) <= treatment_.smallest_spacing;
    };
    points_.erase(std::unique(points_.begin(), points_.end(), close), points_.end());
    if (const std::size_t dropped = before - points_.size(); dropped > 0)
      report_.steps.push_back("dropped " + counted(dropped, "point") + " within " + in_mm(treatment_.smallest_spacing) +
                              " of the one before");
    require_points();
  }

  void require_points() const {
    if (points_.size() < fewest_points)
      fail(counted(points_.size(), "point") + " left: a profile needs at least " + std::to_string(fewest_points));
  }

  void turn_order() {
    if (points_.front().y <= points_.back().y) return;
    std::reverse(points_.begin(), points_.end());
    report_.steps.emplace_back("turned round, to run from the gauge side to the field side");
  }

  void trim() {
    const auto is_outside = [this](const ProfilePoint& p) { return p.y < treatment_.y_min || p.y > treatment_.y_max; };
    const auto first = std::find_if_not(points_.begin(), points_.end(), is_outside);
    const auto last = std::find_if_not(points_.rbegin(), points_.rend(), is_outside).base();
    const std::size_t before = points_.size();
    if (first >= last) fail("no point has y within " + in_mm(treatment_.y_min) + " to " + in_mm(treatment_.y_max));
    points_ = std::vector<ProfilePoint>(first, last);
    if (const std::size_t dropped = before - points_.size(); dropped > 0)
      report_.steps.push_back("dropped " + counted(dropped, "point") + " at the ends, with y outside " +
                              in_mm(treatment_.y_min) + " to " + in_mm(treatment_.y_max));
    require_points();
  }

  void straighten_zigzags() {
    auto kept = without_zigzags(points_, treatment_.zigzag_angle);
    const std::size_t straightened = points_.size() - kept.size();
    if (straightened == 0) return;
    points_ = std::move(kept);
    report_.steps.push_back("straightened " + counted(straightened, "zig-zag"));
    drop_duplicates(); // two means may coincide
  }

  void check_shape() const {
    const double length = polygon_length(points_);
    if (!(length >= shortest && length <= longest))
      fail("the profile is " + in_mm(length) + " long: must be in " + in_mm(shortest) + " to " + in_mm(longest) +
           "; is the unit of length right?");
    require_no_crossing();
  }

  /// Nor may a side lie on the one before.
  void require_no_crossing() const {
    constexpr double back = 0.9999 * std::numbers::pi;
    auto found = find_crossing(points_);
    for (std::size_t k = 1; k + 1 < points_.size() && !found; ++k)
      if (std::abs(turn_at(points_, k)) > back) found = {k - 1, k};
    if (found)
      fail("the profile crosses itself between " + in_mm(points_[found->first]) + " and " +
           in_mm(points_[found->second]));
  }

  void smooth(const std::vector<std::size_t>& kinks) {
    if (!treatment_.smoothing_length)
      smooth_by_noise(kinks);
    else if (*treatment_.smoothing_length != 0)
      smooth_by_length(kinks, *treatment_.smoothing_length);
  }

  void smooth_by_length(const std::vector<std::size_t>& kinks, double length) {
    const auto moved = smoothed(points_, kinks, length);
    for (std::size_t k = 1; k < points_.size(); ++k)
      if (distance(moved[k - 1], moved[k]) <= treatment_.smallest_spacing)
        fail("smoothing with wavelength " + in_mm(length) + " makes points coincide at " + in_mm(moved[k]));
    report_.smoothing.length = length;
    move(moved, kinks, "smoothed with wavelength " + in_mm(length));
  }

  void smooth_by_noise(const std::vector<std::size_t>& kinks) {
    if (report_.noise.smoothing_length == 0) return;
    const auto found = denoised(points_, kinks, report_.noise);
    if (!found) return;
    report_.smoothing.by_noise = true;
    report_.noise.long_waves = found->long_waves;
    report_.smoothing.curvature_left = median_curvature_deviation(*found);
    report_.smoothing.pressure_left = pressure_deviation(*found);
    move(found->points, kinks, "smoothed by their noise of " + in_um(scatter()));
  }

  /// Deviation of the noise that counts.
  double scatter() const { return std::max(report_.noise.deviation, report_.noise.long_waves); }

  void move(const std::vector<ProfilePoint>& moved, const std::vector<std::size_t>& kinks, const std::string& how) {
    ProfileSmoothing& smoothing = report_.smoothing;
    double squares = 0;
    for (std::size_t k = 0; k < points_.size(); ++k) {
      const double move = distance(points_[k], moved[k]);
      smoothing.largest_move = std::max(smoothing.largest_move, move);
      squares += move * move;
    }
    smoothing.mean_move = std::sqrt(squares / static_cast<double>(points_.size()));
    smoothing.curvature_change = curvature_change(points_, moved, kinks);
    points_ = moved;
    report_.steps.push_back(how + ", which moved them by up to " + in_um(smoothing.largest_move) + ", " +
                            in_um(smoothing.mean_move) + " in the mean, and changed the curvature by " +
                            digits(smoothing.curvature_change * 1e-3) + " 1/mm in the mean");
  }

  void warn() {
    warn_of_axes();
    warn_of_extent();
    warn_of_gaps();
    warn_of_noise();
  }

  void warn_of_noise() {
    constexpr double noticeable = 0.05; // of the peak pressure
    const ProfileNoise& noise = report_.noise;
    const ProfileSmoothing& smoothing = report_.smoothing;
    const std::string scatters = "the points scatter by " + in_um(scatter());
    if (smoothing.by_noise && smoothing.pressure_left > noticeable)
      report_.warnings.push_back(scatters + ": peak pressures on the running surface are uncertain by +-" +
                                 in_percent(smoothing.pressure_left));
    if (!smoothing.by_noise && smoothing.length == 0 && noise.smoothing_length > 0)
      report_.warnings.push_back(scatters + ": curvatures are uncertain by " + digits(noise.curvature * 1e-3) +
                                 " 1/mm, and peak pressures mean nothing; " +
                                 (treatment_.smoothing_length
                                      ? "leave smoothing_length out"
                                      : "smooth with a wavelength of " + in_mm(noise.smoothing_length)));
  }

  void warn_of_axes() {
    const auto sense = sense_of_shape(role_, points_);
    const bool is_wheel = role_ == ProfileRole::wheel;
    if (sense.z < 0)
      report_.warnings.emplace_back(is_wheel ? "the flange points up: is z mirrored, or is this a rail?"
                                             : "the head is lower than its sides: is z mirrored, or is this a wheel?");
    if (sense.y < 0)
      report_.warnings.emplace_back(is_wheel ? "the flange is at the field side: is y mirrored?"
                                             : "the field side reaches further down than the gauge side: is y "
                                               "mirrored?");
    if (is_wheel && sense.z == 0) report_.warnings.emplace_back("no flange is to be seen: is this a rail?");
    warn_of_lowest_point(is_wheel && sense.z > 0);
  }

  /// Warns unless the lowest point of a wheel is the flange's tip, inside the curve, and that of a rail at an end.
  void warn_of_lowest_point(bool has_flange) {
    const auto low = std::min_element(points_.begin(), points_.end(), less_in_z);
    const bool is_inner = is_far_from_ends(points_, *low);
    if (has_flange && !is_inner)
      report_.warnings.emplace_back("the profile ends at the flange's tip: is this a rail, or a part of a wheel?");
    const double depth = std::min(points_.front().z, points_.back().z) - low->z;
    if (role_ == ProfileRole::rail && is_inner && depth > least_flange)
      report_.warnings.push_back("the profile is lowest at " + in_mm(*low) + ", not at an end: is this a wheel?");
  }

  void warn_of_extent() {
    const auto [left, right] = std::minmax_element(points_.begin(), points_.end(), less_in_y);
    const double width = right->y - left->y;
    const double least = role_ == ProfileRole::wheel ? 0.08 : 0.03; // of a tread with its flange, of a head [m]
    if (width < least)
      report_.warnings.push_back("the profile is only " + in_mm(width) + " wide: is the unit right, or is it a part?");
  }

  void warn_of_gaps() {
    constexpr double shortest_gap = 3e-3, ratio = 10;
    std::vector<double> steps;
    for (std::size_t k = 0; k + 1 < points_.size(); ++k) steps.push_back(distance(points_[k], points_[k + 1]));
    auto sorted = steps;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    for (std::size_t k = 0; k < steps.size(); ++k)
      if (steps[k] > shortest_gap && steps[k] > ratio * *middle)
        report_.warnings.push_back("a gap of " + in_mm(steps[k]) + " between " + in_mm(points_[k]) + " and " +
                                   in_mm(points_[k + 1]));
  }

  void list_kinks(const Profile& profile, const std::vector<std::size_t>& kinks) {
    for (const std::size_t k : kinks)
      report_.kinks.push_back({points_[k], profile.pieces()[k].start, turn_at(points_, k)});
  }

  ProfileRole role_;
  const ProfileTreatment& treatment_;
  std::vector<ProfilePoint> points_;
  ProfileReport report_;
};

/// 1 or -1 for a flange at low or high z, 0 without one. A flange stands out by more than 15 mm, and its tip is not at
/// an end of the profile where the back of a wheel or its chamfer may reach as far.
int flange_sense(std::span<const ProfilePoint> points, const ProfilePoint*& tip) {
  std::vector<double> heights;
  for (const auto& p : points) heights.push_back(p.z);
  const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
  std::nth_element(heights.begin(), middle, heights.end());
  const auto low = std::min_element(points.begin(), points.end(), less_in_z);
  const auto high = std::max_element(points.begin(), points.end(), less_in_z);
  const double below = *middle - low->z, above = high->z - *middle;
  const bool inner_low = below > least_flange && is_far_from_ends(points, *low);
  const bool inner_high = above > least_flange && is_far_from_ends(points, *high);
  bool is_low = inner_low;
  if (inner_low == inner_high) {
    if (std::max(below, above) < least_flange || std::max(below, above) < 1.5 * std::min(below, above)) return 0;
    is_low = below > above;
  }
  tip = is_low ? &*low : &*high;
  return is_low ? 1 : -1;
}

/// Sense by the height of the middle half against that of the outer tenths.
int head_sense(std::span<const ProfilePoint> points, double left, double width) {
  double middle = 0, ends = 0;
  std::size_t in_middle = 0, at_ends = 0;
  for (const auto& p : points) {
    const double t = (p.y - left) / width;
    if (t >= 0.25 && t <= 0.75) {
      middle += p.z;
      ++in_middle;
    } else if (t < 0.1 || t > 0.9) {
      ends += p.z;
      ++at_ends;
    }
  }
  if (in_middle == 0 || at_ends == 0) return 0;
  const double rise = middle / static_cast<double>(in_middle) - ends / static_cast<double>(at_ends);
  return std::abs(rise) < 0.01 * width ? 0 : rise > 0 ? 1 : -1;
}

/// Sense by how far the outer fifths reach down, where z has this sense.
int gauge_side_sense(std::span<const ProfilePoint> points, double left, double width, int z_sense) {
  constexpr double clearly = 5e-3;
  double lowest_left = std::numeric_limits<double>::infinity(), lowest_right = lowest_left;
  for (const auto& p : points) {
    const double t = (p.y - left) / width;
    if (t < 0.2) lowest_left = std::min(lowest_left, z_sense * p.z);
    if (t > 0.8) lowest_right = std::min(lowest_right, z_sense * p.z);
  }
  return lowest_left < lowest_right - clearly ? 1 : lowest_right < lowest_left - clearly ? -1 : 0;
}

} // namespace

ShapeSense sense_of_shape(ProfileRole role, std::span<const ProfilePoint> points) {
  if (points.empty()) return {};
  const auto [left, right] = std::minmax_element(points.begin(), points.end(), less_in_y);
  if (role == ProfileRole::rail) {
    const double width = right->y - left->y;
    const int z = head_sense(points, left->y, width);
    return {z == 0 ? 0 : gauge_side_sense(points, left->y, width, z), z};
  }
  const ProfilePoint* tip = nullptr;
  const int z = flange_sense(points, tip);
  return {z == 0 ? 0 : tip->y < (left->y + right->y) / 2 ? 1 : -1, z};
}

PreparedProfile prepare_profile(ProfileRole role, std::vector<ProfilePoint> points, const ProfileTreatment& treatment,
                                ProfileReport report) {
  return Preparation(role, std::move(points), treatment, std::move(report)).result();
}

std::string_view to_string(ProfileRole role) {
  return role == ProfileRole::rail ? "rail" : "wheel";
}

} // namespace microslip
