#include "microslip/elasticity/layered_line_kernels.hpp"

#include "microslip/elasticity/spectrum_table.hpp"
#include "microslip/numerics/hankel_nodes.hpp"

#include <cmath>
#include <numbers>

namespace microslip {
namespace {

constexpr std::size_t kinds = 4;    // of kernels
constexpr double panel_width = 0.5; // of asinh(x/h)

using Responses = std::vector<SurfaceResponse<double>>;

/// Adds a wave's contribution to the kernels at a distance; `limit` is that of long waves, faded by exp(-k h).
void add_wave(const WaveNode& wave, double x, const Responses& responses, const Responses& limit, double fade,
              double* kernels) {
  const double f = wave.weight / (std::numbers::pi * wave.wavenumber), angle = wave.wavenumber * x;
  const double c = f * std::cos(angle), s = f * std::sin(angle);
  for (std::size_t m = 0; m < responses.size(); ++m) {
    *kernels++ += c * (responses[m].nn - fade * limit[m].nn);
    *kernels++ += c * (responses[m].ll - fade * limit[m].ll);
    *kernels++ += c * (responses[m].tt - fade * limit[m].tt);
    *kernels++ -= s * responses[m].ln;
  }
}

void add_limit(double logarithm, const Responses& limit, double* kernels) {
  const double f = -logarithm / std::numbers::pi;
  for (const auto& [nn, ll, tt, ln] : limit) {
    kernels[0] += f * nn, kernels[1] += f * ll, kernels[2] += f * tt;
    kernels += kinds;
  }
}

PanelPolynomials kernels_of(const LayeredSpectrum& spectrum, double thickness, double reach, double far) {
  const double farthest = reach + thickness;
  const SpectrumTable table(spectrum, thickness, farthest);
  Responses limit(spectrum.parts());
  table.find_long(limit);
  const std::size_t functions = kinds * spectrum.parts();
  const PanelPolynomials::Values at_nodes = [&](std::span<const double, PanelPolynomials::nodes> t,
                                                std::span<double> values) {
    Responses responses(spectrum.parts());
    const auto x = [&](double at) { return thickness * std::sinh(at); };
    for (const WaveNode& wave : hankel_nodes(x(t.front()), x(t.back()), 2 * table.k_max())) {
      if (wave.wavenumber < table.k_max())
        table.find(wave.wavenumber, responses);
      else
        responses.assign(responses.size(), {});
      const double fade = std::exp(-wave.wavenumber * thickness);
      for (std::size_t node = 0; node < t.size(); ++node)
        add_wave(wave, x(t[node]), responses, limit, fade, values.data() + node * functions);
    }
    for (std::size_t node = 0; node < t.size(); ++node)
      add_limit(std::log(std::hypot(thickness, x(t[node])) / far), limit, values.data() + node * functions);
  };
  return {0, std::asinh(farthest / thickness), panel_width, functions, at_nodes};
}

} // namespace

LayeredLineKernels::LayeredLineKernels(const LayeredSpectrum& spectrum, double thickness, double reach, double far)
    : thickness_(thickness), parts_(spectrum.parts()), of_distance_(kernels_of(spectrum, thickness, reach, far)) {}

void LayeredLineKernels::evaluate(double x, std::span<LineKernel> parts) const {
  static_assert(sizeof(LineKernel) == kinds * sizeof(double));
  of_distance_.evaluate(std::asinh(x / thickness_), {&parts[0].normal, kinds * parts.size()});
}

} // namespace microslip
