#pragma once

#include "microslip/contact/element_grid.hpp"
#include "microslip/contact/normal_load.hpp"
#include "microslip/exact/halfspace/surface_operator.hpp"
#include "microslip/progress.hpp"
#include "microslip/status.hpp"

#include <memory>
#include <span>
#include <vector>

namespace microslip {

/// Sides of the grid.
struct BorderSides {
  bool low_x = false, high_x = false, low_y = false, high_y = false;

  bool any() const { return low_x || high_x || low_y || high_y; }
};

/// Throws Error unless there is a finite gap for each element and the load is in range.
void check(const ElementGrid& grid, std::span<const double> gap, const NormalLoad& load);

/// The contact area and the pressure on it.
struct NormalSolution {
  std::vector<double> pressure;     ///< p_n [Pa], >= 0
  std::vector<double> displacement; ///< u_n = A_zz p_n [m]
  std::vector<double> gap;          ///< deformed, e = h - delta + u_n [m]; zero in contact up to the residual
  double approach = 0;              ///< delta [m]
  double normal_force = 0;          ///< [N]
  double elastic_energy = 0;        ///< of the normal pressure, sum of p_n u_n dx dy/2 [J]
  double peak_pressure = 0;         ///< of the elements [Pa]
  int contact_elements = 0;
  bool touches_border = false; ///< contact reaches the rim of the grid: the potential contact is too small
  BorderSides border;          ///< where it does
  double residual = 0;         ///< largest |e| in contact and largest -e outside, over the largest displacement
  int iterations = 0;
  long products = 0; ///< with A_zz and with its near inverse; those on coarser grids by their share of the elements
  Status status = Status::ok;
};

/// The normal contact problem on a grid of elements (R2), (R4), (R5), (E1), (E13): p_n >= 0, e = h - delta + u_n >= 0,
/// p_n e = 0. For elastically similar bodies. Conjugate gradients with an active set (after Polonsky & Keer
/// 1999), one product with A_zz per iteration and one with its circulant inverse as preconditioner (after Vollebregt
/// 2014), started from the solution on elements twice as large. Hertzian contacts take 17 to 39
/// products to 1e-8, whatever the number N of elements. Cost O(N log N), memory O(N).
class NormalProblem {
public:
  /// Throws Error for a grid without elements, or one that needs more memory than the machine has, and Stopped if
  /// `progress` returns false.
  NormalProblem(const CombinedMaterial& material, const ElementGrid& grid, const Progress& progress = {},
                const TransformPlans& plans = {});
  /// With the influence numbers of a table, the part that is even along x and y; it does not start from coarser
  /// elements.
  NormalProblem(const InfluenceTable& table, const ElementGrid& grid);

  /// `gap` is the undeformed distance h [m] at the elements' centres. Throws Error for a gap with NaN, a load or a
  /// tolerance out of range. Input so large that the result overflows gives Status::invalid_input. `progress` is called
  /// in the iterations on all grids; false ends them, with status not_converged.
  NormalSolution solve(std::span<const double> gap, const NormalLoad& load, double tolerance = 1e-8,
                       const Progress& progress = {});
  /// Solves from a pressure near the solution, of which the shape counts, instead of from coarser elements: that of a
  /// load which differs by a hundredth takes some half of the iterations.
  NormalSolution solve_from(std::vector<double> pressure, std::span<const double> gap, const NormalLoad& load,
                            double tolerance = 1e-8, const Progress& progress = {});

private:
  NormalSolution solve_nested(std::span<const double> gap, const NormalLoad& load, double tolerance,
                              const Progress& progress, double& coarser_products);

  ElementGrid grid_;
  NormalOperator operator_;
  std::unique_ptr<NormalProblem> coarser_; ///< null for few elements
};

} // namespace microslip
