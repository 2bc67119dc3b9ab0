#pragma once

#include "microslip/numerics/symmetric_toeplitz.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace microslip {

/// The product that FittedOperator makes, in double or in single precision: from what it found, slip from tractions.
template <class Real> class FittedProduct {
public:
  static constexpr int most_nodes = 6;
  static constexpr std::size_t lanes = 4; ///< numbers that are corrected together

  /// An element of the grid: its index in the transforms' field.
  struct GridElement {
    std::uint32_t element, cell;
  };
  /// A fitted element as `weight` times the grid's.
  struct Moments {
    std::size_t element, first_cell;
    std::array<Real, 3> weight;
  };
  /// Displacement at a point from those at the grid's points.
  struct Stencil {
    std::size_t point, first_cell;
    std::array<Real, most_nodes> weight;
  };
  /// `count` elements that follow one another, from `element` on, and a point; or an element and points. A multiple of
  /// `lanes`: what would be too many have the weight zero.
  struct Run {
    std::size_t point, element, count;
  };
  /// Influence of elements on points minus that of the transforms, run after run.
  struct Corrections {
    std::vector<Run> runs;
    std::vector<Real> xx, xy, yy;

    void clear() {
      runs.clear();
      for (auto* weights : {&xx, &xy, &yy}) weights->clear();
    }
  };
  /// Lengths are in units of the grid's dx, displacements by unit tractions in units of dx/G: nothing depends on size
  /// or stiffness. Points are those of the elements and then the ends of slip that are none of these.
  struct Tables {
    std::vector<GridElement> grid_elements;
    std::vector<Moments> moments;
    std::vector<Stencil> stencils; ///< of the points that are none of the grid's
    int nodes = most_nodes;        ///< of a stencil
    Corrections at_points;         ///< at points that are none of the grid's, of elements
    Corrections of_elements;       ///< of fitted elements, at the grid's points
    std::size_t points = 0;
    std::vector<std::size_t> end_point; ///< of each element
    std::vector<Real> slip_distance;    ///< from each element's point to the end of its slip

    /// Nothing, in the memory that there is.
    void clear() {
      grid_elements.clear(), moments.clear(), stencils.clear(), end_point.clear(), slip_distance.clear();
      at_points.clear(), of_elements.clear();
    }
  };

  /// `compliance`: 1/G [1/Pa].
  FittedProduct(Tables tables, SymmetricToeplitz<Real> transform, double compliance);
  /// `factor` times another product.
  FittedProduct(const FittedProduct<double>& other, double factor, const TransformPlans& plans = {});

  /// Takes the parts out, to make another one in their memory.
  std::pair<Tables, SymmetricToeplitz<Real>> take_apart() { return {std::move(tables_), std::move(transform_)}; }

  void set_compliance(double compliance) { compliance_ = compliance; }

  /// s = D p; one number for each element.
  void apply(std::span<const Real> px, std::span<const Real> py, std::span<Real> sx, std::span<Real> sy);

  /// The displacement difference [dx/G] at the points for the tractions of the last apply.
  std::span<const Real> ux() const { return std::span(ux_).first(tables_.points); }
  std::span<const Real> uy() const { return std::span(uy_).first(tables_.points); }
  /// The displacement difference at the elements' points over the distance from there to the end of their slip, for the
  /// tractions of the last apply.
  void find_displacement_over_way(std::span<Real> ux, std::span<Real> uy) const;
  /// The point where the slip of each element ends.
  std::span<const std::size_t> end_points() const { return tables_.end_point; }
  long products() const { return transform_.products(); }

private:
  template <class> friend class FittedProduct;
  void load(std::span<const Real> px, std::span<const Real> py);
  void read();
  void correct_points();
  void correct_for_elements();

  Tables tables_;
  SymmetricToeplitz<Real> transform_;
  double compliance_;
  std::vector<Real> px_, py_, ux_, uy_; ///< with `lanes` spare numbers
};

} // namespace microslip
