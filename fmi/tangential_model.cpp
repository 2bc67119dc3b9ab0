// The tangential contact law as a unit.

#include "fmi/model.hpp"
#include "fmi/tangential_law.hpp"
#include "microslip/contact/limits.hpp"

#include <optional>

namespace microslip::fmi {
namespace {

/// The variables by their value references.
enum Reference : std::size_t {
  creepage_longitudinal,
  creepage_lateral,
  spin,
  normal_force,
  friction,
  fx,
  fy,
  mz,
  adhesion_area,
  slip_area,
  semi_axis_x,
  semi_axis_y,
  reference_force,
  shear_modulus,
  poisson_ratio,
  mx,
  my,
  status
};

class TangentialModel final : public Model {
public:
  std::vector<std::string> set_parameters(const Values& v) override {
    law_.emplace(LawParameters{.semi_axis_x = v.real[semi_axis_x],
                               .semi_axis_y = v.real[semi_axis_y],
                               .reference_force = v.real[reference_force],
                               .shear_modulus = v.real[shear_modulus],
                               .poisson_ratio = v.real[poisson_ratio],
                               .mx = v.integer[mx],
                               .my = v.integer[my]});
    return {};
  }

  void evaluate(Values& v) override {
    const ContactForces forces = law_->evaluate(input(v));
    v.real[fx] = forces.fx, v.real[fy] = forces.fy, v.real[mz] = forces.mz;
    v.real[adhesion_area] = forces.adhesion_area, v.real[slip_area] = forces.slip_area;
    v.integer[status] = static_cast<int>(forces.status);
  }

  std::span<const double> differentiate(const Values& v) override {
    derivatives_ = law_->differentiate(input(v));
    return {derivatives_.front().data(), derivatives_.size() * derivatives_.front().size()};
  }

private:
  static LawInput input(const Values& v) {
    return {.creepage = {v.real[creepage_longitudinal], v.real[creepage_lateral], v.real[spin]},
            .normal_force = v.real[normal_force],
            .friction = v.real[friction]};
  }

  std::optional<TangentialLaw> law_;
  std::array<std::array<double, 5>, 3> derivatives_{};
};

} // namespace

ModelInfo model_info() {
  using enum Causality;
  const LawInput usual;
  const LawParameters p;
  const auto real = [](const char* name, Causality causality, const char* unit, double start, const char* text) {
    return Variable{.name = name, .description = text, .causality = causality, .unit = unit, .start = start};
  };
  const auto ranged = [&](Variable v, double min, double max) {
    v.min = min, v.max = max;
    return v;
  };
  const auto cells = [](const char* name, int start, const char* text) {
    return Variable{.name = name,
                    .description = text,
                    .kind = Kind::integer,
                    .causality = parameter,
                    .start = static_cast<double>(start),
                    .min = 1,
                    .max = most_cells};
  };
  return {
      .name = "microslip tangential contact law",
      .identifier = "microslip_tangential",
      .description =
          "Creep forces of a wheel on a rail by FASTSIM2: forces on the wheel, x along the rolling direction, "
          "y to the left, z up",
      .variables = {
          real("creepage_longitudinal", input, "-", 0,
               "xi, velocity of the wheel over the rail along x, over the rolling speed"),
          real("creepage_lateral", input, "-", 0, "eta, the same along y"),
          real("spin", input, "1/m", 0,
               "phi, angular velocity of the wheel over the rail about z, over the rolling speed"),
          real("normal_force", input, "N", usual.normal_force, "Fn; no contact at 0 and below"),
          ranged(real("friction", input, "-", usual.friction, "Coefficient of friction"), 0,
                 FrictionLaw::largest_coefficient),
          real("fx", output, "N", 0, "Longitudinal force on the wheel"),
          real("fy", output, "N", 0, "Lateral force on the wheel"),
          real("mz", output, "N m", 0, "Moment on the wheel about z at the centre of the contact"),
          real("adhesion_area", local, "m^2", 0, "Part of the contact area that adheres"),
          real("slip_area", local, "m^2", 0, "Part of the contact area that slips"),
          real("semi_axis_x", parameter, "m", p.semi_axis_x,
               "Semi-axis of the contact ellipse along x under the reference force; grows as Fn^(1/3)"),
          real("semi_axis_y", parameter, "m", p.semi_axis_y, "The same along y"),
          real("reference_force", parameter, "N", p.reference_force, "Normal force that the semi-axes belong to"),
          real("shear_modulus", parameter, "Pa", p.shear_modulus, "Combined modulus of rigidity of wheel and rail"),
          ranged(real("poisson_ratio", parameter, "-", p.poisson_ratio, "Combined Poisson's ratio of wheel and rail"),
                 0, 0.5),
          cells("mx", p.mx, "Cells along each row of the contact"),
          cells("my", p.my, "Rows of cells"),
          {.name = "status", .description = "0: contact, 3: no contact", .kind = Kind::integer, .causality = output}}};
}

std::unique_ptr<Model> make_model(const std::filesystem::path&) {
  return std::make_unique<TangentialModel>();
}

} // namespace microslip::fmi
