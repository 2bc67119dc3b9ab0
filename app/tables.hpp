#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace microslip::app {

/// Writes a result as tables of CSV, see io/csv_tables.hpp, by way of a result file under a temporary name that
/// `write_result` makes. Returns the names of the tables. `csv` ends with .csv.
std::vector<std::string>
write_tables(const std::filesystem::path& csv,
             const std::function<void(const std::filesystem::path& result_file)>& write_result);

/// Prints the names of files, a line each.
void print_files(const std::vector<std::string>& files);

} // namespace microslip::app
