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
  /// A patch's solver, and where the patch lay.
  struct Track {
    double y0 = 0, y1 = 0; ///< across the track [mm]
    std::shared_ptr<CaseSolver> solver;
    bool is_new = true;    ///< without a solution of this case
    bool taken = false;
  };

  std::shared_ptr<const ProfileCurve> profile(const ProfileRecord& record, ProfileRole role);
  Outcome solve(const Case& c, const Progress& progress);
  Outcome solve_at(const Case& right, WheelGeometry& geometry, double z, const Progress& progress);
  Outcome find_height(const Case& right, WheelGeometry& geometry, const Progress& progress);
  WheelPatch solve_patch(const Case& right, const PatchFrame& frame, const WheelGeometry& geometry, double z,
                         Track& track, const Progress& progress);
  void finish(const Case& c, WheelOutcome& wheel, const Progress& progress);
  void follow(const std::vector<PatchFrame>& frames);

  std::vector<std::pair<ProfileRecord, std::shared_ptr<const ProfileCurve>>> profiles_;
  std::vector<Track> tracks_;          ///< of the patches of the case before, or of the step before in this case
  WheelEffort effort_;
  int lost_ = 0;                       ///< number of the case that could not be run after the last one that was solved
  bool is_first_ = true;               ///< of the solutions for this case
};

} // namespace microslip::contact_program
