#include "microslip/elasticity/layered_kernels.hpp"

#include "microslip/numerics/bessel.hpp"
#include "microslip/numerics/hankel_nodes.hpp"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace microslip {
namespace {

constexpr std::size_t kinds = 4;    // of kernels
constexpr double panel_width = 0.5; // of asinh(r/h)

/// Adds a wave's contribution to the kernels at a distance.
void add_wave(const WaveNode& wave, double r, std::span<const SurfaceResponse<double>> responses, double* kernels) {
  const double f = wave.weight / (2 * std::numbers::pi);
  const auto [j0, j1, j2] = bessel_functions(wave.wavenumber * r);
  for (const auto& [nn, ll, tt, ln] : responses) {
    *kernels++ += f * nn * j0;
    *kernels++ += f * (ll + tt) / 2 * j0;
    *kernels++ -= f * (ll - tt) / 2 * j2;
    *kernels++ -= f * ln * j1;
  }
}

} // namespace

LayeredKernels::LayeredKernels(LayeredSpectrum spectrum, double thickness)
    : spectrum_(std::move(spectrum)), thickness_(thickness), table_(spectrum_, thickness),
      of_distance_(0, panel_width, kinds * spectrum_.parts()) {}

LayeredKernels::LayeredKernels(LayeredSpectrum spectrum, double thickness, double reach)
    : LayeredKernels(std::move(spectrum), thickness) {
  extend(reach);
}

void LayeredKernels::extend(double reach) {
  const double farthest = reach + thickness_;
  const std::size_t functions = kinds * parts();
  const PanelPolynomials::Values at_nodes = [&](std::span<const double, PanelPolynomials::nodes> t,
                                                std::span<double> values) {
    std::vector<SurfaceResponse<double>> responses(parts());
    const auto r = [&](double at) { return thickness_ * std::sinh(at); };
    for (const WaveNode& wave : hankel_nodes(r(t.front()), r(t.back()), table_.k_max())) {
      table_.find(wave.wavenumber, responses);
      for (std::size_t node = 0; node < t.size(); ++node)
        add_wave(wave, r(t[node]), responses, values.data() + node * functions);
    }
  };
  const double end = std::asinh(farthest / thickness_) + panel_width;
  table_.extend(spectrum_, thickness_ * std::sinh(end));
  of_distance_.extend(end - panel_width, at_nodes);
}

void LayeredKernels::evaluate(double r, std::span<PointKernel> parts) const {
  static_assert(sizeof(PointKernel) == kinds * sizeof(double));
  of_distance_.evaluate(std::asinh(r / thickness_), {&parts[0].normal, kinds * parts.size()});
}

} // namespace microslip
