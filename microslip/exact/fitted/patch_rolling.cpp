#include "microslip/exact/fitted/patch_rolling.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/fitted/fitted_solution.hpp"
#include "microslip/exact/fitted/patch_estimate.hpp"
#include "microslip/exact/fitted/patch_response.hpp"
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
    : material_(material), grid_(grid), plans_(plans), direction_(direction) {
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
    : material_(material), grid_(grid), plans_(plans), direction_(direction), normal_(std::move(normal)) {
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

/// A solution along +x: of the mirror image of a contact that rolls along -x.
struct PatchRolling::Found {
  double capacity = 0; ///< mu Fn [N]
  RowVariation variation;
  SecondOrderSolution solution;
};

PatchRolling::Found PatchRolling::find(const PatchRollingMotion& motion) {
  const double side = direction_ == RollingDirection::forward ? 1 : -1;
  Found found{motion.friction * normal_.normal_force, turned(motion.variation, side), {}};
  SecondOrderInput input{
      .creepage = {side * motion.creepage.longitudinal, motion.creepage.lateral, side * motion.creepage.spin},
      .variation = found.variation,
      .force_x = motion.force_x,
      .force_y = motion.force_y,
      .start = {},
      .centred = {},
      .progress = motion.progress,
      .tolerance = motion.tolerance};
  if (input.force_x) *input.force_x *= side;
  if (motion.near_last) input.centred = centred_;
  // With forces prescribed the start needs more than tractions.
  const bool start_known = motion.start.x.size() == contact()->grid.count() && !input.force_x && !input.force_y;
  found.solution = rolling_->solve(found.capacity, input,
                                   start_known ? known_tractions(motion.start, side)
                                               : estimate_by_fastsim(material_, *contact(), found.capacity, input));
  return found;
}

ContactSolution PatchRolling::nothing(const PatchRollingMotion& motion) const {
  ContactSolution nothing;
  nothing.creepage = motion.creepage;
  nothing.report.status = normal_.status == Status::ok ? Status::no_contact : normal_.status;
  conclude(nothing, motion.tolerance);
  return nothing;
}

ContactSolution PatchRolling::solution_of(const Found& found, const PatchRollingMotion& motion) const {
  ContactSolution out = contact_solution(rolling_->contact(), found.solution,
                                         {.bound = rolling_->bound(found.capacity, found.variation),
                                          .normal_force = normal_.normal_force,
                                          .approach = normal_.approach,
                                          .rolling_speed = motion.rolling_speed,
                                          .direction = direction_});
  out.fields.gap = normal_.gap;
  if (normal_.status != Status::ok) out.report.status = normal_.status;
  conclude(out, motion.tolerance);
  return out;
}

ContactSolution PatchRolling::solve(const PatchRollingMotion& motion) {
  check(motion);
  if (!rolling_) return nothing(motion);
  Found found = find(motion);
  ContactSolution out = solution_of(found, motion);
  centred_ = std::move(found.solution.centred);
  return out;
}

FrequencyResponse PatchRolling::respond(const PatchRollingMotion& motion, std::span<const double> wavenumbers,
                                        ResponseTo causes) {
  constexpr double linear_tolerance = 1e-6;
  check(motion);
  if (grid_.my == 1) throw Error("responses: not of line contacts");
  if (!rolling_) return {.solution = nothing(motion)};
  PatchRollingMotion steady = motion;
  steady.progress = part(motion.progress, 0, 0.3);
  const Found found = find(steady);
  FrequencyResponse out{.solution = solution_of(found, motion)};
  if (out.solution.report.status != Status::ok) return out;
  const bool forward = direction_ == RollingDirection::forward;
  std::vector<double> gap = normal_.gap;
  for (std::size_t k = 0; k < gap.size(); ++k) gap[k] -= normal_.displacement[k];
  NormalSolution normal = normal_;
  if (!forward) normal.pressure = mirrored(grid_, normal_.pressure);
  try {
    PatchResponse response({.material = material_,
                            .grid = forward ? grid_ : mirrored(grid_),
                            .gap = forward ? gap : mirrored(grid_, gap),
                            .normal = &normal,
                            .capacity = found.capacity,
                            .variation = found.variation,
                            .rolling = &rolling_->finest(),
                            .solution = &found.solution,
                            .plans = plans_},
                           essential_part(motion.progress, 0.3, 0.4));
    out.normal_stiffness = response.normal_stiffness();
    const double each = 0.6 / static_cast<double>(wavenumbers.size());
    for (const double wavenumber : wavenumbers) {
      const double from = 0.4 + each * static_cast<double>(out.at.size());
      const ForceResponse along_x =
          response.at(wavenumber, causes, linear_tolerance, essential_part(motion.progress, from, from + each));
      out.at.push_back(forward ? along_x : mirrored_along(along_x));
    }
    out.products = response.products();
  } catch (const Stopped& stopped) {
    return {.solution = solution_without_result(Status::not_converged, stopped.what())};
  }
  return out;
}

} // namespace microslip
