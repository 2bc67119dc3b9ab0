#include "microslip/numerics/fftw.hpp"

#include <cmath>
#include <complex>

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

TEST(Transforms, DoublePrecision) {
  wave_there_and_back<double>(1e-14);
}

TEST(Transforms, SinglePrecision) {
  wave_there_and_back<float>(5e-6F);
}

} // namespace
} // namespace microslip::fftw
