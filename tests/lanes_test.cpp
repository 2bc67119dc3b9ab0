#include "microslip/numerics/lanes.hpp"

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace microslip {
namespace {

template <class Vector> using Numbers = std::array<double, Vector::width>;

/// Different in every lane.
template <class Vector> Numbers<Vector> numbers(double first, double step) {
  Numbers<Vector> values{};
  for (int k = 0; k < Vector::width; ++k) values[k] = first + k * step;
  return values;
}

template <class Vector> Numbers<Vector> stored(const Vector& vector) {
  Numbers<Vector> values{};
  vector.store(values.data());
  return values;
}

/// As many as registers hold, fewer and more.
template <class Vector> class LanesTest : public testing::Test {};
using Vectors = testing::Types<Lanes<double>, Lanes<double, 4>, Lanes<double, 16>>;
TYPED_TEST_SUITE(LanesTest, Vectors);

template <class Vector> class LanesInSinglePrecision : public testing::Test {};
using SingleVectors = testing::Types<Lanes<float>, Lanes<float, 8>, Lanes<float, 16>>;
TYPED_TEST_SUITE(LanesInSinglePrecision, SingleVectors);

TYPED_TEST(LanesTest, ComputeWhatPlainNumbersDo) {
  using Vector = TypeParam;
  constexpr int width = Vector::width;
  const Numbers<Vector> a = numbers<Vector>(0.7, 1.3), b = numbers<Vector>(-0.9, 0.37);
  const Vector x = Vector::load(a.data()), y = Vector::load(b.data());
  const Numbers<Vector> sum = stored(x + y), difference = stored(x - y), product = stored(x * y),
                        quotient = stored(x / y), opposite = stored(-x), root = stored(sqrt(x)), size = stored(abs(y));
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

TYPED_TEST(LanesTest, LoadAndStoreAtAnyAddress) {
  using Vector = TypeParam;
  constexpr int width = Vector::width;
  std::array<double, width + 1> from{}, to{};
  for (int k = 0; k <= width; ++k) from[k] = k + 0.5;
  Vector::load(from.data() + 1).store(to.data() + 1);
  EXPECT_EQ(to[0], 0);
  for (int k = 1; k <= width; ++k) EXPECT_EQ(to[k], from[k]);
}

TYPED_TEST(LanesTest, SelectKeepsOutWhatIsNotChosen) {
  using Vector = TypeParam;
  constexpr int width = Vector::width;
  const Numbers<Vector> a = numbers<Vector>(-1, 1); // negative in the first lane only
  const Vector x = Vector::load(a.data()), bad(std::numeric_limits<double>::quiet_NaN());
  const Numbers<Vector> positive = stored(select(x < Vector(0.0), bad, x)),
                        flipped = stored(select(x < Vector(0.0), -x, bad));
  EXPECT_EQ(flipped[0], 1);
  for (int k = 1; k < width; ++k) EXPECT_EQ(positive[k], a[k]);
}

TYPED_TEST(LanesTest, MasksFollowLogic) {
  using Vector = TypeParam;
  constexpr int width = Vector::width;
  const Numbers<Vector> a = numbers<Vector>(0, 1);
  const Vector x = Vector::load(a.data());
  const auto none = x < Vector(0.0), zero = x <= Vector(0.0), all = Vector(-1.0) < x;
  EXPECT_FALSE(any(none));
  EXPECT_TRUE(any(zero));
  EXPECT_TRUE(any(all));
  EXPECT_FALSE(any(~all));
  EXPECT_FALSE(any(zero & none));
  EXPECT_TRUE(any(zero | none));
  const Numbers<Vector> chosen = stored(select(all & ~zero, Vector(1.0), Vector(0.0)));
  for (int k = 0; k < width; ++k) EXPECT_EQ(chosen[k], k == 0 ? 0 : 1);
}

/// A comparison with NaN is false, so that guarded branches are not taken.
TYPED_TEST(LanesTest, NothingComparesWithNotANumber) {
  using Vector = TypeParam;
  const Vector bad(std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(any(bad < Vector(0.0)));
  EXPECT_FALSE(any(Vector(0.0) < bad));
  EXPECT_FALSE(any(bad <= bad));
}

TYPED_TEST(LanesInSinglePrecision, LoadAndStoreDoubles) {
  using Vector = TypeParam;
  std::array<double, Vector::width> from{}, to{};
  for (int k = 0; k < Vector::width; ++k) from[k] = 0.1 * k;
  const Vector x = Vector::load(from.data());
  select(x < Vector(0.15), x, -x).store(to.data());
  for (int k = 0; k < Vector::width; ++k) EXPECT_EQ(to[k], static_cast<float>(from[k]) * (k < 2 ? 1 : -1));
}

/// No lane is overlooked: with 32-bit masks half of them once were.
template <class Vector> void expect_each_lane_seen() {
  for (int lane = 0; lane < Vector::width; ++lane) {
    std::array<double, Vector::width> numbers;
    for (int k = 0; k < Vector::width; ++k) numbers[k] = k == lane ? -1 : 1;
    EXPECT_TRUE(any(Vector::load(numbers.data()) < Vector(0.0))) << lane << " of " << Vector::width;
  }
}
TYPED_TEST(LanesTest, AnySeesEachLane) {
  expect_each_lane_seen<TypeParam>();
}
TYPED_TEST(LanesInSinglePrecision, AnySeesEachLane) {
  expect_each_lane_seen<TypeParam>();
}

template <class Vector> class WideLanesTest : public testing::Test {};
using WideVectors = testing::Types<WideLanes<double, 2>, WideLanes<double, 4>, WideLanes<double, 16>>;
TYPED_TEST_SUITE(WideLanesTest, WideVectors);

TYPED_TEST(WideLanesTest, ComputeWhatPlainNumbersDo) {
  using Vector = TypeParam;
  const Numbers<Vector> a = numbers<Vector>(0.7, 1.3), b = numbers<Vector>(-0.9, 0.37);
  Vector x = Vector::load(a.data());
  const Vector y = Vector::load(b.data());
  const Numbers<Vector> product = stored(x * y), difference = stored(x - y);
  x += y * 2;
  x -= y;
  const Numbers<Vector> rest = stored(x);
  for (int k = 0; k < Vector::width; ++k) {
    EXPECT_EQ(product[k], a[k] * b[k]);
    EXPECT_EQ(difference[k], a[k] - b[k]);
    EXPECT_EQ(rest[k], a[k] + b[k] * 2 - b[k]);
  }
}

TYPED_TEST(WideLanesTest, SumsAllLanes) {
  using Vector = TypeParam;
  const Numbers<Vector> a = numbers<Vector>(1, 1);
  const Vector x = Vector::load(a.data());
  EXPECT_EQ(sum(x), Vector::width * (Vector::width + 1) / 2);
  EXPECT_EQ(sum(x - x), 0);
}

/// Also of negative zero, whose sign arithmetic must not lose.
TYPED_TEST(LanesTest, ConstantsAreTheSameInAllLanes) {
  using Vector = TypeParam;
  const Numbers<Vector> zero = stored(Vector(-0.0)), size = stored(abs(Vector(-0.0)));
  for (int k = 0; k < Vector::width; ++k) {
    EXPECT_TRUE(std::signbit(zero[k]));
    EXPECT_FALSE(std::signbit(size[k]));
  }
}

TYPED_TEST(LanesTest, TransposeExchangesRowsAndColumns) {
  using Vector = TypeParam;
  constexpr int width = Vector::width;
  std::array<Vector, width> rows;
  for (int i = 0; i < width; ++i) {
    const Numbers<Vector> row = numbers<Vector>(i * width, 1);
    rows[i] = Vector::load(row.data());
  }
  transpose(rows.data());
  for (int i = 0; i < width; ++i) {
    const Numbers<Vector> column = stored(rows[i]);
    for (int j = 0; j < width; ++j) EXPECT_EQ(column[j], j * width + i);
  }
}

} // namespace
} // namespace microslip
