#include "compat/contact/wheel_rail/profile_reading.hpp"

#include "compat/contact/wheel_rail/profile_thresholds.hpp"
#include "io/profile_formats.hpp"
#include "io/slices_file.hpp"
#include "microslip/error.hpp"
#include "microslip/railway/profile/profile_crossing.hpp"
#include "microslip/railway/profile/profile_kinks.hpp"
#include "microslip/railway/profile/profile_preparation.hpp"
#include "microslip/railway/profile/profile_slices.hpp"
#include "microslip/railway/profile/profile_smoothing.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

namespace microslip::contact_program {
namespace {

std::string extension(const std::string& file) {
  return io::lower_case(std::filesystem::path(file).extension().string());
}

io::ProfileFormat format_of(const std::string& file) {
  const std::string ending = extension(file);
  if (ending == ".prr" || ending == ".prw") return io::ProfileFormat::simpack;
  return ending == ".ban" || ending == ".whl" ? io::ProfileFormat::miniprof : io::ProfileFormat::columns;
}

void drop_close_points(std::vector<ProfilePoint>& points, double spacing) {
  const auto close = [spacing](const ProfilePoint& a, const ProfilePoint& b) {
    return std::hypot(b.y - a.y, b.z - a.z) < spacing;
  };
  points.erase(std::unique(points.begin(), points.end(), close), points.end());
}

/// The index of a point among all, counted from 1, over their number.
double share_of(const std::vector<ProfilePoint>& points, std::vector<ProfilePoint>::const_iterator point) {
  return static_cast<double>(point - points.begin() + 1) / static_cast<double>(points.size());
}

bool has_less_z(const ProfilePoint& a, const ProfilePoint& b) {
  return a.z < b.z;
}

/// Whether a wheel's z is positive upwards, by CONTACT's rule (m_profile.f90, check_z_pos_down): the least z is not in
/// the outer twentieth at either end, as it is at a wheel's sides, but the greatest one is. Where neither is, as on a
/// hollow wheel, the point midway between them lies beyond the mean of both.
bool is_upside_down_wheel(const std::vector<ProfilePoint>& points) {
  const auto low = std::min_element(points.begin(), points.end(), has_less_z),
             high = std::max_element(points.begin(), points.end(), has_less_z);
  const auto is_outer = [](double share) {
    return share < ProfileThresholds::ends_of_wheel || share > 1 - ProfileThresholds::ends_of_wheel;
  };
  const double at_low = share_of(points, low), at_high = share_of(points, high);
  if (is_outer(at_low)) return false;
  if (is_outer(at_high)) return true;
  const auto middle = std::lround(static_cast<double>(points.size()) * (at_low + at_high) / 2);
  return points[static_cast<std::size_t>(middle - 1)].z > (low->z + high->z) / 2;
}

/// Whether a rail's z is positive upwards, by CONTACT's rule (there): at both ends, or at one where the other says
/// nothing, the first change of z that exceeds a thousandth of the whole height leads upwards. It is looked for in the
/// outer tenth of the points; where there is none, the least z is in the outer tenth.
bool is_upside_down_rail(const std::vector<ProfilePoint>& points) {
  const auto low = std::min_element(points.begin(), points.end(), has_less_z),
             high = std::max_element(points.begin(), points.end(), has_less_z);
  constexpr double ends = ProfileThresholds::ends_of_rail;
  const double least = ProfileThresholds::change_of_rail * std::max(ProfileThresholds::least_height, high->z - low->z);
  const auto n = static_cast<long>(points.size());
  const auto first_change = [&](long reach, bool from_end) { // inwards: +1, -1, or 0 where there is none
    const auto z = [&](long k) { return points[static_cast<std::size_t>(from_end ? n - 1 - k : k)].z; };
    for (long k = 1; k <= reach; ++k)
      if (std::abs(z(k) - z(0)) > least) return z(k) > z(0) ? 1 : -1;
    return 0;
  };
  const double count = static_cast<double>(n);
  const int start = first_change(std::lround(ends * count) - 1, false),
            end = first_change(n - std::lround((1 - ends) * count), true);
  if (start != 0 && end != 0) return start > 0 && end > 0;
  if (start != 0 || end != 0) return start + end > 0;
  const double at_low = share_of(points, low);
  return at_low < ends || at_low > 1 - ends;
}

/// The kinks, and where two of them, or the first one and the profile's beginning, have just one point between them
/// that one as well.
std::vector<std::size_t> with_points_between(const std::vector<std::size_t>& kinks) {
  std::vector<std::size_t> breaks;
  std::size_t last = 0;
  for (const std::size_t kink : kinks) {
    if (kink - last == 2) breaks.push_back(kink - 1);
    breaks.push_back(kink);
    last = kink;
  }
  return breaks;
}

/// Of ISMOOTH = 0, or of 1 and 2.
std::vector<double> smoothing_weights(const std::vector<ProfilePoint>& points, const std::vector<std::size_t>& kinks,
                                      bool by_length) {
  std::vector<double> weights(points.size(), 1);
  if (by_length) {
    weights = shares_of_length(points);
    for (double* end : {&weights.front(), &weights.back()}) *end *= 2 * ProfileThresholds::weight_of_ends;
  }
  for (const std::size_t kink : kinks) weights[kink] *= ProfileThresholds::weight_of_kinks;
  return weights;
}

class CurveReading {
public:
  CurveReading(const ProfileRecord& record, ProfileRole role) : record_(record), role_(role) {}

  std::shared_ptr<const ProfileCurve> curve_of_file() {
    read();
    points_ = without_zigzags(points_, record_.zigzag);
    return curve();
  }

  std::shared_ptr<const ProfileCurve> curve_through(std::vector<ProfilePoint> points) {
    points_ = std::move(points);
    drop_close_points(points_, ProfileThresholds::spacing);
    return curve();
  }

private:
  [[noreturn]] void fail(const std::string& text) const { throw Error(record_.file + ": " + text); }

  /// In CONTACT's order, in which rails ascend and wheels descend, until the spline is laid.
  std::shared_ptr<const ProfileCurve> curve() {
    if (points_.size() < 2) fail("there are fewer than two points");
    mirror();
    scale();
    const bool is_wheel = role_ == ProfileRole::wheel, descends = points_.front().y > points_.back().y;
    if (descends != is_wheel) std::reverse(points_.begin(), points_.end());
    check_length();
    check_crossing();
    auto kinks = with_points_between(find_kinks(points_, {record_.kink_high, record_.kink_low, record_.kink_width}));
    smooth(kinks);
    if (is_wheel) {
      std::reverse(points_.begin(), points_.end());
      std::reverse(kinks.begin(), kinks.end());
      for (std::size_t& kink : kinks) kink = points_.size() - 1 - kink;
    }
    for (ProfilePoint& p : points_) p = {mm * p.y, mm * p.z};
    return std::make_shared<ProfileCurve>(role_, points_, kinks);
  }

  void read() {
    format_ = format_of(record_.file);
    // In CONTACT's files of columns y is the first one, whatever the shape.
    io::ProfileFile file = io::parse_profile_file(format_, io::read_profile_text(record_.file), record_.file, 1, "y,z");
    if (file.role && *file.role != role_) fail("is not the profile of a " + std::string(to_string(role_)));
    if (format_ == io::ProfileFormat::simpack) unit_ = 1e3 * file.unit.value_or(1);
    mirrored_y_ = file.mirrored_y;
    mirrored_z_ = file.mirrored_z;
    points_ = std::move(file.points);
    drop_close_points(points_, file.least_distance ? std::max(ProfileThresholds::least_spacing, *file.least_distance)
                                                   : ProfileThresholds::spacing);
  }

  /// -1 undoes what the file itself asks for.
  void mirror() {
    if (record_.mirror_y == 1 || (record_.mirror_y == -1 && mirrored_y_))
      for (auto& p : points_) p.y = -p.y;
    bool turns = record_.mirror_z == 1 || (record_.mirror_z == -1 && mirrored_z_);
    if (record_.mirror_z == 0 && format_ != io::ProfileFormat::simpack)
      turns = role_ == ProfileRole::wheel ? is_upside_down_wheel(points_) : is_upside_down_rail(points_);
    if (turns)
      for (auto& p : points_) p.z = -p.z;
  }

  void scale() {
    const double factor = record_.scale * unit_;
    for (auto& p : points_) p = {factor * p.y, factor * p.z};
  }

  void check_length() const {
    double length = 0;
    for (std::size_t k = 1; k < points_.size(); ++k)
      length += std::hypot(points_[k].y - points_[k - 1].y, points_[k].z - points_[k - 1].z);
    if (!(length >= ProfileThresholds::shortest && length <= ProfileThresholds::longest))
      fail("the profile is " + std::to_string(length) + " mm long: must be in 5 to 500 mm");
  }

  void check_crossing() const {
    const auto found = find_crossing(points_);
    if (!found) return;
    const auto text = [this](std::size_t k) {
      return "(" + std::to_string(points_[k].y) + ", " + std::to_string(points_[k].z) + ") mm";
    };
    fail("the profile crosses itself behind " + text(found->first) + " and " + text(found->second));
  }

  void smooth(const std::vector<std::size_t>& kinks) {
    if (record_.smooth == 0) return;
    const double square = std::pow(record_.smooth / (2 * std::numbers::pi), 2);
    const double lambdas[] = {record_.smooth, smoothing_factor(record_.smooth), square * square * square};
    const auto penalty =
        record_.smoothing == 2 ? SmoothingPenalty::third_derivative : SmoothingPenalty::second_derivative;
    points_ = smoothed_with_weights(points_, kinks, lambdas[record_.smoothing],
                                    smoothing_weights(points_, kinks, record_.smoothing > 0), penalty);
  }

  const ProfileRecord& record_;
  ProfileRole role_;
  io::ProfileFormat format_ = io::ProfileFormat::columns;
  double unit_ = 1; ///< mm
  bool mirrored_y_ = false, mirrored_z_ = false;
  std::vector<ProfilePoint> points_;
};

} // namespace

bool is_variable(const ProfileRecord& record) {
  return io::names_slices(record.file);
}

std::shared_ptr<const ProfileCurve> read_profile_curve(const ProfileRecord& record, ProfileRole role) {
  return CurveReading(record, role).curve_of_file();
}

std::shared_ptr<const ProfileCurve> profile_curve_through(std::vector<ProfilePoint> points, const ProfileRecord& record,
                                                          ProfileRole role) {
  return CurveReading(record, role).curve_through(std::move(points));
}

ProfileShape read_profile_shape(const ProfileRecord& record, ProfileRole role) {
  if (!is_variable(record)) return {read_profile_curve(record, role)};
  const io::SlicesFile file = io::read_slices(record.file);
  if (file.role != role) throw Error(record.file + ": holds slices of a " + std::string(to_string(file.role)));
  ProfileShape shape;
  const double unit = role == ProfileRole::rail ? mm : 1; // of the place along the rail or around the wheel
  std::vector<ProfileWave> waves = file.waves;
  for (ProfileWave& wave : waves) wave.amplitude *= mm, wave.wavenumber /= unit;
  std::vector<ProfileSlice> slices;
  for (const io::SliceEntry& entry : file.slices) {
    ProfileRecord own = record;
    own.file = entry.file;
    const auto curve = read_profile_curve(own, role);
    if (!shape.curve) shape.curve = curve;
    slices.push_back({unit * entry.u, curve->profile(), in_si(entry.features, UnitList(entry.features.size(), 1))});
  }
  try {
    shape.surface = std::make_shared<ProfileSurface>(
        join_slices(slices, {file.method, file.kinks, waves, mm * ProfileThresholds::slice_spacing}));
  } catch (const Error& error) {
    throw Error(record.file + ": " + error.what());
  }
  return shape;
}

} // namespace microslip::contact_program
