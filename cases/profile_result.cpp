#include "cases/profile_result.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace microslip::cases {
namespace {

io::Json json_point(const ProfilePoint& point) {
  return {{"y", io::json_number(point.y)}, {"z", io::json_number(point.z)}};
}

io::Json json_optional(const std::optional<double>& value) {
  return value ? io::json_number(*value) : io::Json();
}

io::Json dimensions_document(const ProfileFindings& findings) {
  auto document = io::Json::object();
  if (findings.wheel) {
    document["tape_line"] = io::json_number(findings.wheel->tape_line);
    document["flange_height"] = json_optional(findings.wheel->flange_height);
    document["flange_thickness"] = json_optional(findings.wheel->flange_thickness);
    document["flange_gradient"] = json_optional(findings.wheel->flange_gradient);
    document["flange_angle"] = json_optional(findings.wheel->flange_angle);
    document["tape_circle"] = json_optional(findings.wheel->tape_circle);
  }
  if (findings.gauge) {
    document["gauge_point"] = json_point(findings.gauge->point);
    document["reaches_gauge_height"] = findings.gauge->reaches_height;
    document["top"] = json_point(findings.gauge->top);
  }
  return document;
}

/// Coordinates of points and curve as arrays of one file.
class CurveWriter {
public:
  explicit CurveWriter(io::ResultWriter& file) : file_(file) {}

  void points(const std::string& group, const std::vector<ProfilePoint>& points, const std::string& of) {
    std::vector<double> y, z;
    for (const auto& p : points) {
      y.push_back(p.y);
      z.push_back(p.z);
    }
    file_.array(group + "/y", y, "m", "y of " + of + ", to the field side");
    file_.array(group + "/z", z, "m", "z of " + of + ", up");
  }

  /// Three stations of each piece, none at a joint where the third derivative jumps or at a kink.
  void curve(const Profile& profile) {
    std::vector<ProfilePoint> values;
    std::vector<double> s, angle, curvature;
    for (const auto& piece : profile.pieces())
      for (const double t : {1 / 6., 3 / 6., 5 / 6.}) {
        s.push_back(piece.start + t * piece.length);
        const auto [value, first, second] = piece.at(s.back());
        values.push_back(value);
        angle.push_back(std::atan2(first.z, first.y));
        curvature.push_back((first.y * second.z - first.z * second.y) / std::pow(std::hypot(first.y, first.z), 3));
      }
    points("curve", values, "the spline");
    file_.array("curve/s", s, "m", "length along the polygon through the points, from the gauge side");
    file_.array("curve/angle", angle, "rad", "inclination of the curve, counted from y towards z");
    file_.array("curve/curvature", curvature, "1/m", "curvature, positive where the curve turns from y towards z");
  }

private:
  io::ResultWriter& file_;
};

void write_points_of_interest(const ProfileFindings& findings, io::ResultWriter& file) {
  if (findings.wheel) {
    const auto& wheel = *findings.wheel;
    file.scalar("dimensions/tape_line", wheel.tape_line, "m", "y of the tape line");
    const auto write = [&](const char* name, const std::optional<double>& value, const char* what,
                           const char* unit = "m") {
      if (value) file.scalar(std::string("dimensions/") + name, *value, unit, what);
    };
    write("flange_height", wheel.flange_height, "flange height Sh (EN 15313)");
    write("flange_thickness", wheel.flange_thickness, "flange thickness Sd (EN 15313)");
    write("flange_gradient", wheel.flange_gradient, "flange gradient qR (EN 15313)");
    write("flange_angle", wheel.flange_angle, "largest inclination of the flange's flank", "rad");
    write("tape_circle", wheel.tape_circle, "z of the tread at the tape line");
  }
  if (findings.gauge) {
    file.scalar("dimensions/gauge_y", findings.gauge->point.y, "m", "y of the gauge point");
    file.scalar("dimensions/gauge_z", findings.gauge->point.z, "m", "z of the gauge point");
    file.scalar("dimensions/gauge_height", findings.gauge_height, "m", "depth below the top that counts for the gauge");
    file.scalar("dimensions/top_y", findings.gauge->top.y, "m", "y of the top");
    file.scalar("dimensions/top_z", findings.gauge->top.z, "m", "z of the top");
  }
}

} // namespace

ProfileFindings find_dimensions(PreparedProfile prepared, const ProfileMeasures& measures) {
  ProfileFindings findings{std::move(prepared), {}, {}, measures.gauge_height};
  const Profile& profile = findings.prepared.profile;
  if (profile.role() == ProfileRole::wheel)
    findings.wheel = wheel_dimensions(profile, measures.tape_line ? *measures.tape_line : default_tape_line(profile));
  else
    findings.gauge = gauge_point(profile, measures.gauge_height);
  return findings;
}

io::Json profile_document(const ProfileFindings& findings) {
  const auto& profile = findings.prepared.profile;
  const auto& report = findings.prepared.report;
  auto document = io::Json::object();
  document["file_format"] = report.format;
  document["role"] = to_string(profile.role());
  document["comment"] = report.comment;
  document["unit"] = io::json_number(report.unit);
  document["points_read"] = report.points_read;
  document["points"] = report.points;
  document["length"] = io::json_number(profile.length());
  document["noise"] = {{"deviation", io::json_number(report.noise.deviation)},
                       {"curvature", io::json_number(report.noise.curvature)},
                       {"long_waves", io::json_number(report.noise.long_waves)},
                       {"smoothing_length", io::json_number(report.noise.smoothing_length)}};
  document["smoothing_length"] = io::json_number(report.smoothing.length);
  document["smoothing"] = {{"by_noise", report.smoothing.by_noise},
                           {"mean_move", io::json_number(report.smoothing.mean_move)},
                           {"largest_move", io::json_number(report.smoothing.largest_move)},
                           {"curvature_change", io::json_number(report.smoothing.curvature_change)},
                           {"curvature_left", io::json_number(report.smoothing.curvature_left)},
                           {"pressure_left", io::json_number(report.smoothing.pressure_left)}};
  document["dimensions"] = dimensions_document(findings);
  auto kinks = io::Json::array();
  for (const auto& kink : report.kinks)
    kinks.push_back({{"y", io::json_number(kink.point.y)},
                     {"z", io::json_number(kink.point.z)},
                     {"s", io::json_number(kink.s)},
                     {"angle", io::json_number(kink.angle)}});
  document["kinks"] = kinks;
  document["steps"] = report.steps;
  document["assumptions"] = report.assumptions;
  document["warnings"] = report.warnings;
  document["units"] = {{"unit", "m"},
                       {"length", "m"},
                       {"smoothing_length", "m"},
                       {"noise/deviation", "m"},
                       {"noise/curvature", "1/m"},
                       {"noise/long_waves", "m"},
                       {"noise/smoothing_length", "m"},
                       {"smoothing/mean_move", "m"},
                       {"smoothing/largest_move", "m"},
                       {"smoothing/curvature_change", "1/m"},
                       {"smoothing/curvature_left", "1/m"},
                       {"smoothing/pressure_left", "-"},
                       {"dimensions", "m"},
                       {"kinks/y", "m"},
                       {"kinks/z", "m"},
                       {"kinks/s", "m"},
                       {"kinks/angle", "rad"}};
  return document;
}

void write_result(const ProfileFindings& findings, io::ResultWriter& file) {
  const auto& prepared = findings.prepared;
  file.text("role", std::string(to_string(prepared.profile.role())), "rail or wheel");
  CurveWriter curves(file);
  curves.points("measured", prepared.measured, "the points before smoothing");
  curves.curve(prepared.profile);
  std::vector<ProfilePoint> kinks;
  for (const auto& kink : prepared.report.kinks) kinks.push_back(kink.point);
  if (!kinks.empty()) curves.points("kinks", kinks, "the kinks");
  write_points_of_interest(findings, file);
}

} // namespace microslip::cases
