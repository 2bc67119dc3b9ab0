#include "microslip/exact/fitted/contact_change.hpp"

#include "microslip/exact/fitted/fitted_operator.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace microslip {
namespace {

/// Displacements by tractions, which may be known to more than half-spaces.
struct Displacements {
  VectorField at_point, at_end;
};

Displacements displacements(const CombinedMaterial& material, const FittedContact& contact, const VectorField& traction,
                            const RowVariation& variation, const Progress& progress, const TransformPlans& plans) {
  const std::size_t n = contact.elements.size();
  FittedOperator slip_operator(material, contact, progress, plans);
  VectorField slip(n);
  slip_operator.apply(traction.x, traction.y, slip.x, slip.y);
  const FittedProduct<double>& product = slip_operator.product();
  const double unit = contact.grid.dx / material.shear_modulus;
  Displacements u{VectorField(n), VectorField(n)};
  for (std::size_t k = 0; k < n; ++k) {
    const FittedElement& e = contact.elements[k];
    const std::size_t end = product.end_points()[k];
    u.at_point.x[k] = unit * product.ux()[k], u.at_point.y[k] = unit * product.uy()[k];
    u.at_end.x[k] = unit * product.ux()[end], u.at_end.y[k] = unit * product.uy()[end];
    if (!variation.displacement) continue;
    const double y = contact.grid.y(e.row);
    const Vec2 here = variation.displacement(e.point, y), there = variation.displacement(e.end, y);
    u.at_point.x[k] += here.x, u.at_point.y[k] += here.y;
    u.at_end.x[k] += there.x, u.at_end.y[k] += there.y;
  }
  return u;
}

/// (more - less)/(2 step)
std::vector<double> slope(const std::vector<double>& less, const std::vector<double>& more, double step) {
  std::vector<double> out(less.size());
  std::transform(more.begin(), more.end(), less.begin(), out.begin(),
                 [&](double a, double b) { return (a - b) / (2 * step); });
  return out;
}
VectorField slope(const VectorField& less, const VectorField& more, double step) {
  return {slope(less.x, more.x, step), slope(less.y, more.y, step)};
}

/// A number of each element.
template <class Number> std::vector<double> numbers(const FittedContact& contact, const Number& number) {
  std::vector<double> out;
  for (const FittedElement& e : contact.elements) out.push_back(number(e));
  return out;
}

} // namespace

ContactChange contact_change(const CombinedMaterial& material, const NearbyContact& less, const NearbyContact& more,
                             double step, const VectorField& traction, const RowVariation& variation,
                             const Progress& progress, const TransformPlans& plans) {
  const auto field = [&](const NearbyContact& of) {
    return displacements(material, of.contact, traction, variation, progress, plans);
  };
  const auto slope_of = [&](const auto& number) {
    return slope(numbers(less.contact, number), numbers(more.contact, number), step);
  };
  const Displacements before = field(less), after = field(more);
  return {.bound = slope(friction_bound(less.contact, less.capacity, variation),
                         friction_bound(more.contact, more.capacity, variation), step),
          .at_point = slope(before.at_point, after.at_point, step),
          .at_end = slope(before.at_end, after.at_end, step),
          .point = slope_of([](const FittedElement& e) { return e.point; }),
          .end = slope_of([](const FittedElement& e) { return e.end; }),
          .width = slope_of([](const FittedElement& e) { return e.width(); })};
}

} // namespace microslip
