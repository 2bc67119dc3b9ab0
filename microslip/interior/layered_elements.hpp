#pragma once

#include "microslip/contact/element_grid.hpp"
#include "microslip/elasticity/interior_influence.hpp"
#include "microslip/elasticity/layered_body.hpp"

#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace microslip {

/// Influence of elements on the inside of a layered body. In the surface's layer it is that of a half-space of its
/// material in closed form and what layers add, deeper the whole, from the kernels of the depth, InteriorPointKernels
/// or InteriorLineKernels: integrated over elements by Gauss's rule, on cells smaller than 0.7 times the scale hypot(s,
/// r), s = 2 h - z in the surface's layer, else the depth. Errors some 1e-8 of the traction for stresses.
///
/// What is retarded in viscoelastic layers is a sum over the elements ahead, as the surface's (L6). In a viscoelastic
/// surface's layer s is the depth, at least a millionth of an element, above which it is taken for it.
///
/// Kernels are found once for each depth, some 5 ms, of viscoelastic layers 0.1 s, and kept. Calls may be made from
/// several threads.
class LayeredElements {
public:
  /// Steady rolling with `speed` [m/s], positive along +x, which viscoelastic bodies need. Throws Error for values out
  /// of range, and for bilinear elements.
  LayeredElements(const LayeredBody& body, Body number, const ElementGrid& grid, double speed);

  bool is_elastic() const { return body_.is_elastic(); }
  /// Influence of an element on `count` points x_first + i dx, y from it. On an interface they lie in the upper layer
  /// (layer_at). Throws Error for a depth in a rigid core.
  std::vector<InteriorInfluence> row(double x_first, int count, double y, double depth) const;

private:
  struct Kernels;
  /// For distances up to `reach`, which is rounded up: results do not depend on what was asked before.
  std::shared_ptr<const Kernels> kernels(double depth, double reach) const;
  std::vector<InteriorInfluence> rolled_row(double x_first, int count, double y, double depth) const;

  LayeredBody body_;
  Body number_;
  ElementGrid grid_;
  double speed_;
  std::vector<double> lengths_; ///< of memories, V T [m]
  mutable std::mutex guard_;
  mutable std::map<std::pair<double, int>, std::shared_ptr<const Kernels>> known_; ///< by depth and reach
};

} // namespace microslip
