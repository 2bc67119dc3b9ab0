#pragma once

#include "microslip/contact/contact_solution.hpp"
#include "microslip/contact/motion.hpp"
#include "microslip/elasticity/layered_body.hpp"
#include "microslip/exact/classical/contact_sequence.hpp"
#include "microslip/exact/fitted/patch_rolling.hpp"
#include "microslip/exact/halfspace/inclination_correction.hpp"
#include "microslip/progress.hpp"
#include "microslip/railway/geometry/patch_outline.hpp"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace microslip {

/// A force on the surface.
struct PointLoad {
  Vec3<double> place; ///< in track axes [m]
  double force = 0;   ///< normal [N]
  double angle = 0;   ///< of the surface against the track's y [rad]
};

/// A patch for the exact theory: elements over its contact, gaps, and how each row moves. Keeps the last pressures and
/// tractions to begin the next ones with.
class ExactPatch {
public:
  /// Motion of a patch.
  struct Motion {
    double contact_gap = 0; ///< < 0, that of the surface whose velocity the creepages take (PatchSurface::creepage) [m]
    double speed = 0;       ///< V [m/s]
    RollingDirection direction = RollingDirection::forward;
  };

  /// Surface on which it is solved.
  struct Shape {
    PatchShape surface = PatchShape::curved;
    double conformity = 0; ///< in [0, 1], WheelRailMethod::conformity
    bool rolls = true;     ///< else it has no elements to spare that only rolling needs
  };

  /// Elements of the sides `element` over all of the outline, which holds the contact; the frame's origin is the
  /// centre of one, so that elements do not move in the frame. Rows outside the profiles are far apart. `progress` may
  /// end this and all that follows, by Stopped only. Layered bodies take the place of the material's half-spaces but
  /// for what loads on other patches do; the shape then is not conformal.
  ExactPatch(const CombinedMaterial& material, const std::optional<LayeredBodies>& layered, const PatchSurface& surface,
             const PatchOutline& outline, const Shape& shape, Vec2 element, const Motion& motion, Progress progress);

  /// A row of an approximate pressure, which is a semi-ellipse along x.
  struct PressureRow {
    double s = 0;           ///< of the rail's profile from the frame's origin on [m]
    double centre = 0;      ///< x in the frame [m]
    double half_length = 0; ///< [m]
    double peak = 0;        ///< [Pa], >= 0
  };
  /// Pressures near the first ones to be found, of rows across the patch in their order: they take fewer iterations.
  void expect(std::span<const PressureRow> rows);

  const ElementGrid& grid() const { return grid_; }
  double conformity() const { return conformity_; }
  const PatchRow& row(int j) const { return rows_[static_cast<std::size_t>(j)]; }

  /// Loads on other patches from now on lift the rail's surface here.
  void apply_lift(std::span<const PointLoad> loads);
  /// Lift of the pressure's centre by a load elsewhere [m].
  double lift_by(const PointLoad& load) const;

  /// Normal problems: the wheel comes nearer by `approach` [m] along the frame's normal, or carries a normal force [N].
  void solve_normal(double approach, double tolerance);
  void press_with(double normal_force, double tolerance);
  /// A normal force [N] so near the last one that all pressures are multiplied.
  void scale_to(double normal_force);
  double normal_force() const { return pressed_.normal_force; }
  double approach() const { return pressed_.approach + least_; }
  double least_gap() const { return least_; }
  Status status() const { return pressed_.status; }
  /// Unsettled distance of a conformal patch, by which the last tractions would still move the surfaces that the
  /// pressures know of, over the largest displacement [-]; else 0.
  double unsettled() const { return unsettled_; }
  /// Returns whether the outline holds the contact, as the elements need it.
  bool holds_contact() const;
  /// Sides, in the frame, of a rectangle around the contact and where the gap is less than `near` [m], with an element
  /// to spare; nothing without contact.
  struct Extent {
    double x_low, x_high, s_low, s_high;
  };
  std::optional<Extent> extent(double near) const;
  /// The pressures as one load, that of none at the frame's origin; and as some loads over the patch.
  const PointLoad& load() const { return load_; }
  std::span<const PointLoad> loads() const { return loads_; }

  /// The tangential problem with the pressures that there are, to a tolerance of the residual. `friction` is mu over
  /// the inclination of a row [rad]. Elements stay if the load has changed by less than `same_elements` of itself since
  /// they were fitted. With layered bodies normal and tangential problem at once, with the normal force that there is,
  /// classically on the patch's own elements.
  ContactSolution roll(const std::function<double(double angle)>& friction, double same_elements, double tolerance);

  /// Responses (PatchResponse) with the normal force that there is, at wavenumbers [1/m]. What the rows' angles add to
  /// the displacements stays as it is. Throws Error with layered bodies.
  FrequencyResponse respond(const std::function<double(double angle)>& friction, std::span<const double> wavenumbers,
                            double tolerance);

private:
  Vec3<double> place(std::size_t element) const;
  using Fields = InclinationCorrection::Fields;

  void solve(const NormalLoad& load, double tolerance);
  void solve_plane(const NormalLoad& load, double tolerance);
  void correct_angles(const CombinedMaterial& material);
  Fields added_displacements();
  void keep_tractions(const ContactSolution& solution);
  Vec2 added_at(double x, double y) const;
  PatchRollingMotion motion_with(const std::function<double(double angle)>& friction, double tolerance) const;
  ContactSolution roll_plane(PatchRollingMotion motion);
  ContactSolution roll_on_layers(const std::function<double(double angle)>& friction, double tolerance);
  void find_loads();

  CombinedMaterial material_;
  Progress progress_;
  PatchFrame frame_;
  Motion motion_;
  ElementGrid grid_;
  std::vector<PatchRow> rows_;
  std::vector<Creepage> creepage_; ///< of each row about (0, s)
  double least_ = 0;               ///< the least gap, < 0 where the bodies overlap [m]
  std::vector<double> gaps_;       ///< over the least one [m]
  std::vector<double> lifted_;     ///< the same with the lift
  std::optional<LayeredBodies> layered_;
  std::shared_ptr<const InfluenceTable> table_; ///< of these
  NormalProblem normal_;
  std::vector<double> expected_; ///< pressures; empty: not known
  NormalSolution pressed_;
  PointLoad load_;
  std::vector<PointLoad> loads_;
  std::optional<PatchRolling> rolling_;
  ContactSequence sequence_; ///< of layered bodies
  double fitted_force_ = 0;  ///< with which its elements were fitted [N]
  VectorField tractions_;    ///< of the last solution, with the normal force rolled_force_ [N]
  double rolled_force_ = 0;
  double conformity_;                               ///< share of what the rows' angles add
  std::optional<InclinationCorrection> correction_; ///< of a conformal patch whose rows are turned
  Fields on_grid_;                                  ///< the tractions of the last solution at the grid's elements,
  Fields added_;                                    ///< and what the rows' angles add to their displacements
  std::vector<double> known_;                       ///< the normal part of that with which the pressures were found,
  std::vector<double> fitted_known_;                ///< and with which the elements were fitted
  double unsettled_ = 0;
};

} // namespace microslip
