#pragma once

#include "compat/contact/carried_tractions.hpp"
#include "compat/contact/wheel_rail/wheel_geometry.hpp"

#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace microslip::contact_program {

/// Solves the cases of one wheel, of module 1, each with what the ones before it have left: patches go on from those of
/// the case before that lie where they do, each from all that overlap it across the track. Of a patch that has split
/// the new ones take the elements on their side of the line midway between them, so that no tractions are lost or
/// doubled.
class WheelRailSolver {
public:
  /// `progress` as Run's.
  Outcome run(const Case& c, const Progress& progress = {});

  /// State from which a patch of the last case, from 0, began, in shifts and transient rolling.
  CarriedTractions started_from(std::size_t patch) const;

  /// A profile as it is used; files are read once. Throws Error as read_profile_shape does.
  ProfileShape profile(const ProfileRecord& record, ProfileRole role);

private:
  /// Part that a patch takes over of one of the case before: the elements between two lines of s [m].
  struct Part {
    std::size_t origin = 0; ///< which patch
    double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();

    friend bool operator==(const Part&, const Part&) = default;
  };

  /// A row of elements: where it lies across the track [m], and its normal force [N].
  struct RowLoad {
    double y = 0, load = 0;
  };

  /// A patch that is followed from case to case.
  struct TrackedPatch {
    double y0 = 0, y1 = 0; ///< its extent across the track [m]
    std::shared_ptr<CaseSolver> solver;
    bool is_new = true;   ///< without a solution of this case
    bool carries = false; ///< whether its solver was given `parts` in this case
    bool taken = false;
    std::vector<Part> parts = {};
    std::optional<Vec3<double>> force_before = {}; ///< what the patches that it goes on from bore [N]
    /// Data of a case before: origin of elements, where the reference lay along the rail, from the wheelset and along
    /// the profile, the elements' sides, those in contact, and what it has left.
    GridOrigin origin = GridOrigin::reference;
    double place = 0, x = 0, s_rail = 0, dx = 0, ds = 0;
    std::optional<PatchBox> contact = {};
    CarriedTractions carried = {};
    Vec3<double> force = {}; ///< what it carried, in its axes [N],
    std::vector<RowLoad> rows = {};
  };

  Outcome solve(const Case& c, const Progress& progress);
  WheelGeometry geometry_over(const Case& right, const RailDeflection& deflection);
  Outcome solve_placed(const Case& right, const RailDeflection& deflection, const Progress& progress);
  Outcome find_deflection(const Case& right, const Progress& progress);
  Outcome find_settlement(const Case& right, double dy, std::optional<double>& depth, const Progress& progress);
  Outcome find_pitch_velocity(const Case& right, const Progress& progress);
  Outcome solve_at(const Case& right, WheelGeometry& geometry, double z, const Progress& progress);
  Outcome find_height(const Case& right, WheelGeometry& geometry, const Progress& progress);
  WheelPatch solve_patch(const Case& right, const PatchFrame& frame, const WheelGeometry& geometry, double z,
                         TrackedPatch& track, const Progress& progress);
  void remember(const WheelOutcome& wheel, const std::vector<PatchFrame>& frames, double place, GridOrigin origin);
  void move_origins(GridOrigin origin);
  void finish(const Case& c, WheelOutcome& wheel, const Progress& progress);
  std::vector<std::vector<Part>> parts_of(const std::vector<PatchFrame>& frames, bool has_history) const;
  TrackedPatch begin_track(const std::vector<Part>& parts, bool has_history) const;
  std::optional<Vec3<double>> force_before(const std::vector<PatchFrame>& frames, std::size_t k,
                                           Continuation from) const;
  void follow(const std::vector<PatchFrame>& frames, const Digits& digits);
  std::vector<std::string> reach_back(std::vector<PatchFrame>& frames, const Case& right) const;

  std::vector<std::pair<ProfileRecord, ProfileShape>> profiles_;
  RailPlacer rail_placer_;
  std::vector<TrackedPatch> origins_; ///< of the patches of the case before
  std::vector<TrackedPatch> tracks_;  ///< of those of the last solution
  WheelEffort effort_;
  std::optional<double> last_z_;   ///< Z_WS of the case before
  bool is_left_ = false;           ///< whether the last case was that of a left wheel
  std::vector<PatchFrame> frames_; ///< of the last solution
  int lost_ = 0;                   ///< number of the case that could not be run after the last one that was solved
};

} // namespace microslip::contact_program
