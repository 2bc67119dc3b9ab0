#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace microslip::python {

/// The text of a path, as str or os.PathLike.
std::string path_from(const pybind11::object& path);
/// Path of a file to be read. Throws FileNotFoundError, IsADirectoryError and so on, as Python's open() does.
std::string readable_path(const pybind11::object& path);

} // namespace microslip::python
