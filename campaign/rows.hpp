#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace microslip::campaign {

/// A campaign: `count` cases, a row of `width` numbers for each, computed and kept by chunks of cases.
struct CampaignPlan {
  std::uint64_t identity = 0; ///< a hash of all that the rows depend on (hash_of): tells campaigns apart
  std::size_t count = 0;      ///< cases, 1 to most_cases
  std::size_t width = 0;      ///< numbers of a row, >= 1
  std::size_t chunk = 1;      ///< cases that are handed out, and kept, at a time; at most most_chunks chunks

  std::size_t chunks() const { return (count + chunk - 1) / chunk; }
  std::size_t first_of(std::size_t number) const { return number * chunk; }
  /// The last chunk may be shorter.
  std::size_t cases_of(std::size_t number) const { return std::min(chunk, count - first_of(number)); }
};

inline constexpr std::size_t most_chunks = 4'000'000;

/// A case whose row is not to be trusted, and why.
struct FailedCase {
  std::size_t index = 0;
  std::string reason;

  bool operator==(const FailedCase&) const = default;
};

/// The rows of a chunk.
struct CampaignRows {
  std::size_t number = 0;         ///< of the chunk, from 0
  std::vector<double> values;     ///< row after row
  std::vector<FailedCase> failed; ///< ascending

  bool operator==(const CampaignRows&) const = default;
};

} // namespace microslip::campaign
