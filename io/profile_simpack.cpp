#include "io/nearest_word.hpp"
#include "io/profile_formats.hpp"
#include "io/text_line.hpp"
#include "microslip/railway/profile/report_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace microslip::io {
namespace {

constexpr auto known_keys = std::to_array<std::string_view>(
    {"version",        "type",        "approx.smooth", "file",        "file.mtime",  "comment",
     "point.dist.min", "shift.y",     "shift.z",       "rotate",      "bound.y.min", "bound.y.max",
     "bound.z.min",    "bound.z.max", "mirror.y",      "mirror.z",    "inversion",   "units.len",
     "units.len.f",    "units.ang",   "units.ang.f",   "meas_pos.y",  "meas_pos.z",  "meas_pos.x",
     "date",           "time",        "name",          "header.type", "point.count", "point.weight"});

/// Removes a comment, which begins with ! or % outside of quotes.
std::string_view without_comment(std::string_view line) {
  char quote = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quote != 0)
      quote = c == quote ? '\0' : quote;
    else if (c == '\'' || c == '"')
      quote = c;
    else if (c == '!' || c == '%')
      return trimmed(line.substr(0, i));
  }
  return line;
}

class SimpackReader {
public:
  explicit SimpackReader(ProfileLines lines) : lines_(std::move(lines)) {}

  ProfileFile read() {
    while (lines_.next()) {
      const auto line = without_comment(lines_.line());
      if (!line.empty()) read_line(line);
    }
    if (block_ == "point.begin") lines_.fail_as_a_whole("the file ends before point.end; is it truncated?");
    if (file_.points.empty()) lines_.fail_as_a_whole("there are no points between point.begin and point.end");
    file_.points_read = file_.points.size();
    describe();
    process();
    return std::move(file_);
  }

private:
  void read_line(std::string_view line) {
    if (line.ends_with(".begin"))
      block_ = line;
    else if (line.ends_with(".end"))
      block_.clear();
    else if (block_ == "point.begin")
      read_point(line);
    else
      read_key(line);
  }

  void read_point(std::string_view line) {
    const auto fields = split(line, ",;");
    if (fields.size() < 2 || fields.size() > 3)
      lines_.fail(counted(fields.size(), "field") + ", not y, z and perhaps a weight");
    file_.points.push_back({lines_.number(fields[0], "y"), lines_.number(fields[1], "z")});
    if (fields.size() == 3 && lines_.number(fields[2], "weight") != 1) ++weighted_;
  }

  void read_key(std::string_view line) {
    const auto sign = line.find('=');
    if (sign == std::string_view::npos)
      lines_.fail(printable(line) + " is neither KEY = VALUE nor a block's begin or end");
    const auto key = trimmed(line.substr(0, sign));
    const auto value = trimmed(line.substr(sign + 1));
    if (std::find(known_keys.begin(), known_keys.end(), key) == known_keys.end())
      file_.warnings.push_back("unknown key " + printable(key) + suggestion(key, known_keys));
    // `type` of the header is the profile's, that of the spline is of the file from which it was made.
    if (key == "type" && block_ != "header.begin") return;
    if (key == "units.len") place_of_unit_ = lines_.place();
    if (is_text(key))
      texts_[std::string(key)] = unquoted(value);
    else if (std::find(known_keys.begin(), known_keys.end(), key) != known_keys.end())
      numbers_[std::string(key)] = lines_.number(value, key);
  }

  static bool is_text(std::string_view key) {
    constexpr auto texts = std::to_array<std::string_view>(
        {"file", "comment", "units.len", "units.ang", "date", "time", "name", "version", "file.mtime"});
    return std::find(texts.begin(), texts.end(), key) != texts.end();
  }

  double number(const std::string& key, double otherwise) const {
    const auto found = numbers_.find(key);
    return found == numbers_.end() ? otherwise : found->second;
  }

  std::string text(const std::string& key) const {
    const auto found = texts_.find(key);
    return found == texts_.end() ? "" : found->second;
  }

  void describe() {
    file_.comment = text("comment");
    file_.y_axis = LateralSense::field;
    file_.z_axis = VerticalSense::down;
    if (numbers_.contains("type")) {
      const double type = number("type", 0);
      if (type != 0 && type != 1) lines_.fail_as_a_whole("type = " + digits(type) + " in the header: must be 0 or 1");
      file_.role = type == 0 ? ProfileRole::rail : ProfileRole::wheel;
    }
    if (numbers_.contains("units.len.f")) {
      const double per_metre = number("units.len.f", 1);
      if (!(per_metre > 0)) lines_.fail_as_a_whole("units.len.f = " + digits(per_metre) + ": must be positive");
      file_.unit = 1 / per_metre;
    } else if (const auto unit = lower_case(text("units.len")); unit == "mm" || unit == "m") {
      file_.unit = unit == "m" ? 1 : 1e-3;
    } else if (!unit.empty()) {
      file_.stated_unit = {text("units.len"), place_of_unit_};
    }
    if (weighted_ > 0) file_.warnings.push_back("weights of " + counted(weighted_, "point") + " are not used");
    if (const double value = number("approx.smooth", 0); value != 0)
      file_.warnings.push_back("approx.smooth = " + digits(value) + " is not used; ask for a smoothing length");
  }

  /// Processes in the order that the files' comments number: 1 distances, 2 shift, 3 rotation, 4 bounds, 5 mirrors, 6
  /// inversion; 7, the unit, is the caller's.
  void process() {
    if (numbers_.contains("point.dist.min")) file_.least_distance = number("point.dist.min", 0);
    drop_close(file_.least_distance.value_or(0));
    shift(number("shift.y", 0), number("shift.z", 0));
    rotate(number("rotate", 0));
    apply_bounds();
    mirror();
    if (number("inversion", 0) != 0) {
      std::reverse(file_.points.begin(), file_.points.end());
      file_.steps.emplace_back("inversion: order of the points reversed");
    }
  }

  void drop_close(double distance) {
    if (!(distance > 0)) return;
    const auto close = [distance](const ProfilePoint& a, const ProfilePoint& b) {
      return std::hypot(b.y - a.y, b.z - a.z) < distance;
    };
    const std::size_t before = file_.points.size();
    file_.points.erase(std::unique(file_.points.begin(), file_.points.end(), close), file_.points.end());
    if (before > file_.points.size())
      file_.steps.push_back("point.dist.min: dropped " + counted(before - file_.points.size(), "point"));
  }

  void shift(double y, double z) {
    if (y == 0 && z == 0) return;
    for (auto& p : file_.points) p = {p.y + y, p.z + z};
    file_.steps.push_back("shifted by (" + digits(y) + ", " + digits(z) + ") in the file's unit");
  }

  /// About x, from y towards z as they run in the file.
  void rotate(double angle) {
    if (angle == 0) return;
    const bool in_degrees = !numbers_.contains("units.ang.f") && lower_case(text("units.ang")) == "deg";
    const double per_radian = number("units.ang.f", in_degrees ? 180 / std::numbers::pi : 1);
    if (!(per_radian > 0)) lines_.fail_as_a_whole("units.ang.f = " + digits(per_radian) + ": must be positive");
    const double radians = angle / per_radian, c = std::cos(radians), s = std::sin(radians);
    for (auto& p : file_.points) p = {c * p.y - s * p.z, s * p.y + c * p.z};
    file_.steps.push_back("rotated by " + digits(radians) + " rad from y towards z");
  }

  /// Bounds of y drop points, those of z clip them; min > max means none.
  void apply_bounds() {
    auto& points = file_.points;
    const double y_min = number("bound.y.min", 1), y_max = number("bound.y.max", 0);
    if (y_min < y_max) {
      const std::size_t before = points.size();
      std::erase_if(points, [&](const ProfilePoint& p) { return p.y < y_min || p.y > y_max; });
      file_.steps.push_back("bound.y: dropped " + counted(before - points.size(), "point"));
    }
    const double z_min = number("bound.z.min", 1), z_max = number("bound.z.max", 0);
    if (z_min < z_max) {
      std::size_t clipped = 0;
      for (auto& p : points) {
        const double z = std::clamp(p.z, z_min, z_max);
        if (z != p.z) ++clipped;
        p.z = z;
      }
      file_.steps.push_back("bound.z: clipped " + counted(clipped, "point"));
    }
  }

  void mirror() {
    const bool y = file_.mirrored_y = number("mirror.y", 0) == 1, z = file_.mirrored_z = number("mirror.z", 0) == 1;
    for (auto& p : file_.points) p = {y ? -p.y : p.y, z ? -p.z : p.z};
    if (y) file_.steps.emplace_back("mirror.y: sign of y changed");
    if (z) file_.steps.emplace_back("mirror.z: sign of z changed");
  }

  ProfileLines lines_;
  ProfileFile file_;
  std::string block_, place_of_unit_;
  std::map<std::string, double> numbers_;
  std::map<std::string, std::string> texts_;
  std::size_t weighted_ = 0;
};

} // namespace

ProfileFile parse_simpack(ProfileLines lines) {
  return SimpackReader(std::move(lines)).read();
}

} // namespace microslip::io
