#include "microslip/exact/fitted/edge_element.hpp"

#include "tests/support/expect_error.hpp"
#include "tests/support/numbers.hpp"
#include "validation/half_line.hpp"
#include "validation/studies.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using std::numbers::pi;
using Vector = std::vector<double>;

/// Gauss elimination without pivots, as the symmetric part of a rolling contact's matrix is positive definite.
Vector solve(std::vector<Vector> a, Vector b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = k + 1; i < n; ++i) {
      const double factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < n; ++j) a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) b[k] -= a[k][j] * b[j];
    b[k] /= a[k][k];
  }
  return b;
}

/// Carter's problem, contact on -1 < x < 1 with the bound sqrt(1 - x^2) and the kernel -ln|x|/pi, rolling along +x:
/// slip is growth of displacement minus 1 - alpha, the force pi/2 (1 - alpha^2). Elements in ascending order of x.
struct CarterRow {
  Vector left, right;

  /// Regular elements of width h up to `rear`, and a leading element from there to `front`.
  CarterRow(double h, double rear, double front) {
    const int regular = static_cast<int>(std::ceil((rear + 1) / h - 1e-9));
    for (int i = regular; i > 0; --i) {
      left.push_back(rear - i * h);
      right.push_back(rear - (i - 1) * h);
    }
    left.push_back(rear);
    right.push_back(front);
    end_ = front + h / 2;
  }

  double force(double alpha) const {
    const std::size_t n = left.size();
    Vector bound(n);
    for (std::size_t i = 0; i < n; ++i) bound[i] = (below_bound(right[i]) - below_bound(left[i])) / width(i);
    for (std::size_t sliding = 0;; ++sliding) {
      const Vector p = tractions(alpha, bound, sliding);
      double sum = 0;
      bool within = true;
      for (std::size_t i = 0; i < n; ++i) {
        sum += p[i] * width(i);
        within = within && p[i] <= bound[i] + 1e-12;
      }
      if (within) return sum;
    }
  }

private:
  /// The first `sliding` elements on the bound, no slip in the others.
  Vector tractions(double alpha, const Vector& bound, std::size_t sliding) const {
    const std::size_t n = left.size();
    std::vector<Vector> a(n - sliding, Vector(n - sliding));
    Vector b(n - sliding);
    for (std::size_t i = sliding; i < n; ++i) {
      const double x = centre(i), end = i + 1 < n ? centre(i + 1) : end_;
      b[i - sliding] = (1 - alpha) * (end - x);
      for (std::size_t j = 0; j < n; ++j) {
        const double growth = displacement(x, j) - displacement(end, j);
        if (j < sliding)
          b[i - sliding] -= growth * bound[j];
        else
          a[i - sliding][j - sliding] = growth;
      }
    }
    Vector p(bound.begin(), bound.begin() + static_cast<std::ptrdiff_t>(sliding));
    const Vector adhering = solve(a, b);
    p.insert(p.end(), adhering.begin(), adhering.end());
    return p;
  }

  double width(std::size_t i) const { return right[i] - left[i]; }
  double centre(std::size_t i) const { return (left[i] + right[i]) / 2; }

  double displacement(double x, std::size_t i) const {
    const auto antiderivative = [](double t) { return t == 0 ? 0 : t * std::log(std::abs(t)); };
    return (antiderivative(x - right[i]) - antiderivative(x - left[i])) / pi;
  }

  static double below_bound(double x) {
    const double t = std::clamp(x, -1.0, 1.0);
    return (t * std::sqrt(1 - t * t) + std::asin(t)) / 2;
  }

  double end_;
};

/// Relative to the exact force; the true edge lies `distance` h from the leading element's rear side.
double carter_error(int n, double alpha, double distance, bool fitted) {
  const double h = 2.0 / n, rear = 1 - distance * h;
  const double front = fitted ? rear + leading_element_width(distance) * h : 1;
  return CarterRow(h, rear, front).force(alpha) / (pi / 2 * (1 - alpha * alpha)) - 1;
}

constexpr std::array edge_distances = {0.93, 1.18, 1.43, 1.68, 1.93};

/// Root mean square of the errors over three creepages. Where the edge of slip lies within its element changes the size
/// of an error of second order, up to its sign; hence means.
double mean_carter_error(int n, double distance, bool fitted) {
  double sum = 0;
  for (const double alpha : {0.2, 0.5, 0.8}) sum += std::pow(carter_error(n, alpha, distance, fitted), 2) / 3;
  return std::sqrt(sum);
}

TEST(EdgeElement, CarterIsOfFirstOrderWithLeadingElementsThatEndAtTheEdge) {
  for (const double distance : edge_distances)
    EXPECT_NEAR(std::log2(mean_carter_error(16, distance, false) / mean_carter_error(128, distance, false)) / 3, 1,
                0.05)
        << distance;
}

TEST(EdgeElement, CarterIsOfSecondOrderWithFittedOnes) {
  double coarse = 0, fine = 0;
  for (const double distance : edge_distances) {
    coarse += std::pow(mean_carter_error(16, distance, true), 2);
    fine += std::pow(mean_carter_error(128, distance, true), 2);
  }
  EXPECT_GT(std::log2(coarse / fine) / 6, 1.8);
}

/// For alpha = 1/2 the edge of slip, at x = 0, lies at the same point within its element on all these grids.
TEST(EdgeElement, CarterIsOfSecondOrderForEachPlaceOfTheEdge) {
  for (const double distance : edge_distances)
    EXPECT_GT(carter_error(32, 0.5, distance, true) / carter_error(128, 0.5, distance, true), 15) << distance;
}

TEST(EdgeElement, CarterOn64ElementsIsWithinTwoTenThousandths) {
  for (const double distance : edge_distances)
    for (const double alpha : {0.2, 0.5, 0.8}) {
      EXPECT_LT(std::abs(carter_error(64, alpha, distance, true)), 2e-4) << distance << ' ' << alpha;
      EXPECT_GT(carter_error(64, alpha, distance, false), 5e-3) << distance << ' ' << alpha;
    }
}

TEST(EdgeElement, InsetIsThatOfTheHalfLine) {
  const validation::HalfLine line(0.25);
  for (int i = 0; i <= 65; ++i) {
    const double omega = std::lerp(narrowest_leading_element, widest_leading_element, i / 65.0);
    EXPECT_NEAR(edge_inset(omega), line.distance(omega) - omega, 1e-9) << omega;
  }
}

TEST(EdgeElement, StudyMeetsItsFigures) {
  std::ostringstream out;
  EXPECT_TRUE(validation::run_edge_constants({}, out)) << out.str();
}

TEST(EdgeElement, HalfLineWithARegularLeadingElementIsAHalfLine) {
  const validation::HalfLine line(0.25);
  EXPECT_NEAR(line.distance(1), 1 + line.full_width_inset(), 1e-13);
}

TEST(EdgeElement, QuadraturesOfTheHalfLineHaveConverged) {
  const validation::HalfLine line(0.25), finer(0.15);
  for (const double omega : {0.4, 0.8, 1.3, 1.7})
    EXPECT_NEAR(line.distance(omega), finer.distance(omega), 1e-13) << omega;
}

TEST(EdgeElement, WidthInvertsTheDistanceAndGrowsWithIt) {
  double last = 0;
  for (int i = 0; i <= 1300; ++i) {
    const double omega = std::lerp(narrowest_leading_element, widest_leading_element, i / 1300.0);
    const double width = leading_element_width(edge_distance(omega));
    EXPECT_NEAR(width, omega, 2e-15);
    EXPECT_GT(width, last);
    last = width;
  }
}

TEST(EdgeElement, EveryPlaceOfTheEdgeHasALeadingElement) {
  EXPECT_GT(edge_distance(widest_leading_element) - edge_distance(narrowest_leading_element), 1);
}

TEST(EdgeElement, RefusesWhatIsOutOfRange) {
  for (const double omega : {0.39, 1.71, nan}) {
    expect_error([=] { edge_inset(omega); }, "omega", "[-]: must be in [0.4, 1.7]");
    expect_error([=] { edge_distance(omega); }, "omega", "[-]: must be in [0.4, 1.7]");
  }
  for (const double distance : {0.72, 2.07, nan})
    expect_error([=] { leading_element_width(distance); }, "distance", "[-]: must be in [0.7215");
}

} // namespace
} // namespace microslip
