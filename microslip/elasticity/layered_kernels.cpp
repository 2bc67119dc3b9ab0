#include "microslip/elasticity/layered_kernels.hpp"

#include "microslip/numerics/hankel_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace microslip {
namespace {

constexpr std::size_t kinds = 4;      // of responses and of kernels
constexpr double decay_angle = 20;    // k h, where exp(-2 k h) (k h)^2 is below rounding
constexpr double panel_width = 0.5;   // of asinh(r/h)
constexpr double wave_width = 0.35;   // of ln k: soft layers between stiff ones turn quickly
constexpr double longest_wave = 1e10; // in units of the reach: there k times the response is constant

/// The responses of all parts as functions of ln k, index kinds part + (nn, ll, tt, ln).
PanelPolynomials table_of(const LayeredSpectrum& spectrum, double k_min, double k_max) {
  const std::size_t parts = spectrum.parts();
  const PanelPolynomials::Values at_nodes = [&](std::span<const double, PanelPolynomials::nodes> ln_k,
                                                std::span<double> values) {
    std::vector<SurfaceResponse<double>> rest(parts);
    for (std::size_t node = 0; node < ln_k.size(); ++node) {
      spectrum.find(std::exp(ln_k[node]), rest);
      double* to = values.data() + node * kinds * parts;
      for (const auto& [nn, ll, tt, ln] : rest) *to++ = nn, *to++ = ll, *to++ = tt, *to++ = ln;
    }
  };
  return {std::log(k_min), std::log(k_max), wave_width, kinds * parts, at_nodes};
}

/// Adds a wave's contribution to the kernels at a distance.
void add_wave(const WaveNode& wave, double r, std::span<const double> responses, double* kernels) {
  const double angle = wave.wavenumber * r, f = wave.weight / (2 * std::numbers::pi);
  const double j0 = ::j0(angle), j1 = ::j1(angle), j2 = angle > 0 ? 2 * j1 / angle - j0 : 0;
  for (std::size_t p = 0; p < responses.size(); p += kinds) {
    const double nn = responses[p], ll = responses[p + 1], tt = responses[p + 2], ln = responses[p + 3];
    kernels[p] += f * nn * j0;
    kernels[p + 1] += f * (ll + tt) / 2 * j0;
    kernels[p + 2] -= f * (ll - tt) / 2 * j2;
    kernels[p + 3] -= f * ln * j1;
  }
}

PanelPolynomials kernels_of(const LayeredSpectrum& spectrum, double thickness, double reach) {
  const double k_max = decay_angle / thickness, farthest = reach + thickness;
  const PanelPolynomials table = table_of(spectrum, 1 / (longest_wave * farthest), k_max);
  const std::size_t functions = kinds * spectrum.parts();
  const PanelPolynomials::Values at_nodes = [&](std::span<const double, PanelPolynomials::nodes> t,
                                                std::span<double> values) {
    std::vector<double> responses(functions);
    const auto r = [&](double at) { return thickness * std::sinh(at); };
    for (const WaveNode& wave : hankel_nodes(r(t.front()), r(t.back()), k_max)) {
      table.evaluate(std::log(wave.wavenumber), responses);
      for (std::size_t node = 0; node < t.size(); ++node)
        add_wave(wave, r(t[node]), responses, values.data() + node * functions);
    }
  };
  return {0, std::asinh(farthest / thickness), panel_width, functions, at_nodes};
}

} // namespace

LayeredKernels::LayeredKernels(const LayeredSpectrum& spectrum, double thickness, double reach)
    : thickness_(thickness), times_(spectrum.times().begin(), spectrum.times().end()),
      of_distance_(kernels_of(spectrum, thickness, reach)) {}

void LayeredKernels::evaluate(double r, std::span<PointKernel> parts) const {
  static_assert(sizeof(PointKernel) == kinds * sizeof(double));
  of_distance_.evaluate(std::asinh(r / thickness_), {&parts[0].normal, kinds * parts.size()});
}

} // namespace microslip
