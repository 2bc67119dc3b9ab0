#pragma once

#include "microslip/railway/exact/exact_patch.hpp"
#include "microslip/railway/exact/patch_group.hpp"
#include "microslip/railway/rows/row_contact.hpp"

#include <cmath>
#include <optional>
#include <span>
#include <vector>

namespace microslip {

/// Sums over the rows of patches at the fast theory, and what else differs from patch to patch.
struct RowSums {
  double load = 0;      ///< q
  double squares = 0;   ///< q^2 over the row's width
  double lengths = 0;   ///< q times the half-length
  double least_gap = 0; ///< [m]
  double speed = 0;     ///< V times the outline's weight
  double weight = 0;    ///< of the outline

  static RowSums of(const ContactPatch& patch);

  /// Adds another patch by its share. Its least gap counts where it is less.
  void add(const RowSums& other, double share);

  /// Lengths of the contact along x and s [m], which are those of the ellipse if it is one: loads of rows are parabolic
  /// across a Hertzian ellipse.
  Vec2 extent() const;
};

/// Extent of the region where wheel and rail touch, or nearly so.
struct ContactExtent {
  double x_low = 0, x_high = 0; ///< along the track [m]
  double s_low = 0, s_high = 0; ///< of the rail's profile [m]
};

/// A group of patches of the fast theory and its elements for the exact theory.
struct ContactGroup {
  PatchGroup group;
  RowSums rows;
  std::vector<PointLoad> start; ///< loads of the fast theory's rows
  PatchOutline covered;         ///< with elements
  ExactPatch exact;
  double force;                            ///< normal, with which it lifts the others [N]
  double share;                            ///< vertical force for each newton of it
  double pressed = 0;                      ///< the normal force that the others' lift leaves it [N]
  double stiffness = 0;                    ///< its change with the approach [N/m]
  std::optional<double> force_before = {}; ///< what it was in the last step
  double approach_before = 0;              ///< [m], likewise
  ContactSolution solution = {};

  double cosine() const { return std::cos(group.outline.frame.angle); }
  bool covers_overlap() const;
  /// Extent at the wheel's overlap `depth` [m]; nothing where it does not touch.
  std::optional<ContactExtent> extent(double depth) const;
};

/// What is to be found: how a state's load is shared, roughly, or its forces.
enum class Purpose { forecast, forces };

/// The groups of the patches that the fast theory has, with elements over what is given of the overlap, or over all of
/// it where that is nothing.
std::vector<ContactGroup> contact_groups(RowContact& coarse, const WheelRailBodies& bodies,
                                         const WheelRailMethod& method, std::span<const ContactExtent> extents,
                                         Purpose purpose, const Progress& progress);

/// The greatest overlap of the wheel [m].
double greatest_overlap(std::span<const ContactGroup> groups);

} // namespace microslip
