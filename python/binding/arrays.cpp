#include "binding/arrays.hpp"

#include "microslip/error.hpp"

#include <algorithm>

namespace microslip::python {
namespace {

namespace py = pybind11;

Shape shape_of(const py::array& array) {
  return {array.shape(), array.shape() + array.ndim()};
}

py::ssize_t size_of(const Shape& shape) {
  py::ssize_t size = 1;
  for (const auto extent : shape) size *= extent;
  return size;
}

template <class T> py::array view_of(const T* values, std::size_t count, const Shape& shape, const py::object& owner) {
  if (size_of(shape) != static_cast<py::ssize_t>(count))
    return py::array_t<T>(0); // results without fields, as of invalid input
  py::array_t<T> array(shape, values, owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

} // namespace

std::string to_text(const Shape& shape) {
  return py::str(py::tuple(py::cast(shape))).cast<std::string>();
}

RealArray real_array(const char* field, const py::object& values) {
  const auto numpy = py::module_::import("numpy");
  const py::object masks = numpy.attr("ma");
  if (masks.attr("isMaskedArray")(values).cast<bool>() && masks.attr("is_masked")(values).cast<bool>())
    throw Error(std::string(field) + ": has masked values; fill them in first, with filled()");
  py::array array;
  try {
    array = numpy.attr("asarray")(values).cast<py::array>();
  } catch (py::error_already_set& error) { // a ragged list
    throw Error(std::string(field) + ": is no array of numbers");
  }
  const char kind = array.dtype().kind();
  if (kind != 'f' && kind != 'i' && kind != 'u')
    throw Error(std::string(field) + ": must be real numbers, has type " + py::str(array.dtype()).cast<std::string>());
  return RealArray(array.attr("astype")("float64", py::arg("order") = "C", py::arg("copy") = false));
}

RealArray real_array(const char* field, const py::object& values, const Shape& shape) {
  auto array = real_array(field, values);
  const auto found = shape_of(array);
  if (found != shape && !(found.size() == 1 && found[0] == size_of(shape)))
    throw Error(std::string(field) + " has shape " + to_text(found) + ": must be " + to_text(shape));
  return array;
}

std::span<const double> span_of(const RealArray& array) {
  return {array.data(), static_cast<std::size_t>(array.size())};
}

py::array view(const double* values, const Shape& shape, const py::object& owner) {
  return view_of(values, static_cast<std::size_t>(size_of(shape)), shape, owner);
}

py::array view(const std::vector<double>& values, const Shape& shape, const py::object& owner) {
  return view_of(values.data(), values.size(), shape, owner);
}

py::array view(const std::vector<CellState>& values, const Shape& shape, const py::object& owner) {
  static_assert(sizeof(CellState) == 1);
  return view_of(reinterpret_cast<const unsigned char*>(values.data()), values.size(), shape, owner);
}

py::array view(const std::vector<unsigned char>& values, const Shape& shape, const py::object& owner) {
  return view_of(values.data(), values.size(), shape, owner);
}

py::array view(const std::vector<int>& values, const Shape& shape, const py::object& owner) {
  return view_of(values.data(), values.size(), shape, owner);
}

void broadcast(Shape& shape, const char* field, const RealArray& array) {
  const auto own = shape_of(array);
  Shape joint(std::max(shape.size(), own.size()), 1);
  std::copy_backward(shape.begin(), shape.end(), joint.end());
  for (std::size_t i = 0; i < own.size(); ++i) {
    auto& extent = joint[joint.size() - 1 - i];
    const auto mine = own[own.size() - 1 - i];
    if (mine == 1 || mine == extent) continue;
    if (extent != 1)
      throw Error(std::string(field) + " has shape " + to_text(own) + ": does not match " + to_text(shape) +
                  " of the fields before it");
    extent = mine;
  }
  shape = joint;
}

RealArray spread(const RealArray& array, const Shape& shape) {
  if (shape_of(array) == shape) return array;
  return RealArray(py::module_::import("numpy").attr("broadcast_to")(array, py::tuple(py::cast(shape))));
}

} // namespace microslip::python
