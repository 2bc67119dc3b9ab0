// The frictional power of the classical discretisation: that by creepages where the bodies give all back, nearer to the
// limit than the sum over the fields.

#include "validation/frictional_power.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace microslip {
namespace {

using validation::disc_kinds;
using validation::DiscKind;
using validation::power_of_fields;
using validation::roll_discs;

TEST(FrictionalPower, OfElasticBodiesIsThatByCreepages) {
  for (const DiscKind& kind : disc_kinds()) {
    if (!kind.gives_all_back) continue;
    const ContactSolution s = roll_discs(kind, 14);
    EXPECT_EQ(s.report.status, Status::ok) << kind.name;
    EXPECT_NEAR(s.totals.frictional_power, s.totals.power_by_creepage, 1e-9 * s.totals.power_by_creepage) << kind.name;
  }
}

/// Both have the same limit 2 P(h/2) - P(h), as errors of first order have it.
TEST(FrictionalPower, IsNearerToTheLimitThanThatOfTheFields) {
  for (const DiscKind& kind : disc_kinds()) {
    const ContactSolution coarse = roll_discs(kind, 16), fine = roll_discs(kind, 32), finer = roll_discs(kind, 64);
    const double limit = 2 * finer.totals.frictional_power - fine.totals.frictional_power;
    EXPECT_NEAR(2 * power_of_fields(finer) - power_of_fields(fine), limit, 0.04 * limit) << kind.name;
    const double share = kind.name == "layer that yields" ? 0.5 : 0.3; // of the error that the sum has
    EXPECT_LT(std::abs(coarse.totals.frictional_power - limit), share * std::abs(power_of_fields(coarse) - limit))
        << kind.name;
  }
}

} // namespace
} // namespace microslip
