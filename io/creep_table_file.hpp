#pragma once

#include "microslip/table/creep_force_table.hpp"

#include <filesystem>

namespace microslip::io {

class OutputFile;

/// The creep-force table in a file, which is mapped into memory and stays so as long as the nodes or copies of them
/// are there. Throws Error with the path and the reason: a file that cannot be read or is no table, of another version
/// or byte order, cut short or corrupted.
CreepTableNodes read_creep_table(const std::filesystem::path& path);

/// Path of the table that comes with microslip: beside the Python module that asks, in the Python package that was
/// installed with the library that asks, or with the program.
std::filesystem::path shipped_creep_table();

/// Nodes of the table in a file, to make tables from. Throws Error as read_creep_table. That of the table that
/// microslip has is one for the whole process, which reads it when it is first asked for: tables that are made from it
/// share its numbers. From any thread.
CreepTableSource creep_table_source(const std::filesystem::path& path);

/// The file that was asked for, or the table that microslip has if none was.
std::filesystem::path creep_table_or_shipped(const std::filesystem::path& asked);

/// Writes a table; the file appears whole or not at all. Throws Error if it cannot be written.
void write_creep_table(const CreepTableNodes& nodes, const std::filesystem::path& path);
/// Writes into a file that has been tried before.
void write_creep_table(const CreepTableNodes& nodes, OutputFile& file);

} // namespace microslip::io
