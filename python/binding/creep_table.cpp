#include "binding/creep_table.hpp"

#include "binding/bindings.hpp"
#include "binding/contact.hpp"
#include "binding/contact_batch.hpp"
#include "binding/long_work.hpp"
#include "binding/paths.hpp"
#include "binding/words.hpp"
#include "io/creep_table_file.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

namespace microslip::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

/// The table beside the module, unless another one is named.
std::filesystem::path path_of(const py::object& file) {
  return file.is_none() ? io::shipped_creep_table() : std::filesystem::path(readable_path(file));
}

CreepForceTable table_from(const py::object& file, const std::optional<double>& poisson_ratio,
                           RollingDirection direction) {
  const std::filesystem::path path = path_of(file);
  const py::gil_scoped_release release;
  const CreepTableSource source = io::creep_table_source(path);
  return poisson_ratio ? CreepForceTable(source, *poisson_ratio, direction) : CreepForceTable(source, direction);
}

} // namespace

CreepForceTable own_creep_table(std::optional<double> poisson_ratio) {
  return table_from(py::none(), poisson_ratio, RollingDirection::forward);
}

namespace {

/// Answers all contacts of a batch, a thousand at a time.
template <class Arrays, class Answer>
auto batch_by(Answer (CreepForceTable::*answer)(const EllipticContact&) const noexcept) {
  return [answer](const CreepForceTable& table, const ContactBatch& batch, int threads) {
    Arrays out(batch);
    run_batch(batch.count(), 1000, threads, [&]() -> BatchWorker {
      return [&](std::size_t first, std::size_t n, const Progress&) {
        for (std::size_t i = first; i < first + n; ++i) out.put(i, (table.*answer)(batch[i]));
      };
    });
    return out;
  };
}

} // namespace

void bind_creep_table(py::module_& module) {
  py::class_<CreepForceTable, std::shared_ptr<CreepForceTable>> table(
      module, "CreepForceTable",
      "Forces of Hertzian contacts in steady rolling by interpolation between results of the exact\n"
      "theory: of its accuracy, at about 1 us a contact. Forces are continuous with their first\n"
      "derivatives, those of linear theory for vanishing creepages, and never beyond mu Fn. Beyond the\n"
      "table's axis ratios and Poisson's ratios forces are those of limits, with Status.out_of_range.");
  table
      .def(py::init(&table_from), "file"_a = py::none(), "poisson_ratio"_a = py::none(), py::kw_only(),
           "direction"_a = RollingDirection::forward,
           "Reads a table made by `microslip table make`, str or os.PathLike; None: the one that comes with\n"
           "microslip. poisson_ratio [-]: for that one alone, at a fraction of the memory. direction of\n"
           "rolling 'forward' (along +x) or 'backward'. Error for a file that is no table, of another version\n"
           "or byte order, cut short or corrupted.")
      .def(
          "solve", [](const CreepForceTable& self, const EllipticContact& contact) { return self.solve(contact); },
          "contact"_a, "Forces [N], [N m] and areas [m^2] of a contact, as ContactForces.")
      .def(
          "differentiate",
          [](const CreepForceTable& self, const EllipticContact& contact) { return self.differentiate(contact); },
          "contact"_a,
          "Forces [N], [N m] and their derivatives with respect to xi [-], eta [-], phi [1/m] and Fn [N],\n"
          "as ContactDerivatives: those of the interpolation itself.")
      .def_property_readonly(
          "axis_ratios",
          [](const CreepForceTable& self) {
            return py::make_tuple(self.axes().least_ratio, self.axes().largest_ratio);
          },
          "Least and largest a/b [-].")
      .def_property_readonly(
          "poisson_ratios", [](const CreepForceTable& self) { return py::tuple(py::cast(self.axes().poisson_ratios)); },
          "Poisson's ratios of the nodes [-].");
  def_batch(table, "solve_batch", batch_by<ForceArrays>(&CreepForceTable::solve), "Returns ForceArrays.");
  def_batch(table, "differentiate_batch", batch_by<DerivativeArrays>(&CreepForceTable::differentiate),
            "Returns DerivativeArrays.");
}

} // namespace microslip::python
