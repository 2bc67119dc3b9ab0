#pragma once

#include "campaign/statistics.hpp"
#include "io/result_writer.hpp"

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace microslip::campaign {

/// Kind of the result files of statistics.
inline constexpr const char* statistics_kind = "statistics";

struct StatisticsOptions {
  std::vector<std::string> quantities = {}; ///< their names, "fx" or "contact/fx"; empty: all that the file has
  std::vector<double> probabilities = {0.05, 0.5, 0.95}; ///< of the quantiles, in (0, 1)
  std::string group_by = {}; ///< a parameter: statistics for each of its values; empty: of all cases
};

/// What the cases of a group say of a quantity.
struct QuantityStatistics {
  Spread spread;
  std::vector<SobolIndex> indices; ///< of each parameter, of cases made for them; else empty
};

/// Cases that have a value of a parameter in common.
struct CaseGroup {
  double number = 0;     ///< the value, or else
  std::string text = {}; ///< as text
  std::size_t cases = 0;
  std::map<std::string, std::size_t> statuses = {}; ///< cases whose status is not ok, which statistics leave out
  std::vector<QuantityStatistics> quantities = {};  ///< in the order of SweepStatistics::quantities
};

/// A quantity of a sweep's result file.
struct SweepQuantity {
  std::string path, unit, description;
};

struct SweepStatistics {
  std::string title;
  std::vector<SweepQuantity> quantities;
  std::vector<double> probabilities;
  std::vector<std::string> parameters; ///< that vary
  std::string group_by, group_unit;    ///< the unit is empty where values are texts
  bool has_indices = false;
  std::vector<CaseGroup> groups; ///< ascending; one, without a value, of all cases
};

/// Statistics of the cases in the result file of a sweep. Of cases for Sobol's indices only A and B count in quantiles
/// and means. Memory: that of one quantity of all cases. Throws Error with the file's name for one of another kind, for
/// names that it does not have, and for groups by a parameter of more than 1,000 values.
SweepStatistics sweep_statistics(const std::filesystem::path& result_file, const StatisticsOptions& options);

/// Writes them: `cases`, the `shares` of each status, and below each quantity's path `mean`, `quantiles` and so on, an
/// entry for each group, further dimensions for probabilities and parameters.
void write_statistics(const SweepStatistics& statistics, io::ResultWriter& writer);

} // namespace microslip::campaign
