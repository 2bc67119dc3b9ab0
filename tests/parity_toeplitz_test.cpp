// Products with kernels that are even or odd against sums.

#include "microslip/numerics/parity_toeplitz.hpp"

#include "tests/support/expect_error.hpp"
#include "tests/support/fields.hpp"

#include <cmath>
#include <cstdlib>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>
#include <omp.h>
#include <span>
#include <utility>

namespace microslip {
namespace {

constexpr Parity parities[] = {{false, false}, {true, false}, {false, true}, {true, true}};

/// A kernel by its values at offsets >= 0.
struct Kernel {
  int mx;
  Parity parity;
  Field quadrant;

  double at(int i, int j) const {
    double sign = 1;
    if (parity.odd_x) sign *= i < 0 ? -1 : i > 0 ? 1 : 0;
    if (parity.odd_y) sign *= j < 0 ? -1 : j > 0 ? 1 : 0;
    return sign * quadrant[static_cast<std::size_t>(std::abs(j)) * mx + std::abs(i)];
  }
};

struct Product {
  int mx, my;
  std::vector<Field> in;
  std::vector<Kernel> kernels; ///< kernel k acts on in[k % in.size()]

  Product(int x, int y, std::size_t loads) : mx(x), my(y) {
    const std::size_t size = static_cast<std::size_t>(mx) * my;
    for (std::size_t n = 0; n < loads; ++n) in.push_back(random_field(size, 10 + unsigned(n)));
    for (unsigned k = 0; k < 4; ++k) kernels.push_back({mx, parities[k], random_field(size, 20 + k)});
  }

  Field by_transforms(const std::vector<int>& rows) const {
    ParityToeplitz transform(mx, my);
    const std::vector<std::span<const double>> spans(in.begin(), in.end());
    transform.load(spans);
    std::vector<ParityToeplitz::Spectrum> spectra;
    for (const Kernel& kernel : kernels)
      spectra.push_back(transform.spectrum(kernel.parity, [&](int j, std::span<double> entries) {
        for (int i = 0; i < mx; ++i) entries[i] = kernel.quadrant[static_cast<std::size_t>(j) * mx + i];
      }));
    std::vector<ParityToeplitz::Term> terms;
    for (std::size_t k = 0; k < kernels.size(); ++k) terms.push_back({k % in.size(), &spectra[k], kernels[k].parity});
    Field out(rows.size() * mx);
    transform.apply(terms, rows, out);
    return out;
  }

  double sum(int i, int j) const {
    double sum = 0;
    for (std::size_t n = 0; n < kernels.size(); ++n)
      for (int l = 0; l < my; ++l)
        for (int k = 0; k < mx; ++k)
          sum += kernels[n].at(i - k, j - l) * in[n % in.size()][static_cast<std::size_t>(l) * mx + k];
    return sum;
  }
};

std::vector<int> all_rows(int my) {
  std::vector<int> rows(my);
  std::iota(rows.begin(), rows.end(), 0);
  return rows;
}

TEST(ParityToeplitz, IsTheSumOfTheKernelsProducts) {
  for (const int mx : {1, 2, 3, 8, 13})
    for (const int my : {1, 2, 5, 9, 17})
      for (const std::size_t loads : {std::size_t(1), std::size_t(3)}) {
        const Product product(mx, my, loads);
        const Field out = product.by_transforms(all_rows(my));
        for (int j = 0; j < my; ++j)
          for (int i = 0; i < mx; ++i)
            EXPECT_NEAR(out[static_cast<std::size_t>(j) * mx + i], product.sum(i, j), 1e-13 * mx * my)
                << mx << " x " << my << ", " << i << ", " << j;
      }
}

/// A few rows are summed otherwise than all; in any order, and more than once.
TEST(ParityToeplitz, RowsThatAreChosenAreThoseOfAll) {
  const Product product(11, 23, 2);
  const Field all = product.by_transforms(all_rows(23));
  for (const std::vector<int>& rows :
       {std::vector<int>{7}, {22, 0, 5, 5}, {9, 8, 7, 6, 5, 4, 3, 2}, {9, 8, 7, 6, 5, 4, 3, 2, 1, 21, 22}, {}}) {
    const Field some = product.by_transforms(rows);
    ASSERT_EQ(some.size(), rows.size() * 11);
    for (std::size_t r = 0; r < rows.size(); ++r)
      for (std::size_t i = 0; i < 11; ++i)
        EXPECT_NEAR(some[r * 11 + i], all[static_cast<std::size_t>(rows[r]) * 11 + i], 1e-11);
  }
}

TEST(ParityToeplitz, DoesNotDependOnTheNumberOfThreads) {
  const Product product(130, 129, 1);
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const Field one = product.by_transforms(all_rows(129));
  omp_set_num_threads(3);
  const Field three = product.by_transforms(all_rows(129));
  omp_set_num_threads(threads);
  EXPECT_EQ(one, three);
}

/// A kernel of small numbers after products with large ones: nothing of them is left in its transform.
TEST(ParityToeplitz, KernelsDoNotDependOnEarlierProducts) {
  for (const auto& [mx, my] : {std::pair{7, 12}, {9, 10}, {17, 20}}) {
    const std::vector<double> in(static_cast<std::size_t>(mx) * my, 1e6);
    std::vector<double> out(in.size());
    std::vector<int> rows(my);
    std::iota(rows.begin(), rows.end(), 0);
    const auto kernel = [](double size) {
      return [size](int j, std::span<double> entries) {
        for (std::size_t i = 0; i < entries.size(); ++i) entries[i] = size / (1.0 + double(i) + 2 * j);
      };
    };
    for (const Parity parity : {Parity{false, false}, {true, false}, {false, true}, {true, true}}) {
      ParityToeplitz fresh(mx, my), used(mx, my);
      const std::span<const double> loads[] = {in};
      used.load(loads);
      const auto large = used.spectrum(parity, kernel(1));
      const ParityToeplitz::Term term{0, &large, parity};
      used.apply({&term, 1}, rows, out);
      const auto wanted = fresh.spectrum(parity, kernel(1e-17)), found = used.spectrum(parity, kernel(1e-17));
      EXPECT_EQ(found, wanted) << mx << " x " << my;
    }
  }
}

TEST(ParityToeplitz, RefusesGridsWithoutElements) {
  expect_error([] { ParityToeplitz(0, 3); }, "mx", "[-]: must be in [1, 1e+08]");
  expect_error([] { ParityToeplitz(3, 0); }, "my", "[-]: must be in [1, 1e+08]");
}

} // namespace
} // namespace microslip
