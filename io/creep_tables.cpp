#include "io/creep_tables.hpp"

#include "io/creep_table_file.hpp"
#include "io/toml_section.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <string>

namespace microslip::io {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_tables = 8; ///< some ten MB each

std::shared_ptr<const CreepForceTable> make(const CreepTableSource& source, std::optional<double> poisson_ratio,
                                            RollingDirection direction) {
  if (poisson_ratio) return std::make_shared<const CreepForceTable>(source, *poisson_ratio, direction);
  return std::make_shared<const CreepForceTable>(source, direction);
}

} // namespace

std::shared_ptr<const CreepForceTable> CreepTables::get(const fs::path& file, std::optional<double> poisson_ratio,
                                                        RollingDirection direction) const {
  const std::scoped_lock lock(mutex_);
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) {
    return e.file == file && e.poisson_ratio == poisson_ratio && e.direction == direction;
  });
  if (found != entries_.end()) {
    std::rotate(found, found + 1, entries_.end());
  } else {
    const auto same_file =
        std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.file == file; });
    const CreepTableSource source = same_file != entries_.end() ? same_file->source : creep_table_source(file);
    entries_.push_back({file, source, poisson_ratio, direction, make(source, poisson_ratio, direction)});
  }
  if (entries_.size() > most_tables) entries_.erase(entries_.begin());
  return entries_.back().table;
}

std::shared_ptr<const CreepForceTable>
CreepTables::get(const TomlSection& solution, std::optional<double> poisson_ratio, RollingDirection direction) const {
  const bool is_named = solution.has("table");
  std::shared_ptr<const CreepForceTable> table;
  solution.at(is_named ? "table" : "theory", [&] {
    const fs::path file =
        is_named ? fs::path(solution.file()).parent_path() / solution.required_text("table") : shipped_creep_table();
    try {
      table = get(file, poisson_ratio, direction);
    } catch (const Error& error) {
      throw Error(std::string("solution.table: ") + error.what());
    }
  });
  return table;
}

} // namespace microslip::io
