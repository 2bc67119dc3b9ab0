#include "microslip/exact/fitted/centred_operator.hpp"

#include "microslip/exact/fitted/fitted_operator.hpp"
#include "tests/support/steel.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using Field = std::vector<double>;

struct Contact {
  FittedContact fitted = fit_ellipse(6e-3, 4e-3, 12, 10);
  std::size_t n = fitted.elements.size();
  std::vector<char> sliding = std::vector<char>(n);
  Field px = Field(n), py = Field(n);

  Contact() {
    for (std::size_t k = 0; k < n; ++k) {
      sliding[k] = k % 3 != 0;
      px[k] = std::sin(1.3 * double(k)), py[k] = std::cos(0.7 * double(k));
    }
  }
};

TEST(CentredOperator, MovesTheSlipToTheCentres) {
  const Contact c;
  FittedOperator d(steel, c.fitted);
  CentredSlip<double> at_centres(c.fitted, c.sliding);
  CentredOperator centred(d, at_centres);
  Field sx(c.n), sy(c.n), moved_x(c.n), moved_y(c.n);
  d.apply(c.px, c.py, sx, sy);
  at_centres.move(sx);
  at_centres.move(sy);
  centred.apply(c.px, c.py, moved_x, moved_y);
  EXPECT_EQ(moved_x, sx);
  EXPECT_EQ(moved_y, sy);
  EXPECT_EQ(centred.diagonal(), d.diagonal());
  EXPECT_EQ(centred.products(), 2);
}

/// M^-1 (2 - T), as often as it is asked for.
TEST(CentredOperator, PreconditionsWhatIsNearlyMovedBack) {
  const Contact c;
  FittedOperator d(steel, c.fitted);
  CentredSlip<double> at_centres(c.fitted, c.sliding);
  CentredOperator centred(d, at_centres);
  Field undone_x = c.px, undone_y = c.py, qx(c.n), qy(c.n), of_centred_x(c.n), of_centred_y(c.n);
  at_centres.nearly_undo(undone_x);
  at_centres.nearly_undo(undone_y);
  ASSERT_TRUE(d.precondition(undone_x, undone_y, qx, qy));
  for (int time = 0; time < 2; ++time) {
    ASSERT_TRUE(centred.precondition(c.px, c.py, of_centred_x, of_centred_y));
    EXPECT_EQ(of_centred_x, qx);
    EXPECT_EQ(of_centred_y, qy);
  }
  EXPECT_EQ(centred.products(), 0);
}

/// M is near rho times the operator, so that products with both are near the tractions: much nearer than rho D alone.
TEST(CentredOperator, ThePreconditionerIsNearItsInverse) {
  const Contact c;
  FittedOperator d(steel, c.fitted);
  CentredOperator centred(d, CentredSlip<double>(c.fitted, c.sliding));
  Field qx(c.n), qy(c.n), sx(c.n), sy(c.n), plain_x(c.n), plain_y(c.n);
  ASSERT_TRUE(centred.precondition(c.px, c.py, qx, qy));
  centred.apply(qx, qy, sx, sy);
  centred.apply(c.px, c.py, plain_x, plain_y);
  // The angle between p and what comes of it.
  const auto cosine = [&](const Field& x, const Field& y) {
    double product = 0, own = 0, other = 0;
    for (std::size_t k = 0; k < c.n; ++k) {
      product += c.px[k] * x[k] + c.py[k] * y[k];
      own += c.px[k] * c.px[k] + c.py[k] * c.py[k];
      other += x[k] * x[k] + y[k] * y[k];
    }
    return product / std::sqrt(own * other);
  };
  EXPECT_GT(cosine(sx, sy), 0.9);
  EXPECT_GT(cosine(sx, sy), cosine(plain_x, plain_y));
}

} // namespace
} // namespace microslip
