#include "cases/frequency_response_result.hpp"

#include "microslip/decimal.hpp"
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
constexpr Cause causes[4] = {{"creepage_longitudinal", "", "the longitudinal creepage"},
                             {"creepage_lateral", "", "the lateral creepage"},
                             {"spin", " m", "spin"},
                             {"normal_force", "/N", "the normal force"}};

std::complex<double> response(const ForceResponse& r, int force, int cause) {
  return cause < 3 ? r.by_creepage[force][cause] : r.by_load[force];
}

/// The real and the imaginary parts of all responses.
std::vector<Column> columns_of(const std::vector<ForceResponse>& at) {
  std::vector<Column> out;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j) {
      const std::string name = std::string(forces[i].name) + "_by_" + causes[j].name;
      const std::string unit = std::string(forces[i].unit) + causes[j].unit;
      Column real{name + "_real",
                  unit,
                  std::string("amplitude of ") + forces[i].text + " by that of " + causes[j].text + ", real part",
                  {}};
      Column imaginary{name + "_imaginary", unit, "imaginary part; of the other sign than the real one: a lag", {}};
      for (const ForceResponse& r : at) {
        const std::complex<double> value = response(r, i, j);
        real.values.push_back(value.real());
        imaginary.values.push_back(value.imag());
      }
      out.push_back(std::move(real));
      out.push_back(std::move(imaginary));
    }
  return out;
}

std::vector<Column> columns_of(const FrequencyResponseResult& result) {
  std::vector<Column> out = {{"wavelength", "m", "along the track", result.wavelengths},
                             {"frequency", "Hz", "rolling speed over the wavelength", result.frequencies}};
  for (Column& column : columns_of(result.response.at)) out.push_back(std::move(column));
  out.push_back({"contact_filter", "-",
                 "normal force that a roughness wave makes at a given approach, over that of an endless one",
                 result.filter});
  return out;
}

Method method_of(const io::RollingCase& input) {
  Method method = input.method.theory == Theory::exact ? input.method : Method{};
  method.theory = Theory::exact;
  method.accuracy.reset();
  return method;
}

} // namespace

FrequencyResponseResult find_frequency_response(const io::RollingCase& input, const std::vector<double>& wavelengths,
                                                const Progress& progress) {
  FrequencyResponseResult out{
      .wavelengths = wavelengths, .frequencies = {}, .filter = {}, .response = {}, .quasistatic = {}, .warnings = {}};
  std::vector<double> wavenumbers = {0};
  for (const double length : wavelengths) wavenumbers.push_back(2 * std::numbers::pi / length);
  const Method method = method_of(input);
  out.response = Solver(method).respond(input.problem, wavenumbers, progress);
  if (out.response.at.empty()) return out;
  out.quasistatic = out.response.at.front();
  out.response.at.erase(out.response.at.begin());
  const EllipticContact contact = elliptic_contact(input.problem);
  for (std::size_t k = 0; k < wavelengths.size(); ++k) {
    out.frequencies.push_back(contact.rolling_speed / wavelengths[k]);
    out.filter.push_back(contact_filter(contact.a, contact.b, wavenumbers[k + 1]));
  }
  const double shortest = *std::min_element(wavelengths.begin(), wavelengths.end());
  const double resolved = elements_in_wave * 2 * contact.a / method.mx;
  if (shortest < resolved)
    out.warnings.push_back("waves shorter than " + rounded_text(1e3 * resolved, 3) + " mm have fewer than " +
                           rounded_text(elements_in_wave, 3) +
                           " elements: responses to them are rough; a solution.grid with " +
                           rounded_text(std::ceil(elements_in_wave * 2 * contact.a / shortest), 9) +
                           " elements along the track resolves all");
  return out;
}

void write_frequency_response(io::ResultWriter& file, const FrequencyResponseResult& result) {
  for (const Column& column : columns_of(result))
    file.array(column.name, column.values, column.unit, column.description);
  for (const Column& column : columns_of({result.quasistatic}))
    if (column.name.ends_with("_real"))
      file.scalar("quasistatic/" + column.name.substr(0, column.name.size() - 5), column.values[0], column.unit,
                  "the derivative, the response to endless waves");
}

io::Json frequency_response_document(const FrequencyResponseResult& result) {
  io::Json document, units;
  for (const Column& column : columns_of(result)) {
    document[column.name] = column.values;
    units[column.name] = column.unit;
  }
  document["units"] = units;
  document["warnings"] = result.warnings;
  return document;
}

} // namespace microslip::cases
