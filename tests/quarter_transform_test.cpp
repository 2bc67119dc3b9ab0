#include "microslip/numerics/quarter_transform.hpp"

#include <cmath>
#include <complex>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

double some_value(int i, int j) {
  return std::sin(1.7 * i + 0.3) * std::cos(0.9 * j * j) + 0.1 * i;
}

/// The function on the whole period from its quarter.
double whole(const std::vector<double>& quarter, int columns, int rows, Parity parity, int i, int j) {
  const int nx = columns > 1 ? 2 * (columns - 1) : 1, ny = rows > 1 ? 2 * (rows - 1) : 1;
  const bool left = i > nx / 2, low = j > ny / 2;
  const double value = quarter[static_cast<std::size_t>(low ? ny - j : j) * columns + (left ? nx - i : i)];
  return parity == Parity::odd && left != low ? -value : value;
}

/// Against the plain sum over the period.
TEST(QuarterTransform, IsTheFourierTransform) {
  struct Case {
    int columns, rows;
    Parity parity;
  };
  for (const Case& c : {Case{5, 4, Parity::even},
                        {1, 6, Parity::even},
                        {4, 1, Parity::even},
                        {2, 2, Parity::even},
                        {1, 1, Parity::even},
                        {5, 4, Parity::odd},
                        {7, 3, Parity::odd},
                        {2, 4, Parity::odd}}) {
    const int nx = c.columns > 1 ? 2 * (c.columns - 1) : 1, ny = c.rows > 1 ? 2 * (c.rows - 1) : 1;
    std::vector<double> quarter;
    for (int j = 0; j < c.rows; ++j)
      for (int i = 0; i < c.columns; ++i) {
        const bool is_zero = c.parity == Parity::odd && (i == 0 || j == 0 || 2 * i == nx || 2 * j == ny);
        quarter.push_back(is_zero ? 0 : some_value(i, j));
      }
    std::vector<double> transform = quarter;
    transform_quarter(c.columns, c.rows, c.parity, transform);
    for (int l = 0; l < c.rows; ++l)
      for (int k = 0; k < c.columns; ++k) {
        std::complex<double> sum = 0;
        for (int j = 0; j < ny; ++j)
          for (int i = 0; i < nx; ++i)
            sum += whole(quarter, c.columns, c.rows, c.parity, i, j) *
                   std::polar(1.0, -2 * M_PI * (double(i * k) / nx + double(j * l) / ny));
        EXPECT_NEAR(transform[static_cast<std::size_t>(l) * c.columns + k], sum.real(), 1e-12) << k << ' ' << l;
        EXPECT_NEAR(sum.imag(), 0, 1e-12);
      }
  }
}

} // namespace
} // namespace microslip
