#pragma once

#include <gtest/gtest.h>

#include <string>

namespace microslip {

/// Two forces and the moment, of whatever has them.
struct PlaneForces {
  double fx, fy, mz;

  PlaneForces(double along, double across, double moment) : fx(along), fy(across), mz(moment) {}
  template <class Forces>
  requires requires(const Forces& f) {
    f.fx;
    f.fy;
    f.mz;
  }
  PlaneForces(const Forces& f) : fx(f.fx), fy(f.fy), mz(f.mz) {}
};

/// Forces to one tolerance, the moment to another.
inline void expect_forces(const PlaneForces& found, const PlaneForces& wanted, double force, double moment,
                          const std::string& what = "") {
  EXPECT_NEAR(found.fx, wanted.fx, force) << what;
  EXPECT_NEAR(found.fy, wanted.fy, force) << what;
  EXPECT_NEAR(found.mz, wanted.mz, moment) << what;
}
inline void expect_forces(const PlaneForces& found, const PlaneForces& wanted, double tolerance) {
  expect_forces(found, wanted, tolerance, tolerance);
}

/// The components of two places, forces or moments.
template <class Vector>
requires requires(const Vector& v) {
  v.x;
  v.y;
  v.z;
}
void expect_near(const Vector& found, const Vector& wanted, double tolerance) {
  EXPECT_NEAR(found.x, wanted.x, tolerance);
  EXPECT_NEAR(found.y, wanted.y, tolerance);
  EXPECT_NEAR(found.z, wanted.z, tolerance);
}

} // namespace microslip
