#pragma once

#include <filesystem>
#include <vector>

namespace microslip::io {

/// Writes what a result file holds as tables of CSV, each number with the digits that give it back to the bit, NaN as
/// an empty cell; headings are names with units, "fx [N]". Returns their names, that of `csv`, NAME.csv, first:
///
/// - with cases in the file (a sweep, several states of a wheel, a run): a row for each, its inputs first; of a sweep
///   all, with the reasons of those that are not solved, as `failures/reason`;
/// - else all single numbers and texts with units and descriptions, a row for each, which beside cases are
///   NAME.numbers.csv;
/// - NAME.GROUP.csv has the arrays of a group, a row for each entry: patches, cells with their places, points.
///
/// Only the `shape` of a grid of a sweep is left out, which its parameters tell. All files appear whole, or none.
/// Throws Error with a file's name. Memory does not depend on the length of arrays.
std::vector<std::filesystem::path> write_csv_tables(const std::filesystem::path& result_file,
                                                    const std::filesystem::path& csv);

/// Returns whether a name asks for tables: it ends with .csv.
bool is_csv(const std::filesystem::path& name);

} // namespace microslip::io
