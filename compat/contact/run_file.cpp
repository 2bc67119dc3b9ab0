#include "compat/contact/run_file.hpp"

#include <limits>
#include <span>
#include <string>
#include <vector>

namespace microslip::contact_program {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr const char* status_codes =
    "0 ok, 1 invalid input, 2 not converged, 3 no contact, 4 the force given is beyond friction";

/// A number of a solved case, of a point inside the bodies, of a wheel, or of the position of a patch.
template <class Of> struct Column {
  const char *name, *unit, *description;
  double (*value)(const Of& of);
};

constexpr Column<Outcome> columns[] = {
    {"normal_force", "N", "normal force Fn", [](const Outcome& o) { return o.solution.normal_force; }},
    {"fx", "N", "longitudinal force on body 1", [](const Outcome& o) { return o.solution.totals.fx; }},
    {"fy", "N", "lateral force on body 1", [](const Outcome& o) { return o.solution.totals.fy; }},
    {"mz", "N m", "moment about the normal on body 1", [](const Outcome& o) { return o.solution.totals.mz; }},
    {"elastic_energy", "J", "elastic energy of pressure and tractions",
     [](const Outcome& o) { return o.solution.normal.elastic_energy + o.solution.totals.elastic_energy; }},
    {"frictional_power", "W", "power lost by friction; for a shift the work [J]",
     [](const Outcome& o) { return o.solution.totals.frictional_power; }},
    {"creepage_longitudinal", "- (m in a shift)", "given or found, about the origin; for a shift the distance",
     [](const Outcome& o) { return o.solution.creepage.longitudinal; }},
    {"creepage_lateral", "- (m in a shift)", "given or found, about the origin; for a shift the distance",
     [](const Outcome& o) { return o.solution.creepage.lateral; }},
    {"spin", "1/m (rad in a shift)", "given; for a shift the rotation",
     [](const Outcome& o) { return o.solution.creepage.spin; }},
    {"approach", "m", "approach of distant points", [](const Outcome& o) { return o.solution.normal.approach; }},
    {"peak_pressure", "Pa", "largest pressure of an element",
     [](const Outcome& o) { return o.solution.normal.peak_pressure; }},
    {"pressure_integral", "N", "TILDE_FN, of the pressure over a curved patch; NaN for a plane one",
     [](const Outcome& o) { return o.totals.integral_fn.value_or(nan); }},
    {"highest_temperature", "deg C", "of the surfaces in contact; NaN where not asked for",
     [](const Outcome& o) { return o.totals.temperature.value_or(nan); }},
    {"damping_fx", "N", "longitudinal damping force on body 1, M2 > 0; NaN without; no part of fx",
     [](const Outcome& o) { return o.damping ? o.damping->x : nan; }},
    {"damping_fy", "N", "lateral damping force", [](const Outcome& o) { return o.damping ? o.damping->y : nan; }},
    {"damping_fn", "N", "normal damping force", [](const Outcome& o) { return o.damping ? o.damping->z : nan; }},
    {"residual", "-", "of the tangential problem", [](const Outcome& o) { return o.solution.report.residual; }},
    {"shear_modulus", "Pa", "combined shear modulus G",
     [](const Outcome& o) { return o.step.bodies.material.shear_modulus; }},
    {"poisson_ratio", "-", "combined Poisson's ratio",
     [](const Outcome& o) { return o.step.bodies.material.poisson_ratio; }},
    {"x0", "m", "centre of the first element", [](const Outcome& o) { return o.step.grid.x0; }},
    {"y0", "m", "centre of the first element", [](const Outcome& o) { return o.step.grid.y0; }},
    {"dx", "m", "length of an element", [](const Outcome& o) { return o.step.grid.dx; }},
    {"dy", "m", "width of an element", [](const Outcome& o) { return o.step.grid.dy; }},
};

/// A count of a solved case.
struct CountColumn {
  const char *name, *description;
  int (*value)(const Outcome& outcome);
};

constexpr CountColumn counts[] = {
    {"mx", "elements of the potential contact along x", [](const Outcome& o) { return o.step.grid.mx; }},
    {"my", "elements of the potential contact along y", [](const Outcome& o) { return o.step.grid.my; }},
    {"contact_elements", "elements in contact", [](const Outcome& o) { return o.solution.contact_elements; }},
    {"adhesion_elements", "of these in adhesion", [](const Outcome& o) { return o.solution.adhesion_elements; }},
    {"slip_elements", "of these in slip", [](const Outcome& o) { return o.solution.slip_elements; }},
    {"plastic_elements", "of these where the layer yields",
     [](const Outcome& o) { return o.solution.plastic_elements; }},
    {"newton_steps", "of the tangential problem", [](const Outcome& o) { return o.solution.report.newton_steps; }},
};

constexpr Column<InteriorState> interior_columns[] = {
    {"ux", "m", "displacement of the point's body", [](const InteriorState& s) { return s.ux; }},
    {"uy", "m", "displacement of the point's body", [](const InteriorState& s) { return s.uy; }},
    {"uz", "m", "displacement of the point's body", [](const InteriorState& s) { return s.uz; }},
    {"sigma_xx", "Pa", "stress, tension positive", [](const InteriorState& s) { return s.stress.xx; }},
    {"sigma_yy", "Pa", "stress, tension positive", [](const InteriorState& s) { return s.stress.yy; }},
    {"sigma_zz", "Pa", "stress, tension positive", [](const InteriorState& s) { return s.stress.zz; }},
    {"sigma_xy", "Pa", "stress", [](const InteriorState& s) { return s.stress.xy; }},
    {"sigma_xz", "Pa", "stress", [](const InteriorState& s) { return s.stress.xz; }},
    {"sigma_yz", "Pa", "stress", [](const InteriorState& s) { return s.stress.yz; }},
    {"von_mises", "Pa", "von Mises' equivalent stress", [](const InteriorState& s) { return von_mises(s.stress); }},
};

constexpr Column<WheelOutcome> wheel_columns[] = {
    {"z", "m", "Z_WS, depth of the wheelset below its nominal position", [](const WheelOutcome& w) { return w.z; }},
    {"fx_track", "N", "force on the rail, in the track's axes: forward",
     [](const WheelOutcome& w) { return w.track.force.x; }},
    {"fy_track", "N", "to the right", [](const WheelOutcome& w) { return w.track.force.y; }},
    {"fz_track", "N", "down", [](const WheelOutcome& w) { return w.track.force.z; }},
    {"mx_track", "N m", "moment about the rail's marker", [](const WheelOutcome& w) { return w.track.moment.x; }},
    {"my_track", "N m", "moment about the rail's marker", [](const WheelOutcome& w) { return w.track.moment.y; }},
    {"mz_track", "N m", "moment about the rail's marker", [](const WheelOutcome& w) { return w.track.moment.z; }},
    {"fx_wheelset", "N", "the same force in the wheelset's axes",
     [](const WheelOutcome& w) { return w.wheelset.force.x; }},
    {"fy_wheelset", "N", "to the right", [](const WheelOutcome& w) { return w.wheelset.force.y; }},
    {"fz_wheelset", "N", "down", [](const WheelOutcome& w) { return w.wheelset.force.z; }},
    {"mx_wheelset", "N m", "moment about the wheel's marker",
     [](const WheelOutcome& w) { return w.wheelset.moment.x; }},
    {"my_wheelset", "N m", "moment about the wheel's marker",
     [](const WheelOutcome& w) { return w.wheelset.moment.y; }},
    {"mz_wheelset", "N m", "moment about the wheel's marker",
     [](const WheelOutcome& w) { return w.wheelset.moment.z; }},
    {"pitch_velocity", "rad/s", "VPITCH_WS", [](const WheelOutcome& w) { return w.vpitch; }},
    {"rail_deflection_lateral", "m", "to the right, with F = 3", [](const WheelOutcome& w) { return w.dy_rail; }},
    {"rail_deflection_vertical", "m", "down, with F = 3", [](const WheelOutcome& w) { return w.dz_rail; }},
};

constexpr Column<PatchLocation> place_columns[] = {
    {"x_track", "m", "XCP(TR), reference of a patch in the track's axes",
     [](const PatchLocation& l) { return l.track.x; }},
    {"y_track", "m", "YCP(TR)", [](const PatchLocation& l) { return l.track.y; }},
    {"z_track", "m", "ZCP(TR)", [](const PatchLocation& l) { return l.track.z; }},
    {"contact_angle", "rad", "DELTCP(TR)", [](const PatchLocation& l) { return l.angle; }},
    {"y_rail", "m", "YCP(R), in the axes of the rail's profile", [](const PatchLocation& l) { return l.rail.y; }},
    {"z_rail", "m", "ZCP(R)", [](const PatchLocation& l) { return l.rail.z; }},
    {"x_wheel", "m", "XCP(W), in the axes of the wheel's profile", [](const PatchLocation& l) { return l.wheel.x; }},
    {"y_wheel", "m", "YCP(W)", [](const PatchLocation& l) { return l.wheel.y; }},
    {"z_wheel", "m", "ZCP(W)", [](const PatchLocation& l) { return l.wheel.z; }},
};

/// The elements to be stored: all, or those in contact.
std::vector<std::size_t> chosen(const Case& c, const Outcome& outcome) {
  std::vector<std::size_t> elements;
  if (c.digits.matfil == Stored::none || outcome.kind != Outcome::Kind::solved) return elements;
  for (std::size_t k = 0; k < outcome.step.grid.count(); ++k)
    if (c.digits.matfil == Stored::all || outcome.solution.normal.pressure[k] > 0) elements.push_back(k);
  return elements;
}

template <class Number>
void append(io::ResultFile& file, const std::string& path, Number value, const char* unit, const char* what) {
  file.append(path, std::span<const Number>(&value, 1), unit, what);
}

} // namespace

RunFile::RunFile(const std::filesystem::path& path, const io::Provenance& provenance)
    : file_(path, provenance, io::ResultFile::Storage::disk) {}

int RunFile::add_elements(const Case& c, const Outcome& outcome) {
  const auto elements = chosen(c, outcome);
  std::vector<int> index, state;
  index.reserve(elements.size());
  state.reserve(elements.size());
  for (const std::size_t k : elements) {
    index.push_back(static_cast<int>(k));
    state.push_back(element_state(outcome, k));
  }
  file_.append("elements/index", std::span<const int>(index), "-", "j mx + i of the element, from 0, x fastest");
  file_.append("elements/state", std::span<const int>(state), "-",
               "0 exterior, 1 adhesion, 2 slip, 3 plastic deformation");
  const auto add_field = [&](const char* name, const std::vector<double>& field, const char* unit, const char* what) {
    std::vector<double> values;
    values.reserve(elements.size());
    for (const std::size_t k : elements) values.push_back(field[k]);
    file_.append(std::string("elements/") + name, std::span<const double>(values), unit, what);
  };
  const SurfaceFields& f = outcome.solution.fields;
  add_field("undeformed_gap", outcome.step.gap, "m", "undeformed distance h");
  add_field("pressure", f.pressure, "Pa", "p_n");
  add_field("bound", f.bound, "Pa", "traction bound g = mu p_n");
  const std::vector<double> none(outcome.step.grid.count());
  add_field("mu", f.friction.empty() ? none : f.friction, "-", "coefficient of friction; 0 without tractions");
  add_field("px", f.traction.x, "Pa", "traction on body 1");
  add_field("py", f.traction.y, "Pa", "traction on body 1");
  add_field("un", outcome.solution.normal.displacement, "m", "normal displacement difference");
  add_field("ux", f.displacement.x, "m", "displacement difference u1 - u2");
  add_field("uy", f.displacement.y, "m", "displacement difference u1 - u2");
  add_field("sx", f.slip.x, "-", "relative slip; for a shift the slip [m]");
  add_field("sy", f.slip.y, "-", "relative slip; for a shift the slip [m]");
  const std::vector<double> unknown(outcome.has_temperatures() ? 0 : outcome.step.grid.count(), nan);
  add_field("temperature1", unknown.empty() ? f.temperature1 : unknown, "deg C", "of body 1's surface");
  add_field("temperature2", unknown.empty() ? f.temperature2 : unknown, "deg C", "of body 2's surface");
  return static_cast<int>(elements.size());
}

int RunFile::add_points(const Outcome& outcome) {
  std::vector<int> blocks;
  std::vector<double> x, y, z;
  std::vector<InteriorState> states;
  for (std::size_t block = 0; block < outcome.interior.size(); ++block) {
    const auto& [points, field] = outcome.interior[block];
    for (std::size_t k = 0; k < field.size(); ++k) {
      x.push_back(points.x_of(k));
      y.push_back(points.y_of(k));
      z.push_back(points.z_of(k));
    }
    blocks.insert(blocks.end(), field.size(), static_cast<int>(block));
    states.insert(states.end(), field.begin(), field.end());
  }
  file_.append("interior/block", std::span<const int>(blocks), "-", "block of points in the case, from 0");
  const auto add_field = [&](const char* name, const std::vector<double>& values, const char* unit, const char* what) {
    file_.append(std::string("interior/") + name, std::span<const double>(values), unit, what);
  };
  add_field("x", x, "m", "of the point");
  add_field("y", y, "m", "of the point");
  add_field("z", z, "m", "of the point: >= 0 in body 1, < 0 in body 2");
  for (const auto& [name, unit, what, value] : interior_columns) {
    std::vector<double> values;
    values.reserve(states.size());
    for (const InteriorState& state : states) values.push_back(value(state));
    add_field(name, values, unit, what);
  }
  return static_cast<int>(states.size());
}

void RunFile::add(const Case& c, const Outcome& outcome) {
  if (!outcome.wheel) {
    add_contact(c, outcome, {c.number, 0, {}});
    return;
  }
  add_wheel(c, outcome);
  int patch = 0;
  for (const WheelPatch& p : outcome.wheel->patches)
    add_contact(p.contact, *p.solution, {c.number, ++patch, p.location});
}

void RunFile::add_wheel(const Case& c, const Outcome& outcome) {
  const WheelOutcome& wheel = *outcome.wheel;
  append(file_, "wheels/case", c.number, "-", "number of the case in the file, from 1");
  append(file_, "wheels/patches", static_cast<int>(wheel.patches.size()), "-", "contact patches");
  append(file_, "wheels/status", static_cast<int>(outcome.solution.report.status), "-", status_codes);
  for (const auto& [name, unit, what, value] : wheel_columns)
    append(file_, std::string("wheels/") + name, value(wheel), unit, what);
}

void RunFile::add_contact(const Case& c, const Outcome& outcome, const Origin& origin) {
  const bool solved = outcome.kind == Outcome::Kind::solved;
  const auto add_count = [&](const char* name, int value, const char* what) {
    append(file_, std::string("cases/") + name, value, "-", what);
  };
  add_count("line", static_cast<int>(c.line), "line of the input file where the case begins");
  add_count("number", origin.number, "of the case in the file, from 1");
  add_count("patch", origin.patch, "contact patch of a wheel, from 1; 0 for an independent contact");
  for (const auto& [name, unit, what, value] : place_columns)
    append(file_, std::string("cases/") + name, origin.place ? value(*origin.place) : nan, unit, what);
  add_count("outcome", static_cast<int>(outcome.kind), "0 solved, 1 skipped as the file says, 2 refused");
  add_count("status", solved ? static_cast<int>(outcome.solution.report.status) : 0, status_codes);
  add_count("motion", number(c.digits.tang), "0 frictionless, 1 shift, 2 transient rolling, 3 steady rolling");
  for (const auto& [name, what, value] : counts) add_count(name, solved ? value(outcome) : 0, what);
  for (const auto& [name, unit, what, value] : columns)
    append(file_, std::string("cases/") + name, solved ? value(outcome) : nan, unit, what);
  append(file_, "cases/first_element", elements_, "-", "where its elements begin");
  const int stored = add_elements(c, outcome);
  add_count("stored_elements", stored, "how many elements are stored");
  elements_ += stored;
  append(file_, "cases/first_point", points_, "-", "where its points inside the bodies begin");
  const int points = add_points(outcome);
  add_count("stored_points", points, "how many points inside the bodies are stored");
  points_ += points;
}

} // namespace microslip::contact_program
