#pragma once

#include "compat/contact/wheel_rail/patch_frame.hpp"

namespace microslip::contact_program {

/// The surface between wheel and rail on which a conformal patch lies: at a length s along the rail's profile, counted
/// as the elements' s, the middle between the rail's point there and the wheel's point as far from that opposite the
/// reference, with the mean of both surfaces' normals. `rail` in track coordinates.
class CurvedPatch {
public:
  CurvedPatch(const PatchFrame& frame, const Placement& placement, const ProfileCurve& rail);

  /// Chooses the rows: those whose middle lies within the overlap, as far as the surfaces do not part, and two more on
  /// either side.
  void choose_rows(PatchFrame& frame) const;
  /// Lays the rows that there are on the surface; what parts them from one another goes along it, too.
  void bend(PatchFrame& frame) const;

private:
  struct Middle {
    SurfaceRow row;
    bool faces = false; ///< whether the surfaces face one another
  };
  Middle middle(double s) const;

  const Placement& placement_;
  const ProfileCurve& rail_;
  Vec3<double> reference_;
  double s_origin_;         ///< of the elements' s along the rail
  double s_rail_, s_wheel_; ///< of the reference along the profiles
  double x_wheel_;          ///< in the wheel's axes
};

} // namespace microslip::contact_program
