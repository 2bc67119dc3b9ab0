#include "fmi/unit.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <string_view>

namespace microslip::fmi {

Values::Values(std::span<const Variable> variables)
    : real(variables.size()), integer(variables.size()), text(variables.size()) {
  for (std::size_t k = 0; k < variables.size(); ++k) {
    real[k] = variables[k].start;
    integer[k] = static_cast<int>(variables[k].start);
    text[k] = variables[k].start_text;
  }
}

std::filesystem::path folder_of(const char* uri) {
  constexpr std::string_view scheme = "file:", host = "//";
  std::string_view rest = uri ? uri : "";
  if (!rest.starts_with(scheme)) return {};
  rest.remove_prefix(scheme.size());
  if (rest.starts_with(host)) rest.remove_prefix(std::min(rest.find('/', host.size()), rest.size()));
  std::string path;
  for (std::size_t k = 0; k < rest.size(); ++k) {
    int code = 0;
    const char* const digits = rest.data() + k + 1;
    if (rest[k] == '%' && k + 2 < rest.size() && std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2) {
      path += static_cast<char>(code);
      k += 2;
    } else {
      path += rest[k];
    }
  }
#ifdef _WIN32
  // file:///C:/unit
  if (path.size() > 2 && path[0] == '/' && path[2] == ':') path.erase(0, 1);
#endif
  return {reinterpret_cast<const char8_t*>(path.c_str())};
}

Unit::Unit(ModelInfo info, Interface interface, std::filesystem::path resources, Log log, bool logging)
    : values(info.variables), info_(std::move(info)), resources_(std::move(resources)), log_(std::move(log)),
      logging_(logging), model_(make_model(resources_)), interface_(interface), held_(values.integer),
      place_(info_.variables.size()) {
  for (std::size_t k = 0; k < place_.size(); ++k) {
    const Variable& v = info_.variables[k];
    if (v.part > 0 || v.kind != Kind::real) continue;
    if (v.causality == Causality::input) ++inputs_;
    if (v.causality == Causality::output) ++outputs_;
  }
  std::size_t inputs = 0, outputs = 0;
  for (std::size_t k = 0; k < place_.size(); ++k) {
    const Variable& v = info_.variables[k];
    if (v.kind != Kind::real) continue;
    if (v.causality == Causality::input) place_[k] = inputs++ % inputs_;
    if (v.causality == Causality::output) place_[k] = outputs++ % outputs_;
  }
}

const Variable& Unit::variable(ValueReference reference, Kind kind) const {
  if (reference < info_.variables.size() && info_.variables[reference].kind == kind) return info_.variables[reference];
  constexpr const char* kinds[] = {"real", "integer", "string"};
  throw std::invalid_argument(std::string("no ") + kinds[static_cast<int>(kind)] +
                              " variable has this value reference");
}

void Unit::log(Severity severity, const char* text) const {
  if (logging_) log_(severity, text);
}

void Unit::fail(const char* text) {
  stage = Stage::error;
  log(Severity::error, text);
}

void Unit::discard(const char* text) {
  log(Severity::warning, text);
}

void Unit::changed(Causality causality) {
  evaluated_ = false;
  if (causality == Causality::parameter) parameters_changed_ = true;
}

bool Unit::has_parameters_of(const Values& other) const {
  for (std::size_t k = 0; k < info_.variables.size(); ++k)
    if (info_.variables[k].causality == Causality::parameter &&
        (values.real[k] != other.real[k] || values.integer[k] != other.integer[k] || values.text[k] != other.text[k]))
      return false;
  return true;
}

void Unit::apply_parameters() try {
  for (const std::string& warning : model_->set_parameters(values)) log(Severity::warning, warning.c_str());
} catch (const Error& error) {
  throw std::runtime_error(error.what());
}

Model& Unit::model() {
  if (!parameters_changed_) return *model_;
  if (!applied_ || !has_parameters_of(*applied_)) {
    applied_.reset();
    apply_parameters();
    applied_ = values;
  }
  parameters_changed_ = false;
  if (kept_) model_->set_memory(*kept_);
  kept_.reset();
  return *model_;
}

void Unit::evaluate() {
  if (evaluated_) return;
  model().evaluate(values);
  evaluated_ = true;
}

void Unit::advance(double step) {
  evaluate();
  if (!info_.remembers) return;
  model().advance(values, step);
  evaluated_ = false;
  evaluate();
}

void Unit::start() {
  evaluate();
  stage = interface_ == Interface::co_simulation ? Stage::stepping : Stage::event;
}

void Unit::enter_continuous_time() {
  evaluate();
  held_ = values.integer;
  stage = Stage::continuous;
}

bool Unit::wants_event() {
  evaluate();
  return values.integer != held_;
}

int Unit::integer(ValueReference reference) const {
  return stage == Stage::continuous ? held_[reference] : values.integer[reference];
}

void Unit::differentiate() {
  derivatives_ = model().differentiate(values);
}

double Unit::derivative(ValueReference of, ValueReference by) const {
  const std::size_t part = info_.variables[of].part;
  if (info_.variables[by].part != part) return 0;
  return derivatives_[(part * outputs_ + place_[of]) * inputs_ + place_[by]];
}

void Unit::reset() {
  stage = Stage::instantiated;
  time = 0;
  values = Values(info_.variables);
  model_ = make_model(resources_);
  applied_.reset();
  kept_.reset();
  changed(Causality::parameter);
}

void Unit::restore(const Saved& saved) {
  stage = saved.stage;
  time = saved.time;
  values = saved.values;
  held_ = values.integer;
  kept_ = saved.memory;
  changed(Causality::parameter);
}

} // namespace microslip::fmi
