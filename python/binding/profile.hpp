#pragma once

#include "binding/fields.hpp"
#include "microslip/railway/profile_preparation.hpp"

#include <memory>

namespace microslip::python {

template <>
inline constexpr auto fields<ProfilePoint> = std::tuple{Field{"y", &ProfilePoint::y}, Field{"z", &ProfilePoint::z}};

/// Python's Profile: a profile and its report, shared by copies since neither changes.
struct ProfileValue {
  std::shared_ptr<const PreparedProfile> prepared;

  const Profile& profile() const { return prepared->profile; }
  const ProfileReport& report() const { return prepared->report; }
  bool operator==(const ProfileValue& other) const;
};

} // namespace microslip::python
