#pragma once

#include "campaign/campaign.hpp"
#include "campaign/sweep.hpp"
#include "io/result_writer.hpp"
#include "microslip/progress.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace microslip::campaign {

/// Kind of a sweep's result files.
inline constexpr const char* sweep_kind = "sweep";
/// Root attribute of samples: the word of what their cases are for, see SampleAim.
inline constexpr const char* sample_aim_name = "sample_aim";

/// Outcomes of the cases of a sweep.
struct SweepCount {
  std::size_t cases = 0, failed = 0;
  std::vector<std::string> warnings = {}; ///< what makes cases doubtful, and how many
};

/// Checkpoint folder of a sweep that writes to `output`: OUT.h5.checkpoint.
std::filesystem::path checkpoint_of(const std::filesystem::path& output);

/// Outcomes of the cases in the file at `path`, if it is there: the complete result of this very sweep. Throws Error if
/// it is another file, which took as long to compute, perhaps.
std::optional<SweepCount> find_sweep(const Sweep& sweep, const std::filesystem::path& path);

/// Writes the rows of a campaign in which nothing is missing as HDF5, in constant memory: `parameters/KEY`, the columns
/// of the sweep that any case has, `failures/case` and `failures/reason`. The file appears whole or not at all. Throws
/// Error if it cannot be written, and Stopped if `progress` returns false.
SweepCount write_sweep(const Sweep& sweep, const Campaign& campaign, const io::Provenance& provenance,
                       const std::filesystem::path& path, const Progress& progress = {});

} // namespace microslip::campaign
