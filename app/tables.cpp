#include "app/tables.hpp"

#include "io/csv_tables.hpp"
#include "io/output_file.hpp"

#include <cstdio>

#include <fmt/format.h>

namespace microslip::app {

namespace fs = std::filesystem;

std::vector<std::string> write_tables(const fs::path& csv,
                                      const std::function<void(const fs::path& result_file)>& write_result) {
  const io::OutputFile scratch(fs::path(csv).replace_extension(".h5"));
  write_result(scratch.temporary());
  std::vector<std::string> names;
  for (const fs::path& table : io::write_csv_tables(scratch.temporary(), csv)) names.push_back(table.string());
  return names;
}

void print_files(const std::vector<std::string>& files) {
  for (const std::string& file : files) fmt::print("{}\n", file);
  std::fflush(stdout);
}

} // namespace microslip::app
