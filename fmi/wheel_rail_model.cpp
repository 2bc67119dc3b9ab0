// A wheel on a rail as a unit. Parameters are named as the keys of case files, inputs and results as in the tables of
// quantities.

#include "fmi/model.hpp"
#include "io/length_unit.hpp"
#include "io/option_words.hpp"
#include "io/sliced_profile.hpp"
#include "microslip/error.hpp"
#include "microslip/railway/wheel_rail.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace microslip::fmi {
namespace {

constexpr std::size_t patches_shown = 3; ///< tread, flange, flange's back
/// Of wheel_quantities(): forces, moments and height are outputs, since they have derivatives.
constexpr std::size_t outputs = 7;

/// A profile's file as its parameters say.
struct ProfileParameters {
  std::string profile = {}, unit = {}, y_axis = {}, z_axis = {};
  double smoothing_length = 0;

  bool operator==(const ProfileParameters&) const = default;
};

/// All parameters by their names.
struct Parameters {
  ProfileParameters rail{.profile = "60e1.prr"}, wheel{.profile = "s1002.prw"};
  Track track;
  Wheelset wheelset;
  std::string side{io::to_word(TrackSide::left)};
  double young_modulus = 210e9, poisson_ratio = 0.28, friction = 0.3;
  std::string theory{io::to_word(WheelRailLevel::fastsim2)}, shape;
  int grid = WheelRailMethod{}.elements;
  double tolerance = WheelRailMethod{}.tolerance;
};

/// Names, texts and members of the parameters: `visit(name, unit, text, member)`.
template <class Given, class Visit> void for_each_parameter(Given& p, const Visit& visit) {
  const auto profile = [&](const std::string& section, auto& of) {
    visit(section + ".profile", "", "Profile's file: a path, from the unit's resources on if it is relative",
          of.profile);
    visit(section + ".unit", "",
          "Unit of length of that file: mm, m or in; empty: what the file says, else by its width", of.unit);
    visit(section + ".y_axis", "", "Side to which y runs in it: field or gauge; empty: by the format", of.y_axis);
    visit(section + ".z_axis", "", "Where its z is positive: up or down; empty: by the format or the shape", of.z_axis);
    visit(section + ".smoothing_length", "m", "Wavelength of which smoothing leaves half; 0: none",
          of.smoothing_length);
  };
  visit("track.gauge", "m", "Between the gauge points of both rails", p.track.gauge);
  visit("track.gauge_height", "m", "How far below the tops of the rails these lie at most", p.track.gauge_height);
  visit("track.cant", "rad", "Inclination of the rails, positive towards the track's centre", p.track.cant);
  profile("rail", p.rail);
  profile("wheelset", p.wheel);
  visit("wheelset.nominal_radius", "m", "Radius where z = 0 in the wheel's profile", p.wheelset.nominal_radius);
  visit("wheelset.flange_back_distance", "m", "Between the backs of both flanges", p.wheelset.flange_back_distance);
  visit("wheelset.flange_back_position", "m", "y of the flange's back in the profile", p.wheelset.flange_back_position);
  visit("wheel.side", "", "Which wheel: left or right", p.side);
  visit("material.young_modulus", "Pa", "Of wheel and rail", p.young_modulus);
  visit("material.poisson_ratio", "-", "Of wheel and rail, 0 to 0.5", p.poisson_ratio);
  visit("friction.coefficient", "-", "Coefficient of friction", p.friction);
  visit("solution.theory", "", "fastsim2 or exact", p.theory);
  visit("solution.shape", "",
        "Of exact patches: flat, curved or conformal; empty: the true surfaces; fastsim2 has no others", p.shape);
  visit("solution.grid", "", "Elements of the exact theory across each patch, 6 to 1000", p.grid);
  visit("solution.tolerance", "-", "Of the vertical force, relative, 1e-12 to 0.01", p.tolerance);
}

Variable parameter(const std::string& name, const std::string& text) {
  return {.name = name, .description = text, .causality = Causality::parameter};
}
void add_parameter(std::vector<Variable>& all, const std::string& name, const char* unit, const char* text,
                   double start) {
  all.push_back(parameter(name, text));
  all.back().unit = unit, all.back().start = start;
}
void add_parameter(std::vector<Variable>& all, const std::string& name, const char*, const char* text, int start) {
  all.push_back(parameter(name, text));
  all.back().kind = Kind::integer, all.back().start = start;
}
void add_parameter(std::vector<Variable>& all, const std::string& name, const char*, const char* text,
                   const std::string& start) {
  all.push_back(parameter(name, text));
  all.back().kind = Kind::text, all.back().start_text = start;
}

void read(const Values& v, std::size_t place, double& to) {
  to = v.real[place];
}
void read(const Values& v, std::size_t place, int& to) {
  to = v.integer[place];
}
void read(const Values& v, std::size_t place, std::string& to) {
  to = v.text[place];
}

std::string numbered(std::size_t patch) {
  return "patch[" + std::to_string(patch + 1) + "].";
}

class WheelRailModel final : public Model {
public:
  explicit WheelRailModel(std::filesystem::path resources) : resources_(std::move(resources)) {}

  /// Reads the profiles, each of them once unless what is said of its file changes.
  std::vector<std::string> set_parameters(const Values& v) override {
    Parameters p;
    std::size_t place = 0;
    for_each_parameter(p, [&](const auto&, const char*, const char*, auto& member) { read(v, place++, member); });
    solver_.reset();
    std::vector<std::string> warnings;
    const io::PlacedProfile& rail = read_once("rail", ProfileRole::rail, p.rail, rail_, warnings);
    const io::PlacedProfile& wheel = read_once("wheelset", ProfileRole::wheel, p.wheel, wheel_, warnings);
    const Material material = Material::from_young(p.young_modulus, p.poisson_ratio);
    solver_.emplace(WheelRailBodies{.rail = rail.profile,
                                    .wheel = wheel.profile,
                                    .track = p.track,
                                    .wheelset = p.wheelset,
                                    .side = io::from_word<TrackSide>("wheel.side", p.side),
                                    .material = combine(material, material),
                                    .friction = {{0, p.friction}},
                                    .strength = {},
                                    .rail_surface = rail.surface,
                                    .wheel_surface = wheel.surface},
                    WheelRailMethod{.level = io::from_word<WheelRailLevel>("solution.theory", p.theory),
                                    .shape = p.shape.empty()
                                                 ? std::nullopt
                                                 : std::optional(io::from_word<PatchShape>("solution.shape", p.shape)),
                                    .elements = p.grid,
                                    .tolerance = p.tolerance});
    first_input_ = place;
    return warnings;
  }

  void evaluate(Values& v) override {
    solver_->solve(state(v), vertical_force(v), found_);
    std::size_t place = first_input_ + state_numbers + 1;
    for (const WheelQuantity& q : wheel_quantities()) v.real[place++] = q.value(found_);
    v.integer[place++] = static_cast<int>(found_.status);
    v.integer[place++] = found_.warnings.has(Warning::profile_end) ? 1 : 0;
    v.integer[place++] = static_cast<int>(found_.warnings.code);
    for (std::size_t k = 0; k < patches_shown; ++k)
      for (const PatchQuantity& q : patch_quantities())
        v.real[place++] = k < found_.patches.size() ? q.value(found_.patches[k]) : 0;
  }

  std::span<const double> differentiate(const Values& v) override {
    WheelRailDerivatives d;
    solver_->differentiate(state(v), vertical_force(v), found_, d);
    double* value = derivatives_.data();
    for (const WheelDerivative& row : wheel_derivatives().first(outputs))
      for (std::size_t k = 0; k < wheel_variables; ++k) *value++ = row.value(d, k);
    return derivatives_;
  }

private:
  struct Read {
    ProfileParameters from;
    io::PlacedProfile prepared;
  };

  const io::PlacedProfile& read_once(const std::string& section, ProfileRole role, const ProfileParameters& p,
                                     std::optional<Read>& kept, std::vector<std::string>& warnings) const {
    if (!kept || !(kept->from == p)) {
      kept.reset();
      io::ProfileFileOptions options{.role = role};
      if (!p.unit.empty()) options.unit = io::length_of_unit(section + ".unit", p.unit);
      if (!p.y_axis.empty()) options.y_axis = io::from_word<io::LateralSense>(section + ".y_axis", p.y_axis);
      if (!p.z_axis.empty()) options.z_axis = io::from_word<io::VerticalSense>(section + ".z_axis", p.z_axis);
      options.treatment.smoothing_length =
          require_between(section + ".smoothing_length", p.smoothing_length, "m", 0, 1);
      kept = {p, io::read_placed_profile(resources_ / p.profile, options)};
      for (const std::string& warning : kept->prepared.report.warnings)
        warnings.push_back(section + ".profile: " + warning);
    }
    return kept->prepared;
  }

  WheelState<double> state(const Values& v) const {
    WheelState<double> state;
    for (std::size_t k = 0; k < state_numbers; ++k) {
      const StateQuantity& q = state_quantities()[k];
      const double value = v.real[first_input_ + k];
      if (!(std::abs(value) <= q.limit)) // makes the texts of errors only then
        require_between("state." + std::string(q.name), value, std::string(q.unit), -q.limit, q.limit);
      q.of(state) = value;
    }
    return state;
  }

  std::optional<double> vertical_force(const Values& v) const {
    const double force = v.real[first_input_ + state_numbers];
    if (force != 0 && !is_vertical_force(force))
      require_between("state.vertical_force", force, "N", least_vertical_force, largest_vertical_force);
    return force > 0 ? std::optional(force) : std::nullopt;
  }

  std::filesystem::path resources_;
  std::optional<Read> rail_, wheel_;
  std::optional<WheelRail> solver_;
  std::size_t first_input_ = 0;
  WheelRailSolution found_;
  std::array<double, outputs * wheel_variables> derivatives_{};
};

} // namespace

ModelInfo model_info() {
  ModelInfo info{.name = "microslip wheel on rail",
                 .identifier = "microslip_wheel_rail",
                 .description =
                     "Forces of a rail on a wheel by their profiles: in track axes, x forward, y to the left, z "
                     "up, moments about the wheel's centre",
                 .variables = {}};
  std::vector<Variable>& all = info.variables;
  Parameters defaults;
  for_each_parameter(defaults, [&](const std::string& name, const char* unit, const char* text, const auto& start) {
    add_parameter(all, name, unit, text, start);
  });
  for (const StateQuantity& q : state_quantities())
    all.push_back({.name = "state." + std::string(q.name),
                   .description = std::string(q.description),
                   .unit = std::string(q.unit),
                   .min = -q.limit,
                   .max = q.limit});
  all.push_back({.name = "state.vertical_force",
                 .description = "vertical force on the wheel, > 0: its height is found; 0: state.vertical counts",
                 .unit = "N",
                 .start = 80e3,
                 .min = 0,
                 .max = largest_vertical_force});
  for (const WheelQuantity& q : wheel_quantities()) {
    const bool differentiated = static_cast<std::size_t>(&q - wheel_quantities().data()) < outputs;
    all.push_back({.name = "wheel." + std::string(q.name),
                   .description = std::string(q.description),
                   .causality = differentiated ? Causality::output : Causality::local,
                   .unit = std::string(q.unit)});
  }
  all.push_back({.name = "status", .description = status_codes, .kind = Kind::integer, .causality = Causality::output});
  all.push_back({.name = "at_profile_end",
                 .description = "1: a patch ends where a profile ends, its forces are too small",
                 .kind = Kind::integer,
                 .causality = Causality::local});
  all.push_back(
      {.name = "warning_code", .description = warning_codes, .kind = Kind::integer, .causality = Causality::local});
  for (std::size_t k = 0; k < patches_shown; ++k)
    for (const PatchQuantity& q : patch_quantities())
      all.push_back({.name = numbered(k) + std::string(q.name),
                     .description = std::string(q.description),
                     .causality = Causality::local,
                     .unit = std::string(q.unit)});
  return info;
}

std::unique_ptr<Model> make_model(const std::filesystem::path& resources) {
  return std::make_unique<WheelRailModel>(resources);
}

} // namespace microslip::fmi
