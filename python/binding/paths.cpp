#include "binding/paths.hpp"

namespace microslip::python {

namespace py = pybind11;

std::string path_from(const py::object& path) {
  return py::module_::import("os").attr("fspath")(path).cast<std::string>();
}

std::string readable_path(const py::object& path) {
  py::module_::import("builtins").attr("open")(path, "rb").attr("close")();
  return path_from(path);
}

} // namespace microslip::python
