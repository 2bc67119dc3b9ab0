#pragma once

#include "compat/contact/case_solver.hpp"
#include "compat/contact/wheel_rail/wheel_geometry.hpp"

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace microslip::contact_program {

/// Solves the cases of one wheel, of module 1, each with what the ones before it have left: patches go on from those of
/// the case before that lie where they do.
class WheelRailSolver {
public:
  /// `progress` as Run's.
  Outcome run(const Case& c, const Progress& progress = {});

private:
  /// A patch that is followed from case to case.
  struct Track {
    double y0 = 0, y1 = 0; ///< its extent across the track [mm]
    std::shared_ptr<CaseSolver> solver;
    bool is_new = true; ///< without a solution of this case
    bool taken = false;
    /// Of the case before: its origin of elements, where the reference lay along the rail, from the wheelset and along
    /// the profile, the elements' sides, and those in contact.
    GridOrigin origin = GridOrigin::reference;
    double place = 0, x = 0, s_rail = 0, dx = 0, ds = 0;
    std::optional<PatchBox> contact = {};
  };

  ProfileShape profile(const ProfileRecord& record, ProfileRole role);
  Outcome solve(const Case& c, const Progress& progress);
  Outcome solve_placed(const Case& right, const RailDeflection& deflection, const Progress& progress);
  Outcome find_deflection(const Case& right, const Progress& progress);
  Outcome find_pitch_velocity(const Case& right, const Progress& progress);
  Outcome solve_at(const Case& right, WheelGeometry& geometry, double z, const Progress& progress);
  Outcome find_height(const Case& right, WheelGeometry& geometry, const Progress& progress);
  WheelPatch solve_patch(const Case& right, const PatchFrame& frame, const WheelGeometry& geometry, double z,
                         Track& track, const Progress& progress);
  void remember(const WheelOutcome& wheel, const std::vector<PatchFrame>& frames, double place, GridOrigin origin);
  void move_origins(GridOrigin origin);
  void finish(const Case& c, WheelOutcome& wheel, const Progress& progress);
  void follow(const std::vector<PatchFrame>& frames);

  std::vector<std::pair<ProfileRecord, ProfileShape>> profiles_;
  std::vector<Track> tracks_; ///< of the patches of the case before, or of the step before in this case
  WheelEffort effort_;
  std::optional<double> last_z_;   ///< Z_WS of the case before
  std::vector<PatchFrame> frames_; ///< of the last solution
  int lost_ = 0;                   ///< number of the case that could not be run after the last one that was solved
};

} // namespace microslip::contact_program
