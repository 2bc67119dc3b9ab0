#include "microslip/numerics/toeplitz.hpp"

#include "tests/support/expect_error.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/two_threads.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace microslip {
namespace {

struct Shape {
  int mx, my;
};
constexpr Shape shapes[] = {{1, 1}, {1, 17}, {23, 1}, {2, 2}, {5, 7}, {12, 11}, {33, 20}, {64, 64}};

Field random_kernel(const Shape& s, unsigned seed) {
  return random_field((2 * std::size_t(s.mx) - 1) * (2 * std::size_t(s.my) - 1), seed);
}
std::vector<Field> random_fields(const Shape& s, int n, unsigned seed) {
  std::vector<Field> fields;
  for (int c = 0; c < n; ++c) fields.push_back(random_field(std::size_t(s.mx) * s.my, seed + 1000 * c));
  return fields;
}

/// sum_J kernel(I - J) in(J), added to out.
void add_dense_product(const Shape& s, const Field& kernel, const Field& in, Field& out) {
  for (int j = 0; j < s.my; ++j)
    for (int i = 0; i < s.mx; ++i) {
      double sum = 0;
      for (int l = 0; l < s.my; ++l) {
        const double* row = kernel.data() + static_cast<std::size_t>(j - l + s.my - 1) * (2 * s.mx - 1) + i + s.mx - 1;
        for (int k = 0; k < s.mx; ++k) sum += row[-k] * in[static_cast<std::size_t>(l) * s.mx + k];
      }
      out[static_cast<std::size_t>(j) * s.mx + i] += sum;
    }
}

/// out_r = sum_c kernel_rc * in_c.
std::vector<Field> dense_product(const Shape& s, const std::vector<Field>& kernels, const std::vector<Field>& in) {
  std::vector<Field> out(kernels.size() / in.size(), Field(std::size_t(s.mx) * s.my, 0.0));
  for (std::size_t r = 0; r < out.size(); ++r)
    for (std::size_t c = 0; c < in.size(); ++c) add_dense_product(s, kernels[r * in.size() + c], in[c], out[r]);
  return out;
}

std::vector<Field> product(ToeplitzTransform& transform, const std::vector<ToeplitzTransform::Spectrum>& spectra,
                           const std::vector<Field>& in) {
  std::vector<Field> out(spectra.size() / in.size(), Field(in[0].size()));
  std::vector<const ToeplitzTransform::Spectrum*> kernels;
  for (const auto& spectrum : spectra) kernels.push_back(&spectrum);
  transform.load(std::vector<std::span<const double>>(in.begin(), in.end()));
  transform.apply(kernels, std::vector<std::span<double>>(out.begin(), out.end()));
  return out;
}

std::vector<ToeplitzTransform::Spectrum> spectra(ToeplitzTransform& transform, const std::vector<Field>& kernels) {
  std::vector<ToeplitzTransform::Spectrum> all;
  for (const Field& kernel : kernels) all.push_back(transform.kernel_spectrum(kernel));
  return all;
}

std::vector<Field> random_kernels(const Shape& s, std::size_t n, unsigned seed) {
  std::vector<Field> kernels;
  for (std::size_t k = 0; k < n; ++k) kernels.push_back(random_kernel(s, seed + 77 * static_cast<unsigned>(k)));
  return kernels;
}

/// Largest difference over the largest sum that the numbers could give.
double error(const Shape& s, const std::vector<Field>& value, const std::vector<Field>& exact) {
  double worst = 0;
  for (std::size_t c = 0; c < exact.size(); ++c)
    for (std::size_t k = 0; k < exact[c].size(); ++k) worst = std::max(worst, std::abs(value[c][k] - exact[c][k]));
  return worst / std::sqrt(double(s.mx) * s.my);
}

std::string text(const Shape& s) {
  return std::to_string(s.mx) + " x " + std::to_string(s.my);
}

TEST(Toeplitz, IsTheDenseProduct) {
  for (const Shape& s : shapes)
    for (const std::size_t components : {1U, 2U, 3U}) {
      const auto kernels = random_kernels(s, components * components, 5);
      const auto in = random_fields(s, static_cast<int>(components), 9);
      ToeplitzTransform transform(s.mx, s.my, static_cast<int>(components));
      const auto out = product(transform, spectra(transform, kernels), in);
      EXPECT_LT(error(s, out, dense_product(s, kernels, in)), 1e-14) << text(s) << ", components: " << components;
    }
}

/// More grid functions out than in, and fewer.
TEST(Toeplitz, RectangularBlocks) {
  const Shape s{9, 6};
  ToeplitzTransform transform(s.mx, s.my, 3);
  for (const auto& [in, out] : {std::pair{1, 3}, {3, 1}, {2, 3}}) {
    const auto kernels = random_kernels(s, static_cast<std::size_t>(in) * out, 50);
    const auto fields = random_fields(s, in, 60);
    const auto value = product(transform, spectra(transform, kernels), fields);
    ASSERT_EQ(value.size(), static_cast<std::size_t>(out));
    EXPECT_LT(error(s, value, dense_product(s, kernels, fields)), 1e-14);
  }
}

/// A unit at one point gives the kernel around it: nothing wraps around the padded grid.
TEST(Toeplitz, UnitsGiveTheKernelBack) {
  for (const Shape& s : shapes) {
    const Field kernel = random_kernel(s, 3);
    ToeplitzTransform transform(s.mx, s.my, 1);
    const auto spectrum = spectra(transform, {kernel});
    for (const bool last : {false, true}) {
      Field unit(std::size_t(s.mx) * s.my, 0.0), exact(unit);
      (last ? unit.back() : unit.front()) = 1;
      add_dense_product(s, kernel, unit, exact);
      EXPECT_LT(error(s, product(transform, spectrum, {unit}), {exact}), 1e-15) << text(s);
    }
  }
}

TEST(Toeplitz, IdentityKernel) {
  const Shape s{10, 13};
  Field kernel(random_kernel(s, 0).size(), 0.0);
  kernel[kernel.size() / 2] = 1;
  ToeplitzTransform transform(s.mx, s.my, 1);
  const auto in = random_fields(s, 1, 4);
  EXPECT_LT(error(s, product(transform, spectra(transform, {kernel}), in), in), 1e-15);
}

TEST(Toeplitz, IsLinear) {
  const Shape s{33, 20};
  ToeplitzTransform transform(s.mx, s.my, 2);
  const auto kernels = spectra(transform, random_kernels(s, 4, 15));
  const auto a = random_fields(s, 2, 16), b = random_fields(s, 2, 17);
  auto sum = a;
  for (std::size_t c = 0; c < sum.size(); ++c)
    for (std::size_t k = 0; k < sum[c].size(); ++k) sum[c][k] = 3 * a[c][k] - 0.5 * b[c][k];
  auto expected = product(transform, kernels, a);
  const auto of_b = product(transform, kernels, b);
  for (std::size_t c = 0; c < sum.size(); ++c)
    for (std::size_t k = 0; k < sum[c].size(); ++k) expected[c][k] = 3 * expected[c][k] - 0.5 * of_b[c][k];
  EXPECT_LT(error(s, product(transform, kernels, sum), expected), 1e-14);
}

/// What was done before leaves no trace, to the last bit.
TEST(Toeplitz, CanBeUsedAgainAndAgain) {
  const Shape s{12, 7};
  ToeplitzTransform transform(s.mx, s.my, 2);
  const auto one = spectra(transform, random_kernels(s, 4, 21)), two = spectra(transform, random_kernels(s, 4, 22));
  const auto in = random_fields(s, 2, 23), other = random_fields(s, 2, 24);
  const auto first = product(transform, one, in);
  product(transform, two, other);
  product(transform, spectra(transform, random_kernels(s, 1, 25)), {other[0]});
  EXPECT_EQ(product(transform, one, in), first);
  EXPECT_EQ(transform.products(), 4);
}

/// The loaded grid functions stay: other kernels can be applied to them.
TEST(Toeplitz, LoadedOnceAppliedTwice) {
  const Shape s{8, 8};
  ToeplitzTransform transform(s.mx, s.my, 1);
  const auto in = random_fields(s, 1, 31);
  const auto kernels = random_kernels(s, 2, 32);
  const auto all = spectra(transform, kernels);
  transform.load(std::array{std::span<const double>(in[0])});
  for (std::size_t k = 0; k < 2; ++k) {
    Field out(in[0].size());
    transform.apply(std::array{&all[k]}, std::array{std::span<double>(out)});
    EXPECT_LT(error(s, {out}, dense_product(s, {kernels[k]}, in)), 1e-14);
  }
}

TEST(Toeplitz, MovedObjectsWork) {
  const Shape s{6, 4};
  const auto kernels = random_kernels(s, 1, 41), in = random_fields(s, 1, 42);
  ToeplitzTransform transform(s.mx, s.my, 1);
  const auto spectrum = spectra(transform, kernels);
  ToeplitzTransform moved(std::move(transform));
  EXPECT_EQ(moved.mx(), s.mx);
  EXPECT_EQ(moved.my(), s.my);
  EXPECT_LT(error(s, product(moved, spectrum, in), dense_product(s, kernels, in)), 1e-14);
  ToeplitzTransform assigned(1, 1, 1);
  assigned = std::move(moved);
  EXPECT_LT(error(s, product(assigned, spectrum, in), dense_product(s, kernels, in)), 1e-14);
}

/// Objects made, used and destroyed in two threads at once.
TEST(Toeplitz, DistinctObjectsInDistinctThreads) {
  const double worst = worst_in_two_threads([](unsigned thread, unsigned round) {
    const Shape s{3 + static_cast<int>(7 * thread + round % 9), 5 + static_cast<int>(round % 4)};
    const auto kernels = random_kernels(s, 4, 100 * thread + round);
    const auto in = random_fields(s, 2, 7 * round + thread);
    ToeplitzTransform transform(s.mx, s.my, 2);
    const auto out = product(transform, spectra(transform, kernels), in);
    return error(s, out, dense_product(s, kernels, in));
  });
  EXPECT_LT(worst, 1e-14);
}

TEST(Toeplitz, RefusesGridsWithoutElements) {
  expect_error([] { ToeplitzTransform(0, 3, 1); }, "mx", "[-]: must be in [1, 1e+08]");
  expect_error([] { ToeplitzTransform(3, -2, 1); }, "my", "[-]: must be in [1, 1e+08]");
  expect_error([] { ToeplitzTransform(100000001, 1, 1); }, "mx", "[-]: must be in [1, 1e+08]");
}

} // namespace
} // namespace microslip
