#include "validation/rolling_without_slip.hpp"

#include "microslip/error.hpp"

#include <cmath>
#include <complex>
#include <cstdlib>
#include <numbers>
#include <vector>

namespace microslip::validation {
namespace {

using Complex = std::complex<double>;
using Vector = std::vector<Complex>;
constexpr double pi = std::numbers::pi;
constexpr Complex i_unit = {0, 1};

/// Solves A x = r for several right-hand sides, by Gauss's elimination without pivots: A is positive definite.
template <class Number>
void solve_in_place(std::vector<std::vector<Number>>& a, std::vector<std::vector<Number>>& sides) {
  const std::size_t n = a.size();
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = k + 1; i < n; ++i) {
      const Number factor = a[i][k] / a[k][k];
      for (std::size_t j = k + 1; j < n; ++j) a[i][j] -= factor * a[k][j];
      for (auto& side : sides) side[i] -= factor * side[k];
    }
  for (auto& side : sides)
    for (std::size_t k = n; k-- > 0;) {
      for (std::size_t j = k + 1; j < n; ++j) side[k] -= a[k][j] * side[j];
      side[k] /= a[k][k];
    }
}

/// Fourier coefficients of k_xx, k_xy, k_yy over the directions of the lines' normals, c = sqrt(a b) = 1, G = 1.
class Kernel {
public:
  Kernel(double a, double b, double nu, int harmonics) : xx_(harmonics + 1), xy_(harmonics + 1), yy_(harmonics + 1) {
    const int samples = 4 * harmonics + 2048; // the slenderest ellipse's series falls as 0.98^harmonic
    for (int s = 0; s < samples; ++s) {
      const double w = 2 * pi * s / samples, c = std::cos(w), d = std::sin(w);
      // A line with the normal w on the disk has the direction (-a d, b c) on the ellipse.
      const double rho2 = a * a * d * d + b * b * c * c, scale = a * b / (pi * std::sqrt(rho2) * samples);
      for (int m = 0; m <= harmonics; ++m) {
        const Complex wave = scale * std::polar(1.0, -2 * pi * (m * s % samples) / samples);
        xx_[m] += wave * (1 - nu + nu * a * a * d * d / rho2);
        xy_[m] -= wave * (nu * a * b * d * c / rho2);
        yy_[m] += wave * (1 - nu + nu * b * b * c * c / rho2);
      }
    }
  }

  Complex xx(int m) const { return at(xx_, m); }
  Complex xy(int m) const { return at(xy_, m); }
  Complex yy(int m) const { return at(yy_, m); }

private:
  static Complex at(const Vector& series, int m) { return m < 0 ? std::conj(series[-m]) : series[m]; }

  Vector xx_, xy_, yy_;
};

/// A displacement field as its component and ridge functions: u_component = sum of share P_n(x cos w + y sin w).
struct Ridge {
  int component; ///< 0: u_x, 1: u_y
  double share, direction;
};

/// The harmonics of a field of degree n: those of the delta functions in w that make it up, as far as they count.
Vector harmonics_of(int n, const std::vector<Ridge>& field) {
  Vector side(2 * static_cast<std::size_t>(n + 1));
  for (const Ridge& r : field)
    for (int k = 0; k <= n; ++k)
      side[r.component * (n + 1) + k] += r.share / pi * std::polar(1.0, -(2 * k - n) * r.direction);
  return side;
}

/// The integrals g_jn of the tractions that make these displacements of degree n.
void find_tractions(const Kernel& kernel, int n, std::vector<Vector>& sides) {
  const std::size_t half = n + 1;
  std::vector<Vector> matrix(2 * half, Vector(2 * half));
  for (std::size_t l = 0; l < half; ++l)
    for (std::size_t m = 0; m < half; ++m) {
      const int difference = 2 * (static_cast<int>(l) - static_cast<int>(m));
      matrix[l][m] = kernel.xx(difference);
      matrix[l][half + m] = matrix[half + l][m] = kernel.xy(difference);
      matrix[half + l][half + m] = kernel.yy(difference);
    }
  solve_in_place(matrix, sides);
}

/// One solution of w = du/dx: tractions at the leading edge, and what they sum up to.
struct Field {
  std::vector<double> edge; ///< P_x and P_y at points of the leading edge, weighted
  double fx = 0, fy = 0, mz = 0;
};

/// Adds the part of degree n with the integrals g_jn.
void add(Field& field, int n, const Vector& g, double a, double b) {
  const int points = static_cast<int>(field.edge.size() / 2);
  for (int p = 0; p < points; ++p) {
    const double w = pi * ((p + 0.5) / points - 0.5);
    for (int j = 0; j < 2; ++j)
      for (int k = 0; k <= n; ++k)
        field.edge[j * points + p] += std::cos(w) * std::real(g[j * (n + 1) + k] * std::polar(1.0, (2 * k - n) * w));
  }
  // The integrals of P_0 and s P_1 over s are 2 and 2/3; those of s^0 and s^1 with higher degrees are none.
  if (n == 0) field.fx = 2 * a * b * g[0].real(), field.fy = 2 * a * b * g[1].real();
  if (n == 1) {
    const double x_py = std::real(g[2] + g[3]), y_px = std::real(i_unit * (g[1] - g[0]));
    field.mz = 2.0 / 3 * a * b * (a * x_py - b * y_px);
  }
}

/// Factors of the free fields with which `driven` vanishes along the leading edge as closely as can be.
std::vector<double> fit(const std::vector<Field>& free, const Field& driven) {
  const std::size_t n = free.size();
  const auto product = [](const Field& f, const Field& g) {
    double sum = 0;
    for (std::size_t p = 0; p < f.edge.size(); ++p) sum += f.edge[p] * g.edge[p];
    return sum;
  };
  std::vector<std::vector<double>> matrix(n, std::vector<double>(n));
  std::vector<std::vector<double>> side(1, std::vector<double>(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) matrix[i][j] = matrix[j][i] = product(free[i], free[j]);
    side[0][i] = -product(free[i], driven);
  }
  solve_in_place(matrix, side);
  return side[0];
}

} // namespace

LinearCoefficients rolling_without_slip(double a_over_b, double nu, int degree) {
  require_between("a_over_b", a_over_b, "-", 0.01, 100);
  require_between("poisson_ratio", nu, "-", 0, 0.5);
  require_count("degree", degree, 2, 200);
  const double a = std::sqrt(a_over_b), b = 1 / a;
  const Kernel kernel(a, b, nu, 2 * degree);
  const Field nothing = {std::vector<double>(8 * static_cast<std::size_t>(degree + 1)), 0, 0, 0};
  // x = P_1 along x; x y and x^2 are of degree 2, but for a constant.
  const std::vector<Ridge> by_xi = {{0, a, 0}}, by_eta = {{1, a, 0}},
                           by_phi = {{0, -a * b / 3, pi / 4}, {0, a * b / 3, 3 * pi / 4}, {1, a * a / 3, 0}};
  std::vector<Field> free;
  Field xi = nothing, eta = nothing, phi = nothing;
  for (int n = 0; n <= degree; ++n) {
    std::vector<Vector> sides = {harmonics_of(n, {{0, 1, pi / 2}}), harmonics_of(n, {{1, 1, pi / 2}})};
    if (n == 1) sides.push_back(harmonics_of(n, by_xi)), sides.push_back(harmonics_of(n, by_eta));
    if (n == 2) sides.push_back(harmonics_of(n, by_phi));
    find_tractions(kernel, n, sides);
    for (int component = 0; component < 2; ++component) {
      free.push_back(nothing);
      add(free.back(), n, sides[component], a, b);
    }
    if (n == 1) add(xi, n, sides[2], a, b), add(eta, n, sides[3], a, b);
    if (n == 2) add(phi, n, sides[2], a, b);
  }
  for (Field* driven : {&xi, &eta, &phi}) {
    const auto factors = fit(free, *driven);
    for (std::size_t k = 0; k < free.size(); ++k) {
      driven->fx += factors[k] * free[k].fx;
      driven->fy += factors[k] * free[k].fy;
      driven->mz += factors[k] * free[k].mz;
    }
  }
  return {-xi.fx, -eta.fy, -phi.fy, -eta.mz, -phi.mz};
}

} // namespace microslip::validation
