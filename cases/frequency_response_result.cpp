#include "cases/frequency_response_result.hpp"

#include "microslip/decimal.hpp"
#include "microslip/error.hpp"
#include "microslip/response/remington_filter.hpp"
#include "microslip/rolling/solver.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace microslip::cases {
namespace {

constexpr double elements_in_wave = 8; // that a grid resolves it with

struct Column {
  std::string name, unit, description;
  std::vector<double> values;
};

struct Force {
  const char *name, *unit, *text;
};
constexpr Force forces[3] = {{"fx", "N", "Fx"}, {"fy", "N", "Fy"}, {"mz", "N m", "Mz"}};

struct Cause {
  const char *name, *unit, *text;
};
constexpr Cause causes[5] = {{"creepage_longitudinal", "", "the longitudinal creepage"},
                             {"creepage_lateral", "", "the lateral creepage"},
                             {"spin", " m", "spin"},
                             {"normal_force", "/N", "the normal force"},
                             {"roughness", "/m", "roughness"}};

std::complex<double> response(const ForceResponse& r, int force, int cause) {
  return cause < 3 ? r.by_creepage[force][cause] : cause == 3 ? r.by_load[force] : r.by_roughness[force];
}
std::complex<double> work(const ForceResponse& r, int cause) {
  return cause < 3 ? r.work_by_creepage[cause] : cause == 3 ? r.work_by_load : r.work_by_roughness;
}

/// Adds the real and the imaginary part of a number of all responses.
template <class Items, class Number>
void add_complex(std::vector<Column>& columns, const std::string& name, const std::string& unit,
                 const std::string& text, const Items& items, const Number& number) {
  Column real{name + "_real", unit, text + ", real part", {}};
  Column imaginary{name + "_imaginary", unit, "imaginary part; of the other sign than the real one: a lag", {}};
  for (const auto& item : items) {
    const std::complex<double> value = number(item);
    real.values.push_back(value.real());
    imaginary.values.push_back(value.imag());
  }
  columns.push_back(std::move(real));
  columns.push_back(std::move(imaginary));
}

std::vector<Column> columns_of(const std::vector<ForceResponse>& at) {
  std::vector<Column> out;
  for (int j = 0; j < 5; ++j) {
    for (int i = 0; i < 3; ++i)
      add_complex(out, std::string(forces[i].name) + "_by_" + causes[j].name,
                  std::string(forces[i].unit) + causes[j].unit,
                  std::string("amplitude of ") + forces[i].text + " by that of " + causes[j].text, at,
                  [&](const ForceResponse& r) { return response(r, i, j); });
    add_complex(out, std::string("work_by_") + causes[j].name, j == 3 ? "-" : std::string("N") + causes[j].unit,
                std::string("amplitude of the frictional work per metre of the surface by that of ") + causes[j].text,
                at, [&](const ForceResponse& r) { return work(r, j); });
  }
  add_complex(out, "normal_force_by_roughness", "N/m", "amplitude of Fn by that of roughness at a given approach", at,
              [](const ForceResponse& r) { return r.load_by_roughness; });
  return out;
}

std::vector<Column> columns_of(const ContactResponse& contact) {
  std::vector<Column> out = {{"frequency", "Hz", "rolling speed over the wavelength", contact.frequencies}};
  for (Column& column : columns_of(contact.response.at)) out.push_back(std::move(column));
  out.push_back({"contact_filter", "-",
                 "normal force that a roughness wave makes at a given approach, over that of an endless one",
                 contact.filter});
  out.push_back({"remington_filter", "-",
                 "Remington's filter with alpha = 1, for roughness that changes across the track", contact.remington});
  out.push_back({"even_filter", "-", "the same with alpha = 0: the even mean over a disk", contact.even});
  if (contact.growth.empty()) return out;
  add_complex(out, "growth", "-", "growth of corrugation by a passage, over itself", contact.growth,
              [](const CorrugationGrowth& g) { return g.rate; });
  add_complex(out, "dynamic_force_by_roughness", "N/m", "amplitude of Fn with the bodies' receptance", contact.growth,
              [](const CorrugationGrowth& g) { return g.normal_force; });
  return out;
}

Method method_of(const io::RollingCase& input) {
  Method method = input.method.theory == Theory::exact ? input.method : Method{};
  method.theory = Theory::exact;
  method.accuracy.reset();
  return method;
}

/// The contact's length and width, by the elements that carry pressure [m].
Vec2 size_of(const ContactSolution& solution) {
  const ElementGrid& grid = solution.elements.grid;
  int left = grid.mx, right = -1, low = grid.my, high = -1;
  for (std::size_t k = 0; k < solution.fields.pressure.size(); ++k) {
    if (!(solution.fields.pressure[k] > 0)) continue;
    const int i = static_cast<int>(k % grid.mx), j = static_cast<int>(k / grid.mx);
    left = std::min(left, i), right = std::max(right, i), low = std::min(low, j), high = std::max(high, j);
  }
  return {(right - left + 1) * grid.dx, (high - low + 1) * grid.dy};
}

/// Wavenumbers with that of endless waves first.
std::vector<double> wavenumbers_of(const ResponseQuestions& questions) {
  std::vector<double> out = {0};
  for (const double length : questions.wavelengths) out.push_back(2 * std::numbers::pi / length);
  return out;
}

/// A fit to all responses, endless waves among them.
ForceElementFit fit_of(const FrequencyResponse& response, double normal_force, int poles) {
  FrequencyResponse ascending{.solution = response.solution, .at = response.at};
  const auto less = [](const ForceResponse& a, const ForceResponse& b) { return a.wavenumber < b.wavenumber; };
  const auto same = [](const ForceResponse& a, const ForceResponse& b) { return a.wavenumber == b.wavenumber; };
  std::sort(ascending.at.begin(), ascending.at.end(), less);
  ascending.at.erase(std::unique(ascending.at.begin(), ascending.at.end(), same), ascending.at.end());
  return fit_force_element(ascending, normal_force, poles);
}

double normal_force_of(const ContactSolution& solution) {
  double sum = 0;
  for (std::size_t k = 0; k < solution.elements.size(); ++k)
    sum += solution.fields.pressure[k] * solution.elements.area[k];
  return sum;
}

ContactResponse contact_of(FrequencyResponse response, const ResponseQuestions& questions, std::string name,
                           double speed) {
  constexpr double alpha = 1;
  ContactResponse out{.name = std::move(name),
                      .frequencies = {},
                      .filter = {},
                      .remington = {},
                      .even = {},
                      .response = std::move(response),
                      .quasistatic = {}};
  if (questions.poles > 0) out.element = fit_of(out.response, normal_force_of(out.response.solution), questions.poles);
  out.quasistatic = out.response.at.front();
  out.response.at.erase(out.response.at.begin());
  const auto [length, width] = size_of(out.response.solution);
  for (const ForceResponse& at : out.response.at) {
    out.frequencies.push_back(speed * at.wavenumber / (2 * std::numbers::pi));
    out.filter.push_back(std::abs(at.load_by_roughness) / out.response.normal_stiffness);
    out.remington.push_back(remington_filter(length / 2, alpha, at.wavenumber));
    out.even.push_back(remington_filter(length / 2, 0, at.wavenumber));
  }
  if (questions.receptance)
    out.growth = corrugation_growth(out.response, speed, *questions.receptance,
                                    {questions.wear_coefficient, questions.band_width.value_or(width)});
  return out;
}

/// Throws Error for wavelengths whose frequency the receptance does not have.
void require_receptance(const ResponseQuestions& questions, double speed) {
  if (!questions.receptance) return;
  for (const double length : questions.wavelengths) questions.receptance->at(speed / length);
}

void warn_of_short_waves(const ResponseQuestions& questions, FrequencyResponseResult& out) {
  const double shortest = *std::min_element(questions.wavelengths.begin(), questions.wavelengths.end());
  for (const ContactResponse& contact : out.contacts) {
    const double resolved = elements_in_wave * contact.response.solution.elements.grid.dx;
    if (shortest >= resolved) continue;
    const double longer = resolved / shortest;
    out.warnings.push_back((contact.name.empty() ? "" : contact.name + ": ") + "waves shorter than " +
                           rounded_text(1e3 * resolved, 3) + " mm have fewer than " +
                           rounded_text(elements_in_wave, 3) + " elements: responses to them are rough; " +
                           rounded_text(longer, 3) + " times as many elements along the track resolve all");
  }
}

} // namespace

FrequencyResponseResult find_frequency_response(const io::RollingCase& input, const ResponseQuestions& questions,
                                                const Progress& progress) {
  FrequencyResponseResult out{.wavelengths = questions.wavelengths, .contacts = {}, .unsolved = {}, .warnings = {}};
  require_receptance(questions, input.problem.motion.rolling_speed);
  FrequencyResponse response =
      Solver(method_of(input)).respond(input.problem, wavenumbers_of(questions), progress, ResponseTo::roughness_too);
  if (response.at.empty()) {
    out.unsolved = response.solution.report.reason;
    return out;
  }
  ContactResponse contact = contact_of(std::move(response), questions, "", input.problem.motion.rolling_speed);
  if (is_hertzian(input.problem)) {
    const EllipticContact ellipse = elliptic_contact(input.problem);
    for (std::size_t k = 0; k < contact.filter.size(); ++k)
      contact.filter[k] = std::abs(contact_filter(ellipse.a, ellipse.b, contact.response.at[k].wavenumber));
  }
  out.contacts.push_back(std::move(contact));
  warn_of_short_waves(questions, out);
  return out;
}

FrequencyResponseResult find_frequency_response(const io::WheelRailCase& input, const ResponseQuestions& questions,
                                                const Progress& progress) {
  if (input.states.size() > 1) throw Error("responses: of a single state, not of a sweep");
  FrequencyResponseResult out{.wavelengths = questions.wavelengths, .contacts = {}, .unsolved = {}, .warnings = {}};
  WheelRailMethod method = input.method;
  method.theory = Theory::exact;
  WheelRail solver = io::solver_of(input, method);
  WheelRailSolution solution;
  const io::LoadedWheelState& state = input.states.front();
  auto responses = solver.respond(state.state, state.vertical_force, wavenumbers_of(questions), solution, progress);
  for (const std::string_view text : solution.warnings.texts()) out.warnings.emplace_back(text);
  for (std::size_t k = 0; k < responses.size(); ++k) {
    if (responses[k].at.empty()) {
      out.unsolved = responses[k].solution.report.reason;
      out.contacts.clear();
      return out;
    }
    responses[k].solution.creepage = solution.patches[k].creepage; // its rows have theirs on top of none
    out.contacts.push_back(contact_of(std::move(responses[k]), questions, "patch" + std::to_string(k + 1),
                                      solution.patches[k].rolling_speed));
    if (solution.patches[k].conformity > 0)
      out.warnings.push_back(
          "patch" + std::to_string(k + 1) +
          ": what the rows' angles add to the displacements of this conformal patch does not oscillate");
  }
  if (responses.empty())
    out.unsolved = std::string(to_string(solution.status));
  else
    warn_of_short_waves(questions, out);
  return out;
}

namespace {

void write_contact(io::ResultWriter& file, const ContactResponse& contact) {
  const std::string group = contact.name.empty() ? "" : contact.name + "/";
  for (const Column& column : columns_of(contact))
    file.array(group + column.name, column.values, column.unit, column.description);
  for (const Column& column : columns_of(std::vector{contact.quasistatic}))
    if (column.name.ends_with("_real"))
      file.scalar(group + "quasistatic/" + column.name.substr(0, column.name.size() - 5), column.values[0], column.unit,
                  "the derivative, the response to endless waves");
  file.scalar(group + "normal_stiffness", contact.response.normal_stiffness, "N/m", "dFn by the approach");
  if (contact.element) file.text(group + "force_element", text_of(*contact.element), "rational fit as a force element");
}

io::Json document_of(const ContactResponse& contact) {
  io::Json document, units;
  for (const Column& column : columns_of(contact)) {
    document[column.name] = column.values;
    units[column.name] = column.unit;
  }
  document["normal_stiffness"] = contact.response.normal_stiffness;
  units["normal_stiffness"] = "N/m";
  if (contact.element) document["force_element"] = text_of(*contact.element);
  document["units"] = units;
  return document;
}

} // namespace

void write_frequency_response(io::ResultWriter& file, const FrequencyResponseResult& result) {
  file.array("wavelength", result.wavelengths, "m", "along the track");
  for (const ContactResponse& contact : result.contacts) write_contact(file, contact);
}

io::Json frequency_response_document(const FrequencyResponseResult& result) {
  const bool of_patches = !result.contacts.front().name.empty();
  io::Json document = of_patches ? io::Json::object() : document_of(result.contacts.front());
  if (of_patches) {
    document["patches"] = io::Json::array();
    for (const ContactResponse& contact : result.contacts) document["patches"].push_back(document_of(contact));
  }
  document["wavelength"] = result.wavelengths;
  document["units"]["wavelength"] = "m";
  document["warnings"] = result.warnings;
  return document;
}

} // namespace microslip::cases
