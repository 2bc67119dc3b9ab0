#include "app/hertz.hpp"

#include "app/commands.hpp"
#include "app/input_options.hpp"
#include "app/json_document.hpp"
#include "cases/rolling_contact_result.hpp"
#include "io/case_file.hpp"
#include "microslip/description/input.hpp"
#include "microslip/error.hpp"
#include "microslip/rolling/contact_warnings.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace microslip::app {
namespace {

struct HertzArguments {
  std::filesystem::path case_file;
  std::vector<double> rolling_radius, transverse_radius;           ///< of body 1 and 2
  std::vector<double> young_modulus, shear_modulus, poisson_ratio; ///< of both, or of body 1 and 2
  std::vector<double> normal_force, approach;                      ///< one value, if given
  InputOptions body{description::rolling_inputs(), "body1"}, load{description::rolling_inputs(), "load"};
  bool json = false;
};

struct HertzResult {
  io::BodyInput body1, body2;
  HertzContact contact;
};

Material material(const HertzArguments& arguments, std::size_t body) {
  const auto of_body = [&](const std::vector<double>& values) { return values[std::min(body, values.size() - 1)]; };
  const double nu = of_body(arguments.poisson_ratio);
  return arguments.shear_modulus.empty() ? Material::from_young(of_body(arguments.young_modulus), nu)
                                         : Material{of_body(arguments.shear_modulus), nu};
}

bool has_options(const HertzArguments& arguments) {
  const auto lists = {&arguments.rolling_radius, &arguments.transverse_radius, &arguments.young_modulus,
                      &arguments.shear_modulus,  &arguments.poisson_ratio,     &arguments.normal_force,
                      &arguments.approach};
  return std::any_of(lists.begin(), lists.end(), [](const auto* list) { return !list->empty(); });
}

void require_options(const HertzArguments& arguments) {
  if (arguments.rolling_radius.empty()) throw Error("hertz needs CASE.toml or --rolling-radius");
  if (arguments.transverse_radius.empty()) throw Error("hertz needs --transverse-radius");
  if (arguments.poisson_ratio.empty()) throw Error("hertz needs --poisson-ratio");
  if (arguments.young_modulus.empty() == arguments.shear_modulus.empty())
    throw Error("hertz needs either --young-modulus or --shear-modulus");
  if (arguments.normal_force.empty() == arguments.approach.empty())
    throw Error("hertz needs either --normal-force or --approach");
}

HertzResult solve_case(const std::filesystem::path& path) {
  const auto input = io::parse_case(io::read_case_text(path), path.string());
  return {input.body1, input.body2, hertz_contact(input.problem)};
}

io::BodyInput body(const HertzArguments& arguments, std::size_t number) {
  return {arguments.rolling_radius[number], arguments.transverse_radius[number], material(arguments, number)};
}

HertzResult solve(const HertzArguments& arguments) {
  if (!arguments.case_file.empty() && has_options(arguments))
    throw Error("hertz needs either CASE.toml or options, not both");
  if (!arguments.case_file.empty()) return solve_case(arguments.case_file);
  require_options(arguments);
  arguments.body.require();
  arguments.load.require();
  const io::BodyInput body1 = body(arguments, 0), body2 = body(arguments, 1);
  const auto gap = gap_curvatures(io::principal_radii(body1, body2));
  const auto combined = combine(body1.material, body2.material);
  return {body1, body2,
          arguments.approach.empty() ? hertz_from_load(gap, combined, arguments.normal_force[0])
                                     : hertz_from_approach(gap, combined, arguments.approach[0])};
}

/// Adds what Hertz's theory takes of a body, by the keys of case files.
void add_body(io::Json& document, io::Json& units, const std::string& name, const io::BodyInput& body) {
  const std::pair<const char*, double> numbers[] = {{"rolling_radius", body.rolling_radius},
                                                    {"transverse_radius", body.transverse_radius},
                                                    {"shear_modulus", body.material.shear_modulus},
                                                    {"poisson_ratio", body.material.poisson_ratio}};
  for (const auto& [key, value] : numbers) {
    const std::string path = "inputs/" + name + "/" + key;
    document[io::Json::json_pointer("/" + path)] = io::json_number(value);
    units[path] = description::rolling_inputs().find(name, key)->unit;
  }
}

void print_document(const HertzArguments& arguments, const HertzResult& result,
                    const std::vector<std::string>& warnings) {
  auto document = json_document("hertz");
  document["case_file"] = arguments.case_file.string();
  auto units = io::Json::object();
  add_body(document, units, "body1", result.body1);
  add_body(document, units, "body2", result.body2);
  const auto add = [&](const std::vector<cases::StoredNumber>& quantities) {
    for (const auto& quantity : quantities) {
      document[io::Json::json_pointer("/" + quantity.path)] = io::json_number(quantity.value);
      units[quantity.path] = quantity.unit;
    }
  };
  add(cases::hertz_quantities(result.contact));
  add(cases::material_quantities(combine(result.body1.material, result.body2.material)));
  document["units"] = units;
  document["warnings"] = warnings;
  print_json(document);
}

void hertz(const HertzArguments& arguments) {
  const auto result = solve(arguments);
  const auto warnings = contact_warnings(result.contact, io::principal_radii(result.body1, result.body2),
                                         combine(result.body1.material, result.body2.material))
                            .texts;
  print_warnings(arguments.case_file.empty() ? "hertz" : arguments.case_file.string(), warnings);
  if (arguments.json) return print_document(arguments, result, warnings);
  const auto& contact = result.contact;
  QuantityTable table("Hertz");
  table.add("normal force", contact.normal_force, "N");
  add_hertz(table, contact);
  table.add("curvature of the gap along x", contact.gap.x, "1/m");
  table.add("curvature of the gap along y", contact.gap.y, "1/m");
  table.print();
}

void add_options(Command& command, HertzArguments& arguments) {
  command.add_option("CASE.toml", arguments.case_file, "case file, instead of the options below");
  InputOptions &body = arguments.body, &load = arguments.load;
  body.add(command, "rolling_radius", arguments.rolling_radius, "R1 R2").expected(2);
  body.add(command, "transverse_radius", arguments.transverse_radius, "R1 R2").expected(2);
  body.add(command, "young_modulus", arguments.young_modulus, "E1 [E2]").expected(1, 2);
  body.add(command, "shear_modulus", arguments.shear_modulus, "G1 [G2]").expected(1, 2);
  body.add(command, "poisson_ratio", arguments.poisson_ratio, "NU1 [NU2]").expected(1, 2);
  load.add(command, "normal_force", arguments.normal_force, "FN").expected(1);
  load.add(command, "approach", arguments.approach, "DELTA").expected(1);
  add_json_flag(command, arguments.json);
}

} // namespace

void add_hertz(QuantityTable& table, const HertzContact& contact) {
  if (contact.gap.is_line()) { // a metre of a line contact
    table.add("half-width", contact.a, "m");
    table.add("peak pressure", contact.peak_pressure, "Pa");
    return;
  }
  table.add("semi-axis a, along x", contact.a, "m");
  table.add("semi-axis b, along y", contact.b, "m");
  table.add("peak pressure", contact.peak_pressure, "Pa");
  table.add("approach", contact.approach, "m");
  table.add("stiffness", contact.stiffness, "N/m");
}

void print_warnings(const std::string& of, const std::vector<std::string>& warnings) {
  for (const auto& warning : warnings) fmt::print(stderr, "microslip: warning: {}: {}\n", of, warning);
}

constexpr const char* footer =
    R"(Prints semi-axes, peak pressure, approach, stiffness and curvatures of the gap, in units that fit; with --json in
SI units, by the names that they have in result files.

Example:
  microslip hertz --rolling-radius 0.46 inf --transverse-radius inf 0.3 \
    --young-modulus 210e9 --poisson-ratio 0.28 --normal-force 80e3)";

void add_hertz_command(Command& program) {
  Command command = program.add_subcommand("hertz", "Contact ellipse, peak pressure, approach and stiffness", footer);
  HertzArguments& arguments = command.arguments(hertz);
  add_options(command, arguments);
}

} // namespace microslip::app
