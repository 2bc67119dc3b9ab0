#include "explorer/core/explorer.hpp"

#include "cases/case_document.hpp"
#include "cases/conicity_result.hpp"
#include "cases/profile_result.hpp"
#include "cases/wheel_rail_result.hpp"
#include "explorer/core/description.hpp"
#include "explorer/core/rolling_start.hpp"
#include "io/length_unit.hpp"
#include "io/nearest_word.hpp"
#include "io/option_words.hpp"
#include "io/profile_file.hpp"
#include "io/toml_section.hpp"
#include "microslip/contact/quantities.hpp"
#include "microslip/description/input.hpp"
#include "microslip/error.hpp"
#include "microslip/version.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <exception>
#include <map>
#include <new>
#include <sstream>
#include <utility>
#include <variant>
#include <vector>

namespace microslip::explorer {
namespace {

constexpr std::string_view extents[] = {"full", "solution"};
constexpr int most_points = 1000; ///< of a curve

/// The text of a case without its state. A sweep is part of it: it tells which results there are.
std::string setting_of(toml::table table) {
  std::ostringstream text;
  if (auto* const wheel = table["wheel"].as_table())
    if (const auto side = (*wheel)["side"].value<std::string>()) text << "side of the wheel: " << *side << '\n';
  table.erase("wheel");
  text << table;
  return text.str();
}

/// Files have no folders here: of the paths of profiles their ends count. Error for two that end alike, and for what is
/// not there, all of it by name.
toml::table with_files(toml::table table, const std::string& name, const KeptFiles& files) {
  std::map<std::string, std::string> paths;
  std::vector<std::string> missing;
  for (const std::string_view section : io::profile_sections) {
    auto* const profile = table[section]["profile"].as_string();
    if (profile == nullptr || profile->get().empty()) continue;
    const std::string path = profile->get(), end = path.substr(path.find_last_of("/\\") + 1),
                      key = std::string(section) + ".profile";
    const auto known = paths.try_emplace(end, path).first;
    const io::TomlSection named = io::TomlSection(table, name).required_section(section);
    named.at("profile", [&] {
      if (known->second != path)
        throw Error(key + ": " + io::printable(path) + " and " + io::printable(known->second) +
                    " have one name without their folders, and there are none here");
      if (!files.has(end) && !io::names_standard(path)) missing.push_back(key + " = " + io::printable(path));
    });
    *profile = end;
  }
  std::string all;
  for (const std::string& one : missing) all += (all.empty() ? "" : ", ") + one;
  if (!all.empty()) throw Error(name + ": " + all + ": not here; such a file goes along with the case");
  return table;
}

/// A case that is parsed as TOML.
struct CaseText {
  /// What is read of it goes to `keys`.
  CaseText(const Request& request, const std::string& case_name, const KeptFiles& files,
           io::TomlSection::ReadKeys* keys = nullptr)
      : text(request.text("case")), name(case_name), table(with_files(io::parse_toml(text, name), name, files)),
        root(table, name, {}, keys) {}
  CaseText(const CaseText&) = delete;
  CaseText& operator=(const CaseText&) = delete;

  io::RollingCase rolling_case(const io::CreepTables& tables) const {
    if (io::is_wheel_rail_case(root)) throw Error(name + ": is about a wheel on a rail; two bodies are wanted");
    return io::read_case(root, tables);
  }
  io::WheelRailCase wheel_rail_case(const io::CreepTables& tables) const {
    if (!io::is_wheel_rail_case(root)) throw Error(name + ": is about two bodies; a wheel on a rail is wanted");
    return io::read_wheel_rail_case(root, tables);
  }
  io::Provenance provenance(const char* kind, const std::string& title) const {
    return {.kind = kind, .title = title, .command_line = {}, .case_file = {}, .case_text = text};
  }

  std::string text, name;
  toml::table table;
  io::TomlSection root;
};

template <class Input, class Result>
io::Json document(const CaseText& given, const Input& input, const Result& result, io::JsonFields fields) {
  io::Json all = cases::case_document(input, result, given.provenance(cases::kind_of(input), input.title), fields);
  if (!result.reason.empty()) all["reason"] = result.reason;
  return all;
}

io::Json json_of(double number) {
  return io::json_number(number);
}
io::Json json_of(const std::string& text) {
  return text;
}
template <class Item> io::Json json_of(const std::vector<Item>& items) {
  io::Json list = io::Json::array();
  for (const Item& item : items) list.push_back(json_of(item));
  return list;
}

constexpr std::array<std::string_view, 3> creep_variables = {"creepage_longitudinal", "creepage_lateral", "spin"};

double& creepage_of(Creepage& creepage, std::string_view variable) {
  if (variable == "spin") return creepage.spin;
  return variable == "creepage_lateral" ? creepage.lateral : creepage.longitudinal;
}

/// What case files may have under a key of a profile.
const description::Input& profile_input(std::string_view key) {
  return *description::wheel_inputs().find(io::profile_sections[0], key);
}

io::ProfileFileOptions profile_options(const Request& request) {
  io::ProfileFileOptions options;
  const auto option = [&]<class Option>(const char* member, std::optional<Option>& value) {
    if (request.has(member)) value = io::from_word<Option>(std::string("request.") + member, request.text(member));
  };
  option("role", options.role);
  option("format", options.format);
  option("y_axis", options.y_axis);
  option("z_axis", options.z_axis);
  if (request.has("unit")) options.unit = io::length_of_unit("request.unit", request.text("unit"));
  if (request.has("section")) options.section = request.count("section", profile_input("section").bounds);
  if (request.has("smoothing_length"))
    options.treatment.smoothing_length = request.number("smoothing_length", profile_input("smoothing_length"));
  return options;
}

bool has_vector_lanes() {
#if defined(__wasm_simd128__) || defined(__SSE2__) || defined(__ARM_NEON)
  return true;
#else
  return false;
#endif
}

} // namespace

Explorer::Explorer(const std::filesystem::path& folder) : files_(folder), case_name_((folder / "case.toml").string()) {}

std::string Explorer::answer(std::string_view text) {
  const auto start = std::chrono::steady_clock::now();
  const auto written = [](const io::Json& reply) {
    return reply.dump(-1, ' ', false, io::Json::error_handler_t::replace);
  };
  try {
    io::Json reply = {{"result", call(Request(text))}};
    reply["time"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return written(reply);
  } catch (const std::bad_alloc&) {
    return R"({"error":{"message":"not enough memory"}})";
  } catch (const std::exception& error) {
    return written({{"error", {{"message", error.what()}}}});
  }
}

io::Json Explorer::call(const Request& request) {
  constexpr std::pair<std::string_view, io::Json (Explorer::*)(const Request&)> calls[] = {
      {"solve", &Explorer::solve},         {"inputs", &Explorer::inputs},
      {"radii", &Explorer::radii},         {"creep_curve", &Explorer::creep_curve},
      {"transient", &Explorer::transient}, {"nip", &Explorer::nip},
      {"nip_curve", &Explorer::nip_curve}, {"profile", &Explorer::profile},
      {"conicity", &Explorer::conicity},   {"description", &Explorer::description},
      {"version", &Explorer::version}};
  std::vector<std::string_view> names;
  for (const auto& [name, member] : calls) names.push_back(name);
  const std::string name = request.text("call");
  io::require_word("request.call", name, names);
  const auto* const found =
      std::find_if(std::begin(calls), std::end(calls), [&](const auto& c) { return c.first == name; });
  return (this->*found->second)(request);
}

/// What has been read of other files is no longer true.
void Explorer::take_files(const Request& request) {
  bool are_new = false;
  for (const auto& [name, contents] : request.texts("files")) are_new |= files_.put(name, contents);
  if (are_new) models_.clear();
}

io::Json Explorer::solve(const Request& request) {
  request.allow({"case", "files", "fields", "extent"});
  take_files(request);
  const CaseText given(request, case_name_, files_);
  const io::JsonFields fields = request.flag("fields") ? io::JsonFields::kept : io::JsonFields::left_out;
  const bool is_full = request.word("extent", extents) == "full";
  if (!io::is_wheel_rail_case(given.root)) {
    const io::RollingCase input = given.rolling_case(tables_);
    return document(given, input,
                    cases::solve_case(input, {}, is_full ? cases::ExactExtent::full : cases::ExactExtent::solution),
                    fields);
  }
  if (io::is_wheelset_case(given.root)) {
    const io::WheelsetCase input = io::read_wheelset_case(given.root, tables_);
    return document(given, input, cases::solve_case(input), fields);
  }
  WheelModels::Model& model = models_.of(given.root, setting_of(given.table), tables_);
  io::Json all = document(given, model.input, cases::solve_case(model.input, model.solver), fields);
  if (!is_full) all.erase("profiles"); // which do not change while a wheel is dragged
  return all;
}

/// What a case says, and the defaults of what it leaves out.
io::Json Explorer::inputs(const Request& request) {
  request.allow({"case", "files"});
  take_files(request);
  io::TomlSection::ReadKeys keys;
  const CaseText given(request, case_name_, files_, &keys);
  io::Json all = io::Json::object();
  if (!io::is_wheel_rail_case(given.root))
    all["kind"] = cases::kind_of(given.rolling_case(tables_));
  else if (!io::is_wheelset_case(given.root))
    all["kind"] = cases::kind_of(given.wheel_rail_case(tables_));
  else
    all["kind"] = cases::kind_of(io::read_wheelset_case(given.root, tables_));
  io::Json inputs = io::Json::object(), units = io::Json::object(), in_the_text = io::Json::array();
  for (const auto& [key, read] : keys) {
    inputs[key] = std::visit([](const auto& value) { return json_of(value); }, read.value);
    if (!read.unit.empty()) units[key] = read.unit;
    if (read.is_given) in_the_text.push_back(key);
  }
  all["inputs"] = std::move(inputs);
  all["given"] = std::move(in_the_text);
  all["units"] = std::move(units);
  return all;
}

/// The upper body whose contact with a flat one, of the case's material and under its load, is an ellipse.
io::Json Explorer::radii(const Request& request) {
  request.allow({"case", "a", "b"});
  const io::RollingCase input = CaseText(request, case_name_, files_).rolling_case(tables_);
  const double normal_force = hertz_contact(input.problem).normal_force;
  const GapCurvatures gap =
      hertz_from_ellipse(request.number("a"), request.number("b"), input.problem.bodies.material, normal_force).gap;
  return {{"rolling_radius", io::json_number(0.5 / gap.x)}, // h = x^2/(2R) + ...
          {"transverse_radius", io::json_number(0.5 / gap.y)},
          {"units", {{"rolling_radius", "m"}, {"transverse_radius", "m"}}}};
}

io::Json Explorer::creep_curve(const Request& request) {
  request.allow({"case", "variable", "from", "to", "count"});
  const CaseText given(request, case_name_, files_);
  const io::RollingCase input = given.rolling_case(tables_);
  const std::string_view variable = request.word("variable", creep_variables);
  const double from = request.number("from"), to = request.number("to");
  const int count = request.count("count", description::between(2, most_points));
  RollingProblem problem = input.problem;
  Solver solver(input.method);
  const std::string_view unit = quantity(variable).unit;
  io::Json curve = {{"theory", io::to_word(input.method.theory)}, {"variable", variable}, {"unit", unit}};
  for (const char* member : {"value", "fx", "fy", "mz", "status"}) curve[member] = io::Json::array();
  for (int k = 0; k < count; ++k) {
    const double value = from + (to - from) * k / (count - 1);
    creepage_of(problem.motion.creepage, variable) = value;
    const ContactForces forces = solver.solve(problem).forces();
    curve["value"].push_back(io::json_number(value));
    curve["fx"].push_back(io::json_number(forces.fx));
    curve["fy"].push_back(io::json_number(forces.fy));
    curve["mz"].push_back(io::json_number(forces.mz));
    curve["status"].push_back(to_string(forces.status));
  }
  curve["units"] = {{"value", unit}};
  for (const char* force : {"fx", "fy", "mz"}) curve["units"][force] = quantity(force).unit;
  return curve;
}

io::Json Explorer::transient(const Request& request) {
  request.allow({"case"});
  return rolling_start(CaseText(request, case_name_, files_).rolling_case(tables_));
}

io::Json Explorer::nip(const Request& request) {
  request.allow({"case"});
  return nips_.solve(CaseText(request, case_name_, files_).rolling_case(tables_));
}

io::Json Explorer::nip_curve(const Request& request) {
  request.allow({"case", "count"});
  const io::RollingCase input = CaseText(request, case_name_, files_).rolling_case(tables_);
  return nips_.curve(input, request.count("count", description::between(2, most_points)));
}

io::Json Explorer::profile(const Request& request) {
  request.allow({"name", "text", "role", "format", "unit", "y_axis", "z_axis", "section", "smoothing_length"});
  const std::string name = request.text("name");
  const cases::ProfileFindings findings =
      cases::find_dimensions(io::parse_profile(request.text("text"), name, profile_options(request)));
  io::JsonResult curves({.kind = "profile", .title = name}, io::JsonFields::kept);
  cases::write_result(findings, curves);
  io::Json all = curves.document();
  const io::Json units = all["units"];
  all.update(cases::profile_document(findings));
  all["units"].update(units);
  return all;
}

io::Json Explorer::conicity(const Request& request) {
  request.allow({"case", "files", "amplitudes"});
  take_files(request);
  const CaseText given(request, case_name_, files_);
  const io::WheelRailCase read = given.wheel_rail_case(tables_);
  const auto range = request.numbers("amplitudes", 3).value_or(std::vector<double>{1e-3, 7e-3, 2e-4});
  cases::ConicityInput input{.track = read.track, .wheelset = read.wheelset};
  input.amplitudes = cases::amplitude_range("request.amplitudes", range[0], range[1], range[2]);
  const WheelsetSearch::Side side = {read.rail.profile, read.wheel.profile};
  io::Json all = cases::conicity_document(input, cases::find_conicity(input, side, side, true), side, side);
  all["units"] = cases::conicity_units();
  return all;
}

io::Json Explorer::description(const Request& request) {
  request.allow({});
  return explorer::description();
}

io::Json Explorer::version(const Request& request) {
  request.allow({});
  const BuildInfo build = build_info();
  return {{"version", build.version},
          {"commit", build.commit},
          {"compiler", build.compiler},
          {"vector_lanes", has_vector_lanes()},
          {"result_format", io::result_format}};
}

} // namespace microslip::explorer
