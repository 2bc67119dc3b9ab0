#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace microslip::app {

/// What writes or reads a result file of this name.
using UseOfFile = std::function<void(const std::filesystem::path& result_file)>;

/// Makes something of a result file that is not kept: `write` writes it under a temporary name beside `output`.
void with_result_file(const std::filesystem::path& output, const UseOfFile& write, const UseOfFile& use);

/// Writes a result as tables of CSV, see io/csv_tables.hpp. Returns the names of the tables. `csv` ends with .csv.
std::vector<std::string> write_tables(const std::filesystem::path& csv, const UseOfFile& write_result);

/// Prints the names of files, a line each.
void print_files(const std::vector<std::string>& files);

} // namespace microslip::app
