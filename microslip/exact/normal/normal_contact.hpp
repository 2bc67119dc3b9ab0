#pragma once

#include "microslip/exact/normal/normal_problem.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace microslip {

/// The undeformed distance h [m] of the bodies at a point [m].
using GapFunction = std::function<double(double x, double y)>;

/// A solved normal problem with the potential contact that it was solved on.
struct NormalContact {
  ElementGrid grid;
  std::vector<double> undeformed_gap; ///< h [m] at the elements' centres
  NormalSolution solution;
};

/// Solves the normal problem on a potential contact that is large enough: around the contact there is at least one free
/// element on every side. Where the contact reaches the border of `start`, the grid grows there by whole elements, a
/// quarter of its side at a time, while it has at most `most_elements` elements. With `most_elements` = 0 it stays as
/// it is. A row or a column of elements grows along itself only.
///
/// Throws Error if the contact still reaches the border, with the sides; if h is not finite somewhere on the grid, with
/// the position; for an approach given for a line contact that may grow, because that approach is relative to a
/// distance that grows with the grid; and as NormalProblem does.
NormalContact solve_normal_contact(const CombinedMaterial& material, const GapFunction& gap, const ElementGrid& start,
                                   const NormalLoad& load, std::size_t most_elements = 0, double tolerance = 1e-8);

} // namespace microslip
