#pragma once

#include <filesystem>
#include <string>

#include <hdf5.h>

namespace microslip::io {

/// The name by which HDF5 opens a file: UTF-8 on every system.
inline std::string hdf5_name(const std::filesystem::path& path) {
  const std::u8string name = path.u8string();
  return {name.begin(), name.end()};
}

/// An HDF5 handle that closes itself.
class Hdf5Handle {
public:
  using Close = herr_t (*)(hid_t);
  Hdf5Handle(hid_t id, Close close) : id_(id), close_(close) {}
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;
  ~Hdf5Handle() { finish(); }
  /// Negative if what it stands for could not be opened.
  hid_t get() const { return id_; }
  /// Negative if what was to be written on closing could not be.
  herr_t finish() {
    const herr_t result = id_ >= 0 ? close_(id_) : 0;
    id_ = -1;
    return result;
  }

private:
  hid_t id_;
  Close close_;
};

} // namespace microslip::io
