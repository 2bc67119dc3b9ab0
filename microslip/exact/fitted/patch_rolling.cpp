#include "microslip/exact/fitted/patch_rolling.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/fitted/fitted_solution.hpp"
#include "microslip/exact/fitted/patch_estimate.hpp"
#include "microslip/exact/halfspace/coarser_elements.hpp"
#include "microslip/exact/halfspace/memory_need.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace microslip {
namespace {

constexpr double normal_tolerance = 1e-8;

/// A pressure on a grid.
struct PressureField {
  ElementGrid grid;
  std::vector<double> pressure;
};

/// The rows and columns that are in contact.
struct Extent {
  int left, right, low, high;

  int shortest() const { return std::min(right - left, high - low) + 1; }
};

Extent extent_of(const PressureField& f) {
  Extent e{f.grid.mx, -1, f.grid.my, -1};
  for (std::size_t k = 0; k < f.pressure.size(); ++k) {
    if (!(f.pressure[k] > 0)) continue;
    const int i = static_cast<int>(k % f.grid.mx), j = static_cast<int>(k / f.grid.mx);
    e.left = std::min(e.left, i), e.right = std::max(e.right, i);
    e.low = std::min(e.low, j), e.high = std::max(e.high, j);
  }
  return e;
}

/// Pressure on elements twice as long and wide around the contact: the root of the mean square, as p_n^2 falls linearly
/// to zero at the edges.
PressureField coarser(const PressureField& fine, const Extent& contact) {
  constexpr int columns_to_spare = 8; // which are half as many coarser ones
  PressureField around{fine.grid, {}};
  ElementGrid& grid = around.grid;
  grid.mx = contact.right - contact.left + 1 + 2 * columns_to_spare;
  grid.my = contact.high - contact.low + 1;
  grid.x0 = fine.grid.x(contact.left - columns_to_spare);
  grid.y0 = fine.grid.y(contact.low);
  around.pressure.assign(grid.count(), 0);
  for (int j = contact.low; j <= contact.high; ++j)
    for (int i = contact.left; i <= contact.right; ++i) {
      const double p = fine.pressure[static_cast<std::size_t>(j) * fine.grid.mx + i];
      around.pressure[static_cast<std::size_t>(j - contact.low) * grid.mx + i - contact.left + columns_to_spare] =
          p * p;
    }
  PressureField coarse{coarser_grid(grid), mean_on_coarser(grid, around.pressure)};
  for (double& p : coarse.pressure) p = std::sqrt(p);
  return coarse;
}

/// Elements fitted to the contact, and to coarser ones as long as these have enough elements.
std::unique_ptr<NestedRolling> nested(const CombinedMaterial& material, const PressureField& field,
                                      const Progress& progress, const TransformPlans& plans) {
  constexpr int smallest_with_coarser = 48; // elements across; below, a coarser grid saves less than it costs
  const Extent contact = extent_of(field);
  std::unique_ptr<NestedRolling> on_coarser;
  if (contact.shortest() >= smallest_with_coarser)
    on_coarser = nested(material, coarser(field, contact), progress, plans);
  return std::make_unique<NestedRolling>(material, fit_contact(field.grid, field.pressure), std::move(on_coarser),
                                         progress, plans);
}

/// Variation for a contact whose x axis points in the opposite direction where `side` is -1.
RowVariation turned(RowVariation variation, double side) {
  if (side < 0 && variation.creepage)
    variation.creepage = [given = variation.creepage](double y) {
      const Creepage w = given(y);
      return Creepage{-w.longitudinal, w.lateral, -w.spin};
    };
  if (side < 0 && variation.displacement)
    variation.displacement = [given = variation.displacement](double x, double y) {
      const Vec2 u = given(-x, y);
      return Vec2{-u.x, u.y};
    };
  return variation;
}

void require_similar(const CombinedMaterial& material) {
  if (material.dissimilarity != 0)
    throw Error("dissimilarity", material.dissimilarity, "-",
                "0: rolling of patches is for elastically similar bodies");
}

/// Tractions that are known on the grid's cells, along an x axis that points in the opposite direction where `side` is
/// -1.
RollingEstimate known_tractions(const VectorField& tractions, double side) {
  return {.tractions =
              [&tractions, side](const FittedContact& contact, std::span<const double>, const Creepage&) {
                VectorField out;
                for (const FittedElement& e : contact.elements) {
                  const std::size_t mx = contact.grid.mx, column = e.cell % mx;
                  const std::size_t cell = side > 0 ? e.cell : e.cell + mx - 1 - 2 * column;
                  out.x.push_back(side * tractions.x[cell]), out.y.push_back(tractions.y[cell]);
                }
                return out;
              },
          .creepage = [] { return std::nullopt; },
          .near = true};
}

void check(const PatchRollingMotion& motion) {
  require_positive("friction", motion.friction, "-");
  require_finite("creepage.longitudinal", motion.creepage.longitudinal, "-");
  require_finite("creepage.lateral", motion.creepage.lateral, "-");
  require_finite("creepage.spin", motion.creepage.spin, "1/m");
  if (motion.force_x) require_finite("force_x", *motion.force_x, "N");
  if (motion.force_y) require_finite("force_y", *motion.force_y, "N");
  require_positive("rolling_speed", motion.rolling_speed, "m/s");
  require_between("tolerance", motion.tolerance, "-", smallest_tolerance, largest_tolerance);
}

} // namespace

PatchRolling::PatchRolling(const CombinedMaterial& material, const ElementGrid& grid, std::span<const double> gap,
                           const NormalLoad& load, RollingDirection direction, const Progress& progress,
                           const TransformPlans& plans)
    : material_(material), direction_(direction) {
  require_similar(material);
  require_memory(ContactProblem::tangential, grid);
  try {
    const Progress essential = essential_part(progress, 0, 1);
    normal_ = NormalProblem(material, grid, essential, plans).solve(gap, load, normal_tolerance, essential);
    fit(grid, essential, plans);
  } catch (const Stopped&) {
    normal_ = {};
    normal_.status = Status::not_converged;
  }
}

PatchRolling::PatchRolling(const CombinedMaterial& material, const ElementGrid& grid, NormalSolution normal,
                           RollingDirection direction, const Progress& progress, const TransformPlans& plans)
    : material_(material), direction_(direction), normal_(std::move(normal)) {
  require_similar(material);
  require_memory(ContactProblem::tangential, grid);
  try {
    fit(grid, essential_part(progress, 0, 1), plans);
  } catch (const Stopped&) {
    normal_ = {};
    normal_.status = Status::not_converged;
  }
}

void PatchRolling::fit(const ElementGrid& grid, const Progress& progress, const TransformPlans& plans) {
  if (normal_.contact_elements == 0) return;
  const bool forward = direction_ == RollingDirection::forward;
  rolling_ = nested(material_,
                    forward ? PressureField{grid, normal_.pressure}
                            : PressureField{mirrored(grid), mirrored(grid, normal_.pressure)},
                    progress, plans);
}

ContactSolution PatchRolling::solve(const PatchRollingMotion& motion) {
  check(motion);
  if (!rolling_) {
    ContactSolution nothing;
    nothing.creepage = motion.creepage;
    nothing.report.status = normal_.status == Status::ok ? Status::no_contact : normal_.status;
    conclude(nothing, motion.tolerance);
    return nothing;
  }
  const double capacity = motion.friction * normal_.normal_force;
  const double side = direction_ == RollingDirection::forward ? 1 : -1;
  SecondOrderInput input{
      .creepage = {side * motion.creepage.longitudinal, motion.creepage.lateral, side * motion.creepage.spin},
      .variation = turned(motion.variation, side),
      .force_x = motion.force_x,
      .force_y = motion.force_y,
      .start = {},
      .centred = {},
      .progress = motion.progress,
      .tolerance = motion.tolerance};
  if (input.force_x) *input.force_x *= side;
  if (motion.near_last) input.centred = centred_;
  const std::vector<double> bound = rolling_->bound(capacity, input.variation);
  // With forces prescribed the start needs more than tractions.
  const bool start_known = motion.start.x.size() == contact()->grid.count() && !input.force_x && !input.force_y;
  SecondOrderSolution found = rolling_->solve(
      capacity, input,
      start_known ? known_tractions(motion.start, side) : estimate_by_fastsim(material_, *contact(), capacity, input));
  ContactSolution out = contact_solution(rolling_->contact(), found,
                                         {.bound = bound,
                                          .normal_force = normal_.normal_force,
                                          .approach = normal_.approach,
                                          .rolling_speed = motion.rolling_speed,
                                          .direction = direction_});
  centred_ = std::move(found.centred);
  out.fields.gap = normal_.gap;
  if (normal_.status != Status::ok) out.report.status = normal_.status;
  conclude(out, motion.tolerance);
  return out;
}

} // namespace microslip
