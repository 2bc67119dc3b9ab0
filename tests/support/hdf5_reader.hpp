#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <hdf5.h>

namespace microslip {

/// Reads a file with HDF5 itself.
class Hdf5Reader {
public:
  explicit Hdf5Reader(const std::filesystem::path& path) : file_(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)) {}
  Hdf5Reader(const Hdf5Reader&) = delete;
  Hdf5Reader& operator=(const Hdf5Reader&) = delete;
  ~Hdf5Reader() { H5Fclose(file_); }

  template <class Value> std::vector<Value> values(const std::string& path, hid_t type) const {
    const auto dataset = H5Dopen2(file_, path.c_str(), H5P_DEFAULT);
    std::vector<Value> read(static_cast<std::size_t>(H5Sget_simple_extent_npoints(H5Dget_space(dataset))));
    H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, read.data());
    H5Dclose(dataset);
    return read;
  }

  /// Returns whether there is such a group or dataset; the groups above it must be there.
  bool has(const std::string& path) const { return H5Lexists(file_, path.c_str(), H5P_DEFAULT) > 0; }
  bool has_attribute(const std::string& path, const char* name) const {
    return H5Aexists_by_name(file_, path.c_str(), name, H5P_DEFAULT) > 0;
  }

  std::vector<hsize_t> shape(const std::string& path) const {
    const auto dataset = H5Dopen2(file_, path.c_str(), H5P_DEFAULT);
    const auto space = H5Dget_space(dataset);
    std::vector<hsize_t> extents(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
    H5Sget_simple_extent_dims(space, extents.data(), nullptr);
    H5Sclose(space);
    H5Dclose(dataset);
    return extents;
  }

  std::string text(const std::string& path) const {
    const auto type = text_type();
    const auto read = values<char*>(path, type);
    const std::string value(read.at(0));
    std::free(read[0]);
    H5Tclose(type);
    return value;
  }

  std::string attribute(const std::string& path, const char* name) const {
    const auto type = text_type();
    const auto attribute = H5Aopen_by_name(file_, path.c_str(), name, H5P_DEFAULT, H5P_DEFAULT);
    char* pointer = nullptr;
    H5Aread(attribute, type, static_cast<void*>(&pointer));
    const std::string value(pointer);
    std::free(pointer);
    H5Aclose(attribute);
    H5Tclose(type);
    return value;
  }

private:
  static hid_t text_type() {
    const auto type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, H5T_VARIABLE);
    H5Tset_cset(type, H5T_CSET_UTF8);
    return type;
  }

  hid_t file_;
};

} // namespace microslip
