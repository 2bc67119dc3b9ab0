#include "io/result_reader.hpp"

#include "io/result_writer.hpp"
#include "microslip/error.hpp"

#include <functional>
#include <numeric>

#include <fmt/format.h>

namespace microslip::io {
namespace {

/// Opens a file without the error messages that HDF5 prints by itself.
hid_t open_quietly(const std::filesystem::path& path) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  return H5Fopen(hdf5_name(path).c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
}

} // namespace

std::size_t StoredDataset::size() const {
  return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

ResultReader::ResultReader(const std::filesystem::path& path)
    : name_(path.string()), file_(open_quietly(path), H5Fclose), text_(H5Tcopy(H5T_C_S1), H5Tclose) {
  if (file_.get() < 0) throw Error(name_ + ": cannot be read as HDF5");
  H5Tset_size(text_.get(), H5T_VARIABLE);
  H5Tset_cset(text_.get(), H5T_CSET_UTF8);
  const Hdf5Handle root(check(H5Gopen2(file_.get(), "/", H5P_DEFAULT), "/"), H5Gclose);
  find_members(root.get(), "");
  require_known_format();
}

/// Files without the attribute are taken for the format that is known.
void ResultReader::require_known_format() const {
  const std::string known = std::to_string(result_format);
  for (const auto& [group, name, value] : attributes_)
    if (group.empty() && name == "format" && value != known)
      throw Error(
          fmt::format("{}: has format {} of result files; this version of microslip reads {}", name_, value, known));
}

/// Passes on what an HDF5 call returned, which is negative if the call failed.
template <class Result> Result ResultReader::check(Result result, const std::string& path) const {
  if (result < 0) throw Error(name_ + ": HDF5 cannot read " + path);
  return result;
}

/// The name that `ask` writes to a buffer of a size, once it has said with no buffer how long the name is.
template <class Ask> std::string ResultReader::name_by(const Ask& ask, const std::string& path) const {
  std::string name(static_cast<std::size_t>(check(ask(nullptr, std::size_t{0}), path)), '\0');
  check(ask(name.data(), name.size() + 1), path);
  return name;
}

void ResultReader::find_members(hid_t group, const std::string& path) {
  find_attributes(group, path);
  H5G_info_t info{};
  check(H5Gget_info(group, &info), path);
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    const std::string name = name_by(
        [&](char* buffer, std::size_t size) {
          return H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, i, buffer, size, H5P_DEFAULT);
        },
        path);
    std::string member_path = path;
    member_path.append(path.empty() ? "" : "/").append(name);
    const Hdf5Handle member(check(H5Oopen(group, name.c_str(), H5P_DEFAULT), member_path), H5Oclose);
    if (H5Iget_type(member.get()) == H5I_GROUP)
      find_members(member.get(), member_path);
    else
      datasets_.push_back(describe(member.get(), path, name));
  }
}

void ResultReader::find_attributes(hid_t group, const std::string& path) {
  const int count = check(H5Aget_num_attrs(group), path);
  for (int i = 0; i < count; ++i) {
    const Hdf5Handle attribute(
        check(H5Aopen_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, static_cast<hsize_t>(i), H5P_DEFAULT, H5P_DEFAULT),
              path),
        H5Aclose);
    const std::string name =
        name_by([&](char* buffer, std::size_t size) { return H5Aget_name(attribute.get(), size, buffer); }, path);
    attributes_.push_back({path, name, attribute_text(attribute.get(), path)});
  }
}

std::string ResultReader::attribute_text(hid_t attribute, const std::string& path) const {
  char* read = nullptr;
  check(H5Aread(attribute, text_.get(), static_cast<void*>(&read)), path);
  std::string value = read;
  H5free_memory(read);
  return value;
}

std::string ResultReader::attribute_of(hid_t dataset, const char* name, const std::string& path) const {
  const Hdf5Handle attribute(check(H5Aopen(dataset, name, H5P_DEFAULT), path), H5Aclose);
  return attribute_text(attribute.get(), path);
}

StoredDataset ResultReader::describe(hid_t dataset, const std::string& group, const std::string& name) const {
  StoredDataset found = {.group = group, .name = name, .unit = {}, .description = {}};
  const std::string path = found.path();
  found.unit = attribute_of(dataset, "unit", path);
  found.description = attribute_of(dataset, "description", path);
  const Hdf5Handle space(check(H5Dget_space(dataset), path), H5Sclose);
  std::vector<hsize_t> extents(static_cast<std::size_t>(check(H5Sget_simple_extent_ndims(space.get()), path)));
  check(H5Sget_simple_extent_dims(space.get(), extents.data(), nullptr), path);
  found.shape.assign(extents.begin(), extents.end());
  return found;
}

ResultReader::Values ResultReader::read(hid_t dataset, hid_t in_memory, hid_t in_file, std::size_t count,
                                        const std::string& path) const {
  const Hdf5Handle type(check(H5Dget_type(dataset), path), H5Tclose);
  const auto values_of = [&](hid_t memory_type, auto values) {
    check(H5Dread(dataset, memory_type, in_memory, in_file, H5P_DEFAULT, static_cast<void*>(values.data())), path);
    return values;
  };
  const auto kind = H5Tget_class(type.get());
  if (kind == H5T_INTEGER) return values_of(H5T_NATIVE_INT, std::vector<int>(count));
  if (kind != H5T_STRING) return values_of(H5T_NATIVE_DOUBLE, std::vector<double>(count));
  auto pointers = values_of(text_.get(), std::vector<char*>(count));
  std::vector<std::string> texts(pointers.begin(), pointers.end());
  for (char* pointer : pointers) H5free_memory(pointer);
  return texts;
}

ResultReader::Values ResultReader::read(const StoredDataset& dataset) const {
  const std::string path = dataset.path();
  const Hdf5Handle opened(check(H5Dopen2(file_.get(), path.c_str(), H5P_DEFAULT), path), H5Dclose);
  return read(opened.get(), H5S_ALL, H5S_ALL, dataset.size(), path);
}

ResultReader::Values ResultReader::read(const StoredDataset& dataset, std::size_t first, std::size_t count) const {
  const std::string path = dataset.path();
  const Hdf5Handle opened(check(H5Dopen2(file_.get(), path.c_str(), H5P_DEFAULT), path), H5Dclose);
  std::vector<hsize_t> begin(dataset.shape.size()), extents(dataset.shape.begin(), dataset.shape.end());
  begin.front() = first;
  extents.front() = count;
  const Hdf5Handle all(check(H5Dget_space(opened.get()), path), H5Sclose),
      part(H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr), H5Sclose);
  check(H5Sselect_hyperslab(all.get(), H5S_SELECT_SET, begin.data(), nullptr, extents.data(), nullptr), path);
  return read(opened.get(), part.get(), all.get(),
              std::accumulate(extents.begin(), extents.end(), std::size_t{1}, std::multiplies<>()), path);
}

} // namespace microslip::io
