#include "microslip/elasticity/spectrum_table.hpp"

#include <cmath>

namespace microslip {
namespace {

constexpr std::size_t kinds = 4;      // of responses
constexpr double decay_angle = 20;    // k h, where exp(-2 k h) (k h)^2 is below rounding
constexpr double wave_width = 0.35;   // of ln k: soft layers between stiff ones turn quickly
constexpr double longest_wave = 1e10; // in units of the reach

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

} // namespace

SpectrumTable::SpectrumTable(const LayeredSpectrum& spectrum, double thickness, double reach)
    : k_max_(decay_angle / thickness), of_logarithm_(table_of(spectrum, 1 / (longest_wave * reach), k_max_)) {}

void SpectrumTable::find(double k, std::span<SurfaceResponse<double>> rest) const {
  static_assert(sizeof(SurfaceResponse<double>) == kinds * sizeof(double));
  of_logarithm_.evaluate(std::log(k), {&rest[0].nn, kinds * rest.size()});
}

} // namespace microslip
