#include "microslip/railway/exact/contact_groups.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>

namespace microslip {

RowSums RowSums::of(const ContactPatch& patch) {
  RowSums sum;
  for (const LoadedRow& row : patch.loaded)
    sum.load += row.load, sum.squares += row.load * row.load / row.width, sum.lengths += row.load * row.half_length;
  sum.least_gap = patch.least_gap;
  sum.weight = patch.outline.weight, sum.speed = sum.weight * patch.speed;
  return sum;
}

void RowSums::add(const RowSums& other, double share) {
  load += share * other.load, squares += share * other.squares, lengths += share * other.lengths;
  least_gap = std::min(least_gap, least_gap + share * (other.least_gap - least_gap));
  speed += share * other.speed, weight += share * other.weight;
}

Vec2 RowSums::extent() const {
  if (!(load > 0)) return {};
  return {2 * lengths / load * 32 / (9 * std::numbers::pi), load * load / squares * 6 / 5};
}

bool ContactGroup::covers_overlap() const {
  const PatchOutline& overlap = group.outline;
  return covered.x_low == overlap.x_low && covered.x_high == overlap.x_high && covered.s_low == overlap.s_low &&
         covered.s_high == overlap.s_high;
}

std::optional<ContactExtent> ContactGroup::extent(double depth) const {
  constexpr double near = 0.03; // of the overlap
  const auto touches = exact.extent(near * depth);
  if (!touches) return {};
  const PatchFrame& frame = group.outline.frame;
  return ContactExtent{frame.origin.x + touches->x_low, frame.origin.x + touches->x_high, frame.rail_s + touches->s_low,
                       frame.rail_s + touches->s_high};
}

double greatest_overlap(std::span<const ContactGroup> groups) {
  double depth = 0;
  for (const ContactGroup& one : groups) depth = std::max(depth, -one.exact.least_gap());
  return depth;
}

namespace {

/// Elements of the fast theory's contact; where that is small within the overlap they are not smaller than a third of
/// those across the overlap.
Vec2 element_of(const RowSums& rows, const PatchOutline& outline, int elements) {
  const Vec2 extent = rows.extent();
  return {std::max(extent.x, (outline.x_high - outline.x_low) / 3) / elements,
          std::max(extent.y, (outline.s_high - outline.s_low) / 3) / elements};
}

/// An outline limited to what is in these extents, all of it if nothing is.
PatchOutline limited_to(const PatchOutline& whole, std::span<const ContactExtent> extents) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const PatchFrame& frame = whole.frame;
  ContactExtent all{infinity, -infinity, infinity, -infinity}; // in the frame
  for (const ContactExtent& e : extents) {
    const double x_low = std::max(whole.x_low, e.x_low - frame.origin.x),
                 x_high = std::min(whole.x_high, e.x_high - frame.origin.x);
    const double s_low = std::max(whole.s_low, e.s_low - frame.rail_s),
                 s_high = std::min(whole.s_high, e.s_high - frame.rail_s);
    if (!(x_low < x_high && s_low < s_high)) continue;
    all.x_low = std::min(all.x_low, x_low), all.x_high = std::max(all.x_high, x_high);
    all.s_low = std::min(all.s_low, s_low), all.s_high = std::max(all.s_high, s_high);
  }
  if (!(all.x_low < all.x_high)) return whole;
  PatchOutline limited = whole;
  limited.x_low = all.x_low, limited.x_high = all.x_high, limited.s_low = all.s_low, limited.s_high = all.s_high;
  return limited;
}

/// The rows of the fast theory as loads.
void add_rows(const ContactPatch& patch, std::vector<PointLoad>& loads) {
  for (std::size_t j = 0; j < patch.loaded.size(); ++j) {
    const LoadedRow& row = patch.loaded[j];
    if (row.load > 0)
      loads.push_back({patch.rows[j].at.point + Vec3<double>{row.centre, 0, 0}, row.load, patch.rows[j].at.angle});
  }
}

/// The rows of the fast theory as pressures.
void add_pressures(const ContactPatch& patch, const PatchFrame& frame, std::vector<ExactPatch::PressureRow>& rows) {
  for (std::size_t j = 0; j < patch.loaded.size(); ++j) {
    const LoadedRow& row = patch.loaded[j];
    const PatchRow& at = patch.rows[j].at;
    ExactPatch::PressureRow pressure{at.rail_s - frame.rail_s, at.point.x + row.centre - frame.origin.x,
                                     row.half_length, 0};
    if (row.load > 0) pressure.peak = 2 * row.load / (std::numbers::pi * row.half_length * row.width);
    rows.push_back(pressure);
  }
}

} // namespace

std::vector<ContactGroup> contact_groups(RowContact& coarse, const WheelRailBodies& bodies,
                                         const WheelRailMethod& method, std::span<const ContactExtent> extents,
                                         Purpose purpose, const Progress& progress) {
  const std::span<const ContactPatch> patches = coarse.patches();
  std::vector<PatchOutline> outlines;
  double depth = 0;
  for (const ContactPatch& patch : patches) {
    outlines.push_back(patch.outline);
    depth = std::max(depth, -patch.least_gap);
  }
  const PatchSurface surface = coarse.surface();
  const RollingDirection direction = coarse.rolls_forward() ? RollingDirection::forward : RollingDirection::backward;
  std::vector<ContactGroup> groups;
  for (PatchGroup& group :
       group_patches(surface.placement(), bodies.rail, bodies.wheel, outlines, method.surface(), depth)) {
    double force = 0, vertical = 0;
    std::vector<PointLoad> loads;
    std::vector<ExactPatch::PressureRow> pressures;
    std::optional<RowSums> rows; // of its patches first
    for (const bool own : {true, false})
      for (std::size_t k = 0; k < patches.size(); ++k) {
        if ((group.shares[k] == 1) != own) continue;
        const RowSums sums = RowSums::of(patches[k]);
        if (!rows)
          rows = sums;
        else
          rows->add(sums, group.shares[k]);
        if (!own || !(sums.load > 0)) continue;
        force += sums.load, vertical += sums.load * patches[k].vertical_share;
        add_rows(patches[k], loads);
        add_pressures(patches[k], group.outline.frame, pressures);
      }
    const Vec2 element = element_of(*rows, group.outline, method.elements);
    if (!(element.x > 0 && element.y > 0 && std::isfinite(element.x + element.y))) continue; // the fast theory failed
    const ExactPatch::Motion motion{rows->least_gap, rows->speed / rows->weight, direction};
    const PatchOutline covered = limited_to(group.outline, extents);
    const ExactPatch::Shape shape{method.surface(), method.conformity(group.outline.turn), purpose == Purpose::forces};
    ExactPatch exact(bodies.material, bodies.layered, surface, covered, shape, element, motion, progress);
    exact.expect(pressures);
    double share = std::cos(group.outline.frame.angle);
    if (force > 0) share = vertical / force;
    // Rows of the fast theory have separate planes.
    if (force > 0 && method.surface() == PatchShape::flat)
      for (const PointLoad& row : loads)
        share += row.force / force * (std::cos(group.outline.frame.angle) - std::cos(row.angle));
    groups.push_back({std::move(group), *rows, std::move(loads), covered, std::move(exact), force, share});
  }
  return groups;
}

} // namespace microslip
