#pragma once

#include "io/case_file.hpp"
#include "io/json.hpp"
#include "io/result_writer.hpp"
#include "io/wheel_rail_case.hpp"
#include "microslip/progress.hpp"
#include "microslip/response/corrugation.hpp"
#include "microslip/response/force_element.hpp"
#include "microslip/rolling/frequency_response.hpp"

#include <optional>
#include <string>
#include <vector>

namespace microslip::cases {

/// What `microslip respond` is asked for.
struct ResponseQuestions {
  std::vector<double> wavelengths;           ///< along the track [m]
  std::optional<Receptance> receptance = {}; ///< of wheel and rail, for the growth of corrugation
  double wear_coefficient = 1e-13;           ///< volume by frictional work [m^3/J]
  std::optional<double> band_width = {};     ///< that wear is spread over [m]; none: the contact's width
  int poles = 0;                             ///< of a rational fit as a force element; none: no fit
};

/// What it finds of a contact.
struct ContactResponse {
  std::string name;                    ///< "patch1"; empty where there is one contact alone
  std::vector<double> frequencies;     ///< V/wavelength [Hz]
  std::vector<double> filter;          ///< normal force by roughness, over that of endless waves: its size [-]
  std::vector<double> remington, even; ///< Remington's filter with alpha = 1 and 0, of half the contact's length [-]
  FrequencyResponse response;          ///< at the wavelengths
  ForceResponse quasistatic;           ///< of endless waves: the derivatives
  std::vector<CorrugationGrowth> growth = {}; ///< with a receptance
  std::optional<ForceElementFit> element = {};
};

struct FrequencyResponseResult {
  std::vector<double> wavelengths;       ///< [m]
  std::vector<ContactResponse> contacts; ///< patches of a wheel in their order; none of an unsolved steady state
  std::string unsolved;                  ///< why there are none
  std::vector<std::string> warnings;
};

/// By the exact theory on the grid of a case that is solved by it, else on the default one. Throws Error as
/// Solver::respond, and WheelRail::respond.
FrequencyResponseResult find_frequency_response(const io::RollingCase& input, const ResponseQuestions& questions,
                                                const Progress& progress = {});
FrequencyResponseResult find_frequency_response(const io::WheelRailCase& input, const ResponseQuestions& questions,
                                                const Progress& progress = {});

/// Arrays over the wavelength, real and imaginary parts apart, and the same of endless waves under quasistatic/; of a
/// wheel's patches each under its name.
void write_frequency_response(io::ResultWriter& file, const FrequencyResponseResult& result);
/// The same as a document with its units; of a wheel `patches`, in their order.
io::Json frequency_response_document(const FrequencyResponseResult& result);

} // namespace microslip::cases
