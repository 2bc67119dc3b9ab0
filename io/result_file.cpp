#include "io/result_file.hpp"

#include "io/hdf5_handle.hpp"
#include "io/output_file.hpp"
#include "microslip/error.hpp"

#include <functional>
#include <map>
#include <numeric>

namespace microslip::io {
namespace {

/// Access properties of a file that lives in memory only, or on disk.
hid_t access_to(bool on_disk) {
  constexpr std::size_t increment = 1 << 20;
  // HDF5 prints every error by itself unless told not to; ours name the file.
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const auto properties = H5Pcreate(H5P_FILE_ACCESS);
  if (!on_disk) H5Pset_fapl_core(properties, increment, 0);
  return properties;
}

hid_t with_parent_groups() {
  const auto properties = H5Pcreate(H5P_LINK_CREATE);
  H5Pset_create_intermediate_group(properties, 1);
  return properties;
}

/// HDF5's type of the numbers of an array.
template <class Value> hid_t type_of();
template <> hid_t type_of<double>() {
  return H5T_NATIVE_DOUBLE;
}
template <> hid_t type_of<int>() {
  return H5T_NATIVE_INT;
}
template <> hid_t type_of<std::uint8_t>() {
  return H5T_NATIVE_UINT8;
}

hid_t utf8_text() {
  const auto type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return type;
}

} // namespace

struct ResultFile::Contents {
  Contents(const std::filesystem::path& path, Storage storage)
      : name(path.string()), output(path), on_disk(storage == Storage::disk && !output.temporary().empty()),
        access(access_to(on_disk), H5Pclose), links(with_parent_groups(), H5Pclose), text(utf8_text(), H5Tclose),
        file(
            H5Fcreate(hdf5_name(on_disk ? output.temporary() : path).c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.get()),
            H5Fclose) {
    check(file.get(), "/");
  }

  /// Passes on what an HDF5 call returned, which is negative if the call failed.
  template <class Result> Result check(Result result, const std::string& path) const {
    if (result < 0) throw Error(name + ": HDF5 cannot write " + path);
    return result;
  }

  void attribute(hid_t object, const std::string& path, const std::string& attribute_name, const std::string& value) {
    const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    const Hdf5Handle created(
        check(H5Acreate2(object, attribute_name.c_str(), text.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT), path),
        H5Aclose);
    const char* pointer = value.c_str();
    check(H5Awrite(created.get(), text.get(), static_cast<const void*>(&pointer)), path);
  }

  void dataset(const std::string& path, hid_t type, const Hdf5Handle& space, const void* values,
               const std::string& unit, const std::string& description) {
    check(space.get(), path);
    const Hdf5Handle created(
        check(H5Dcreate2(file.get(), path.c_str(), type, space.get(), links.get(), H5P_DEFAULT, H5P_DEFAULT), path),
        H5Dclose);
    check(H5Dwrite(created.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), path);
    attribute(created.get(), path, "unit", unit);
    attribute(created.get(), path, "description", description);
  }

  template <class Value>
  void array(const std::string& path, std::span<const Value> values, const std::string& unit,
             const std::string& description, const Shape& shape) {
    const std::vector<hsize_t> extents =
        shape.empty() ? std::vector<hsize_t>{values.size()} : std::vector<hsize_t>(shape.begin(), shape.end());
    if (std::accumulate(extents.begin(), extents.end(), hsize_t{1}, std::multiplies<>()) != values.size())
      throw Error(name + ": the shape of " + path + " does not fit its values");
    const Hdf5Handle space(H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr), H5Sclose);
    dataset(path, type_of<Value>(), space, values.data(), unit, description);
  }

  /// An array that can grow.
  struct Growing {
    explicit Growing(hid_t id) : dataset(id, H5Dclose) {}
    Hdf5Handle dataset;
    hsize_t length = 0;
  };

  Growing& growing(const std::string& path, hid_t type, const std::string& unit, const std::string& description) {
    constexpr hsize_t none = 0, endless = H5S_UNLIMITED, chunk = 1024;
    const auto known = arrays.find(path);
    if (known != arrays.end()) return known->second;
    const Hdf5Handle space(H5Screate_simple(1, &none, &endless), H5Sclose),
        layout(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_chunk(layout.get(), 1, &chunk);
    const hid_t created =
        check(H5Dcreate2(file.get(), path.c_str(), type, space.get(), links.get(), layout.get(), H5P_DEFAULT), path);
    Growing& array = arrays.try_emplace(path, created).first->second;
    attribute(created, path, "unit", unit);
    attribute(created, path, "description", description);
    return array;
  }

  void append(const std::string& path, hid_t type, const void* values, hsize_t count, const std::string& unit,
              const std::string& description) {
    Growing& array = growing(path, type, unit, description);
    if (count == 0) return;
    const hsize_t begin = array.length, end = begin + count;
    check(H5Dset_extent(array.dataset.get(), &end), path);
    const Hdf5Handle all(H5Dget_space(array.dataset.get()), H5Sclose),
        part(H5Screate_simple(1, &count, nullptr), H5Sclose);
    check(H5Sselect_hyperslab(all.get(), H5S_SELECT_SET, &begin, nullptr, &count, nullptr), path);
    check(H5Dwrite(array.dataset.get(), type, part.get(), all.get(), H5P_DEFAULT, values), path);
    array.length = end;
  }

  template <class Value>
  void append(const std::string& path, std::span<const Value> values, const std::string& unit,
              const std::string& description) {
    append(path, type_of<Value>(), values.data(), values.size(), unit, description);
  }

  /// Writes what HDF5 still holds.
  void close() {
    for (auto& [path, array] : arrays) check(array.dataset.finish(), path);
    check(file.finish(), "/");
  }

  std::string image() const {
    check(H5Fflush(file.get(), H5F_SCOPE_GLOBAL), "/");
    std::string bytes(static_cast<std::size_t>(check(H5Fget_file_image(file.get(), nullptr, 0), "/")), '\0');
    check(H5Fget_file_image(file.get(), bytes.data(), bytes.size()), "/");
    return bytes;
  }

  std::string name;
  OutputFile output;
  bool on_disk;
  Hdf5Handle access, links, text, file;
  std::map<std::string, Growing> arrays;
};

ResultFile::ResultFile(const std::filesystem::path& path, const Provenance& provenance, Storage storage)
    : contents_(std::make_unique<Contents>(path, storage)) {
  for (const auto& [name, value] : provenance_attributes(provenance)) ResultFile::attribute("/", name, value);
}

ResultFile::~ResultFile() = default;

void ResultFile::scalar(const std::string& path, double value, const std::string& unit,
                        const std::string& description) {
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  contents_->dataset(path, type_of<double>(), space, &value, unit, description);
}

void ResultFile::text(const std::string& path, const std::string& value, const std::string& description) {
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const char* pointer = value.c_str();
  contents_->dataset(path, contents_->text.get(), space, static_cast<const void*>(&pointer), "-", description);
}

void ResultFile::array(const std::string& path, const Values& values, const std::string& unit,
                       const std::string& description, const Shape& shape) {
  std::visit([&](auto numbers) { contents_->array(path, numbers, unit, description, shape); }, values);
}

void ResultFile::append(const std::string& path, const Values& values, const std::string& unit,
                        const std::string& description) {
  std::visit([&](auto numbers) { contents_->append(path, numbers, unit, description); }, values);
}

void ResultFile::append(const std::string& path, std::span<const std::string> texts, const std::string& description) {
  std::vector<const char*> pointers;
  for (const std::string& text : texts) pointers.push_back(text.c_str());
  contents_->append(path, contents_->text.get(), static_cast<const void*>(pointers.data()), pointers.size(), "-",
                    description);
}

void ResultFile::attribute(const std::string& path, const std::string& name, const std::string& value) {
  const Hdf5Handle object(contents_->check(H5Oopen(contents_->file.get(), path.c_str(), H5P_DEFAULT), path), H5Oclose);
  contents_->attribute(object.get(), path, name, value);
}

void ResultFile::commit() {
  if (contents_->on_disk)
    contents_->close();
  else
    contents_->output.write(contents_->image());
  contents_->output.commit();
}

} // namespace microslip::io
