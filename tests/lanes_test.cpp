#include "microslip/numerics/lanes.hpp"

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using Register = std::experimental::native_simd<double>;
using Vector = Lanes<Register>;
constexpr int width = Vector::width;
using Numbers = std::array<double, width>;

/// Different in every lane.
Numbers numbers(double first, double step) {
  Numbers values{};
  for (int k = 0; k < width; ++k) values[k] = first + k * step;
  return values;
}

Numbers stored(const Vector& vector) {
  Numbers values{};
  vector.store(values.data());
  return values;
}

TEST(Lanes, ComputeWhatPlainNumbersDo) {
  const Numbers a = numbers(0.7, 1.3), b = numbers(-0.9, 0.37);
  const Vector x = Vector::load(a.data()), y = Vector::load(b.data());
  const Numbers sum = stored(x + y), difference = stored(x - y), product = stored(x * y), quotient = stored(x / y),
                opposite = stored(-x), root = stored(sqrt(x)), size = stored(abs(y));
  for (int k = 0; k < width; ++k) {
    EXPECT_EQ(sum[k], a[k] + b[k]);
    EXPECT_EQ(difference[k], a[k] - b[k]);
    EXPECT_EQ(product[k], a[k] * b[k]);
    EXPECT_EQ(quotient[k], a[k] / b[k]);
    EXPECT_EQ(opposite[k], -a[k]);
    EXPECT_EQ(root[k], std::sqrt(a[k]));
    EXPECT_EQ(size[k], std::abs(b[k]));
  }
}

TEST(Lanes, LoadAndStoreAtAnyAddress) {
  std::array<double, width + 1> from{}, to{};
  for (int k = 0; k <= width; ++k) from[k] = k + 0.5;
  Vector::load(from.data() + 1).store(to.data() + 1);
  EXPECT_EQ(to[0], 0);
  for (int k = 1; k <= width; ++k) EXPECT_EQ(to[k], from[k]);
}

TEST(Lanes, SelectKeepsOutWhatIsNotChosen) {
  const Numbers a = numbers(-1, 1); // negative in the first lane only
  const Vector x = Vector::load(a.data()), bad(std::numeric_limits<double>::quiet_NaN());
  const Numbers positive = stored(select(x < Vector(0.0), bad, x)), flipped = stored(select(x < Vector(0.0), -x, bad));
  EXPECT_EQ(flipped[0], 1);
  for (int k = 1; k < width; ++k) EXPECT_EQ(positive[k], a[k]);
}

TEST(Lanes, MasksFollowLogic) {
  const Numbers a = numbers(0, 1);
  const Vector x = Vector::load(a.data());
  const auto none = x < Vector(0.0), zero = x <= Vector(0.0), all = Vector(-1.0) < x;
  EXPECT_FALSE(any(none));
  EXPECT_TRUE(any(zero));
  EXPECT_TRUE(any(all));
  EXPECT_FALSE(any(~all));
  EXPECT_FALSE(any(zero & none));
  EXPECT_TRUE(any(zero | none));
  const Numbers chosen = stored(select(all & ~zero, Vector(1.0), Vector(0.0)));
  for (int k = 0; k < width; ++k) EXPECT_EQ(chosen[k], k == 0 ? 0 : 1);
}

/// A comparison with NaN is false, so that guarded branches are not taken.
TEST(Lanes, NothingComparesWithNotANumber) {
  const Vector bad(std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(any(bad < Vector(0.0)));
  EXPECT_FALSE(any(Vector(0.0) < bad));
  EXPECT_FALSE(any(bad <= bad));
}

} // namespace
} // namespace microslip
