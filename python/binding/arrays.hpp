#pragma once

#include "binding/long_work.hpp"
#include "microslip/contact/surface_fields.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

namespace microslip::python {

using Shape = std::vector<pybind11::ssize_t>;
using RealArray = pybind11::array_t<double, pybind11::array::c_style>;

/// Numbers as float64 in C order. Throws Error that names the field for what is not real numbers: text, complex
/// numbers, objects, booleans, ragged lists.
RealArray real_array(const char* field, const pybind11::object& values);
/// Array with a shape that it must have, row by row (my, mx); the flat array with the same number of values is the
/// same.
RealArray real_array(const char* field, const pybind11::object& values, const Shape& shape);
std::span<const double> span_of(const RealArray& array);

/// `(3, 4)`, for messages.
std::string to_text(const Shape& shape);

/// A view of a result's values that keeps the result alive and cannot be written to.
pybind11::array view(const double* values, const Shape& shape, const pybind11::object& owner);
pybind11::array view(const std::vector<double>& values, const Shape& shape, const pybind11::object& owner);
pybind11::array view(const std::vector<CellState>& values, const Shape& shape, const pybind11::object& owner);
pybind11::array view(const std::vector<unsigned char>& values, const Shape& shape, const pybind11::object& owner);
pybind11::array view(const std::vector<int>& values, const Shape& shape, const pybind11::object& owner);

/// Broadcasts to one shape by numpy's rules. Throws Error with both shapes for one that does not fit.
void broadcast(Shape& shape, const char* field, const RealArray& array);
/// The array spread over a shape that broadcast() has found.
RealArray spread(const RealArray& array, const Shape& shape);

/// An array of a function's values at all items of a list, whatever its shape.
template <class Number, class Items, class Function>
pybind11::array_t<Number> array_of(const Shape& shape, const Items& items, const Function& function) {
  pybind11::array_t<Number> out(shape);
  std::transform(items.begin(), items.end(), out.mutable_data(),
                 [&](const auto& item) { return static_cast<Number>(function(item)); });
  return out;
}

/// Values of a function, which may not touch Python objects, at arrays of arguments that broadcast; a number for
/// numbers. Ctrl-C ends it.
template <class Function>
pybind11::object mapped(const char* name_x, const pybind11::object& x, const char* name_y, const pybind11::object& y,
                        const Function& function) {
  auto a = real_array(name_x, x), b = real_array(name_y, y);
  Shape shape;
  broadcast(shape, name_x, a);
  broadcast(shape, name_y, b);
  a = spread(a, shape);
  b = spread(b, shape);
  RealArray out(shape);
  const double *first = a.data(), *second = b.data();
  double* const value = out.mutable_data();
  const pybind11::ssize_t count = out.size();
  long_work([&](const Progress& progress) {
    for (pybind11::ssize_t i = 0; i < count; ++i) {
      if (i % 32 == 0) progress(0);
      value[i] = function(first[i], second[i]);
    }
  });
  return shape.empty() ? pybind11::object(pybind11::float_(*out.data())) : pybind11::object(std::move(out));
}

} // namespace microslip::python
