#include "validation/error_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace microslip::validation {

ErrorStatistics statistics(std::vector<double>& errors) {
  if (errors.empty()) return {};
  std::sort(errors.begin(), errors.end());
  const auto n = errors.size();
  const auto share = [&](double p) { return errors[static_cast<std::size_t>(std::ceil(p * double(n))) - 1]; };
  const double squares = std::inner_product(errors.begin(), errors.end(), errors.begin(), 0.0);
  return {share(0.8), share(0.95), std::sqrt(squares / double(n)), errors.back(), share(0.5), share(0.99)};
}

} // namespace microslip::validation
