#pragma once

#include "microslip/contact/contact_solution.hpp"
#include "microslip/interior/interior_field.hpp"
#include "microslip/progress.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace microslip {

/// Points inside the bodies: all combinations of the coordinates [m]; z >= 0 lies in body 1, z < 0 in body 2. On the
/// interface of two layers they lie in the one nearer to the surface.
struct InteriorGrid {
  std::vector<double> x, y, z;

  std::size_t count() const { return x.size() * y.size() * z.size(); }
  double x_of(std::size_t point) const { return x[point % x.size()]; }
  double y_of(std::size_t point) const { return y[point / x.size() % y.size()]; }
  double z_of(std::size_t point) const { return z[point / x.size() / y.size()]; }
};

/// A body whose interior field is wanted: elastic, with a retarded part of its deformation, or with layers.
struct InteriorBody {
  InteriorBody(const Material& elastic) : material(elastic) {} // NOLINT(google-explicit-constructor)
  InteriorBody(const Material& instantaneous, const Retardation& retarded)
      : material(instantaneous), retardation(retarded) {}
  /// Of viscoelastic layers in steady rolling with `rolling_speed` [m/s].
  InteriorBody(const LayeredBody& body, double rolling_speed)
      : material(body.top().instantaneous), layered(body), speed(rolling_speed) {}

  Material material; ///< of the surface
  Retardation retardation = {};
  std::optional<LayeredBody> layered = {};
  double speed = 0;

  friend bool operator==(const InteriorBody&, const InteriorBody&) = default;
};

/// Displacements and stresses at the points of a grid, x fastest, then y, then z: by InteriorLayers where there are
/// several points below elements' centres, else by InteriorField. Errors as theirs.
///
/// Keeps what InteriorLayers keeps: where bodies and elements are those of the call before, depths that have occurred
/// cost transforms of the tractions only. `progress` is called between and within the planes; false throws Stopped.
class InteriorSequence {
public:
  std::vector<InteriorState> states(const InteriorBody& body1, const InteriorBody& body2, const ElementGrid& elements,
                                    const SurfaceTractions& tractions, const InteriorGrid& points,
                                    const Progress& progress = {});

private:
  struct OfBody {
    InteriorBody body;
    InteriorLayers layers;
  };
  InteriorLayers& layers_of(const InteriorBody& body, Body number, const ElementGrid& elements,
                            const SurfaceTractions& tractions, const Progress& progress);

  std::array<std::optional<OfBody>, 2> bodies_;
};

/// States at the points of a grid, for one set of tractions.
std::vector<InteriorState> interior_states(const InteriorBody& body1, const InteriorBody& body2,
                                           const ElementGrid& elements, const SurfaceTractions& tractions,
                                           const InteriorGrid& points, const Progress& progress = {});

/// States of a solution with pressures: of the exact theory, whatever solved it, or of a wheel on a rail at either
/// level. An element that is fitted to the edge counts as one of the grid's with the same forces, and the forces of
/// rows that are divided along their lengths are distributed over the grid's elements; both matter less than an
/// element deep only. Throws Error for a solution without pressures (FASTSIM's and FASTSIM2's on ellipses) or with
/// numbers that are not finite.
std::vector<InteriorState> interior_states(const InteriorBody& body1, const InteriorBody& body2,
                                           const ContactSolution& solution, const InteriorGrid& points,
                                           const Progress& progress = {});

/// The largest value of a measure of stress among points, or the smallest of one that is a compression.
struct InteriorExtreme {
  std::string name;      ///< sigma_hyd, von_mises, tresca, sigma_1, sigma_3, sigma_xx, sigma_yy, sigma_zz
  double value = 0;      ///< [Pa], with its sign
  std::size_t point = 0; ///< where
};

/// The extremes of all measures: of sigma_hyd and sigma_xx, yy, zz the largest magnitude, of sigma_3 the smallest
/// value, else the largest; of equal ones the first. Empty without points.
std::vector<InteriorExtreme> interior_extremes(const std::vector<InteriorState>& states);

} // namespace microslip
