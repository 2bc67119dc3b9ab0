#include "compat/contact/fastsim.hpp"

#include "compat/contact/set_up.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/classical/tangential_totals.hpp"
#include "microslip/simplified/grid_fastrip.hpp"
#include "microslip/simplified/prescribed_forces.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace microslip::contact_program {
namespace {

/// mu of each law at a slip velocity [m/s].
std::vector<double> friction_at(const ContactStep& step, double velocity) {
  std::vector<double> mu;
  for (const FrictionLaw& law : step.friction) mu.push_back(law.coefficient(velocity));
  return mu;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

SlopeReduction slope_reduction(const Case& c) {
  const auto& data = c.material->model_data;
  if (data.size() < 3) return {};
  const std::size_t first = data.size() - 3;
  return {require_between("K0_MF", data[first], "-", 1e-6, 1), require_between("ALFAMF", data[first + 1], "-", 0, 1),
          require_between("BETAMF", data[first + 2], "-", 0, 1e6)};
}

/// What a step goes on from.
Springs origin_of(const Case& c, const CarriedSprings& carried) {
  if (!c.digits.has_history()) return {};
  if (c.digits.pvtime == Continuation::repeated) return carried.before;
  return c.digits.pvtime == Continuation::previous ? carried.after : Springs{};
}

/// The displacements of springs where the particles come from.
VectorField at_origin(const ContactStep& step, const Springs& springs) {
  return moved_to(origin_of_particles(step), springs.tractions, springs.grid).traction;
}

FastripForm form_of(Bulk model) {
  if (model == Bulk::fastrip) return FastripForm::modified;
  return model == Bulk::fastrip_first ? FastripForm::first : FastripForm::first_bounded;
}

/// CONTACT's choice of friction, ellipses and flexibilities for the simplified theory of the library.
class SimplifiedCase {
public:
  SimplifiedCase(const Case& c, const ContactStep& step, const std::vector<double>& pressure, double normal_force,
                 const CarriedSprings& carried)
      : case_(c), step_(step), normal_force_(normal_force), solver_(step.grid, pressure),
        before_(at_origin(step, origin_of(c, carried))) {
    const TangentialInput& m = step.motion;
    rolling_.spin_centre = {c.spin_x, c.spin_y};
    rolling_.spin_in_x = c.extra != ExtraSlip::without_spin_x;
    rolling_.spin_in_y = c.extra != ExtraSlip::without_spin_y;
    if (c.digits.has_history()) rolling_.before = &before_;
    if (m.motion == ContactMotion::shift) {
      rolling_.step = 1; // creepages are shifts
    } else {
      const bool transient = m.motion == ContactMotion::transient;
      const double length = m.direction == RollingDirection::forward ? step.grid.dx : -step.grid.dx;
      const double distance = transient ? signed_step(m, step.grid) : length;
      rolling_.ahead = way_of(m, m.spin_offset * distance);
      rolling_.direction = m.direction;
      rolling_.rolling_speed = m.rolling_speed;
      if (transient) rolling_.step = std::abs(distance);
    }
    if (c.extra != ExtraSlip::by_element) return;
    rolling_.extra_x = step.extra_slip_x;
    rolling_.extra_y = step.extra_slip_y;
  }

  ContactSolution solve() const {
    const Digits& d = case_.digits;
    const bool shifts = d.tang == Tangential::shift;
    const Creepage creepage = {slip_of(case_.x), slip_of(case_.y), case_.phi};
    if (d.force == Prescribed::creepages) return solve(creepage);
    PrescribedForces prescribed;
    if (step_.force_x) prescribed.x = *step_.force_x * normal_force_;
    if (step_.force_y) prescribed.y = *step_.force_y * normal_force_;
    const std::vector<double> at_rest = friction_at(step_, 0);
    const double capacity = solver_.capacity(at_rest);
    const double length = shifts ? std::sqrt(solver_.contact_area()) : 1; // of a shift that slides, over a creepage
    const double scale = length * capacity / (step_.bodies.material.shear_modulus * solver_.contact_area());
    const FoundCreepage found = find_creepage([this](const Creepage& w) { return solve(w).forces(); }, prescribed,
                                              creepage, capacity, scale, step_.motion.tolerance);
    ContactSolution s = found.status == Status::no_solution ? sliding(creepage, prescribed) : solve(found.creepage);
    s.report.residual = found.residual;
    s.report.status = found.status;
    return s;
  }

  PrintedSprings springs(const Creepage& creepage) const {
    const std::vector<double> friction = friction_of(creepage);
    const Flexibilities l = full_flexibilities(creepage);
    return {{l.longitudinal / mm3_per_newton, l.lateral / mm3_per_newton, l.spin / mm3_per_newton},
            slope_for(creepage, friction)};
  }

private:
  std::vector<double> friction_of(const Creepage& creepage) const {
    return friction_at(step_, rolling_.rolling_speed * std::hypot(creepage.longitudinal, creepage.lateral));
  }

  ContactSolution solve(const Creepage& creepage) const {
    const std::vector<double> friction = friction_of(creepage);
    GridRolling rolling = rolling_;
    rolling.creepage = creepage;
    const Flexibilities l = flexibilities_for(creepage, friction);
    if (!case_.digits.is_fastrip()) return solver_.solve(l, friction, rolling);
    const bool first = case_.digits.is_first_fastrip();
    const EllipticContact ellipse = first ? hertzian(creepage, friction) : equivalent(creepage, friction);
    return solve_fastrip(solver_, form_of(case_.digits.mater), ellipse, l, friction, rolling);
  }

  /// All slides in the direction of the force, with friction at rest.
  ContactSolution sliding(const Creepage& creepage, const PrescribedForces& prescribed) const {
    const double x = prescribed.x.value_or(0), y = prescribed.y.value_or(0), size = std::hypot(x, y);
    const std::vector<double> friction = friction_at(step_, 0);
    ContactSolution s = solver_.slide(flexibilities_for({}, friction), friction, {x / size, y / size});
    s.creepage = creepage;
    return s;
  }

  EllipticContact contact(double a, double b, double normal_force, const Creepage& creepage,
                          const std::vector<double>& friction) const {
    return {.a = a,
            .b = b,
            .shear_modulus = step_.bodies.material.shear_modulus,
            .poisson_ratio = step_.bodies.material.poisson_ratio,
            .normal_force = normal_force,
            .friction = FrictionLaw::coulomb(mean(friction)),
            .creepage = creepage,
            .rolling_speed = step_.motion.rolling_speed};
  }

  EllipticContact equivalent(const Creepage& creepage, const std::vector<double>& friction) const {
    const Vec2 axes = solver_.equivalent_axes();
    return contact(axes.x, axes.y, normal_force_, creepage, friction);
  }

  /// Hertz's ellipse, if the case has one.
  EllipticContact hertzian(const Creepage& creepage, const std::vector<double>& friction) const {
    const auto shape = hertzian_shape(case_, step_);
    return shape ? contact(shape->a, shape->b, shape->normal_force, creepage, friction)
                 : equivalent(creepage, friction);
  }

  /// Flexibilities come from Hertz's ellipse, but the reduction of the slope from that of the elements. They are
  /// blended only if the creepages are given.
  Flexibilities flexibilities_for(const Creepage& creepage, const std::vector<double>& friction) const {
    const Flexibilities l = full_flexibilities(creepage);
    const double k = slope_for(creepage, friction);
    return {l.longitudinal / k, l.lateral / k, l.spin / k};
  }

  double slope_for(const Creepage& creepage, const std::vector<double>& friction) const {
    const EllipticContact of_elements = equivalent(creepage, friction);
    return flexibilities(FlexibilityModel::three, {}, of_elements).longitudinal /
           flexibilities(FlexibilityModel::three, slope_reduction(case_), of_elements).longitudinal;
  }

  Flexibilities full_flexibilities(const Creepage& creepage) const {
    if (case_.digits.mater == Bulk::fastsim_one) {
      const double given =
          require_positive("FLX", case_.material->model_data[0] / mm3_per_newton, "mm3/N") * mm3_per_newton;
      return {given, given, given};
    }
    const bool by_force = case_.digits.force != Prescribed::creepages;
    return flexibilities(by_force ? FlexibilityModel::three : FlexibilityModel::blended, {},
                         hertzian(creepage, friction_at(step_, 0)));
  }

  const Case& case_;
  const ContactStep& step_;
  double normal_force_;
  GridFastsim solver_;
  VectorField before_;
  GridRolling rolling_ = {};
};

} // namespace

PrintedSprings printed_springs(const Case& c, const ContactStep& step, const ContactStepSolution& solution) {
  if (solution.contact_elements == 0) return {};
  const SimplifiedCase simplified(c, step, solution.normal.pressure, solution.normal_force, {});
  // About the centre of spin, as the case was solved.
  const Creepage& found = solution.creepage;
  const double phi = found.spin;
  return simplified.springs({found.longitudinal - phi * c.spin_y, found.lateral + phi * c.spin_x, phi});
}

ContactStepSolution solve_simplified(const Case& c, const ContactStep& step, ContactSequence& steps,
                                     CarriedSprings& carried) {
  ContactStep normal = step;
  normal.frictionless = true;
  ContactStepSolution out = steps.solve(normal);
  const bool virtual_penetration =
      c.digits.bound == PressureModel::kik_piotrowski || c.digits.bound == PressureModel::analyn;
  if (step.given && !virtual_penetration) out.normal.elastic_energy = 0;
  if (out.contact_elements > 0) {
    const Status status = out.report.status;
    std::vector<double> friction = std::move(out.fields.friction);
    static_cast<ContactSolution&>(out) =
        SimplifiedCase(c, step, out.normal.pressure, out.normal_force, carried).solve();
    out.motion = step.motion.motion;
    out.fields.friction = std::move(friction);
    add_normal(out, out.normal);
    if (!virtual_penetration) out.totals.elastic_energy = 0;
    if (status != Status::ok) out.report.status = status;
    const auto& state = out.fields.state;
    out.adhesion_elements = static_cast<int>(std::count(state.begin(), state.end(), CellState::adhesion));
    out.slip_elements = out.contact_elements - out.adhesion_elements;
  }
  carried = {.before = origin_of(c, carried), .after = {step.grid, {out.fields.displacement}}};
  return out;
}

} // namespace microslip::contact_program
