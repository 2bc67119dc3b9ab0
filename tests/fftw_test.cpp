#include "microslip/numerics/fftw.hpp"

#include <cmath>
#include <complex>
#include <optional>

#include <gtest/gtest.h>

namespace microslip::fftw {
namespace {

TEST(QuickSize, IsTheNextOfEvenSizesThatAreNotFarApart) {
  for (int n = 1; n <= 5000; ++n) {
    const int size = quick_size(n);
    ASSERT_GE(size, n);
    ASSERT_EQ(size % 2, 0) << n;
    ASSERT_EQ(quick_size(size), size) << n;
    ASSERT_LE(quick_size(n), quick_size(n + 1));
    if (n > 20) {
      ASSERT_LE(size, 1.55 * n) << n;
    }
    if (n > 128) {
      ASSERT_LE(size, 1.25 * n) << n;
    }
  }
}

/// A wave becomes one number, and back.
template <class Real> void wave_there_and_back(Real tolerance) {
  constexpr int n = 20, count = 3, wave = 7;
  const auto in = allocate<std::complex<Real>>(n * count), out = allocate<std::complex<Real>>(n * count);
  const Transforms<Real> forward(n, count, FFTW_FORWARD);
  const Transforms<Real> backward(n, count, FFTW_BACKWARD);
  const auto value = [](int row, int i) {
    return static_cast<Real>(row + 1) * std::polar<Real>(1, static_cast<Real>(2 * M_PI * wave * i / n));
  };
  for (int row = 0; row < count; ++row)
    for (int i = 0; i < n; ++i) in[row * n + i] = value(row, i);
  forward.execute(in.get(), out.get());
  for (int row = 0; row < count; ++row)
    for (int k = 0; k < n; ++k)
      EXPECT_NEAR(std::abs(out[row * n + k] - Real(k == wave ? n * (row + 1) : 0)), 0, n * tolerance);
  backward.execute(out.get(), in.get());
  for (int row = 0; row < count; ++row)
    for (int i = 0; i < n; ++i) EXPECT_NEAR(std::abs(in[row * n + i] - Real(n) * value(row, i)), 0, n * tolerance);
}

/// Copies share the plans, which do not depend on who made them, and outlive them in what uses them.
TEST(TransformPlans, AreSharedAndKept) {
  constexpr int n = 24, count = 2;
  const auto in = allocate<std::complex<double>>(n * count);
  const auto out = allocate<std::complex<double>>(n * count), other = allocate<std::complex<double>>(n * count);
  for (int i = 0; i < n * count; ++i) in[i] = {std::sin(i + 0.5), std::cos(3.0 * i)};
  std::optional<TransformPlans> plans(std::in_place);
  const TransformPlans copy = *plans;
  EXPECT_EQ(&copy.kept(), &plans->kept());
  const Transforms<double> first(n, count, FFTW_FORWARD, *plans), second(n, count, FFTW_FORWARD, copy);
  const Transforms<double> alone(n, count, FFTW_FORWARD);
  plans.reset();
  first.execute(in.get(), out.get());
  for (const auto* transforms : {&second, &alone}) {
    transforms->execute(in.get(), other.get());
    for (int i = 0; i < n * count; ++i) EXPECT_EQ(other[i], out[i]);
  }
}

TEST(RealTransforms, AreThoseOfComplexNumbers) {
  for (const int n : {1, 2, 5, 12}) {
    constexpr int count = 3;
    const int columns = n / 2 + 1;
    const auto real = allocate<double>(2 * columns * count);
    const auto half = allocate<std::complex<double>>(columns * count);
    const auto in = allocate<std::complex<double>>(n * count), out = allocate<std::complex<double>>(n * count);
    const auto value = [](int row, int i) { return std::sin(2.3 * i + row) + 0.1 * row; };
    for (int row = 0; row < count; ++row)
      for (int i = 0; i < n; ++i) real[row * 2 * columns + i] = value(row, i), in[row * n + i] = value(row, i);
    const RealTransforms of_real(n, count);
    of_real.forward(real.get(), half.get());
    Transforms<double>(n, count, FFTW_FORWARD).execute(in.get(), out.get());
    for (int row = 0; row < count; ++row)
      for (int k = 0; k < columns; ++k)
        EXPECT_NEAR(std::abs(half[row * columns + k] - out[row * n + k]), 0, 1e-14 * n) << n;
    of_real.backward(half.get(), real.get());
    for (int row = 0; row < count; ++row)
      for (int i = 0; i < n; ++i) EXPECT_NEAR(real[row * 2 * columns + i], n * value(row, i), 1e-14 * n) << n;
  }
}

TEST(Transforms, DoublePrecision) {
  wave_there_and_back<double>(1e-14);
}

TEST(Transforms, SinglePrecision) {
  wave_there_and_back<float>(5e-6F);
}

} // namespace
} // namespace microslip::fftw
