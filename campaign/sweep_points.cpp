#include "campaign/sweep_points.hpp"

#include "campaign/sweep.hpp"
#include "campaign/sweep_file.hpp"
#include "io/case_file.hpp"
#include "io/nearest_word.hpp"
#include "io/result_reader.hpp"
#include "microslip/decimal.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <sstream>
#include <string_view>
#include <utility>

namespace microslip::campaign {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double same = 0.05; ///< relative difference of speeds and loads that are taken for the same

/// What a case says of a creep curve, NaN where it is not solved.
struct CreepState {
  double creepage = nan, coefficient = nan, speed = nan, normal_force = nan;
};

/// Keys that make the creepage, of two bodies first.
std::span<const std::string_view> creepage_keys(bool is_lateral) {
  static constexpr std::string_view longitudinal[] = {"motion.creepage_longitudinal", "wheel.pitch_velocity",
                                                      "wheel.deflection_pitch_velocity",
                                                      "wheel.deflection_longitudinal_velocity"};
  static constexpr std::string_view lateral[] = {"motion.creepage_lateral", "wheel.yaw", "wheel.lateral_velocity",
                                                 "wheel.deflection_yaw", "wheel.deflection_lateral_velocity"};
  return is_lateral ? std::span<const std::string_view>(lateral) : longitudinal;
}

/// A sweep's result file.
class SweepResult {
public:
  explicit SweepResult(const std::filesystem::path& path) : name_(path.string()), reader_(path) {
    if (attribute("kind") != sweep_kind) throw Error(name_ + ": is no result of a sweep");
    std::istringstream names(attribute("parameters"));
    for (std::string name; std::getline(names, name);) {
      values_.push_back(reader_.read(dataset("parameters/" + name)));
      parameters_.push_back(name);
    }
    count_ = std::visit([](const auto& values) { return values.size(); }, values_.front());
  }

  const std::string& name() const { return name_; }
  std::size_t count() const { return count_; }
  const std::vector<std::string>& parameters() const { return parameters_; }
  bool is_grid() const { return find("shape") != nullptr; }

  std::string attribute(std::string_view name) const {
    for (const io::StoredAttribute& one : reader_.attributes())
      if (one.group.empty() && one.name == name) return one.value;
    return {};
  }
  bool has(const std::string& path) const { return find(path) != nullptr; }
  std::vector<double> numbers(const std::string& path) const {
    return std::get<std::vector<double>>(reader_.read(dataset(path)));
  }

  /// The values of all parameters but one in a case, all their digits or 6: `motion.spin = 0.3`.
  std::string combination(std::size_t index, std::size_t without, bool is_exact) const {
    std::string text;
    for (std::size_t k = 0; k < parameters_.size(); ++k) {
      if (k == without || !varies(k)) continue;
      text += (text.empty() ? "" : ", ") + parameters_[k] + " = " + value_text(index, k, is_exact);
    }
    return text;
  }

private:
  const io::StoredDataset* find(const std::string& path) const {
    const auto& all = reader_.datasets();
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.path() == path; });
    return found == all.end() ? nullptr : &*found;
  }
  const io::StoredDataset& dataset(const std::string& path) const {
    if (const auto* const found = find(path)) return *found;
    throw Error(name_ + ": has no " + path + ", which measured points need; leave it in output.quantities");
  }
  bool varies(std::size_t k) const {
    return std::visit(
        [](const auto& values) {
          return std::any_of(values.begin(), values.end(), [&](const auto& value) { return value != values.front(); });
        },
        values_[k]);
  }
  std::string value_text(std::size_t index, std::size_t k, bool is_exact) const {
    const auto* const texts = std::get_if<std::vector<std::string>>(&values_[k]);
    if (texts) return (*texts)[index];
    const auto* const numbers = std::get_if<std::vector<double>>(&values_[k]);
    if (!numbers) return std::to_string(std::get<std::vector<int>>(values_[k])[index]);
    return is_exact ? shortest_text((*numbers)[index]) : rounded_text((*numbers)[index], 6);
  }

  std::string name_;
  io::ResultReader reader_;
  std::vector<std::string> parameters_;
  std::vector<io::ResultReader::Values> values_;
  std::size_t count_ = 0;
};

/// The parameter that makes the creepage.
std::size_t creepage_parameter(const SweepResult& result, bool is_lateral) {
  const auto keys = creepage_keys(is_lateral);
  const auto& all = result.parameters();
  const auto found = std::find_first_of(all.begin(), all.end(), keys.begin(), keys.end());
  if (found == all.end())
    throw Error(result.name() + ": nothing varies that makes the " + (is_lateral ? "lateral" : "longitudinal") +
                " creepage of the measured points: " + io::listed(keys));
  if (!result.is_grid() && all.size() > 1)
    throw Error(result.name() + ": has curves over the creepage only as a grid, or where nothing else varies");
  return static_cast<std::size_t>(found - all.begin());
}

/// Of two bodies: creepage, speed and load are those of the cases, which are read anew.
std::vector<CreepState> states_of_bodies(const SweepResult& result, bool is_lateral) {
  const std::vector<double> force = result.numbers(is_lateral ? "contact/fy" : "contact/fx");
  const Sweep sweep(result.attribute("case_text"), result.attribute("case_file"));
  const SweepSpec& spec = sweep.spec();
  if (spec.count() != result.count()) throw Error(spec.name() + ": has other cases than " + result.name());
  const io::CreepTables tables;
  toml::table table = spec.base();
  std::vector<CreepState> states(result.count());
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (std::isnan(force[i])) continue;
    for (std::size_t k = 0; k < spec.parameters().size(); ++k) spec.set(i, k, table);
    const RollingProblem problem = io::read_case(io::TomlSection(table, spec.base_name()), tables).problem;
    if (problem.load.given != NormalLoad::Given::force)
      throw Error("load.approach: creep curves need load.normal_force");
    const auto& creepage = problem.motion.creepage;
    states[i] = {.creepage = is_lateral ? creepage.lateral : creepage.longitudinal,
                 .coefficient = -force[i] / problem.load.value,
                 .speed = problem.motion.rolling_speed,
                 .normal_force = problem.load.value};
  }
  return states;
}

/// Of a wheel on a rail: the patches of each case together.
std::vector<CreepState> states_of_wheel(const SweepResult& result, bool is_lateral) {
  struct Sums {
    double creepage = 0, force = 0, speed = 0, load = 0;
  };
  std::vector<Sums> sums(result.count());
  std::size_t kept = 0;
  for (; result.has("patches/" + std::to_string(kept) + "/status"); ++kept) {
    const std::string patch = "patches/" + std::to_string(kept) + "/";
    if (kept > 0 && !result.has(patch + "normal_force")) continue; // no case has so many
    const auto creepage = result.numbers(patch + (is_lateral ? "creepage_lateral" : "creepage_longitudinal"));
    const auto force = result.numbers(patch + (is_lateral ? "fy" : "fx"));
    const auto speed = result.numbers(patch + "rolling_speed"), load = result.numbers(patch + "normal_force");
    for (std::size_t i = 0; i < sums.size(); ++i) {
      if (std::isnan(load[i]) || std::isnan(force[i])) continue;
      sums[i].creepage += creepage[i] * load[i], sums[i].speed += speed[i] * load[i];
      sums[i].force += force[i], sums[i].load += load[i];
    }
  }
  const auto patches = result.numbers("wheel/patch_count");
  std::vector<CreepState> states(result.count());
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (patches[i] > static_cast<double>(kept))
      throw Error(result.name() + ": a case has more patches than are kept; let output.patches be " +
                  rounded_text(patches[i], 3));
    if (sums[i].load > 0)
      states[i] = {.creepage = sums[i].creepage / sums[i].load,
                   .coefficient = -sums[i].force / sums[i].load,
                   .speed = sums[i].speed / sums[i].load,
                   .normal_force = sums[i].load};
  }
  return states;
}

std::vector<CreepState> states_of(const SweepResult& result, bool is_lateral) {
  if (result.has("contact/status")) return states_of_bodies(result, is_lateral);
  if (result.has("wheel/status")) return states_of_wheel(result, is_lateral);
  throw Error(result.name() + ": measured points are for sweeps of two bodies or of one wheel; of a wheelset sweep "
                              "one wheel, with side = \"left\" or \"right\"");
}

/// Cases that differ in nothing but the creepage.
struct Combination {
  std::string exact_name, name; ///< with all digits, and as it is shown
  std::vector<CreepState> states = {};
};

/// In the order of the cases. Names are rounded unless those of two combinations would then be the same.
std::vector<Combination> combinations_of(const SweepResult& result, std::size_t along,
                                         const std::vector<CreepState>& states) {
  std::vector<Combination> all;
  std::map<std::string, std::size_t> places, uses; // by exact and by rounded names
  for (std::size_t i = 0; i < states.size(); ++i) {
    const std::string exact = result.combination(i, along, true);
    const auto place = places.emplace(exact, all.size()).first->second;
    if (place == all.size()) {
      all.push_back({.exact_name = exact, .name = result.combination(i, along, false)});
      ++uses[all.back().name];
    }
    all[place].states.push_back(states[i]);
  }
  for (Combination& one : all)
    if (uses[one.name] > 1) one.name = one.exact_name;
  return all;
}

/// The curve through cases, on the side that more of them are on; empty if no case has a creepage.
ComparedCurve curve_through(const std::vector<CreepState>& states) {
  std::map<double, const CreepState*> sides[2];
  for (const CreepState& state : states)
    if (std::isfinite(state.coefficient) && state.creepage != 0)
      sides[state.creepage < 0].emplace(std::abs(state.creepage), &state);
  const auto& side = sides[sides[1].size() > sides[0].size()];
  ComparedCurve curve;
  if (side.empty()) return curve;
  curve.speed = side.begin()->second->speed, curve.normal_force = side.begin()->second->normal_force;
  for (const auto& [creepage, state] : side) {
    curve.creepage.push_back(creepage);
    curve.coefficient.push_back(state->creepage < 0 ? -state->coefficient : state->coefficient);
  }
  return curve;
}

/// Coefficient at a creepage between those of the cases.
double coefficient_at(const ComparedCurve& curve, double creepage) {
  const auto& x = curve.creepage;
  constexpr double rounding = 1e-9;
  const double at = std::clamp(creepage, x.front(), x.back());
  if (std::abs(at - creepage) > rounding * creepage)
    throw Error("a point at the creepage " + rounded_text(creepage, 4) + " is beyond those of the sweep, " +
                rounded_text(x.front(), 4) + " to " + rounded_text(x.back(), 4));
  const auto next = static_cast<std::size_t>(std::lower_bound(x.begin(), x.end(), at) - x.begin());
  if (next == 0) return curve.coefficient.front();
  const double part = (at - x[next - 1]) / (x[next] - x[next - 1]);
  return (1 - part) * curve.coefficient[next - 1] + part * curve.coefficient[next];
}

bool is_near(double one, double other) {
  return std::abs(one - other) <= same * std::abs(other);
}

/// Adds the points at the curve's speed and load.
void add_points(ComparedCurve& curve, const std::string& text, const std::string& name) {
  curve.measured = io::read_measured_curves(text, name, {.speed = curve.speed, .normal_force = curve.normal_force});
  std::erase_if(curve.measured.points, [&](const io::MeasuredPoint& point) {
    return !is_near(point.speed, curve.speed) || !is_near(point.normal_force, curve.normal_force);
  });
  for (const io::MeasuredPoint& point : curve.measured.points)
    curve.computed.push_back(coefficient_at(curve, point.creepage));
  curve.find_deviations();
}

} // namespace

void ComparedCurve::find_deviations() {
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < computed.size(); ++i) {
    const double deviation = computed[i] - measured.points[i].coefficient;
    sum += deviation, squares += deviation * deviation;
  }
  const auto count = static_cast<double>(std::max<std::size_t>(1, computed.size()));
  bias = sum / count, rms = std::sqrt(squares / count);
}

std::vector<ComparedCurve> compare_sweep(const std::filesystem::path& result_file,
                                         const std::filesystem::path& points) {
  const std::string text = io::read_case_text(points), name = points.string();
  constexpr io::MeasuringConditions any = {.speed = 1, .normal_force = 1e12}; // large: no force is out of range
  const bool is_lateral = io::read_measured_curves(text, name, any).is_lateral;
  const SweepResult result(result_file);
  const std::size_t along = creepage_parameter(result, is_lateral);
  std::vector<ComparedCurve> curves;
  for (const Combination& one : combinations_of(result, along, states_of(result, is_lateral))) {
    ComparedCurve curve = curve_through(one.states);
    if (curve.creepage.empty()) continue;
    curve.name = one.name;
    add_points(curve, text, name);
    if (!curve.measured.points.empty()) curves.push_back(std::move(curve));
  }
  if (curves.empty()) throw Error(name + ": no point has a rolling speed and load of " + result.name() + ", to 5 %");
  return curves;
}

} // namespace microslip::campaign
