#pragma once

#include <vector>

namespace microslip::validation {

/// Statistics of a set of errors, as the papers print them.
struct ErrorStatistics {
  double p80, p95, rms, largest; ///< 80 % and 95 % of the errors are at most this large; root mean square; the largest
  double median = 0, p99 = 0;
};

/// Statistics of errors >= 0; sorts them.
ErrorStatistics statistics(std::vector<double>& errors);

} // namespace microslip::validation
