#pragma once

#include "microslip/contact/vector_field.hpp"
#include "microslip/elasticity/material.hpp"
#include "microslip/exact/fitted/fitted_contact.hpp"
#include "microslip/exact/fitted/row_variation.hpp"
#include "microslip/numerics/transform_plans.hpp"
#include "microslip/progress.hpp"

#include <vector>

namespace microslip {

/// A contact whose pressures differ a little from those of another one, on as many elements.
struct NearbyContact {
  FittedContact contact;
  double capacity = 0; ///< mu Fn [N]
};

/// What changes where the pressures change, edges and leading elements with them, while the tractions of the elements
/// stay: per unit of the change, for each element.
struct ContactChange {
  std::vector<double> bound;      ///< of g [Pa]
  VectorField at_point, at_end;   ///< of the displacement at the element's point, and at the end of its slip [m]
  std::vector<double> point, end; ///< of these places [m]
  std::vector<double> width;      ///< of the element, whose centre is its point [m]
};

/// By differences between contacts that are changed by `step` units to either side. Throws Stopped. Cost: two
/// operators.
ContactChange contact_change(const CombinedMaterial& material, const NearbyContact& less, const NearbyContact& more,
                             double step, const VectorField& traction, const RowVariation& variation,
                             const Progress& progress, const TransformPlans& plans);

} // namespace microslip
