#include "compat/contact/wheel_rail/profile_reading.hpp"

#include "compat/contact/wheel_rail/profile_thresholds.hpp"
#include "io/profile_formats.hpp"
#include "io/slices_file.hpp"
#include "microslip/error.hpp"
#include "microslip/railway/profile/profile_kinks.hpp"
#include "microslip/railway/profile/profile_preparation.hpp"
#include "microslip/railway/profile/profile_slices.hpp"
#include "microslip/railway/profile/profile_smoothing.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

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

void drop_close_points(std::vector<ProfilePoint>& points) {
  const auto close = [](const ProfilePoint& a, const ProfilePoint& b) {
    return std::hypot(b.y - a.y, b.z - a.z) < ProfileThresholds::spacing;
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

class CurveReading {
public:
  CurveReading(const ProfileRecord& record, ProfileRole role) : record_(record), role_(role) {}

  std::shared_ptr<const ProfileCurve> curve_of_file() {
    read();
    return curve();
  }

  std::shared_ptr<const ProfileCurve> curve_through(std::vector<ProfilePoint> points) {
    points_ = std::move(points);
    return curve();
  }

private:
  [[noreturn]] void fail(const std::string& text) const { throw Error(record_.file + ": " + text); }

  std::shared_ptr<const ProfileCurve> curve() {
    drop_close_points(points_);
    points_ = without_zigzags(points_, record_.zigzag);
    if (points_.size() < 2) fail("there are fewer than two points");
    mirror();
    scale();
    if (points_.front().y > points_.back().y) std::reverse(points_.begin(), points_.end());
    check_length();
    const auto kinks = find_kinks(points_, {record_.kink_high, record_.kink_low, record_.kink_width});
    smooth(kinks);
    return std::make_shared<ProfileCurve>(role_, points_, kinks);
  }

  void read() {
    format_ = format_of(record_.file);
    io::ProfileFile file = io::parse_profile_file(format_, io::read_profile_text(record_.file), record_.file);
    if (file.role && *file.role != role_) fail("is not the profile of a " + std::string(to_string(role_)));
    if (format_ == io::ProfileFormat::simpack) unit_ = 1e3 * file.unit.value_or(1);
    points_ = std::move(file.points);
  }

  void mirror() {
    if (record_.mirror_y == 1)
      for (auto& p : points_) p.y = -p.y;
    bool turns = record_.mirror_z == 1;
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

  void smooth(const std::vector<std::size_t>& kinks) {
    if (record_.smooth == 0) return;
    if (record_.smoothing == 2) fail("ISMOOTH = 2 (smoothing by B-splines) is not supported");
    if (record_.smoothing == 0) {
      points_ = smoothed_without_weights(points_, kinks, record_.smooth);
      return;
    }
    constexpr double mm = 1e-3;
    for (auto& p : points_) p = {mm * p.y, mm * p.z};
    points_ = smoothed(points_, kinks, mm * record_.smooth);
    for (auto& p : points_) p = {p.y / mm, p.z / mm};
  }

  const ProfileRecord& record_;
  ProfileRole role_;
  io::ProfileFormat format_ = io::ProfileFormat::columns;
  double unit_ = 1; ///< mm
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
  std::vector<ProfileSlice> slices;
  for (const io::SliceEntry& entry : file.slices) {
    ProfileRecord own = record;
    own.file = entry.file;
    const auto curve = read_profile_curve(own, role);
    if (!shape.curve) shape.curve = curve;
    slices.push_back({entry.u, curve->profile(), entry.features});
  }
  try {
    shape.surface = std::make_shared<ProfileSurface>(
        join_slices(slices, {file.method, file.kinks, file.waves, ProfileThresholds::slice_spacing}));
  } catch (const Error& error) {
    throw Error(record.file + ": " + error.what());
  }
  return shape;
}

} // namespace microslip::contact_program
