#include "microslip/numerics/lanes.hpp"
#include "microslip/numerics/vector_simd.hpp"

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

/// By the registers of the standard library and by those of lane_vector.hpp.
template <class Register> class LanesTest : public testing::Test {};
using Registers = testing::Types<simd::native_simd<double>, vector_simd::native_simd<double>,
                                 vector_simd::fixed_size_simd<double, 16>>;
TYPED_TEST_SUITE(LanesTest, Registers);

template <class Register> class LanesInSinglePrecision : public testing::Test {};
using SingleRegisters = testing::Types<simd::native_simd<float>, vector_simd::native_simd<float>>;
TYPED_TEST_SUITE(LanesInSinglePrecision, SingleRegisters);

TYPED_TEST(LanesTest, ComputeWhatPlainNumbersDo) {
  using Vector = Lanes<TypeParam>;
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
  using Vector = Lanes<TypeParam>;
  constexpr int width = Vector::width;
  std::array<double, width + 1> from{}, to{};
  for (int k = 0; k <= width; ++k) from[k] = k + 0.5;
  Vector::load(from.data() + 1).store(to.data() + 1);
  EXPECT_EQ(to[0], 0);
  for (int k = 1; k <= width; ++k) EXPECT_EQ(to[k], from[k]);
}

TYPED_TEST(LanesTest, SelectKeepsOutWhatIsNotChosen) {
  using Vector = Lanes<TypeParam>;
  constexpr int width = Vector::width;
  const Numbers<Vector> a = numbers<Vector>(-1, 1); // negative in the first lane only
  const Vector x = Vector::load(a.data()), bad(std::numeric_limits<double>::quiet_NaN());
  const Numbers<Vector> positive = stored(select(x < Vector(0.0), bad, x)),
                        flipped = stored(select(x < Vector(0.0), -x, bad));
  EXPECT_EQ(flipped[0], 1);
  for (int k = 1; k < width; ++k) EXPECT_EQ(positive[k], a[k]);
}

TYPED_TEST(LanesTest, MasksFollowLogic) {
  using Vector = Lanes<TypeParam>;
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
  using Vector = Lanes<TypeParam>;
  const Vector bad(std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(any(bad < Vector(0.0)));
  EXPECT_FALSE(any(Vector(0.0) < bad));
  EXPECT_FALSE(any(bad <= bad));
}

TYPED_TEST(LanesInSinglePrecision, LoadAndStoreDoubles) {
  using Vector = Lanes<TypeParam>;
  std::array<double, Vector::width> from{}, to{};
  for (int k = 0; k < Vector::width; ++k) from[k] = 0.1 * k;
  const Vector x = Vector::load(from.data());
  select(x < Vector(0.15), x, -x).store(to.data());
  for (int k = 0; k < Vector::width; ++k) EXPECT_EQ(to[k], static_cast<float>(from[k]) * (k < 2 ? 1 : -1));
}

TEST(VectorSimd, SumsAllLanes) {
  std::array<float, 16> values{};
  for (int k = 0; k < 16; ++k) values[k] = static_cast<float>(k);
  const vector_simd::fixed_size_simd<float, 16> v(values.data(), vector_simd::element_aligned);
  EXPECT_EQ(reduce(v), 120);
  EXPECT_EQ(reduce(v - v), 0);
}

} // namespace
} // namespace microslip
