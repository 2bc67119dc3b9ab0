// Forces of a contact that remember creepages and loads before, as a unit.

#include "fmi/model.hpp"
#include "microslip/contact/quantities.hpp"
#include "microslip/description/input.hpp"
#include "microslip/error.hpp"
#include "microslip/response/force_element.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace microslip::fmi {
namespace {

/// The variables by their value references.
enum Reference : std::size_t {
  creepage_longitudinal,
  creepage_lateral,
  spin,
  normal_force,
  rolling_speed,
  fx,
  fy,
  mz,
  element
};
constexpr std::size_t real_inputs = 5;

ElementInput input_of(const Values& v) {
  return {{require_finite("creepage_longitudinal", v.real[creepage_longitudinal], "-"),
           require_finite("creepage_lateral", v.real[creepage_lateral], "-"),
           require_finite("spin", v.real[spin], "1/m")},
          require_finite("normal_force", v.real[normal_force], "N")};
}

double speed_of(const Values& v) {
  return require_between("rolling_speed", v.real[rolling_speed], "m/s", 0, std::numeric_limits<double>::max());
}

class ForceElementModel final : public Model {
public:
  explicit ForceElementModel(std::filesystem::path resources) : resources_(std::move(resources)) {}

  std::vector<std::string> set_parameters(const Values& v) override {
    element_.reset();
    const std::filesystem::path path = resources_ / v.text[element];
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (!file) throw Error("element = " + path.string() + ": cannot be read");
    element_.emplace(force_element_from(text));
    for (std::size_t i = 0; i < element_outputs; ++i)
      for (std::size_t j = 0; j < element_inputs; ++j)
        derivatives_[i][j] = element_->fit().constants[i * element_inputs + j];
    return {};
  }

  void evaluate(Values& v) override {
    speed_of(v);
    const ElementForces forces = element_->forces(input_of(v));
    v.real[fx] = forces.fx, v.real[fy] = forces.fy, v.real[mz] = forces.mz;
  }

  std::span<const double> differentiate(const Values&) override {
    return {derivatives_.front().data(), derivatives_.size() * real_inputs};
  }

  void advance(const Values& v, double step) override { element_->step_held(speed_of(v) * step, input_of(v)); }
  std::vector<double> memory() const override { return element_ ? element_->state() : std::vector<double>{}; }
  void set_memory(std::span<const double> memory) override {
    if (!element_) return;
    if (memory.empty()) // of a state before the start
      element_->reset();
    else if (memory.size() == element_->state_size())
      element_->set_state(memory);
  }

private:
  std::filesystem::path resources_;
  std::optional<ForceElement> element_;
  std::array<std::array<double, real_inputs>, element_outputs> derivatives_{}; ///< those at once
};

/// A variable that cases of two bodies have, by its unit and text there.
Variable of_input(const char* section, const char* key, const char* name, double start) {
  const description::Input& input = *description::rolling_inputs().find(section, key);
  return {.name = name, .description = std::string(input.text), .unit = std::string(input.unit), .start = start};
}

Variable of_result(const char* name) {
  const Quantity& q = quantity(name);
  return {.name = name,
          .description = std::string(q.description),
          .causality = Causality::output,
          .unit = std::string(q.unit)};
}

} // namespace

ModelInfo model_info() {
  Variable speed = of_input("motion", "rolling_speed", "rolling_speed", 30);
  speed.min = 0;
  return {.name = "microslip force element with memory",
          .identifier = "microslip_force_element",
          .description =
              "Creep forces of a contact that remember creepages and loads before, linear about a steady "
              "state: a rational fit of its responses over frequency, as microslip respond --poles writes it",
          .variables = {of_input("motion", "creepage_longitudinal", "creepage_longitudinal", 0),
                        of_input("motion", "creepage_lateral", "creepage_lateral", 0),
                        of_input("motion", "spin", "spin", 0),
                        of_input("load", "normal_force", "normal_force", 80e3),
                        speed,
                        of_result("fx"),
                        of_result("fy"),
                        of_result("mz"),
                        {.name = "element",
                         .description = "Fit: a path, from the unit's resources on if it is relative",
                         .kind = Kind::text,
                         .causality = Causality::parameter,
                         .start_text = "force_element.txt"}},
          .remembers = true};
}

std::unique_ptr<Model> make_model(const std::filesystem::path& resources) {
  return std::make_unique<ForceElementModel>(resources);
}

} // namespace microslip::fmi
