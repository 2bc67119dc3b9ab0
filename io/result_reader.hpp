#pragma once

#include "io/hdf5_handle.hpp"

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace microslip::io {

/// A dataset of a result file.
struct StoredDataset {
  std::string group, name; ///< "exact/fields" and "px"; group empty: in the root
  std::string unit, description;
  std::vector<std::size_t> shape = {}; ///< empty: a single number or text

  std::string path() const { return group.empty() ? name : group + "/" + name; }
  std::size_t size() const;
};

/// A text attribute of the root (`group` empty) or of a group.
struct StoredAttribute {
  std::string group, name, value;
};

/// What an HDF5 file of results holds. Errors name the file.
class ResultReader {
public:
  /// Throws Error for what is no HDF5 file, or has a format of another version.
  explicit ResultReader(const std::filesystem::path& path);

  /// Those of all groups, by their names.
  const std::vector<StoredDataset>& datasets() const { return datasets_; }
  const std::vector<StoredAttribute>& attributes() const { return attributes_; }

  /// Values of a dataset, the last index fastest: real numbers, whole ones or texts.
  using Values = std::variant<std::vector<double>, std::vector<int>, std::vector<std::string>>;
  Values read(const StoredDataset& dataset) const;
  /// Those at `count` indices of the first dimension, from `first` on. The dataset must have a dimension.
  Values read(const StoredDataset& dataset, std::size_t first, std::size_t count) const;

private:
  template <class Result> Result check(Result result, const std::string& path) const;
  template <class Ask> std::string name_by(const Ask& ask, const std::string& path) const;
  void find_members(hid_t group, const std::string& path);
  void find_attributes(hid_t group, const std::string& path);
  StoredDataset describe(hid_t dataset, const std::string& group, const std::string& name) const;
  std::string attribute_text(hid_t attribute, const std::string& path) const;
  std::string attribute_of(hid_t dataset, const char* name, const std::string& path) const;
  Values read(hid_t dataset, hid_t in_memory, hid_t in_file, std::size_t count, const std::string& path) const;
  void require_known_format() const;

  std::string name_;
  Hdf5Handle file_, text_;
  std::vector<StoredDataset> datasets_;
  std::vector<StoredAttribute> attributes_;
};

} // namespace microslip::io
