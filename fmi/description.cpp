#include "fmi/description.hpp"

#include "microslip/decimal.hpp"
#include "microslip/error.hpp"
#include "microslip/version.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

namespace microslip::fmi {
namespace {

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

/// The name of a unit in a description: of products with dots, of powers without a sign, 1 for none.
std::string unit_name(const std::string& unit) {
  if (unit == "-") return "1";
  std::string name;
  for (const char c : unit)
    if (c != '^') name += c == ' ' ? '.' : c;
  return name;
}

/// A unit as powers of kg, m, s, K and rad.
using Powers = std::array<int, 5>;
constexpr const char* bases[] = {"kg", "m", "s", "K", "rad"};

struct Symbol {
  std::string_view name;
  Powers powers;
};
constexpr Symbol symbols[] = {{"kg", {1, 0, 0, 0, 0}}, {"m", {0, 1, 0, 0, 0}},   {"s", {0, 0, 1, 0, 0}},
                              {"K", {0, 0, 0, 1, 0}},  {"rad", {0, 0, 0, 0, 1}}, {"N", {1, 1, -2, 0, 0}},
                              {"J", {1, 2, -2, 0, 0}}, {"W", {1, 2, -3, 0, 0}},  {"Pa", {1, -1, -2, 0, 0}},
                              {"1", {0, 0, 0, 0, 0}},  {"-", {0, 0, 0, 0, 0}}};

/// Powers of a product of symbols, divided by what follows the first slash: "N m", "W/m^2", "W/(m K)".
Powers powers_of(const std::string& unit) {
  Powers sum{};
  int sign = 1;
  for (std::size_t i = 0; i < unit.size();) {
    if (unit[i] == '/') sign = -1;
    if (unit[i] == '/' || unit[i] == ' ' || unit[i] == '(' || unit[i] == ')') {
      ++i;
      continue;
    }
    const std::size_t end = std::min(unit.find_first_of(" /^()", i), unit.size());
    const auto symbol = std::find_if(std::begin(symbols), std::end(symbols), [&](const Symbol& s) {
      return s.name == std::string_view(unit).substr(i, end - i);
    });
    if (symbol == std::end(symbols)) throw Error("the unit " + unit + " has no powers of base units");
    i = end;
    int power = 1;
    if (i < unit.size() && unit[i] == '^')
      i = static_cast<std::size_t>(std::from_chars(unit.data() + i + 1, unit.data() + unit.size(), power).ptr -
                                   unit.data());
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += sign * power * symbol->powers[k];
  }
  return sum;
}

/// Definitions of the units of variables, and with FMI 3.0 of time.
std::string unit_definitions(const ModelInfo& info, Version version) {
  std::set<std::string> units;
  for (const Variable& v : info.variables)
    if (v.kind == Kind::real) units.insert(v.unit);
  if (version == Version::fmi3) units.insert("s");
  std::string text = "  <UnitDefinitions>\n";
  for (const std::string& unit : units) {
    text += "    <Unit name=\"" + unit_name(unit) + "\"><BaseUnit";
    const Powers powers = powers_of(unit);
    for (std::size_t k = 0; k < powers.size(); ++k)
      if (powers[k] != 0) text += std::string(" ") + bases[k] + "=\"" + std::to_string(powers[k]) + "\"";
    text += "/></Unit>\n";
  }
  return text + "  </UnitDefinitions>\n";
}

bool has_start(const Variable& v) {
  return v.causality == Causality::input || v.causality == Causality::parameter;
}

/// Attributes of every variable, whatever the version.
std::string common_attributes(const Variable& v, std::size_t reference) {
  constexpr const char* causalities[] = {"parameter", "input", "output", "local"};
  const char* variability = v.causality == Causality::parameter ? "fixed"
                            : v.kind == Kind::real              ? "continuous"
                                                                : "discrete";
  std::string text = " name=\"" + escaped(v.name) + "\" valueReference=\"" + std::to_string(reference) +
                     "\" causality=\"" + causalities[static_cast<int>(v.causality)] + "\" variability=\"" +
                     variability + "\"";
  if (v.causality != Causality::input)
    text += std::string(" initial=\"") + (v.causality == Causality::parameter ? "exact" : "calculated") + "\"";
  return text + "\n      description=\"" + escaped(v.description) + "\"";
}

/// Unit, range and start of a number.
std::string number_attributes(const Variable& v) {
  const auto printed = [&](double value) {
    return v.kind == Kind::integer ? std::to_string(std::lround(value)) : shortest_text(value);
  };
  std::string text = v.kind == Kind::real ? " unit=\"" + unit_name(v.unit) + "\"" : "";
  if (std::isfinite(v.min)) text += " min=\"" + printed(v.min) + "\"";
  if (std::isfinite(v.max)) text += " max=\"" + printed(v.max) + "\"";
  if (has_start(v)) text += " start=\"" + printed(v.start) + "\"";
  return text;
}

/// FMI 2.0: types are elements of a variable. FMI 3.0: variables are elements of their type.
std::string variable_text(const Variable& v, std::size_t reference, Version version) {
  if (version == Version::fmi2) {
    constexpr const char* types[] = {"Real", "Integer", "String"};
    const std::string type = types[static_cast<int>(v.kind)];
    return "    <ScalarVariable" + common_attributes(v, reference) + ">\n      <" + type +
           (v.kind == Kind::text ? " start=\"" + escaped(v.start_text) + "\"" : number_attributes(v)) +
           "/></ScalarVariable>\n";
  }
  constexpr const char* types[] = {"Float64", "Int32", "String"};
  const std::string start = std::string("    <") + types[static_cast<int>(v.kind)] + common_attributes(v, reference);
  if (v.kind == Kind::text) return start + ">\n      <Start value=\"" + escaped(v.start_text) + "\"/></String>\n";
  return start + number_attributes(v) + "/>\n";
}

/// Inputs of a part, or these and parameters: by their indices from 1 on, with FMI 3.0 by their value references.
std::string dependencies(const ModelInfo& info, std::size_t part, bool with_parameters, Version version) {
  std::string text;
  for (std::size_t k = 0; k < info.variables.size(); ++k) {
    const Variable& v = info.variables[k];
    if ((v.causality == Causality::input && v.part == part) || (with_parameters && v.causality == Causality::parameter))
      text += (text.empty() ? "" : " ") + std::to_string(version == Version::fmi2 ? k + 1 : k);
  }
  return text;
}

/// Elements of all outputs, with what these depend on.
std::string unknowns(const ModelInfo& info, const std::string& element, bool with_parameters, Version version) {
  std::string text;
  for (std::size_t k = 0; k < info.variables.size(); ++k)
    if (info.variables[k].causality == Causality::output)
      text += "    <" + element + (version == Version::fmi2 ? " index=\"" : " valueReference=\"") +
              std::to_string(version == Version::fmi2 ? k + 1 : k) + "\" dependencies=\"" +
              dependencies(info, info.variables[k].part, with_parameters, version) + "\"/>\n";
  return text;
}

std::string model_structure(const ModelInfo& info, Version version) {
  if (version == Version::fmi3)
    return unknowns(info, "Output", false, version) + unknowns(info, "InitialUnknown", true, version);
  return "    <Outputs>\n" + unknowns(info, "Unknown", false, version) + "    </Outputs>\n    <InitialUnknowns>\n" +
         unknowns(info, "Unknown", true, version) + "    </InitialUnknowns>\n";
}

std::string model_exchange(const ModelInfo& info, Version version) {
  const std::string start =
      "  <ModelExchange modelIdentifier=\"" + info.identifier + "\" canBeInstantiatedOnlyOncePerProcess=\"false\"\n";
  if (version == Version::fmi3)
    return start + "    canGetAndSetFMUState=\"true\" canSerializeFMUState=\"false\"\n"
                   "    providesDirectionalDerivatives=\"true\" providesAdjointDerivatives=\"true\"/>\n";
  return start + "    completedIntegratorStepNotNeeded=\"false\" canNotUseMemoryManagementFunctions=\"true\"\n"
                 "    canGetAndSetFMUstate=\"true\" canSerializeFMUstate=\"false\" "
                 "providesDirectionalDerivative=\"true\"/>\n";
}

std::string co_simulation(const ModelInfo& info, Version version) {
  const std::string start = "  <CoSimulation modelIdentifier=\"" + info.identifier +
                            "\" canHandleVariableCommunicationStepSize=\"true\"\n"
                            "    maxOutputDerivativeOrder=\"0\" canBeInstantiatedOnlyOncePerProcess=\"false\"\n";
  if (version == Version::fmi3)
    return start + "    canGetAndSetFMUState=\"true\" canSerializeFMUState=\"false\" hasEventMode=\"false\"\n"
                   "    providesDirectionalDerivatives=\"true\" providesAdjointDerivatives=\"true\"/>\n";
  return start + "    canInterpolateInputs=\"false\" canRunAsynchronuously=\"false\"\n"
                 "    canNotUseMemoryManagementFunctions=\"true\" canGetAndSetFMUstate=\"true\"\n"
                 "    canSerializeFMUstate=\"false\" providesDirectionalDerivative=\"true\"/>\n";
}

std::string description_with(const ModelInfo& info, const std::string& guid, Version version) {
  const std::string program(build_info().version);
  const bool structured = std::any_of(info.variables.begin(), info.variables.end(),
                                      [](const Variable& v) { return v.name.find('.') != std::string::npos; });
  const bool is_fmi2 = version == Version::fmi2;
  std::string text = std::string("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fmiModelDescription fmiVersion=\"") +
                     (is_fmi2 ? "2.0" : "3.0") + "\" modelName=\"" + info.name + "\" " +
                     (is_fmi2 ? "guid" : "instantiationToken") + "=\"" + guid + "\"\n  description=\"" +
                     escaped(info.description) + "\"\n  version=\"" + program +
                     (is_fmi2 ? "\" numberOfEventIndicators=\"0" : "") + "\" generationTool=\"microslip " + program +
                     "\" variableNamingConvention=\"" + (structured ? "structured" : "flat") + "\">\n";
  if (!info.remembers) text += model_exchange(info, version);
  text += co_simulation(info, version) + unit_definitions(info, version);
  text += "  <LogCategories>\n"
          "    <Category name=\"logStatusError\" description=\"Why a call failed\"/>\n"
          "    <Category name=\"logStatusWarning\" description=\"What is probably wrong with the parameters\"/>\n"
          "  </LogCategories>\n"
          "  <DefaultExperiment startTime=\"0\" stopTime=\"1\" stepSize=\"0.001\"/>\n  <ModelVariables>\n";
  for (std::size_t k = 0; k < info.variables.size(); ++k) text += variable_text(info.variables[k], k, version);
  if (!is_fmi2)
    text += "    <Float64 name=\"time\" valueReference=\"" + std::to_string(info.variables.size()) +
            "\" causality=\"independent\" variability=\"continuous\"\n      description=\"Time of the simulation\" "
            "unit=\"s\"/>\n";
  return text + "  </ModelVariables>\n  <ModelStructure>\n" + model_structure(info, version) +
         "  </ModelStructure>\n</fmiModelDescription>\n";
}

/// FNV-1a.
std::uint64_t hash(const std::string& text, std::uint64_t start) {
  std::uint64_t h = start;
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return h;
}

} // namespace

std::string guid(const ModelInfo& info, Version version) {
  const std::string text = description_with(info, "", version);
  constexpr char digits[] = "0123456789abcdef";
  std::string out;
  for (const std::uint64_t start : {0xcbf29ce484222325U, 0x84222325cbf29ce4U}) {
    const std::uint64_t h = hash(text, start);
    for (int k = 60; k >= 0; k -= 4) out += digits[h >> k & 15U];
  }
  for (const std::size_t place : {20, 16, 12, 8}) out.insert(place, "-");
  return out;
}

std::string model_description(const ModelInfo& info, Version version) {
  return description_with(info, guid(info, version), version);
}

namespace {

std::string range_of(const Variable& v) {
  if (!std::isfinite(v.min) && !std::isfinite(v.max)) return "";
  return (std::isfinite(v.min) ? shortest_text(v.min) : "") + " to " +
         (std::isfinite(v.max) ? shortest_text(v.max) : "");
}

std::string row_of(const Variable& v) {
  const std::string start = v.kind == Kind::text ? escaped(v.start_text) : has_start(v) ? shortest_text(v.start) : "";
  return "<tr><td>" + escaped(v.name) + "</td><td>" + (v.kind == Kind::real ? escaped(v.unit) : "") + "</td><td>" +
         start + "</td><td>" + range_of(v) + "</td><td>" + escaped(v.description) + "</td></tr>\n";
}

} // namespace

std::string documentation(const ModelInfo& info) {
  std::string text =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + escaped(info.name) +
      "</title>\n<style>body{font-family:sans-serif;max-width:60em;margin:2em auto;padding:0 1em}"
      "td,th{text-align:left;padding:.2em .6em;border-bottom:1px solid #ccc;vertical-align:top}</style>"
      "</head><body>\n<h1>" +
      escaped(info.name) + "</h1>\n<p>" + escaped(info.description) + "</p>\n<p>" +
      (info.remembers ? "The unit remembers its inputs: it goes on by the steps of co-simulation, in which "
                        "they are constant. Derivatives are those at once. "
                      : "The unit has no states: outputs follow from inputs and parameters at once, and a "
                        "step of any length gives the same. ") +
      "Parameters are set before initialization ends. Directional "
      "derivatives are exact. A call that fails says through the importer's logger which variable is "
      "wrong, with its range.</p>\n";
  constexpr std::pair<Causality, const char*> groups[] = {{Causality::parameter, "Parameters"},
                                                          {Causality::input, "Inputs"},
                                                          {Causality::output, "Outputs"},
                                                          {Causality::local, "Local variables"}};
  for (const auto& [causality, title] : groups) {
    std::string rows;
    for (const Variable& v : info.variables)
      if (v.causality == causality) rows += row_of(v);
    if (!rows.empty())
      text += std::string("<h2>") + title +
              "</h2>\n<table><tr><th>name</th><th>unit</th><th>start</th><th>range</th><th></th></tr>\n" + rows +
              "</table>\n";
  }
  return text + "<p>microslip " + std::string(build_info().version) + "</p>\n</body></html>\n";
}

} // namespace microslip::fmi
