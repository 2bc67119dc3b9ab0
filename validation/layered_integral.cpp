#include "validation/layered_integral.hpp"

#include "microslip/elasticity/layered_response.hpp"
#include "microslip/numerics/gauss_legendre.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace microslip::validation {
namespace {

using Complex = std::complex<double>;

double sine_ratio(double x) {
  return x == 0 ? 1 : std::sin(x) / x;
}

/// Panels of about 5 rad at a distance, halved towards 0, up to k h = 20.
std::vector<double> panel_ends(double thickness, double distance) {
  const double end = 20 / thickness;
  const int panels = static_cast<int>(end * distance / 5) + 4;
  std::vector<double> ends = {0};
  for (int n = 30; n > 0; --n) ends.push_back(end / panels * std::exp2(-n));
  for (int n = 1; n <= panels; ++n) ends.push_back(end * n / panels);
  return ends;
}

/// Displacements at (x, y) by a wave of unit weight along (c, s).
Influence wave_influence(const SurfaceResponse<Complex>& r, const Complex& wave, double c, double s) {
  const Complex turned = Complex(0, 1) * wave * r.ln;
  return {((r.ll * c * c + r.tt * s * s) * wave).real(),
          ((r.ll - r.tt) * c * s * wave).real(),
          ((r.ll * s * s + r.tt * c * c) * wave).real(),
          (r.nn * wave).real(),
          c * turned.real(),
          s * turned.real()};
}

} // namespace

Influence layered_integral(const LayeredBody& body, double speed, const ElementSides& sides, int i, int j,
                           int directions) {
  const GaussLegendre rule(16);
  const double dx = sides.dx, dy = sides.dy;
  const std::vector<double> ends =
      panel_ends(body.layers.front().thickness, std::hypot(i * dx, j * dy) + std::hypot(dx, dy));
  const LayerStack<Complex> at_rest = stack_at(body, 0);
  Influence sum{};
  for (std::size_t p = 1; p < ends.size(); ++p)
    for (std::size_t n = 0; n < rule.count(); ++n) {
      const double k = rule.node(n, ends[p - 1], ends[p]);
      const double weight = rule.weight(n, ends[p - 1], ends[p]) * dx * dy / (2 * std::numbers::pi * directions);
      SurfaceResponse<Complex> rest = rest_of_response(at_rest, k);
      for (int d = 0; d < directions; ++d) {
        const double angle = 2 * std::numbers::pi * d / directions, c = std::cos(angle), s = std::sin(angle);
        if (speed != 0) rest = rest_of_response(stack_at(body, -speed * k * c), k);
        double element = sine_ratio(k * c * dx / 2) * sine_ratio(k * s * dy / 2);
        if (sides.shape == ElementShape::bilinear) element *= element;
        add(sum, 1, wave_influence(rest, weight * element * std::polar(1.0, k * (c * i * dx + s * j * dy)), c, s));
      }
    }
  return sum;
}

} // namespace microslip::validation
