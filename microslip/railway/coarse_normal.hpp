#pragma once

#include "microslip/contact/element_grid.hpp"
#include "microslip/elasticity/material.hpp"
#include "microslip/railway/frame.hpp"
#include "microslip/status.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace microslip {

/// A patch between wheel and rail, discretised: elements in its own plane.
struct CoarsePatch {
  ElementGrid grid;               ///< x and s of the patch's frame
  Vec3<double> origin;            ///< of the frame, in track axes [m]
  double angle = 0;               ///< of s against the track's y [rad]
  std::span<const double> gaps;   ///< h [m] of the elements, negative where the undeformed bodies overlap
  std::span<const double> angles; ///< of each row's own plane against the track's y [rad]
  std::span<const double> shear; ///< of each row the force along s over the normal one [-]: it bears some of the weight
};

/// The normal problem of all patches of a wheel in one: p >= 0, e = h - zeta cos(angle) + A p >= 0, p e = 0, with zeta
/// [m] by how much the wheel is lowered further, given or such that the vertical force is given: sum of p dA
/// (cos(angle) + shear sin(angle)) = F. A dense system for few elements, by active sets and Cholesky's method. Within a
/// patch A is that of rectangles on a half-space (E7); elements of other patches act as point forces, pi G u = (1 - nu)
/// F cos(angle - angle')/r, so that neighbours influence each other smoothly, whatever their distance.
///
/// All memory is taken in the constructor; solve() allocates nothing. Cost some n^3/6 operations for each of 2 to 6
/// active sets, n the number of elements in contact.
class CoarseNormal {
public:
  explicit CoarseNormal(std::size_t most_elements);

  struct Result {
    double lowering = 0;  ///< zeta [m]
    double stiffness = 0; ///< change of the vertical force with zeta [N/m]
    Status status = Status::ok;
    int sets = 0; ///< active sets tried
  };
  /// `vertical_force` [N]; without it the wheel stays where it is, zeta = 0. Starts from the elements that overlap
  /// most, or from those of the last solve if `warm` and there are as many elements. Not converging is a status.
  Result solve(const CombinedMaterial& material, std::span<const CoarsePatch> patches,
               std::optional<double> vertical_force, bool warm) noexcept;

  /// p_n [Pa] of the elements of all patches one after another, of the last solve.
  std::span<const double> pressure() const { return {pressure_.data(), elements_}; }

private:
  void set_up(const CombinedMaterial& material, std::span<const CoarsePatch> patches);
  void find_within(const CombinedMaterial& material, const ElementGrid& grid, std::size_t first);
  void find_between(const CombinedMaterial& material, const CoarsePatch& one, std::size_t first,
                    const CoarsePatch& other, std::size_t other_first);
  bool touches() const;
  void start();
  void solve_active();

  std::size_t most_, elements_ = 0;
  std::vector<double> matrix_;          ///< A [m/Pa], most_ to a row
  std::vector<double> factor_;          ///< Cholesky's factor on the active elements
  std::vector<double> corner_, offset_; ///< of the kernel's table
  // The unknowns are p sqrt(dA), and rows are multiplied by sqrt(dA), so that A is symmetric between patches, too.
  std::vector<double> gap_, slope_, weight_, root_area_; ///< h, cos(angle), the vertical force of p dA = 1, and 1
  std::vector<double> pressure_, per_lowering_, deformed_, column_;
  std::vector<std::size_t> active_; ///< indices of the elements in contact, ascending
  std::vector<char> in_contact_;
};

} // namespace microslip
