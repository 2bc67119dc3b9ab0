#include "validation/interior_integral.hpp"

#include "microslip/elasticity/interior_response.hpp"
#include "microslip/numerics/gauss_legendre.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace microslip::validation {
namespace {

using Complex = std::complex<double>;
using Response = InteriorResponse<Complex>;

double sine_ratio(double x) {
  return x == 0 ? 1 : std::sin(x) / x;
}

/// Panels of about 5 rad at a distance, halved towards 0, up to k z = 36.
std::vector<double> panel_ends(double depth, double distance) {
  const double end = 36 / depth;
  const int panels = static_cast<int>(end * distance / 5) + 4;
  std::vector<double> ends = {0};
  for (int n = 30; n > 0; --n) ends.push_back(end / panels * std::exp2(-n));
  for (int n = 1; n <= panels; ++n) ends.push_back(end * n / panels);
  return ends;
}

/// The whole response: in the surface's layer that is the half-space's and the rest.
std::vector<Response> whole_response(const LayerStack<Complex>& stack, const LayerDepth& at, double k) {
  std::vector<Response> terms = {interior_response(stack, at, k)};
  if (at.layer == 0) terms.push_back(interior_response(LayerStack<Complex>{{}, stack.top()}, at, k));
  return terms;
}

/// Components along the wave, across it and inwards, by one traction, turned into x, y, z.
struct WaveField {
  Complex ul, ut, un, ll, tt, nn, lt, ln, tn;

  InteriorState turned(const Complex& wave, double k, double c, double s) const {
    const auto real = [&](const Complex& value) { return (value * wave).real(); };
    return {real(ul * c - ut * s) / k,
            real(ul * s + ut * c) / k,
            real(un) / k,
            {real(ll * c * c + tt * s * s - 2 * c * s * lt), real(ll * s * s + tt * c * c + 2 * c * s * lt), real(nn),
             real((ll - tt) * c * s + lt * (c * c - s * s)), real(ln * c - tn * s), real(ln * s + tn * c)}};
  }
};

WaveField of_normal(const Response& r) {
  constexpr Complex i(0, 1);
  const auto& n = r.normal;
  return {i * n.l, 0, n.n, n.ll, n.tt, n.nn, 0, i * n.ln, 0};
}
/// Of tractions along the wave and across it.
WaveField of_tangential(const Response& r, double along, double across) {
  constexpr Complex i(0, 1);
  const auto& a = r.along; // of i along the wave
  return {a.l * along,       r.t * across,      -i * a.n * along, -i * a.ll * along, -i * a.tt * along,
          -i * a.nn * along, i * r.lt * across, a.ln * along,     r.tn * across};
}

} // namespace

InteriorInfluence interior_integral(const LayeredBody& body, double speed, const ElementSides& sides, double x,
                                    double y, double depth, int directions) {
  const GaussLegendre rule(16);
  const double dx = sides.dx, dy = sides.dy;
  const std::vector<double> ends = panel_ends(depth, std::hypot(x, y) + std::hypot(dx, dy));
  const LayerStack<Complex> at_rest = stack_at(body, 0);
  const LayerDepth at = layer_at(body, depth);
  InteriorInfluence sum;
  for (std::size_t p = 1; p < ends.size(); ++p)
    for (std::size_t n = 0; n < rule.count(); ++n) {
      const double k = rule.node(n, ends[p - 1], ends[p]);
      const double weight = k * rule.weight(n, ends[p - 1], ends[p]) * dx * dy / (2 * std::numbers::pi * directions);
      std::vector<Response> terms = whole_response(at_rest, at, k);
      for (int d = 0; d < directions; ++d) {
        const double angle = 2 * std::numbers::pi * d / directions, c = std::cos(angle), s = std::sin(angle);
        if (speed != 0) terms = whole_response(stack_at(body, -speed * k * c), at, k);
        const double element = sine_ratio(k * c * dx / 2) * sine_ratio(k * s * dy / 2);
        const Complex wave = weight * element * std::polar(1.0, k * (c * x + s * y));
        for (const Response& r : terms) {
          add(sum.px, 1, of_tangential(r, c, -s).turned(wave, k, c, s));
          add(sum.py, 1, of_tangential(r, s, c).turned(wave, k, c, s));
          add(sum.pn, 1, of_normal(r).turned(wave, k, c, s));
        }
      }
    }
  return sum;
}

} // namespace microslip::validation
