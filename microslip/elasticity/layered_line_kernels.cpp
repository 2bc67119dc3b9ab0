#include "microslip/elasticity/layered_line_kernels.hpp"

#include "microslip/numerics/hankel_nodes.hpp"

#include <cmath>
#include <numbers>
#include <utility>

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

} // namespace

LayeredLineKernels::LayeredLineKernels(LayeredSpectrum spectrum, double thickness)
    : spectrum_(std::move(spectrum)), thickness_(thickness), table_(spectrum_, thickness), limit_(spectrum_.parts()),
      of_distance_(0, panel_width, kinds * spectrum_.parts()) {
  spectrum_.find_long(limit_);
}

void LayeredLineKernels::extend(double reach) {
  const double farthest = reach + thickness_;
  const std::size_t functions = kinds * parts();
  const PanelPolynomials::Values at_nodes = [&](std::span<const double, PanelPolynomials::nodes> t,
                                                std::span<double> values) {
    Responses responses(parts());
    const auto x = [&](double at) { return thickness_ * std::sinh(at); };
    for (const WaveNode& wave : hankel_nodes(x(t.front()), x(t.back()), 2 * table_.k_max())) {
      if (wave.wavenumber < table_.k_max())
        table_.find(wave.wavenumber, responses);
      else
        responses.assign(responses.size(), {});
      const double fade = std::exp(-wave.wavenumber * thickness_);
      for (std::size_t node = 0; node < t.size(); ++node)
        add_wave(wave, x(t[node]), responses, limit_, fade, values.data() + node * functions);
    }
    for (std::size_t node = 0; node < t.size(); ++node)
      add_limit(std::log(std::cosh(t[node])), limit_, values.data() + node * functions);
  };
  const double end = std::asinh(farthest / thickness_) + panel_width;
  table_.extend(spectrum_, thickness_ * std::sinh(end));
  of_distance_.extend(end - panel_width, at_nodes);
}

void LayeredLineKernels::evaluate(double x, double far, std::span<LineKernel> parts) const {
  static_assert(sizeof(LineKernel) == kinds * sizeof(double));
  of_distance_.evaluate(std::asinh(x / thickness_), {&parts[0].normal, kinds * parts.size()});
  const double nearer = std::log(far / thickness_) / std::numbers::pi;
  for (std::size_t m = 0; m < parts.size(); ++m) {
    parts[m].normal += nearer * limit_[m].nn;
    parts[m].along += nearer * limit_[m].ll;
    parts[m].across += nearer * limit_[m].tt;
  }
}

} // namespace microslip
