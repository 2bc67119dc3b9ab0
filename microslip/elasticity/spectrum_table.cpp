#include "microslip/elasticity/spectrum_table.hpp"

#include <cmath>

namespace microslip {
namespace {

constexpr std::size_t kinds = 4;      // of responses
constexpr double decay_angle = 20;    // k h, where exp(-2 k h) (k h)^2 is below rounding
constexpr double wave_width = 0.35;   // of ln k: soft layers between stiff ones turn quickly
constexpr double longest_wave = 2e12; // in units of the reach: what hankel_nodes asks for

} // namespace

SpectrumTable::SpectrumTable(const LayeredSpectrum& spectrum, double thickness)
    : k_max_(decay_angle / thickness), of_length_(-std::log(k_max_), wave_width, kinds * spectrum.parts()) {}

void SpectrumTable::extend(const LayeredSpectrum& spectrum, double reach) {
  const PanelPolynomials::Values at_nodes = [&](std::span<const double, PanelPolynomials::nodes> length,
                                                std::span<double> values) {
    std::vector<SurfaceResponse<double>> rest(spectrum.parts());
    for (std::size_t node = 0; node < length.size(); ++node) {
      spectrum.find(std::exp(-length[node]), rest);
      double* to = values.data() + node * kinds * rest.size();
      for (const auto& [nn, ll, tt, ln] : rest) *to++ = nn, *to++ = ll, *to++ = tt, *to++ = ln;
    }
  };
  of_length_.extend(std::log(longest_wave * reach), at_nodes);
}

void SpectrumTable::find(double k, std::span<SurfaceResponse<double>> rest) const {
  static_assert(sizeof(SurfaceResponse<double>) == kinds * sizeof(double));
  of_length_.evaluate(-std::log(k), {&rest[0].nn, kinds * rest.size()});
}

} // namespace microslip
