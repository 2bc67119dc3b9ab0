#pragma once

#include "microslip/exact/fitted_contact.hpp"
#include "microslip/exact/surface_response.hpp"
#include "microslip/numerics/symmetric_toeplitz.hpp"

#include <array>
#include <cstdint>
#include <memory>

namespace microslip {

class QuarterKernel;

/// What the tractions of a fitted contact contribute to the slip in steady rolling along +x, D p = (u(centre) -
/// u(end))/(end - centre), with one number for each element. The regular grid's part goes by fast transforms: a fitted
/// element stands there as three of the grid's with its moments of orders 0 to 2, and u between the grid's points comes
/// from polynomials of degree 5. What that misses is corrected exactly within a few elements; beyond, it is below
/// 1e-4 of an element's own influence. Elastically similar bodies. Memory O(N), cost one transform there and back.
class FittedResponse : public SlipResponse {
public:
  FittedResponse(const CombinedMaterial& material, const FittedContact& contact);

  void apply(std::span<const double> px, std::span<const double> py, std::span<double> sx,
             std::span<double> sy) override;
  double diagonal() const override { return diagonal_; }
  long products() const override { return transform_->products(); }

  /// The displacement difference u at the elements' centres [m] for the tractions of the last apply.
  std::span<const double> ux() const { return {point_ux_.data(), elements_.size()}; }
  std::span<const double> uy() const { return {point_uy_.data(), elements_.size()}; }

private:
  static constexpr int most_nodes = 6;

  /// Value at a point from those at the grid's points.
  struct Stencil {
    std::size_t first_cell;
    std::array<double, most_nodes> weight;
  };
  /// A fitted element as `weight` times the grid's.
  struct Moments {
    std::size_t element;
    std::size_t first_cell;
    std::array<double, 3> weight;
  };
  /// `count` elements that follow one another, from `element` on, and a point; or an element and points.
  struct Run {
    std::size_t point, element, count;
  };
  /// What elements do to points less what the transforms make of it, run after run.
  struct Corrections {
    std::vector<Run> runs;
    std::vector<double> xx, xy, yy;
  };

  void place_points();
  void find_moments();
  void find_corrections(const CombinedMaterial& material, const QuarterKernel& kernel);
  std::vector<std::size_t> first_elements() const;
  void correct(std::span<const double> px, std::span<const double> py);

  ElementGrid grid_;
  std::vector<FittedElement> elements_;
  int nodes_ = most_nodes;
  /// Points are the elements' centres and then the ends of slip that are no centres.
  std::vector<double> point_x_;
  std::vector<int> point_row_;
  std::vector<std::size_t> point_cell_; ///< the grid's point, for points of the grid
  std::vector<std::size_t> stencil_of_; ///< the stencil, for others
  std::vector<std::size_t> end_point_;  ///< of each element
  std::vector<Stencil> stencils_;
  std::vector<Moments> moments_;
  Corrections at_points_;   ///< at points that are none of the grid's, of elements
  Corrections of_elements_; ///< of fitted elements, at the grid's points

  std::unique_ptr<SymmetricToeplitz> transform_;
  double diagonal_ = 0;
  std::vector<double> grid_px_, grid_py_, grid_ux_, grid_uy_, point_ux_, point_uy_;
};

} // namespace microslip
