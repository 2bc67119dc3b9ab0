#include "microslip/simplified/prescribed_forces.hpp"

#include "microslip/numerics/plane_root.hpp"

#include <cmath>
#include <numbers>

namespace microslip {

FoundCreepage find_creepage(const std::function<ContactForces(const Creepage&)>& forces,
                            const PrescribedForces& prescribed, const Creepage& given, double capacity,
                            double creepage_scale, double tolerance) {
  const double wanted = std::hypot(prescribed.x.value_or(0), prescribed.y.value_or(0));
  if (!(wanted < capacity)) return {given, wanted / capacity - 1, Status::no_solution};
  const auto creepage = [&](Vec2 v) -> Creepage {
    return {prescribed.x ? v.x : given.longitudinal, prescribed.y ? v.y : given.lateral, given.spin};
  };
  const auto misfit = [&](Vec2 v) -> Vec2 {
    const ContactForces f = forces(creepage(v));
    return {prescribed.x ? (f.fx - *prescribed.x) / capacity : v.x / creepage_scale,
            prescribed.y ? (f.fy - *prescribed.y) / capacity : v.y / creepage_scale};
  };
  const PlaneRoot root = find_plane_root(misfit, {}, {creepage_scale, creepage_scale}, tolerance);
  return {creepage(root.at), root.size, root.found ? Status::ok : Status::not_converged};
}

FoundCreepage find_creepage(RowSolver& solver, const EllipticContact& contact, const PrescribedForces& prescribed,
                            double tolerance) {
  const double capacity = contact.friction.peak_coefficient() * contact.normal_force;
  const double scale = capacity / (contact.shear_modulus * std::numbers::pi * contact.a * contact.b);
  const auto forces = [&](const Creepage& creepage) {
    EllipticContact at = contact;
    at.creepage = creepage;
    return solver.solve(at);
  };
  return find_creepage(forces, prescribed, contact.creepage, capacity, scale, tolerance);
}

} // namespace microslip
