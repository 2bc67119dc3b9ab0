#pragma once

#include "microslip/railway/geometry/contact_search.hpp"
#include "microslip/railway/geometry/patch_surface.hpp"
#include "microslip/railway/problem/wheel_rail_types.hpp"
#include "microslip/simplified/loaded_rows.hpp"
#include "validation/models/normal_models.hpp"

#include <vector>

namespace microslip::validation {

/// A patch of a pressed wheel by a model.
struct PressedPatch {
  NormalPatch normal;
  double angle = 0;       ///< of the plane at the point of contact [rad]
  Creepage creepage = {}; ///< in that plane, at the point
  double fx = 0, fs = 0;  ///< on the wheel, along x and along the plane [N]
  double power = 0;       ///< T-gamma, -(xi fx + eta fs + phi mz) [N]
};

struct PressedWheel {
  double lowering = 0;    ///< below the first touch [m]
  bool bears_load = true; ///< else no height bears it: forces jump there
  std::vector<PressedPatch> patches;
  int presses = 0; ///< of patches, until the height was found

  Vec3<double> force() const; ///< on the wheel, in track axes [N]
};

/// A left wheel on its rail as a vehicle program has it: points of contact, at each the gap in the plane that both
/// surfaces share there, a model of the normal problem, and FASTSIM2 on the model's patch.
class ModelledWheel {
public:
  /// The bodies must outlive it.
  explicit ModelledWheel(const WheelRailBodies& bodies);

  /// Finds the points of contact and the gaps about them; what its height is does not matter.
  void place(const WheelState<double>& state);
  /// The wheel at the height at which it bears the load [N]. A point is pressed by how much the wheel is lowered
  /// beyond its own first touch, along its normal. Points in the rows of the patch of a deeper one belong to that.
  PressedWheel press(const NormalModel& model, double vertical_force, double friction);
  /// Height of the wheelset's centre at which the wheel first touches [m].
  double touching() const { return state_.vertical; }

private:
  struct Point {
    PatchFrame frame;
    double wheel_s = 0, clearance = 0; ///< [m]; vertical, above the first touch
    PatchGap gap;
  };

  PatchGap gap_about(const ContactPoint& point, const PatchFrame& frame, const PatchSurface& surface) const;
  PressedWheel lowered(const NormalModel& model, double lowering, double friction);
  void roll(PressedPatch& patch, const Point& point, double approach, double lowering, double friction);

  const WheelRailBodies& bodies_;
  NominalPlacement nominal_;
  ContactSearch search_;
  WheelState<double> state_; ///< at its first touch
  std::vector<Point> points_;
  LoadedRowSolver fastsim2_;
};

/// Rows of a patch for FASTSIM2, at most as many as `ModelledWheel` takes, in the plane of its point.
std::vector<LoadedRow> loaded_rows(const NormalPatch& patch, const Creepage& at_point, double friction);

} // namespace microslip::validation
