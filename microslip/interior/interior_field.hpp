#pragma once

#include "microslip/contact/element_grid.hpp"
#include "microslip/elasticity/interior_influence.hpp"
#include "microslip/elasticity/viscoelastic.hpp"
#include "microslip/interior/layered_elements.hpp"
#include "microslip/numerics/parity_toeplitz.hpp"
#include "microslip/progress.hpp"

#include <array>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace microslip {

/// Tractions of the elements, **on body 1**, index j mx + i [Pa]; what is empty is zero.
struct SurfaceTractions {
  std::span<const double> px, py, pn;
};

/// A point of a body, `depth` >= 0 below its surface: z = depth in body 1, z = -depth in body 2 [m].
struct InteriorPoint {
  double x = 0, y = 0, depth = 0;
};

/// Displacements and stresses in a body from the tractions on its surface, as sums over the elements. Elastic
/// half-space, any combination of bodies; a line contact gives the plane field of endless strips, with displacements as
/// in line_interior_influence, `far` being the grid's length.
///
/// The sums are exact for tractions that are constant in each element, at every depth. Those of a contact are not:
/// nearer to the surface than about an element the steps between elements are felt. How much, and where less:
/// docs/theory-interior.md, section 6. Bilinear elements have no steps; their sums have the errors of
/// bilinear_interior_influence.
///
/// A body with layers is elastic, or viscoelastic in steady rolling; then all of its state is retarded. Its elements
/// are constant, its points not in a rigid core; on an interface they lie in the upper layer (layer_at).
///
/// For a half-space in steady rolling with a retarded part (Retardation), displacements are those of this part (I11).
/// Its stresses are the elastic ones: they depend on the tractions and on Poisson's ratio, which does not change with
/// time. Const calls may be made from several threads.
class InteriorField {
public:
  /// Copies the tractions. Throws Error for a material or grid out of range, and for tractions whose number is not that
  /// of the elements or which are not finite.
  InteriorField(const Material& material, Body body, const ElementGrid& grid, const SurfaceTractions& tractions,
                const Retardation& retardation = {});
  /// A body with layers, of which viscoelastic ones roll with `speed` [m/s], positive along +x. Throws Error likewise,
  /// and for bilinear elements.
  InteriorField(const LayeredBody& body, Body number, const ElementGrid& grid, const SurfaceTractions& tractions,
                double speed = 0);
  /// Replaces the tractions by others, copied. Throws Error as the constructor does.
  void set_tractions(const SurfaceTractions& tractions);

  /// Cost: 0.3 us for every element with tractions; bilinear ones 16 times that far away and as much as 2 ms each near
  /// the surface; with a retardation some 100 times as much; with layers 2 us for every element between the first and
  /// the last with tractions in a row, and some 5 ms for a new depth (viscoelastic ones ten times as much). Throws
  /// Error unless depth >= 0 and all is finite, and for a point in a rigid core.
  InteriorState at(const InteriorPoint& point, const Progress& progress = {}) const;
  /// States at many points, shared among OpenMP's threads. `progress` is called often; false throws Stopped.
  std::vector<InteriorState> at(std::span<const InteriorPoint> points, const Progress& progress = {}) const;

  /// Influence of an element at `count` offsets x_first, x_first + dx, ... from it: the instantaneous one, and of
  /// elastic layers.
  std::vector<InteriorInfluence> influence(double x_first, int count, double y, double depth,
                                           const Progress& progress = {}) const;
  /// What is retarded: displacements of a half-space, and no stresses; all of a body with viscoelastic layers.
  std::vector<InteriorInfluence> retarded_influence(double x_first, int count, double y, double depth) const;
  /// How many of the nine components of a state have a retarded part; displacements come first.
  int retarded_components() const;
  bool has_retardation() const { return retarded_components() > 0; }

  const ElementGrid& grid() const { return grid_; }
  /// Tractions and pressures of all elements, index j mx + i.
  const std::vector<double>& px() const { return px_; }
  const std::vector<double>& py() const { return py_; }
  const std::vector<double>& pn() const { return pn_; }

private:
  struct LoadedElement {
    int i, j; ///< column and row
    double px, py, pn;
  };
  /// Adjoining elements of loaded_ that lie in one row.
  struct LoadedRow {
    std::size_t begin, end;
  };

  InteriorInfluence half_space_influence(double x, double y, double depth) const;
  void add_rows(const InteriorPoint& point, const Progress& progress, InteriorState& sum) const;

  std::shared_ptr<const LayeredElements> layers_; ///< none: a half-space
  Material material_;
  Retardation delay_;
  Body body_;
  ElementGrid grid_;
  std::vector<double> px_, py_, pn_;
  std::vector<LoadedElement> loaded_;
  std::vector<LoadedRow> loaded_rows_;
  InteriorInfluence
      retarded_far_away_; ///< of a line contact: subtracted from retarded displacements along the tractions
};

/// States at the centres of elements in planes of constant depth, by fast transforms. It agrees with the sum to about
/// 1e-15 of the plane's largest values.
///
/// Cost for a plane of N points: N influences and 9 transforms of kernels for each of px, py, pn that is not zero, on a
/// quarter of a grid padded to 4N, and 9 transforms back; a few rows of the plane cost a fifth of the latter. Kernels
/// depend on the depth only and are kept, up to 256 MB, for other tractions. With a retardation 120 more influences for
/// each point. Memory: some 900 bytes for a point, 1600 with a retardation, besides the kernels that are kept, 300
/// bytes for a point of each depth.
class InteriorLayers {
public:
  /// Points at the elements' centres and, beyond the grid, `margin` more columns and rows on each side (rows not for a
  /// line contact).
  /// Throws Error for a plane that needs more memory than the machine has. `progress` is called often; false throws
  /// Stopped.
  explicit InteriorLayers(InteriorField field, int margin = 0, const Progress& progress = {});
  /// Replaces the tractions of the field. Throws Error as InteriorField does; where it is Stopped tractions
  /// must be set once more.
  void set_tractions(const SurfaceTractions& tractions, const Progress& progress = {});

  /// Positions of the points.
  const ElementGrid& grid() const { return grid_; }
  const InteriorField& field() const { return field_; }

  /// States at the points, index j mx + i. Throws Error unless depth >= 0 and finite, and Stopped where `progress`
  /// returns false.
  std::vector<InteriorState> at_depth(double depth, const Progress& progress = {});
  /// States at the points of some columns, i, and rows, j, of the grid only: row by row.
  std::vector<InteriorState> at_depth(double depth, std::span<const int> columns, std::span<const int> rows,
                                      const Progress& progress = {});

private:
  /// Influences at a depth: of offsets x, y >= 0, and retarded ones of all x and y >= 0.
  struct Influences {
    std::vector<InteriorInfluence> quadrant, retarded;
  };
  /// Kernels of each component, each followed by that of its retarded part.
  using LoadKernels = std::vector<ParityToeplitz::Spectrum>;
  using Kernels = std::array<LoadKernels, 3>; ///< of px, py, pn; empty ones have not been needed

  void load(const Progress& progress);
  Influences influences(double depth, const Progress& progress) const;
  LoadKernels find_kernels(int load, const Influences& influences, const Progress& progress);
  const Kernels& kernels(double depth, const Progress& progress);
  void limit_memory(double depth);

  InteriorField field_;
  ElementGrid grid_;
  std::vector<int> loads_; ///< those of px, py, pn that are not zero
  ParityToeplitz transform_;
  std::map<double, Kernels> kept_; ///< by depth
};

} // namespace microslip
