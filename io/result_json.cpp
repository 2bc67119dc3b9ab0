#include "io/result_json.hpp"

#include "io/hdf5_handle.hpp"
#include "io/json_result.hpp"
#include "microslip/error.hpp"

#include <array>
#include <string>
#include <vector>

namespace microslip::io {
namespace {

/// Opens a file without the error messages that HDF5 prints by itself.
hid_t open_quietly(const std::string& name) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  return H5Fopen(name.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
}

class Reader {
public:
  explicit Reader(const std::filesystem::path& path)
      : name_(path.string()), file_(open_quietly(name_), H5Fclose), text_(H5Tcopy(H5T_C_S1), H5Tclose) {
    if (file_.get() < 0) throw Error(name_ + ": cannot be read as HDF5");
    H5Tset_size(text_.get(), H5T_VARIABLE);
    H5Tset_cset(text_.get(), H5T_CSET_UTF8);
  }

  Json read() {
    const Hdf5Handle root(check(H5Gopen2(file_.get(), "/", H5P_DEFAULT), "/"), H5Gclose);
    Json result = group(root.get(), "");
    require_known_format(result);
    result["units"] = units_;
    return result;
  }

private:
  /// Files without the attribute are taken for the format that is known.
  void require_known_format(const Json& root) const {
    const std::string known = std::to_string(result_format), format = root.value("format", known);
    if (format != known)
      throw Error(name_ + ": has format " + format + " of result files; this version of microslip reads " + known);
  }

  /// Passes on what an HDF5 call returned, which is negative if the call failed.
  template <class Result> Result check(Result result, const std::string& path) const {
    if (result < 0) throw Error(name_ + ": HDF5 cannot read " + path);
    return result;
  }

  /// Its attributes and members; `path` ends with a stroke or is empty for the root.
  Json group(hid_t id, const std::string& path) {
    Json result = Json::object();
    attributes(id, path, result);
    H5G_info_t info{};
    check(H5Gget_info(id, &info), path);
    for (hsize_t i = 0; i < info.nlinks; ++i) {
      std::array<char, 256> name{};
      check(H5Lget_name_by_idx(id, ".", H5_INDEX_NAME, H5_ITER_INC, i, name.data(), name.size(), H5P_DEFAULT), path);
      const auto member_path = path + name.data();
      const Hdf5Handle member(check(H5Oopen(id, name.data(), H5P_DEFAULT), member_path), H5Oclose);
      const bool is_group = H5Iget_type(member.get()) == H5I_GROUP;
      if (is_group && is_field(member_path + "/")) continue;
      if (is_group)
        result[name.data()] = group(member.get(), member_path + "/");
      else
        dataset(member.get(), member_path, result[name.data()]);
      if (result[name.data()].is_null()) result.erase(name.data());
    }
    return result;
  }

  void attributes(hid_t id, const std::string& path, Json& result) const {
    const int count = check(H5Aget_num_attrs(id), path);
    for (int i = 0; i < count; ++i) {
      const Hdf5Handle attribute(
          check(H5Aopen_by_idx(id, ".", H5_INDEX_NAME, H5_ITER_INC, static_cast<hsize_t>(i), H5P_DEFAULT, H5P_DEFAULT),
                path),
          H5Aclose);
      std::array<char, 256> name{};
      check(H5Aget_name(attribute.get(), name.size(), name.data()), path);
      result[name.data()] = attribute_text(attribute.get(), path);
    }
  }

  std::string attribute_text(hid_t attribute, const std::string& path) const {
    char* read = nullptr;
    check(H5Aread(attribute, text_.get(), static_cast<void*>(&read)), path);
    std::string value = read;
    H5free_memory(read);
    return value;
  }

  /// Leaves `result` as it is if the dataset has more than one dimension.
  void dataset(hid_t id, const std::string& path, Json& result) {
    const Hdf5Handle space(check(H5Dget_space(id), path), H5Sclose), type(check(H5Dget_type(id), path), H5Tclose);
    const int dimensions = check(H5Sget_simple_extent_ndims(space.get()), path);
    if (dimensions > 1) return;
    const auto count = static_cast<std::size_t>(check(H5Sget_simple_extent_npoints(space.get()), path));
    const auto kind = H5Tget_class(type.get());
    Json values = kind == H5T_STRING    ? texts(id, path, space.get(), count)
                  : kind == H5T_INTEGER ? Json(read<int>(id, path, H5T_NATIVE_INT, count))
                                        : numbers(read<double>(id, path, H5T_NATIVE_DOUBLE, count));
    result = dimensions == 0 ? values.at(0) : values;
    if (kind != H5T_STRING) add_unit(id, path);
  }

  template <class Value>
  std::vector<Value> read(hid_t id, const std::string& path, hid_t type, std::size_t count) const {
    std::vector<Value> values(count);
    check(H5Dread(id, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), path);
    return values;
  }

  Json texts(hid_t id, const std::string& path, hid_t space, std::size_t count) const {
    auto pointers = read<char*>(id, path, text_.get(), count);
    Json result(std::vector<std::string>(pointers.begin(), pointers.end()));
    H5Dvlen_reclaim(text_.get(), space, H5P_DEFAULT, static_cast<void*>(pointers.data()));
    return result;
  }

  static Json numbers(const std::vector<double>& values) {
    Json result = Json::array();
    for (const double value : values) result.push_back(json_number(value));
    return result;
  }

  void add_unit(hid_t id, const std::string& path) {
    const Hdf5Handle attribute(check(H5Aopen(id, "unit", H5P_DEFAULT), path), H5Aclose);
    units_[path] = attribute_text(attribute.get(), path);
  }

  std::string name_;
  Hdf5Handle file_, text_;
  Json units_ = Json::object();
};

} // namespace

Json result_json(const std::filesystem::path& result_file) {
  return Reader(result_file).read();
}

} // namespace microslip::io
