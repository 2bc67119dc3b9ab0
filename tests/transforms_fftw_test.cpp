// Transforms of lengths for which sums over all terms would take too long, against FFTW's.

#include "microslip/numerics/transforms.hpp"

#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <memory>
#include <random>
#include <type_traits>
#include <vector>

#include <fftw3.h>
#include <gtest/gtest.h>

namespace microslip {
namespace {

using Complex = std::complex<double>;

constexpr int lengths[] = {768, 1080, 1536, 2000, 2048, 3125, 4096, 6561, 10000};

std::vector<Complex> waves_by_fftw(std::vector<Complex> z) {
  auto* const numbers = reinterpret_cast<fftw_complex*>(z.data());
  using Plan = std::remove_pointer_t<fftw_plan>;
  const std::unique_ptr<Plan, decltype(&fftw_destroy_plan)> plan(
      fftw_plan_dft_1d(static_cast<int>(z.size()), numbers, numbers, FFTW_FORWARD, FFTW_ESTIMATE), fftw_destroy_plan);
  fftw_execute(plan.get());
  return z;
}

template <class Real> Buffer<Real> random_numbers(std::size_t count) {
  std::mt19937 engine(static_cast<unsigned>(count));
  Buffer<Real> numbers = allocate<Real>(count);
  for (std::size_t i = 0; i < count; ++i) numbers[i] = static_cast<Real>(static_cast<double>(engine()) * 0x1p-31 - 1);
  return numbers;
}

template <class Real> double tolerance(int n) {
  return 4 * std::numeric_limits<Real>::epsilon() * std::sqrt(n) * (1 + std::log2(n));
}

template <class Real> class TransformsAgainstFftw : public testing::Test {};
using Precisions = testing::Types<double, float>;
TYPED_TEST_SUITE(TransformsAgainstFftw, Precisions);

TYPED_TEST(TransformsAgainstFftw, LongColumns) {
  using Real = TypeParam;
  constexpr int lanes = block_lanes<Real>, line = line_size<Real>;
  for (const int n : lengths) {
    const ColumnTransforms<Real> transforms(n);
    const std::size_t size = static_cast<std::size_t>(n) * line;
    const Buffer<Real> numbers = random_numbers<Real>(size), waves = allocate<Real>(size), back = allocate<Real>(size),
                       work = allocate<Real>(transforms.work_size());
    transforms.forward({numbers.get(), line, n}, lanes, waves.get(), work.get());
    const auto column = [n](const Buffer<Real>& block, int lane) {
      std::vector<Complex> z;
      for (int k = 0; k < n; ++k) z.emplace_back(block[k * line + lane], block[k * line + lanes + lane]);
      return z;
    };
    for (int lane = 0; lane < lanes; ++lane) {
      const auto found = column(waves, lane), expected = waves_by_fftw(column(numbers, lane));
      for (int k = 0; k < n; ++k) ASSERT_NEAR(std::abs(found[k] - expected[k]), 0, tolerance<Real>(n)) << n << ' ' << k;
    }
    transforms.backward(waves.get(), {back.get(), line, n}, lanes, work.get());
    for (std::size_t i = 0; i < size; ++i)
      ASSERT_NEAR(back[i], n * double(numbers[i]), n * tolerance<Real>(n)) << n << ' ' << i;
  }
}

TYPED_TEST(TransformsAgainstFftw, LongRows) {
  using Real = TypeParam;
  constexpr int lanes = block_lanes<Real>, line = line_size<Real>, rows = RowTransforms<Real>::most_rows;
  for (const int n : lengths) {
    const RowTransforms<Real> transforms(n);
    const std::size_t size = static_cast<std::size_t>(n) * rows, block_size = static_cast<std::size_t>(rows) * line,
                      two_rows = 2 * static_cast<std::size_t>(n);
    const Buffer<Real> numbers = random_numbers<Real>(size), waves = allocate<Real>((n / 2 / lanes + 1) * block_size),
                       back = allocate<Real>(size), work = allocate<Real>(transforms.work_size());
    transforms.forward({numbers.get(), numbers.get() + n, two_rows}, rows, n, waves.get(), block_size, work.get());
    for (int row = 0; row < rows; ++row) {
      const Real* const first = numbers.get() + static_cast<std::size_t>(row) * n;
      const auto expected = waves_by_fftw(std::vector<Complex>(first, first + n));
      for (int k = 0; k <= n / 2; ++k) {
        const Real* const at = waves.get() + k / lanes * block_size + row * line + k % lanes;
        ASSERT_NEAR(std::abs(Complex(at[0], at[lanes]) - expected[k]), 0, tolerance<Real>(n)) << n << ' ' << k;
      }
    }
    transforms.backward(waves.get(), block_size, {back.get(), back.get() + n, two_rows}, rows, n, work.get());
    for (std::size_t i = 0; i < size; ++i)
      ASSERT_NEAR(back[i], n * double(numbers[i]), n * tolerance<Real>(n)) << n << ' ' << i;
  }
}

} // namespace
} // namespace microslip
