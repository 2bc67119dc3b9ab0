// Products of a single row against sums, and with every instruction set.

#include "microslip/numerics/even_toeplitz.hpp"
#include "microslip/numerics/symmetric_toeplitz.hpp"
#include "microslip/numerics/toeplitz_row.hpp"
#include "tests/support/fields.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

constexpr int longest = ToeplitzRow<double>::longest;

/// Falls like 1/distance, as displacements do.
Field kernel(int n) {
  Field k(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) k[static_cast<std::size_t>(i)] = 1 / std::hypot(i, 0.4);
  return k;
}

Field sums(const Field& kernel, const Field& in) {
  const auto n = static_cast<int>(in.size());
  Field out(in.size());
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      out[static_cast<std::size_t>(i)] +=
          kernel[static_cast<std::size_t>(std::abs(i - j))] * in[static_cast<std::size_t>(j)];
  return out;
}

TEST(ToeplitzRow, IsTheSumInPlaceToo) {
  for (const int n : {1, 2, 7, 23, 24, 25, 92, 200}) {
    const Field in = random_field(static_cast<std::size_t>(n), 5), exact = sums(kernel(n), in);
    ToeplitzRow<double> row{kernel(n)};
    Field out = in;
    row.apply(out.data(), out.data());
    for (std::size_t k = 0; k < out.size(); ++k) EXPECT_NEAR(out[k], exact[k], 1e-13 * n) << n;
  }
}

TEST(ToeplitzRow, HasTheSameBitsForEveryInstructionSet) {
  const int n = 92;
  const Field in = random_field(n, 5);
  Field mirrored = kernel(n);
  std::reverse(mirrored.begin(), mirrored.end());
  for (const double value : kernel(n)) mirrored.push_back(value);
  mirrored.erase(mirrored.begin() + n);
  mirrored.resize(mirrored.size() + detail::row_product_padding);
  std::vector<Field> found;
  for (const InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
    if (!is_available(set)) continue;
    found.emplace_back(n);
    detail::row_product<double>(set)(mirrored.data() + n - 1, n, in.data(), found.back().data());
  }
  for (const Field& out : found) EXPECT_EQ(out, found.front());
}

/// From this length on transforms are taken instead of sums: the operators do not change.
TEST(ToeplitzRow, TakesThePlaceOfTransforms) {
  for (const int n : {longest, longest + 1}) {
    const Field in = random_field(static_cast<std::size_t>(n), 5), exact = sums(kernel(n), in);
    Field long_kernel = kernel(4 * n), out(in.size()), back(in.size());
    EvenToeplitz even(n, 1, [&](int j, std::span<double> entries) {
      for (std::size_t k = 0; k < entries.size(); ++k) entries[k] = j == 0 ? long_kernel[k] : 0;
    });
    even.apply(in, out);
    for (std::size_t k = 0; k < out.size(); ++k) EXPECT_NEAR(out[k], exact[k], 1e-11);
    even.apply_circulant_inverse(out, back);
    double error = 0, size = 0;
    for (std::size_t k = 0; k < in.size(); ++k) error += std::pow(back[k] - in[k], 2), size += in[k] * in[k];
    EXPECT_LT(error, 0.1 * size);
    const Field kernel_of_row = kernel(n), none(in.size());
    SymmetricToeplitz<double> symmetric(n, 1, {kernel_of_row, none, kernel_of_row});
    Field ux(in.size()), uy(in.size());
    symmetric.apply(in, in, 1, ux, uy);
    for (std::size_t k = 0; k < out.size(); ++k) {
      EXPECT_NEAR(ux[k], exact[k], 1e-11);
      EXPECT_NEAR(uy[k], exact[k], 1e-11);
    }
  }
}

} // namespace
} // namespace microslip
