#include "app/tables.hpp"

#include "io/csv_tables.hpp"
#include "io/output_file.hpp"

#include <cstdio>

#include <fmt/format.h>

namespace microslip::app {

namespace fs = std::filesystem;

void with_result_file(const fs::path& output, const UseOfFile& write, const UseOfFile& use) {
  const io::OutputFile scratch(fs::path(output).replace_extension(".h5"));
  write(scratch.temporary());
  use(scratch.temporary());
}

std::vector<std::string> write_tables(const fs::path& csv, const UseOfFile& write_result) {
  std::vector<std::string> names;
  with_result_file(csv, write_result, [&](const fs::path& result_file) {
    for (const fs::path& table : io::write_csv_tables(result_file, csv)) names.push_back(table.string());
  });
  return names;
}

void print_files(const std::vector<std::string>& files) {
  for (const std::string& file : files) fmt::print("{}\n", file);
  std::fflush(stdout);
}

} // namespace microslip::app
