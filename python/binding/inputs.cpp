#include "binding/bindings.hpp"
#include "binding/keywords.hpp"

#include "io/option_words.hpp"
#include "microslip/description/input.hpp"

#include <pybind11/stl.h>

#include <string>
#include <vector>

namespace microslip::python {

namespace py = pybind11;
using namespace py::literals;
using description::Input;
using description::InputKind;

py::object default_of(const Input& input) {
  if (!input.missing_word.empty()) return py::str(std::string(input.missing_word));
  if (!input.missing_numbers.empty())
    return py::cast(std::vector<double>(input.missing_numbers.begin(), input.missing_numbers.end()));
  if (!input.missing) return py::none();
  const bool is_whole = input.kind == InputKind::whole || input.kind == InputKind::wholes;
  return is_whole ? py::object(py::int_(static_cast<int>(*input.missing))) : py::float_(*input.missing);
}

namespace {

py::list inputs(const std::string& kind) {
  io::require_word("kind", kind, description::input_kinds);
  py::list all;
  for (const Input& input : description::inputs_of(kind).inputs()) {
    py::list words;
    for (const std::string_view word : input.words) words.append(std::string(word));
    all.append(py::dict("section"_a = std::string(input.section), "key"_a = std::string(input.key),
                        "unit"_a = std::string(input.unit), "default"_a = default_of(input),
                        "needed"_a = input.is_needed, "range"_a = input.bounds.text(), "words"_a = words,
                        "state"_a = input.is_state, "text"_a = std::string(input.text)));
  }
  return all;
}

} // namespace

void bind_inputs_of_cases(py::module_& module) {
  module.def(
      "inputs", &inputs, "kind"_a,
      "The keys of case files of a kind, bodies, wheel or wheelset, those of files of sweeps, sweep, or the options "
      "of\n"
      "microslip conicity or table make, conicity or table: for each a dict of its section and key, unit,\n"
      "default (None: none; without a unit [-]), whether a case without it is refused, range and words that may stand "
      "there, whether\n"
      "it is a number of a wheel's state, and a text. The section body is that of body1 and body2, profile that\n"
      "of all sections with a profile.");
}

} // namespace microslip::python
