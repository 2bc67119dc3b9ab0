#include "microslip/railway/profile/standard_profile.hpp"

#include "microslip/error.hpp"
#include "microslip/numerics/bracketed_root.hpp"
#include "microslip/railway/profile/report_text.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

namespace microslip {
namespace {

// Lengths here are in mm and z is positive downwards, as in the standards.

constexpr double spacing = 0.25;

/// A curve that grows part by part, each one from where the last one ended.
class Outline {
public:
  /// Part of a circle between two angles, counted from y towards z.
  void arc(ProfilePoint centre, double radius, double from, double to) {
    add(radius * std::abs(to - from), [=](double part) {
      const double angle = from + (to - from) * part;
      return ProfilePoint{centre.y + radius * std::cos(angle), centre.z + radius * std::sin(angle)};
    });
  }
  /// Part of a circle above its centre between two inclinations.
  void crown(ProfilePoint centre, double radius, double from, double to) {
    add(radius * std::abs(to - from), [=](double part) {
      const double angle = from + (to - from) * part;
      return ProfilePoint{centre.y + radius * std::sin(angle), centre.z - radius * std::cos(angle)};
    });
  }
  /// Part of a circle between two y, on the side of larger z than the centre's (`side` 1) or of lesser (-1).
  void arc_between(ProfilePoint centre, double radius, double from_y, double to_y, double side) {
    const auto angle = [&](double y) { return side * std::acos(std::clamp((y - centre.y) / radius, -1., 1.)); };
    arc(centre, radius, angle(from_y), angle(to_y));
  }
  template <class Function> void curve(double from_y, double to_y, const Function& z) {
    add(std::abs(to_y - from_y), [&](double part) {
      const double y = from_y + (to_y - from_y) * part;
      return ProfilePoint{y, z(y)};
    });
  }
  void line(ProfilePoint from, ProfilePoint to) {
    add(std::hypot(to.y - from.y, to.z - from.z), [=](double part) {
      return ProfilePoint{from.y + (to.y - from.y) * part, from.z + (to.z - from.z) * part};
    });
  }

  ProfilePoint end() const { return points_.back(); }
  /// In m, z up.
  std::vector<ProfilePoint> points() const {
    std::vector<ProfilePoint> result;
    for (const auto& p : points_) result.push_back({p.y * 1e-3, 0 - p.z * 1e-3});
    return result;
  }

private:
  /// Points at equal steps; where two parts meet the first one's stays.
  template <class Function> void add(double length, const Function& at) {
    constexpr double nothing = 1e-9;
    if (length < nothing) return;
    const int steps = std::max(1, static_cast<int>(std::ceil(length / spacing)));
    for (int k = points_.empty() ? 0 : 1; k <= steps; ++k) points_.push_back(at(static_cast<double>(k) / steps));
  }

  std::vector<ProfilePoint> points_;
};

// Wheels

struct Polynomial {
  std::span<const double> coefficients; ///< of 1, y, y^2, ...

  double operator()(double y) const {
    double sum = 0;
    for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) sum = sum * y + *c;
    return sum;
  }
  double slope(double y) const {
    double sum = 0;
    for (std::size_t k = coefficients.size() - 1; k > 0; --k) sum = sum * y + static_cast<double>(k) * coefficients[k];
    return sum;
  }
};

constexpr double s1002_tread[] = {0,
                                  -3.358537058e-2,
                                  1.565681624e-3,
                                  -2.810427944e-5,
                                  5.844240864e-8,
                                  -1.562379023e-8,
                                  5.309217349e-15,
                                  -5.957839843e-12,
                                  2.646656573e-13};
constexpr double s1002_throat[] = {-4.320221063e3,  -1.038384026e3,  -1.065501873e2,  -6.051367875,
                                   -2.054332446e-1, -4.169739389e-3, -4.687195829e-5, -2.252755540e-7};
constexpr Polynomial tread{s1002_tread}, throat{s1002_throat};
constexpr double throat_start = -35, throat_end = -26, relief_start = 32.15796, outer_end = 60;

constexpr double back = -70;
constexpr ProfilePoint root = {-26.210665, 16.446};
constexpr double root_radius = 13, flank_offset = -93.576667419, flank_slope = -2.747477419, flank_end = -38.426669071;

/// Arcs of the flange from its back to the flank, moved by -shift in y.
void add_tip(Outline& outline, double shift) {
  const auto moved = [=](double y, double z) { return ProfilePoint{y - shift, z}; };
  outline.arc_between(moved(-49.5, 9.519259302), 20.5, back, -62.764705882 - shift, 1);
  outline.arc_between(moved(-55, 16), 12, -62.764705882 - shift, -49.662510381 - shift, 1);
  outline.arc_between(moved(-58.558326413, 8.834924130), 20, -49.662510381 - shift, -39.764473993 - shift, 1);
}

/// Flank from the tip to the root's arc, and that arc to where it ends.
void add_root(Outline& outline, ProfilePoint centre, double start_y, double end_y) {
  const double start_z = centre.z - std::sqrt(root_radius * root_radius - (start_y - centre.y) * (start_y - centre.y));
  outline.line(outline.end(), {start_y, start_z});
  outline.arc_between(centre, root_radius, start_y, end_y, -1);
}

/// Thickness of a flange whose root has this centre: 10 mm below the tape circle, where its front is the arc or the
/// flank.
double thickness_of(ProfilePoint centre) {
  constexpr double depth = 10;
  const double across = std::hypot(1, flank_slope);
  const ProfilePoint end = {centre.y + root_radius * flank_slope / across, centre.z - root_radius / across};
  if (depth > end.z) return end.y + (depth - end.z) / flank_slope - back;
  return centre.y - std::sqrt(root_radius * root_radius - (depth - centre.z) * (depth - centre.z)) - back;
}

/// The shift at which a flange has a thickness. `centre` gives the root's centre by the shift.
template <class Centre> double shift_for(double thickness, const Centre& centre) {
  const auto excess = [&](double shift) { return thickness_of(centre(shift)) - thickness; };
  constexpr double widest = 10;
  return find_bracketed_root({-widest, excess(-widest)}, {widest, excess(widest)}, 1e-12, 1e-13, excess).side.at;
}

Outline s1002(std::optional<double> thickness) {
  const double slope = tread.slope(throat_end);
  const auto moved_root = [&](double shift) { return ProfilePoint{root.y - shift, root.z - slope * shift}; };
  constexpr double rounding = 1e-4; // of the standard's numbers: with these they make a flange of 32.5 mm
  double shift = thickness ? shift_for(*thickness, moved_root) : 0;
  if (shift < rounding) shift = 0;
  Outline outline;
  add_tip(outline, shift * (1 - slope / flank_slope)); // the flank is tangent to both arcs again
  add_root(outline, moved_root(shift), flank_end - shift, throat_start - shift);
  outline.curve(throat_start - shift, throat_end - shift, [&](double y) { return throat(y + shift) - slope * shift; });
  if (shift > 0) outline.line(outline.end(), {throat_end, tread(throat_end)});
  outline.curve(throat_end, relief_start, tread);
  outline.curve(relief_start, outer_end, [](double y) { return 1.364323640 - 0.066666667 * y; });
  return outline;
}

/// A straight tread z = -inclination y; the root's arc is tangent to it and to the flank.
Outline cone(double inclination, double thickness) {
  const double across = std::hypot(1, inclination), across_flank = std::hypot(1, flank_slope);
  const auto centre = [&](double shift) {
    // z + inclination y = radius across, z - flank_slope (y + shift) - flank_offset = radius across_flank
    const double offset = root_radius * (across - across_flank) - flank_offset - flank_slope * shift;
    const double y = offset / (inclination + flank_slope);
    return ProfilePoint{y, root_radius * across - inclination * y};
  };
  const double shift = shift_for(thickness, centre);
  const ProfilePoint arc = centre(shift);
  Outline outline;
  add_tip(outline, shift);
  add_root(outline, arc, arc.y + root_radius * flank_slope / across_flank, arc.y - root_radius * inclination / across);
  outline.curve(outline.end().y, outer_end, [=](double y) { return -inclination * y; });
  return outline;
}

// Rails

/// Widths up to which the arcs of 300 and of 80 mm reach; both are tangent, and so is the one of 13 mm to the sides.
Outline rail_head(double width_300, double width_80) {
  constexpr double top = 300, shoulder = 80, corner = 13, side_slope = 20, lowest = 30;
  const double y_1 = width_300 / 2, y_2 = width_80 / 2;
  const double angle_1 = std::asin(y_1 / top);
  const ProfilePoint centre_2 = {y_1 - shoulder * std::sin(angle_1), top - (top - shoulder) * std::cos(angle_1)};
  const double angle_2 = std::asin((y_2 - centre_2.y) / shoulder);
  const ProfilePoint centre_3 = {y_2 - corner * std::sin(angle_2),
                                 centre_2.z - (shoulder - corner) * std::cos(angle_2)};
  const double angle_3 = std::atan(side_slope);
  const ProfilePoint end = {centre_3.y + corner * std::sin(angle_3), centre_3.z - corner * std::cos(angle_3)};
  const double foot = end.y + (lowest - end.z) / side_slope;
  const auto mirrored = [](ProfilePoint p) { return ProfilePoint{-p.y, p.z}; };
  Outline outline;
  outline.line({-foot, lowest}, mirrored(end));
  outline.crown(mirrored(centre_3), corner, -angle_3, -angle_2);
  outline.crown(mirrored(centre_2), shoulder, -angle_2, -angle_1);
  outline.crown({0, top}, top, -angle_1, 0);
  outline.crown({0, top}, top, 0, angle_1);
  outline.crown(centre_2, shoulder, angle_1, angle_2);
  outline.crown(centre_3, corner, angle_2, angle_3);
  outline.line(end, {foot, lowest});
  return outline;
}

std::string_view name_of(StandardProfile standard) {
  return standard_profile_names[static_cast<std::size_t>(standard)];
}

std::string_view source_of(StandardProfile standard) {
  if (role_of(standard) == ProfileRole::rail) return "EN 13674-1";
  return standard == StandardProfile::s1002 ? "EN 13715" : "construction";
}

std::string comment_on(StandardProfile standard, std::optional<double> thickness) {
  const std::string name(name_of(standard)), source(source_of(standard));
  if (role_of(standard) == ProfileRole::rail) return name + " of " + source + ", from its arcs and lines, not canted";
  if (standard == StandardProfile::s1002)
    return name + " of " + source + ", from its arcs, lines and polynomials" +
           (thickness ? ", its flange moved to be " + digits(*thickness * 1e3) + " mm thick" : "");
  return "straight tread " + name.substr(name.find('-') + 1) + " with the flange of S1002, " +
         digits(thickness.value_or(thickest_flange) * 1e3) + " mm thick";
}

} // namespace

ProfileRole role_of(StandardProfile standard) {
  const bool rail = standard == StandardProfile::rail_60 || standard == StandardProfile::rail_54;
  return rail ? ProfileRole::rail : ProfileRole::wheel;
}

std::vector<ProfilePoint> standard_points(StandardProfile standard, std::optional<double> flange_thickness) {
  if (flange_thickness) {
    if (role_of(standard) == ProfileRole::rail)
      throw Error("flange_thickness: " + std::string(name_of(standard)) + " is a rail");
    require_between("flange_thickness", *flange_thickness, "m", thinnest_flange, thickest_flange);
  }
  const double thickness = flange_thickness.value_or(thickest_flange) * 1e3;
  switch (standard) {
  case StandardProfile::s1002:
    return s1002(flange_thickness ? std::optional(thickness) : std::nullopt).points();
  case StandardProfile::rail_60:
    return rail_head(20.456, 52.053).points();
  case StandardProfile::rail_54:
    return rail_head(20.024, 49.727).points();
  case StandardProfile::cone_20:
    return cone(1 / 20., thickness).points();
  case StandardProfile::cone_40:
    break;
  }
  return cone(1 / 40., thickness).points();
}

PreparedProfile standard_profile(StandardProfile standard, std::optional<double> flange_thickness,
                                 const ProfileTreatment& treatment) {
  std::vector<ProfilePoint> points = standard_points(standard, flange_thickness);
  ProfileReport report;
  report.source = name_of(standard);
  report.format = source_of(standard);
  report.comment = comment_on(standard, flange_thickness);
  report.points_read = points.size();
  return prepare_profile(role_of(standard), std::move(points), treatment, std::move(report));
}

} // namespace microslip
