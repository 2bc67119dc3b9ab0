#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace microslip::campaign {

/// The whole text of a file; Error if it cannot be read.
std::string read_text(const std::filesystem::path& path);

/// Separator of the fields of a table, by its first line that is not blank.
char separator_of(std::string_view text);

/// Calls `take` with fields and number of each line of a table that is not blank, the headings' first; its Errors get
/// file and line. Fields are separated by separator_of the text.
void visit_lines(std::string_view text, const std::string& file,
                 const std::function<void(const std::vector<std::string_view>& fields, std::size_t line)>& take);

/// Numbers of a table's column.
struct TableColumn {
  std::vector<double> numbers;
  std::string unit; ///< that of its heading, "load [kN]"; empty if it has none
};

/// The column with a name; that of a table of one column may be empty. Throws Error with file and line for a table
/// without it, with the nearest of its names, for a line that has not a field for each heading, and for a field that is
/// no number.
TableColumn read_column(std::string_view text, const std::string& file, const std::string& name);

} // namespace microslip::campaign
