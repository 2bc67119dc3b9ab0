#include "io/result_attribute.hpp"

#include "io/hdf5_handle.hpp"

namespace microslip::io {

std::optional<std::string> result_attribute(const std::filesystem::path& result_file, const std::string& name) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); // else HDF5 prints every error by itself
  const Hdf5Handle file(H5Fopen(hdf5_name(result_file).c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (file.get() < 0) return std::nullopt;
  const Hdf5Handle attribute(H5Aopen(file.get(), name.c_str(), H5P_DEFAULT), H5Aclose);
  const Hdf5Handle text(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(text.get(), H5T_VARIABLE);
  H5Tset_cset(text.get(), H5T_CSET_UTF8);
  char* read = nullptr;
  if (attribute.get() < 0 || H5Aread(attribute.get(), text.get(), static_cast<void*>(&read)) < 0) return std::nullopt;
  std::string value = read;
  H5free_memory(read);
  return value;
}

} // namespace microslip::io
