#pragma once

#include "binding/fields.hpp"
#include "microslip/railway/profile/profile_preparation.hpp"
#include "microslip/railway/profile/profile_surface.hpp"

#include <memory>

namespace microslip::python {

template <> inline constexpr auto fields<ProfilePoint> = members<&ProfilePoint::y, &ProfilePoint::z>;

/// Python's Profile: a profile, its report, and its surface where it varies; shared by copies since none changes.
struct ProfileValue {
  std::shared_ptr<const PreparedProfile> prepared;
  std::shared_ptr<const ProfileSurface> surface = {}; ///< of one that varies

  const Profile& profile() const { return prepared->profile; }
  const ProfileReport& report() const { return prepared->report; }
  bool operator==(const ProfileValue& other) const;
};

} // namespace microslip::python
