#pragma once

#include "microslip/table/creep_force_table.hpp"

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace microslip::io {

class TomlSection;

/// Creep-force tables by the files they come from, each file read once, for readers of many cases. It keeps the last
/// few. From any thread.
class CreepTables {
public:
  /// The table in a file for one Poisson's ratio, or for all that it has. Throws Error as read_creep_table. Cost as
  /// that of a CreepForceTable, or nothing if it is there.
  std::shared_ptr<const CreepForceTable> get(const std::filesystem::path& file, std::optional<double> poisson_ratio,
                                             RollingDirection direction) const;

  /// Table for the [solution] of a case: its `table`, from the case's folder on, or the built-in one.
  /// Throws Error with the case's file and line.
  std::shared_ptr<const CreepForceTable> get(const TomlSection& solution, std::optional<double> poisson_ratio,
                                             RollingDirection direction) const;

private:
  struct Entry {
    std::filesystem::path file;
    CreepTableSource source;
    std::optional<double> poisson_ratio;
    RollingDirection direction;
    std::shared_ptr<const CreepForceTable> table;
  };

  mutable std::mutex mutex_;
  mutable std::vector<Entry> entries_; ///< the one that was asked for last stands last
};

} // namespace microslip::io
