#include "binding/bindings.hpp"
#include "binding/long_work.hpp"
#include "binding/paths.hpp"
#include "fit/fitted_curves.hpp"
#include "io/case_file.hpp"

#include <algorithm>
#include <string>
#include <thread>

#include <pybind11/pybind11.h>

namespace microslip::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

py::dict fit_creep_curve(const py::object& measured, const py::object& case_file, const std::string& model,
                         const std::string& start, bool huber) {
  const std::string points_path = readable_path(measured), case_path = readable_path(case_file);
  const std::string text = long_work([&](const Progress& progress) {
    const io::CaseInputs base = io::CaseInputs::read(io::read_case_text(case_path), case_path);
    const auto models = fit::chosen_models(base, model, start);
    auto curves = io::read_measured_curves(io::read_case_text(points_path), points_path, fit::conditions_of(base));
    const fit::FitOptions options{.huber = huber,
                                  .threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency())),
                                  .progress = progress};
    const fit::FittedCurves fitted = fit::fit_creep_curves(std::move(curves), models, options);
    io::Json document = fit::fitted_document(fitted);
    const auto inputs = fitted.inputs();
    document["case"] = inputs ? io::Json(inputs->text()) : io::Json();
    return io::json_text(document);
  });
  return py::module_::import("json").attr("loads")(text);
}

} // namespace

void bind_creep_curve_fit(py::module_& module) {
  module.def(
      "fit_creep_curve", &fit_creep_curve, "measured"_a, "case_file"_a, "model"_a = "", "start"_a = "",
      "huber"_a = false,
      "Fits friction and layers to the measured creep curves of a CSV by the theory of a case file, both given by\n"
      "their paths, as `microslip fit` does [-]. Without `model` the simplest of the best is taken. Returns its\n"
      "document as a dict: rms, parameters with value and interval, curves, models; and case, the text of the\n"
      "fitted case file. Error for wrong files, unknown names, and points that no model can be fitted to.");
}

} // namespace microslip::python
