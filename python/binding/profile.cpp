#include "binding/profile.hpp"

#include "binding/bindings.hpp"
#include "binding/paths.hpp"
#include "binding/value.hpp"
#include "binding/words.hpp"
#include "io/output_file.hpp"
#include "io/profile_writer.hpp"
#include "io/sliced_profile.hpp"
#include "microslip/error.hpp"
#include "microslip/railway/profile/profile_dimensions.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace microslip::python {

template <>
inline constexpr auto fields<ProfileKink> = members<&ProfileKink::point, &ProfileKink::s, &ProfileKink::angle>;
template <>
inline constexpr auto fields<ProfileNoise> = members<&ProfileNoise::deviation, &ProfileNoise::curvature,
                                                     &ProfileNoise::long_waves, &ProfileNoise::smoothing_length>;
template <>
inline constexpr auto fields<ProfileSmoothing> =
    members<&ProfileSmoothing::length, &ProfileSmoothing::by_noise, &ProfileSmoothing::mean_move,
            &ProfileSmoothing::largest_move, &ProfileSmoothing::curvature_change, &ProfileSmoothing::curvature_left,
            &ProfileSmoothing::pressure_left>;
template <>
inline constexpr auto fields<ProfileReport> =
    members<&ProfileReport::source, &ProfileReport::format, &ProfileReport::comment, &ProfileReport::unit,
            &ProfileReport::points_read, &ProfileReport::points, &ProfileReport::steps, &ProfileReport::assumptions,
            &ProfileReport::warnings, &ProfileReport::kinks, &ProfileReport::noise, &ProfileReport::smoothing>;
template <>
inline constexpr auto fields<WheelDimensions> =
    members<&WheelDimensions::tape_line, &WheelDimensions::flange_height, &WheelDimensions::flange_thickness,
            &WheelDimensions::flange_gradient, &WheelDimensions::flange_angle, &WheelDimensions::tape_circle>;
template <>
inline constexpr auto fields<GaugePoint> =
    members<&GaugePoint::point, &GaugePoint::s, &GaugePoint::top, &GaugePoint::reaches_height>;

/// State of a profile in a pickle: its spline is made anew from the points and kinks.
struct ProfileState {
  ProfileRole role = ProfileRole::rail;
  std::vector<ProfilePoint> points = {}, measured = {};
  std::vector<std::size_t> kinks = {};
  ProfileReport report = {};
};
template <>
inline constexpr auto fields<ProfileState> =
    members<&ProfileState::role, &ProfileState::points, &ProfileState::measured, &ProfileState::kinks,
            &ProfileState::report>;

namespace {

namespace py = pybind11;
using namespace py::literals;

ProfileState state_from(const ProfileValue& self) {
  const auto kinks = self.profile().kinks();
  return {self.profile().role(),
          self.prepared->points,
          self.prepared->measured,
          {kinks.begin(), kinks.end()},
          self.report()};
}

} // namespace

bool ProfileValue::operator==(const ProfileValue& other) const {
  if (surface != other.surface) return false;
  return prepared == other.prepared || are_equal(state_from(*this), state_from(other));
}

pybind11::object state_of(const ProfileValue& self) {
  if (self.surface)
    throw Error(self.report().source + ": a profile that varies cannot be pickled: read its file again");
  return state_of(state_from(self));
}

void read_state(const pybind11::handle& state, const std::string& name, ProfileValue& self) {
  ProfileState given;
  read_state(state, name, given);
  Profile profile(given.role, given.points, given.kinks);
  self.prepared = std::make_shared<const PreparedProfile>(
      PreparedProfile{std::move(profile), std::move(given.points), std::move(given.measured), std::move(given.report)});
}

namespace {

ProfileValue shared(PreparedProfile prepared) {
  return {std::make_shared<const PreparedProfile>(std::move(prepared))};
}

/// `trim` is None or two values.
ProfileTreatment treatment_of(std::optional<double> smoothing_length,
                              const std::optional<std::pair<double, double>>& trim) {
  ProfileTreatment treatment;
  if (smoothing_length) treatment.smoothing_length = require_between("smoothing_length", *smoothing_length, "m", 0, 1);
  if (trim) {
    treatment.y_min = require_finite("trim", trim->first, "m");
    treatment.y_max = require_finite("trim", trim->second, "m");
  }
  return treatment;
}

ProfileValue from_points(const py::object& y, const py::object& z, ProfileRole kind,
                         std::optional<double> smoothing_length, const std::optional<std::pair<double, double>>& trim) {
  const auto ys = real_array("y", y);
  const auto zs = real_array("z", z, Shape{ys.size()});
  std::vector<ProfilePoint> points;
  for (py::ssize_t k = 0; k < ys.size(); ++k) points.push_back({ys.data()[k], zs.data()[k]});
  return shared(prepare_profile(kind, std::move(points), treatment_of(smoothing_length, trim)));
}

/// A coordinate of a prepared profile's points.
auto coordinates(std::vector<ProfilePoint> PreparedProfile::*points, double ProfilePoint::*coordinate) {
  return [points, coordinate](const ProfileValue& self) {
    const auto& all = (*self.prepared).*points;
    return array_of<double>({static_cast<py::ssize_t>(all.size())}, all, [&](const auto& p) { return p.*coordinate; });
  };
}

/// A function of s at a number or an array.
template <class Function> py::object along(const py::object& s, const Function& function) {
  return mapped("s", s, "s", py::float_(0.0), [&](double at, double) { return function(at); });
}

double curvature(const CurvePoint& p) {
  return (p.first.y * p.second.z - p.first.z * p.second.y) / std::pow(std::hypot(p.first.y, p.first.z), 3);
}

void write(const ProfileValue& self, const py::object& path) {
  io::require_one_section(self.report(), self.surface, "a profile's file");
  const std::string name = path_from(path);
  const auto format = io::format_of_ending(name, self.profile().role());
  io::OutputFile file(name);
  file.write(io::profile_text(*self.prepared, format));
  file.commit();
}

// The report

std::string to_text(const ProfileReport& report) {
  std::string text = report.source.empty() ? "profile" : report.source + " (" + report.format + ")";
  text += ": " + std::to_string(report.points) + " points of " + std::to_string(report.points_read) + ", " +
          std::to_string(report.kinks.size()) + " kinks";
  const auto add = [&](const char* heading, const std::vector<std::string>& lines) {
    for (const auto& line : lines) text += std::string("\n") + heading + line;
  };
  add("  done: ", report.steps);
  add("  assumed: ", report.assumptions);
  add("  warning: ", report.warnings);
  return text;
}

void bind_report(py::module_& module) {
  auto kink = py::class_<ProfileKink>(module, "ProfileKink", "A corner of a profile, at which its spline is cut.");
  kink.def_property_readonly(
          "y", [](const ProfileKink& self) { return self.point.y; }, "[m], to the field side.")
      .def_property_readonly(
          "z", [](const ProfileKink& self) { return self.point.z; }, "[m], up.")
      .def_readonly("s", &ProfileKink::s, "Length along the polygon through the points [m].")
      .def_readonly("angle", &ProfileKink::angle, "By which the direction turns [rad], positive from y to z.");
  add_value(kink, {"y", "z", "s", "angle"});

  auto report = py::class_<ProfileReport>(
      module, "ProfileReport", "What was done to a profile's points and what is conspicuous about them; print it.");
  add_members(report, Shown<&ProfileReport::source>{"The file's name; empty without one."},
              Shown<&ProfileReport::format>{"Simpack, MiniProf or columns; empty without a file."},
              Shown<&ProfileReport::comment>{"From the file."},
              Shown<&ProfileReport::unit>{"Length of the file's unit with the scale [m]."},
              Shown<&ProfileReport::points_read>{"Points in the file or arrays [-]."},
              Shown<&ProfileReport::points>{"Points that the spline is laid through [-]."},
              Shown<&ProfileReport::steps>{"What was done to the points, in order."},
              Shown<&ProfileReport::assumptions>{"What neither the file nor an argument says."},
              Shown<&ProfileReport::warnings>{"What is probably wrong."},
              Shown<&ProfileReport::kinks>{"Corners, as ProfileKink."});
  report
      .def_property_readonly(
          "noise", [](const ProfileReport& self) { return self.noise.deviation; },
          "Standard deviation of the points across the curve [m].")
      .def_property_readonly(
          "curvature_noise", [](const ProfileReport& self) { return self.noise.curvature; },
          "Standard deviation of the curvature that follows from the noise [1/m].")
      .def_property_readonly(
          "recommended_smoothing_length", [](const ProfileReport& self) { return self.noise.smoothing_length; },
          "Wavelength of smoothing with the best peak pressures [m]; 0: the points do not scatter.")
      .def_property_readonly(
          "smoothing_length", [](const ProfileReport& self) { return self.smoothing.length; },
          "Wavelength of smoothing that was asked for [m]; 0: none.")
      .def_property_readonly(
          "smoothed_by_noise", [](const ProfileReport& self) { return self.smoothing.by_noise; },
          "Whether the points were smoothed by their noise, since they scatter and smoothing_length was None.")
      .def_property_readonly(
          "mean_move", [](const ProfileReport& self) { return self.smoothing.mean_move; },
          "Root mean square of what smoothing moved the points by [m].")
      .def_property_readonly(
          "largest_move", [](const ProfileReport& self) { return self.smoothing.largest_move; },
          "Largest move of a point by smoothing [m].")
      .def_property_readonly(
          "curvature_change", [](const ProfileReport& self) { return self.smoothing.curvature_change; },
          "Root mean square of what smoothing changed the polygon's curvature by [1/m].")
      .def_property_readonly(
          "curvature_left", [](const ProfileReport& self) { return self.smoothing.curvature_left; },
          "Standard deviation of the curvature of 6 mm that smoothing by noise leaves [1/m], median of the profile.")
      .def_property_readonly(
          "pressure_left", [](const ProfileReport& self) { return self.smoothing.pressure_left; },
          "The same of the peak pressure of a straight tread on a head of radius 300 mm, relative [-].");
  report.def("__repr__", &to_text); // before the one of add_value
  add_value(report, {"source", "points"});
}

void bind_dimensions(py::module_& module) {
  auto wheel = py::class_<WheelDimensions>(module, "WheelDimensions",
                                           "A flange's dimensions by EN 15313; None where the profile does not reach.");
  add_fields(wheel, {"y of the tape line [m], 70 mm from the flange's back.", "Sh [m], from the tape line to the tip.",
                     "Sd [m], from the back, at 10 mm from the tape line towards the tip.",
                     "qR [m], width from there to the flank 2 mm short of the tip.",
                     "Largest inclination of the flank between tip and tape line [rad].",
                     "z of the tread at the tape line [m]."});
  add_value(wheel);
  auto gauge = py::class_<GaugePoint>(module, "GaugePoint", "Where a rail's gauge is measured.");
  gauge
      .def_property_readonly(
          "y", [](const GaugePoint& self) { return self.point.y; }, "[m], to the field side.")
      .def_property_readonly(
          "z", [](const GaugePoint& self) { return self.point.z; }, "[m], up.")
      .def_property_readonly(
          "top", [](const GaugePoint& self) { return std::pair(self.top.y, self.top.z); },
          "y and z of the highest point [m].")
      .def_readonly("s", &GaugePoint::s, "Length along the curve [m].")
      .def_readonly("reaches_height", &GaugePoint::reaches_height,
                    "True if the profile reaches down to the gauge's height.");
  add_value(gauge, {"y", "z", "top", "reaches_height"});
}

void bind_curve(py::class_<ProfileValue>& profile) {
  profile
      .def_property_readonly(
          "kind", [](const ProfileValue& self) { return self.profile().role(); }, "rail or wheel.")
      .def_property_readonly(
          "length", [](const ProfileValue& self) { return self.profile().length(); },
          "Length of the polygon through the points [m], the largest s.")
      .def_property_readonly(
          "extent",
          [](const ProfileValue& self) {
            return self.surface ? std::optional(std::pair(self.surface->first_u(), self.surface->last_u()))
                                : std::nullopt;
          },
          "Positions of the first and the last slice of a varying profile, along the track [m] or around the\n"
          "wheel [rad]; else None. Its points are those of the first one.")
      .def_property_readonly("y", coordinates(&PreparedProfile::points, &ProfilePoint::y),
                             "y of the points that the spline is laid through [m], shape (n).")
      .def_property_readonly("z", coordinates(&PreparedProfile::points, &ProfilePoint::z),
                             "z of these points [m], shape (n).")
      .def_property_readonly("measured_y", coordinates(&PreparedProfile::measured, &ProfilePoint::y),
                             "y of the points before smoothing [m], shape (n).")
      .def_property_readonly("measured_z", coordinates(&PreparedProfile::measured, &ProfilePoint::z),
                             "z of these points [m], shape (n).")
      .def_property_readonly(
          "report", [](const ProfileValue& self) { return self.report(); }, "The ProfileReport.")
      .def(
          "point",
          [](const ProfileValue& self, const py::object& s) {
            return py::make_tuple(along(s, [&](double at) { return self.profile().at(at).value.y; }),
                                  along(s, [&](double at) { return self.profile().at(at).value.z; }));
          },
          "s"_a,
          "y and z [m] of the curve at s [m], a number or an array, shape (...); straight lines beyond its ends.")
      .def(
          "angle",
          [](const ProfileValue& self, const py::object& s) {
            return along(s, [&](double at) {
              const auto first = self.profile().at(at).first;
              return std::atan2(first.z, first.y);
            });
          },
          "s"_a, "Inclination [rad] of the curve at s [m], from y towards z.")
      .def(
          "curvature",
          [](const ProfileValue& self, const py::object& s) {
            return along(s, [&](double at) { return curvature(self.profile().at(at)); });
          },
          "s"_a, "Curvature [1/m] at s [m], positive where the curve turns from y towards z.");
}

} // namespace

void bind_profile(py::module_& module) {
  bind_report(module);
  bind_dimensions(module);
  auto profile = py::class_<ProfileValue>(
      module, "Profile",
      "The cross-section of a rail, or of a wheel through its axle: cubic splines between kinks, y to the field side,\n"
      "z up, from the gauge side to the field side, or from the back of the flange to the outer face.");
  profile.def(
      py::init(&from_points), "y"_a, "z"_a, "kind"_a, py::kw_only(), "smoothing_length"_a = py::none(),
      "trim"_a = py::none(),
      "Points y, z [m], shape (n), in any order along the curve; smoothing_length [m], 0: none, None: by the points'\n"
      "noise, if they scatter; trim drops the ends with y outside (y_min, y_max) [m]. Error for fewer than 4 points,\n"
      "for a length outside 5 mm to 500 mm, and for a curve that crosses itself; the report says what was done and\n"
      "what looks wrong.");
  bind_curve(profile);
  profile
      .def(
          "wheel_dimensions",
          [](const ProfileValue& self, std::optional<double> tape_line) {
            if (self.profile().role() != ProfileRole::wheel) throw Error("wheel_dimensions: the profile is of a rail");
            return wheel_dimensions(self.profile(), tape_line.value_or(default_tape_line(self.profile())));
          },
          "tape_line"_a = py::none(),
          "WheelDimensions by EN 15313 from the tape line's y [m]; None: 0 if the profile begins about 70 mm on the\n"
          "flange's side of its origin, else 70 mm from its first point.")
      .def(
          "gauge_point",
          [](const ProfileValue& self, double height) {
            if (self.profile().role() != ProfileRole::rail) throw Error("gauge_point: the profile is of a wheel");
            return gauge_point(self.profile(), height);
          },
          "height"_a = 0.014, "The GaugePoint, at most `height` [m] below the top, > 0.")
      .def("write", &write, "path"_a,
           "Writes the points [mm] as the file's ending says: .prr, .prw, .ban, .whl, columns for others.");
  add_value(profile, {"kind", "length", "report"});
  module.def(
      "read_profile",
      [](const py::object& path, std::optional<ProfileRole> kind, std::optional<io::ProfileFormat> format,
         std::optional<double> unit, double scale, std::optional<io::LateralSense> y_axis,
         std::optional<io::VerticalSense> z_axis, std::optional<TrackSide> side, const std::string& columns,
         std::optional<double> flange_thickness, int section, std::optional<double> smoothing_length,
         const std::optional<std::pair<double, double>>& trim) {
        const io::ProfileFileOptions options = {.format = format,
                                                .role = kind,
                                                .unit = unit,
                                                .scale = scale,
                                                .y_axis = y_axis,
                                                .z_axis = z_axis,
                                                .side = side,
                                                .columns = columns,
                                                .flange_thickness = flange_thickness,
                                                .section = section,
                                                .treatment = treatment_of(smoothing_length, trim)};
        io::PlacedProfile placed = io::read_placed_profile(
            io::names_standard(path_from(path)) ? path_from(path) : readable_path(path), options);
        ProfileValue value = shared(placed);
        value.surface = placed.surface;
        return value;
      },
      "path"_a, py::kw_only(), "kind"_a = py::none(), "format"_a = py::none(), "unit"_a = py::none(), "scale"_a = 1.0,
      "y_axis"_a = py::none(), "z_axis"_a = py::none(), "side"_a = py::none(), "columns"_a = "",
      "flange_thickness"_a = py::none(), "section"_a = 1, "smoothing_length"_a = py::none(), "trim"_a = py::none(),
      "The Profile in a file: Simpack .prr .prw, MiniProf .ban .whl .mpt, columns of y and z, or slices .slcs .slcw "
      "of\n"
      "a rail that varies along the track and of a wheel that is not round. What the file does not\n"
      "say can be given: kind, format, unit (its length [m], e.g. 1e-3), the side to which y runs (y_axis), where z "
      "is\n"
      "positive (z_axis); what neither says is assumed, and the report names it. scale [-] enlarges, section chooses "
      "one\n"
      "of several profiles of a .mpt file, smoothing_length [m] and trim [m] are as in Profile. side, left or right, "
      "says\n"
      "on which side of the track a file lies whose y runs to the left on both; columns names those of a file, "
      "\"z,y\".\n"
      "S1002, 60E1, 54E1, cone-1:20 and cone-1:40 in place of a path, if there is no such file, are profiles of "
      "standards,\n"
      "wheels with a flange_thickness [m].");
}

} // namespace microslip::python
