#include "app/hertz.hpp"

#include "io/case_file.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace microslip {
namespace {

struct HertzArguments {
  std::filesystem::path case_file;
  std::vector<double> rolling_radius, transverse_radius;           ///< of body 1 and 2
  std::vector<double> young_modulus, shear_modulus, poisson_ratio; ///< of both, or of body 1 and 2
  std::vector<double> normal_force, approach;                      ///< one value, if given
};

Material material(const HertzArguments& arguments, std::size_t body) {
  const auto of_body = [&](const std::vector<double>& values) { return values[std::min(body, values.size() - 1)]; };
  const auto nu = require_between("--poisson-ratio", of_body(arguments.poisson_ratio), "-", 0, 0.5);
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

HertzContact contact_of(const HertzArguments& arguments) {
  if (!arguments.case_file.empty() && has_options(arguments))
    throw Error("hertz needs either CASE.toml or options, not both");
  if (!arguments.case_file.empty())
    return hertz_contact(parse_case(read_case_text(arguments.case_file), arguments.case_file.string()));
  require_options(arguments);
  const auto gap = gap_curvatures({arguments.rolling_radius[0], arguments.rolling_radius[1],
                                   arguments.transverse_radius[0], arguments.transverse_radius[1]});
  const auto combined = combine(material(arguments, 0), material(arguments, 1));
  return arguments.approach.empty() ? hertz_from_load(gap, combined, arguments.normal_force[0])
                                    : hertz_from_approach(gap, combined, arguments.approach[0]);
}

void hertz(const HertzArguments& arguments) {
  const auto contact = contact_of(arguments);
  QuantityTable table("Hertz");
  table.add("normal force", contact.normal_force, "N");
  add_hertz(table, contact);
  table.add("curvature of the gap along x", contact.gap.x, "1/m");
  table.add("curvature of the gap along y", contact.gap.y, "1/m");
  table.print();
}

void add_options(CLI::App& command, HertzArguments& arguments) {
  const auto option = [&](const char* name, std::vector<double>& values, int fewest, int most, const char* what) {
    command.add_option(name, values, what)->expected(fewest, most)->type_name("");
  };
  command.add_option("CASE.toml", arguments.case_file, "case file, instead of the options below");
  option("--rolling-radius", arguments.rolling_radius, 2, 2,
         "R1 R2: radii of body 1 and 2 in the plane of rolling [m]; inf: flat, negative: concave");
  option("--transverse-radius", arguments.transverse_radius, 2, 2,
         "R1 R2: radii of body 1 and 2 in the lateral plane [m]");
  option("--young-modulus", arguments.young_modulus, 1, 2, "E, or E1 E2 [Pa]; inf: rigid");
  option("--shear-modulus", arguments.shear_modulus, 1, 2, "G, or G1 G2 [Pa], instead of Young's modulus");
  option("--poisson-ratio", arguments.poisson_ratio, 1, 2, "nu, or nu1 nu2 [-], 0 to 0.5");
  option("--normal-force", arguments.normal_force, 1, 1, "Fn [N]");
  option("--approach", arguments.approach, 1, 1, "approach of distant points [m], instead of the load");
}

} // namespace

void add_hertz(QuantityTable& table, const HertzContact& contact) {
  table.add("semi-axis a, along x", contact.a * 1e3, "mm");
  table.add("semi-axis b, along y", contact.b * 1e3, "mm");
  table.add("peak pressure", contact.peak_pressure * 1e-6, "MPa");
  table.add("approach", contact.approach * 1e3, "mm");
  table.add("stiffness", contact.stiffness * 1e-6, "kN/mm");
}

void add_hertz_command(CLI::App& program) {
  auto* command = program.add_subcommand("hertz", "Contact ellipse, peak pressure, approach and stiffness");
  const auto arguments = std::make_shared<HertzArguments>();
  add_options(*command, *arguments);
  command->footer("Example:\n  microslip hertz --rolling-radius 0.46 inf --transverse-radius inf 0.3 \\\n"
                  "    --young-modulus 210e9 --poisson-ratio 0.28 --normal-force 80e3");
  command->callback([arguments] { hertz(*arguments); });
}

} // namespace microslip
