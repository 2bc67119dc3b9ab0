#include "app/rolling_contact_result.hpp"

#include "io/option_words.hpp"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace microslip {
namespace {

GridError grid_error(const RollingCase& input, const EllipticContact& contact, const ContactForces& forces) {
  auto options = input.options;
  options.mx *= 2;
  options.my *= 2;
  const auto finer = RowSolver(input.theory, options).solve(contact);
  const auto limit = contact.friction.static_coefficient() * contact.normal_force;
  if (limit == 0) return {};
  const auto length = std::sqrt(contact.a * contact.b);
  return {std::abs(forces.fx - finer.fx) / limit, std::abs(forces.fy - finer.fy) / limit,
          std::abs(forces.mz - finer.mz) / (limit * length)};
}

void write_body(ResultFile& file, const BodyInput& body, const std::string& number) {
  const auto scalar = [&](const std::string& name, double value, const char* unit, const std::string& what) {
    file.scalar("inputs/" + name + "_" + number, value, unit, what + " of body " + number);
  };
  scalar("rolling_radius", body.rolling_radius, "m", "radius in the plane of rolling");
  scalar("transverse_radius", body.transverse_radius, "m", "radius in the lateral plane");
  scalar("shear_modulus", body.material.shear_modulus, "Pa", "shear modulus G");
  scalar("poisson_ratio", body.material.poisson_ratio, "-", "Poisson's ratio");
}

void write_friction(ResultFile& file, const RollingCase& input) {
  const auto& law = input.friction;
  file.text("inputs/friction_law", input.friction_law, "friction as a function of the slip velocity");
  file.scalar("inputs/friction_coefficient", law.static_coefficient(), "-", "friction coefficient mu without slip");
  if (law.kind() == FrictionLaw::Kind::coulomb) return;
  file.scalar("inputs/kinetic_coefficient", law.kinetic_coefficient(), "-", "friction coefficient at large slip");
  for (std::size_t i = 0; i < law.terms().size(); ++i) {
    const auto name = "inputs/" + std::string(i == 0 ? "" : "second_");
    file.scalar(name + "drop", law.terms()[i].drop, "-", "what a term of the friction law adds without slip");
    file.scalar(name + "half_velocity", law.terms()[i].half_velocity, "m/s", "slip velocity at half of it");
  }
}

void write_motion(ResultFile& file, const RollingCase& input) {
  file.scalar("inputs/creepage_longitudinal", input.creepage.longitudinal, "-", "longitudinal creepage xi");
  file.scalar("inputs/creepage_lateral", input.creepage.lateral, "-", "lateral creepage eta");
  file.scalar("inputs/spin", input.creepage.spin, "1/m", "spin creepage phi");
  file.scalar("inputs/rolling_speed", input.rolling_speed, "m/s", "rolling speed V");
  file.text("inputs/direction", std::string(to_word(input.options.direction)), "rolling along +x or -x");
}

void write_solution(ResultFile& file, const RollingCase& input) {
  const auto& options = input.options;
  file.text("inputs/theory", std::string(to_word(input.theory)), "algorithm");
  file.scalar("inputs/mx", options.mx, "-", "cells along x");
  file.scalar("inputs/my", options.my, "-", "rows along y");
  file.text("inputs/bound", std::string(to_word(options.bound)), "shape of the traction bound");
  file.text("inputs/flexibility", std::string(to_word(options.flexibility)), "flexibilities of the simplified theory");
  const auto& reduction = options.slope_reduction;
  file.scalar("inputs/slope_reduction_initial", reduction.initial, "-", "factor on the creep curve's initial slope");
  file.scalar("inputs/slope_reduction_at_infinity", reduction.at_infinity, "-", "its part that is left at large slip");
  file.scalar("inputs/slope_reduction_decay", reduction.decay, "-", "how fast it falls");
}

void write_inputs(ResultFile& file, const RollingCase& input, const EllipticContact& contact) {
  write_body(file, input.body1, "1");
  write_body(file, input.body2, "2");
  file.scalar("inputs/shear_modulus", contact.shear_modulus, "Pa", "combined shear modulus G");
  file.scalar("inputs/poisson_ratio", contact.poisson_ratio, "-", "combined Poisson's ratio");
  file.scalar("inputs/normal_force", contact.normal_force, "N", "normal force Fn");
  write_friction(file, input);
  write_motion(file, input);
  write_solution(file, input);
}

void write_tolerances(ResultFile& file, const GridError& error) {
  const std::string what = ": difference to the grid with twice the cells in each direction";
  file.scalar("tolerances/hertz_relative", 1e-12, "-", "relative error of the Hertz solution");
  file.scalar("tolerances/grid_fx", error.fx, "mu Fn", "discretisation error of fx" + what);
  file.scalar("tolerances/grid_fy", error.fy, "mu Fn", "discretisation error of fy" + what);
  file.scalar("tolerances/grid_mz", error.mz, "mu Fn sqrt(a b)", "discretisation error of mz" + what);
}

void write_hertz(ResultFile& file, const HertzContact& hertz) {
  file.scalar("hertz/a", hertz.a, "m", "semi-axis along x");
  file.scalar("hertz/b", hertz.b, "m", "semi-axis along y");
  file.scalar("hertz/approach", hertz.approach, "m", "approach of distant points");
  file.scalar("hertz/peak_pressure", hertz.peak_pressure, "Pa", "peak normal pressure p0");
  file.scalar("hertz/stiffness", hertz.stiffness, "N/m", "derivative of the normal force to the approach");
  file.scalar("hertz/curvature_x", hertz.gap.x, "1/m", "A of the gap A x^2 + B y^2");
  file.scalar("hertz/curvature_y", hertz.gap.y, "1/m", "B of the gap A x^2 + B y^2");
}

void write_theory(ResultFile& file, const std::string& theory, const ContactFields& fields) {
  const auto& forces = fields.forces;
  file.scalar(theory + "/fx", forces.fx, "N", "longitudinal force on body 1");
  file.scalar(theory + "/fy", forces.fy, "N", "lateral force on body 1");
  file.scalar(theory + "/mz", forces.mz, "N m", "spin moment on body 1");
  file.scalar(theory + "/adhesion_area", forces.adhesion_area, "m^2", "area of adhesion");
  file.scalar(theory + "/slip_area", forces.slip_area, "m^2", "area of slip");
  file.scalar(theory + "/frictional_power", fields.frictional_power, "W", "power lost to friction");
  file.text(theory + "/status", std::string(to_string(forces.status)), "how the calculation ended");

  const ResultFile::Shape shape = {static_cast<std::size_t>(fields.my), static_cast<std::size_t>(fields.mx)};
  const auto field = [&](const char* name, const std::vector<double>& values, const char* unit, const char* what) {
    file.array(theory + "/fields/" + name, values, unit, what, shape);
  };
  field("x", fields.x, "m", "x of the cell's centre, from the leading to the trailing edge");
  field("y", fields.y, "m", "y of the cell's centre");
  field("area", fields.area, "m^2", "weight of the cell in the forces");
  field("bound", fields.bound, "Pa", "traction bound g");
  field("px", fields.px, "Pa", "longitudinal traction on body 1");
  field("py", fields.py, "Pa", "lateral traction on body 1");
  field("sx", fields.sx, "-", "relative slip of body 1 over body 2, longitudinal");
  field("sy", fields.sy, "-", "relative slip of body 1 over body 2, lateral");
  std::vector<std::uint8_t> states;
  for (const auto state : fields.state) states.push_back(static_cast<std::uint8_t>(state));
  file.array(theory + "/fields/state", states, "-", "0 exterior, 1 adhesion, 2 slip", shape);
}

void write_curve(ResultFile& file, const CreepCurve& curve, const ContactForces& point) {
  const auto write = [&](const std::string& name, const char* unit, double ContactForces::*member) {
    std::vector<double> values;
    for (const auto& forces : curve.forces) values.push_back(forces.*member);
    file.array("creep_curve/" + name, values, unit, name + " along the curve");
    file.scalar("creep_curve/point_" + name, point.*member, unit, name + " of the case itself");
  };
  file.array("creep_curve/value", curve.value, curve.unit, "the creepage that varies");
  file.scalar("creep_curve/point_value", curve.point_value, curve.unit, "its value in the case itself");
  write("fx", "N", &ContactForces::fx);
  write("fy", "N", &ContactForces::fy);
  write("mz", "N m", &ContactForces::mz);
  file.attribute("creep_curve", "variable", curve.variable);
}

} // namespace

RollingContactResult solve_case(const RollingCase& input) {
  RollingContactResult result;
  result.hertz = hertz_contact(input);
  result.contact = elliptic_contact(input, result.hertz);
  RowSolver solver(input.theory, input.options);
  result.fields = solver.fields(result.contact);
  result.grid_error = grid_error(input, result.contact, result.fields.forces);
  result.curve = creep_curve(solver, result.contact);
  return result;
}

void write_result(const RollingCase& input, const RollingContactResult& result, const Provenance& provenance,
                  const std::filesystem::path& path) {
  ResultFile file(path, provenance);
  write_inputs(file, input, result.contact);
  write_tolerances(file, result.grid_error);
  write_hertz(file, result.hertz);
  write_theory(file, input.theory == MarchingScheme::fastsim2 ? "fastsim2" : "fastsim", result.fields);
  write_curve(file, result.curve, result.fields.forces);
  file.commit();
}

} // namespace microslip
