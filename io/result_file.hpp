#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace microslip {

/// Where a result comes from: root attributes of every result file, beside those the build knows itself (`version`,
/// `commit`, `compiler`, `build_type`) and `created` (ISO 8601, UTC).
struct Provenance {
  std::string kind = {}; ///< what the file holds, e.g. "rolling_contact" or a study's name
  std::string title = {};
  std::string command_line = {};
  std::string case_file = {}; ///< path of the case file; empty if there is none
  std::string case_text = {}; ///< its text, verbatim
};

/// An HDF5 file of results. Every dataset has the text attributes `unit` ("-" for pure numbers) and `description`.
/// A path such as "creep_curve/fx" creates the groups it names. The file appears whole at commit() or, after any
/// failure, not at all. Failures throw Error with the file's name. Objects must not be used from two threads at a time,
/// nor two objects: HDF5 keeps global state.
class ResultFile {
public:
  enum class Storage {
    memory, ///< composed in memory, twice its size at the end
    disk,   ///< composed under a temporary name, in constant memory: for files that grow by append()
  };

  /// Fails at once if the folder cannot be written.
  ResultFile(const std::filesystem::path& path, const Provenance& provenance, Storage storage = Storage::memory);
  ResultFile(const ResultFile&) = delete;
  ResultFile& operator=(const ResultFile&) = delete;
  ~ResultFile();

  void scalar(const std::string& path, double value, const std::string& unit, const std::string& description);
  void text(const std::string& path, const std::string& value, const std::string& description);

  /// Arrays, the last index fastest; `shape` empty means one dimension. Error if it does not fit the values.
  using Shape = std::vector<std::size_t>;
  void array(const std::string& path, std::span<const double> values, const std::string& unit,
             const std::string& description, const Shape& shape = {});
  void array(const std::string& path, std::span<const int> values, const std::string& unit,
             const std::string& description, const Shape& shape = {});
  void array(const std::string& path, std::span<const std::uint8_t> values, const std::string& unit,
             const std::string& description, const Shape& shape = {});

  /// Adds values at the end of an array of one dimension, which the first call creates with unit and description.
  void append(const std::string& path, std::span<const double> values, const std::string& unit,
              const std::string& description);
  void append(const std::string& path, std::span<const int> values, const std::string& unit,
              const std::string& description);

  /// A text attribute of a group or dataset that is there; "/" is the root.
  void attribute(const std::string& path, const std::string& name, const std::string& value);

  /// Writes the file to its final name. Once.
  void commit();

private:
  struct Contents;
  std::unique_ptr<Contents> contents_;
};

} // namespace microslip
