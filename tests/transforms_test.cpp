// Fast transforms against sums over all terms, for every instruction set.

#include "microslip/numerics/transforms.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <random>
#include <thread>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using Complex = std::complex<double>;

std::vector<InstructionSet> instruction_sets() {
  std::vector<InstructionSet> sets;
  for (const auto set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512})
    if (is_available(set)) sets.push_back(set);
  return sets;
}

template <class Real> std::vector<Real> random_numbers(std::size_t count, unsigned seed) {
  std::mt19937 engine(seed);
  std::vector<Real> numbers(count);
  for (Real& number : numbers) number = static_cast<Real>(static_cast<double>(engine()) * 0x1p-31 - 1);
  return numbers;
}

/// sum_j exp(sign 2 pi i j k/n) z_j.
std::vector<Complex> sums(const std::vector<Complex>& z, int sign) {
  const auto n = static_cast<std::int64_t>(z.size());
  std::vector<Complex> out(z.size());
  for (std::int64_t k = 0; k < n; ++k)
    for (std::int64_t j = 0; j < n; ++j)
      out[k] +=
          z[j] * std::polar(1.0, sign * 2 * std::numbers::pi * static_cast<double>(j * k % n) / static_cast<double>(n));
  return out;
}

/// All lengths with small factors, and some longer ones, with every beginning and end.
std::vector<int> lengths() {
  std::vector<int> all;
  for (int n = 1; n <= 130; ++n) {
    int rest = n;
    for (const int factor : {2, 3, 5})
      while (rest % factor == 0) rest /= factor;
    if (rest == 1) all.push_back(n);
  }
  all.insert(all.end(), {243, 250, 256, 375, 512, 600, 625});
  return all;
}

template <class Real> double tolerance(int n) {
  return 4 * std::numeric_limits<Real>::epsilon() * std::sqrt(n) * (1 + std::log2(n));
}

template <class Real> struct Columns {
  static constexpr int lanes = block_lanes<Real>, line = line_size<Real>;
  int n;
  Buffer<Real> numbers = allocate<Real>(size()), waves = allocate<Real>(size()), work = allocate<Real>(size());

  explicit Columns(int length) : n(length) {}
  std::size_t size() const { return static_cast<std::size_t>(n) * line; }
  static Complex at(const Real* block, int k, int lane) {
    return {block[k * line + lane], block[k * line + lanes + lane]};
  }
  std::vector<Complex> column(const Real* block, int lane) const {
    std::vector<Complex> z;
    for (int k = 0; k < n; ++k) z.push_back(at(block, k, lane));
    return z;
  }
};

template <class Real> void columns_are_sums() {
  constexpr int lanes = block_lanes<Real>, line = line_size<Real>;
  for (const auto set : instruction_sets())
    for (const int n : lengths()) {
      Columns<Real> c(n);
      const ColumnTransforms<Real> transforms(n, {}, set);
      ASSERT_EQ(transforms.work_size(), c.size());
      const auto random = random_numbers<Real>(c.size(), static_cast<unsigned>(n));
      for (const int used : {1, 2, 3, lanes / 2, lanes / 2 + 1, lanes})
        for (const int given : {n, n / 2, n / 2 + 1, 1}) {
          std::copy(random.begin(), random.end(), c.numbers.get());
          transforms.forward({c.numbers.get(), line, given}, used, c.waves.get(), c.work.get());
          const int lane = used - 1;
          auto column = c.column(c.numbers.get(), lane);
          std::fill(column.begin() + given, column.end(), Complex(0));
          const auto exact = sums(column, -1);
          for (int k = 0; k < n; ++k)
            ASSERT_NEAR(std::abs(c.at(c.waves.get(), k, lane) - exact[k]), 0, tolerance<Real>(n))
                << n << ' ' << given << ' ' << used;
          const auto there_and_back = column;
          auto out = random;
          transforms.backward(c.waves.get(), {out.data(), line, given}, used, c.work.get());
          for (int k = 0; k < n; ++k)
            if (k < given)
              ASSERT_NEAR(std::abs(c.at(out.data(), k, lane) - double(n) * there_and_back[k]), 0,
                          n * tolerance<Real>(n));
            else
              for (int i = 0; i < line; ++i) ASSERT_EQ(out[k * line + i], random[k * line + i]) << "not wanted";
        }
    }
}

TEST(ColumnTransforms, AreSums) {
  columns_are_sums<double>();
}
TEST(ColumnTransforms, AreSumsInSinglePrecision) {
  columns_are_sums<float>();
}

/// Lines of two blocks by turns.
TEST(ColumnTransforms, LinesMayBeApart) {
  constexpr int n = 24, lanes = block_lanes<double>;
  constexpr std::size_t line = line_size<double>;
  Columns<double> c(n);
  auto both = random_numbers<double>(2 * c.size(), 3);
  const ColumnTransforms<double> transforms(n);
  transforms.forward({both.data() + line, 2 * line, n}, lanes, c.waves.get(), c.work.get());
  for (int k = 0; k < n; ++k) std::copy_n(&both[(2 * k + 1) * line], line, &c.numbers[k * line]);
  const auto exact = sums(c.column(c.numbers.get(), 5), -1);
  for (int k = 0; k < n; ++k) EXPECT_NEAR(std::abs(c.at(c.waves.get(), k, 5) - exact[k]), 0, 1e-13);
  const auto before = both;
  transforms.backward(c.waves.get(), {both.data() + line, 2 * line, n}, lanes, c.work.get());
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < line; ++i) {
      EXPECT_EQ(both[2 * k * line + i], before[2 * k * line + i]);
      EXPECT_NEAR(both[(2 * k + 1) * line + i], n * before[(2 * k + 1) * line + i], 1e-13 * n);
    }
}

template <class Real> struct Rows {
  static constexpr int lanes = block_lanes<Real>, most = RowTransforms<Real>::most_rows;
  static constexpr std::size_t line = line_size<Real>;
  int n, blocks;
  std::size_t stride, block_stride = (most + 3) * line;
  std::vector<Real> numbers;
  Buffer<Real> waves;

  explicit Rows(int length)
      : n(length), blocks(n / 2 / lanes + 1), stride(2 * static_cast<std::size_t>(n) + 5),
        numbers(random_numbers<Real>(most / 2 * stride, static_cast<unsigned>(n))),
        waves(allocate<Real>(blocks * block_stride)) {
    std::fill_n(waves.get(), blocks * block_stride, Real(0));
  }
  template <class Numbers> static auto pairs(Numbers& of, int length, std::size_t apart) {
    return RowPairs<std::remove_reference_t<decltype(of[0])>>{&of[0], &of[0] + length, apart};
  }
  Complex wave(int row, int k) const {
    const Real* at = &waves[k / lanes * block_stride + row * line + k % lanes];
    return {at[0], at[lanes]};
  }
  std::vector<Complex> row(int r, int given) const {
    std::vector<Complex> z(n);
    const int of_pair = r % 2 * n;
    for (int i = 0; i < given; ++i) z[i] = numbers[r / 2 * stride + of_pair + i];
    return z;
  }
};

template <class Real> void rows_are_sums() {
  for (const auto set : instruction_sets())
    for (const int n : lengths()) {
      Rows<Real> r(n);
      const RowTransforms<Real> transforms(n, {}, set);
      const auto work = allocate<Real>(transforms.work_size());
      for (const int count : {1, 2, 5, 8, 9, Rows<Real>::most - 1, Rows<Real>::most})
        for (const int given : {n, n / 2, 1}) {
          if (given == 0) continue;
          const auto& given_numbers = r.numbers;
          transforms.forward(r.pairs(given_numbers, n, r.stride), count, given, r.waves.get(), r.block_stride,
                             work.get());
          const auto exact = sums(r.row(count - 1, given), -1);
          for (int k = 0; k <= n / 2; ++k)
            ASSERT_NEAR(std::abs(r.wave(count - 1, k) - exact[k]), 0, tolerance<Real>(n)) << n << ' ' << count;
          auto out = random_numbers<Real>(r.numbers.size(), 77);
          const auto before = out;
          transforms.backward(r.waves.get(), r.block_stride, r.pairs(out, n, r.stride), count, given, work.get());
          for (int row = 0; row < Rows<Real>::most; ++row)
            for (int i = 0; i < n; ++i) {
              const std::size_t at = row / 2 * r.stride + row % 2 * n + i;
              if (row < count && i < given)
                ASSERT_NEAR(out[at], n * double(r.numbers[at]), n * tolerance<Real>(n)) << n << ' ' << count;
              else
                ASSERT_EQ(out[at], before[at]) << "not wanted";
            }
        }
    }
}

TEST(RowTransforms, AreSums) {
  rows_are_sums<double>();
}
TEST(RowTransforms, AreSumsInSinglePrecision) {
  rows_are_sums<float>();
}

/// Parseval: n times the squares of the numbers are those of the waves, all but 0 and n/2 of which are there twice.
TEST(RowTransforms, KeepTheSquares) {
  for (const int n : {2, 30, 96, 1000, 2048}) {
    Rows<double> r(n);
    const RowTransforms<double> transforms(n);
    const auto work = allocate<double>(transforms.work_size());
    const auto& numbers = r.numbers;
    transforms.forward(r.pairs(numbers, n, r.stride), r.most, n, r.waves.get(), r.block_stride, work.get());
    for (int row = 0; row < r.most; ++row) {
      double of_numbers = 0, of_waves = 0;
      for (const Complex& z : r.row(row, n)) of_numbers += n * std::norm(z);
      for (int k = 0; k <= n / 2; ++k) of_waves += (k == 0 || 2 * k == n ? 1 : 2) * std::norm(r.wave(row, k));
      EXPECT_NEAR(of_waves / of_numbers, 1, 1e-14) << n;
    }
  }
}

/// No instruction set may fuse or reorder what others do not.
TEST(Transforms, AreTheSameToTheLastBitForEveryInstructionSet) {
  for (const int n : {20, 72, 128, 300}) {
    std::vector<std::vector<double>> results;
    for (const auto set : instruction_sets()) {
      Rows<double> r(n);
      const RowTransforms<double> rows(n, {}, set);
      const ColumnTransforms<double> columns(n, {}, set);
      const auto work = allocate<double>(rows.work_size());
      const auto& numbers = r.numbers;
      rows.forward(r.pairs(numbers, n, r.stride), r.most, n / 2, r.waves.get(), r.block_stride, work.get());
      Columns<double> c(n);
      columns.forward({r.waves.get(), r.line, std::min(n, r.most)}, r.lanes, c.waves.get(), c.work.get());
      results.emplace_back(c.waves.get(), c.waves.get() + c.size());
    }
    for (const auto& result : results) EXPECT_EQ(result, results[0]) << n;
  }
}

/// Copies share what is kept, which does not depend on who made it, and outlives it in what uses it.
TEST(TransformPlans, AreSharedAndKept) {
  constexpr int n = 24;
  Columns<double> c(n), other(n);
  const auto random = random_numbers<double>(c.size(), 5);
  std::optional<TransformPlans> plans(std::in_place);
  const TransformPlans copy = *plans;
  EXPECT_EQ(&copy.kept(), &plans->kept());
  const ColumnTransforms<double> first(n, *plans), second(n, copy), alone(n);
  plans.reset();
  first.forward({random.data(), c.line, n}, c.lanes, c.waves.get(), c.work.get());
  for (const auto* transforms : {&second, &alone}) {
    transforms->forward({random.data(), c.line, n}, c.lanes, other.waves.get(), other.work.get());
    for (std::size_t i = 0; i < c.size(); ++i) EXPECT_EQ(other.waves[i], c.waves[i]);
  }
}

TEST(TransformPlans, AreMadeByManyThreadsAtOnce) {
  const TransformPlans plans;
  std::vector<std::thread> threads;
  std::vector<int> right(4, 0);
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&, t] {
      for (const int n : {8, 12, 20, 24, 48, 64}) {
        Columns<double> c(n);
        std::fill_n(c.numbers.get(), c.size(), 1.0);
        ColumnTransforms<double>(n, plans).forward({c.numbers.get(), c.line, n}, c.lanes, c.waves.get(), c.work.get());
        right[t] += c.at(c.waves.get(), 0, 0) == Complex(n, n) ? 1 : 0;
      }
    });
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(right, std::vector<int>(4, 6));
}

TEST(Transforms, LengthsMustBePositive) {
  EXPECT_THROW(RowTransforms<double>(0), Error);
  EXPECT_THROW(ColumnTransforms<float>(-3), Error);
}

TEST(QuickSize, IsTheNextOfEvenSizesThatAreNotFarApart) {
  for (int n = 1; n <= 5000; ++n) {
    const int size = quick_size(n);
    ASSERT_GE(size, n);
    ASSERT_EQ(size % 2, 0) << n;
    ASSERT_EQ(quick_size(size), size) << n;
    ASSERT_LE(quick_size(n), quick_size(n + 1));
    ASSERT_NO_THROW(RowTransforms<float>{size}) << n;
    if (n >= 24) {
      ASSERT_LE(size, 1.3 * n) << n;
    }
    if (n >= 128) {
      ASSERT_LE(size, 1.2 * n) << n;
    }
  }
}

} // namespace
} // namespace microslip
