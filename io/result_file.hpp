#pragma once

#include "io/result_writer.hpp"

#include <filesystem>
#include <memory>
#include <string>

namespace microslip::io {

/// An HDF5 file of results. Every dataset has the text attributes `unit` ("-" for pure numbers) and `description`.
/// A path such as "creep_curve/fx" creates the groups it names. The file appears whole at commit() or, after any
/// failure, not at all. Failures throw Error with the file's name. Objects must not be used from two threads at a time,
/// nor two objects: HDF5 keeps global state.
class ResultFile : public ResultWriter {
public:
  enum class Storage {
    memory, ///< composed in memory, twice its size at the end
    disk,   ///< composed under a temporary name, in constant memory: for files that grow by append()
  };

  /// Fails at once if the folder cannot be written.
  ResultFile(const std::filesystem::path& path, const Provenance& provenance, Storage storage = Storage::memory);
  ~ResultFile() override;

  void scalar(const std::string& path, double value, const std::string& unit, const std::string& description) override;
  void text(const std::string& path, const std::string& value, const std::string& description) override;
  void array(const std::string& path, const Values& values, const std::string& unit, const std::string& description,
             const Shape& shape = {}) override;
  void attribute(const std::string& path, const std::string& name, const std::string& value) override;

  /// Adds values at the end of an array of one dimension, which the first call creates with unit and description.
  void append(const std::string& path, const Values& values, const std::string& unit, const std::string& description);

  /// Appends texts.
  void append(const std::string& path, std::span<const std::string> texts, const std::string& description);

  /// Writes the file to its final name. Once.
  void commit();

private:
  struct Contents;
  std::unique_ptr<Contents> contents_;
};

} // namespace microslip::io
