#pragma once

#include "io/case_file.hpp"
#include "io/json.hpp"
#include "io/result_writer.hpp"
#include "microslip/progress.hpp"
#include "microslip/rolling/frequency_response.hpp"

#include <string>
#include <vector>

namespace microslip::cases {

/// What `microslip respond` finds of a case.
struct FrequencyResponseResult {
  std::vector<double> wavelengths; ///< [m]
  std::vector<double> frequencies; ///< V/wavelength [Hz]
  std::vector<double> filter;      ///< contact_filter of waves along the track [-]
  FrequencyResponse response;      ///< at these; of an unsolved steady state nothing
  ForceResponse quasistatic;       ///< of endless waves: the derivatives
  std::vector<std::string> warnings;
};

/// By the exact theory on the grid of a case that is solved by it, else on the default one. Throws Error as
/// Solver::respond.
FrequencyResponseResult find_frequency_response(const io::RollingCase& input, const std::vector<double>& wavelengths,
                                                const Progress& progress = {});

/// Arrays over the wavelength, real and imaginary parts apart, and the same of endless waves under quasistatic/.
void write_frequency_response(io::ResultWriter& file, const FrequencyResponseResult& result);
/// The same as a document with its units.
io::Json frequency_response_document(const FrequencyResponseResult& result);

} // namespace microslip::cases
