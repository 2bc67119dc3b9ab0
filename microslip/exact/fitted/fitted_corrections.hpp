#pragma once

#include "microslip/exact/fitted/fitted_contact.hpp"
#include "microslip/exact/fitted/fitted_product.hpp"
#include "microslip/exact/fitted/grid_kernel.hpp"
#include "microslip/progress.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace microslip {

/// A fitted element as the corrections need it: lengths in units of dx, from the centre of the grid's first column.
struct LeadingElement {
  std::size_t element;
  int row;
  double left, right;
  int first_moment; ///< column of the first of the grid's elements that stand for it
  std::array<double, 3> moments;
  /// Points where its displacement is taken and where its slip ends.
  struct Point {
    std::size_t point;
    double x;
    int first_node; ///< column
    std::array<double, FittedProduct<double>::most_nodes> nodes;
  };
  std::array<Point, 2> points;
};

/// Finds the corrections of a FittedProduct: what elements do to points less what the transforms make of it, within a
/// few elements of points that are none of the grid's and of elements that are none of the grid's.
void find_corrections(double poisson_ratio, const FittedContact& contact, const GridKernel& kernel,
                      std::vector<LeadingElement> leading, FittedProduct<double>::Tables& tables,
                      const Progress& progress);

} // namespace microslip
