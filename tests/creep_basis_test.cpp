#include "microslip/elasticity/creep_basis.hpp"

#include "microslip/elasticity/layered_spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numeric>
#include <vector>

namespace microslip {
namespace {

using Complex = std::complex<double>;

LayeredBody polymer_on_steel() {
  return {{{1e-3, {{1e9, 0.4}, {{0.3, 1e-2}, {0.4, 2}}}}, {2e-3, {{5e9, 0.45}, {{0.9, 0.5}}, PronySeries{{0.2, 30}}}}},
          {{80e9, 0.3}}};
}
Complex creep_at(double omega, double time) {
  return 1.0 / Complex(1, omega * time);
}

TEST(CreepBasis, DescribesEveryTimeOfItsRangesAtEveryFrequency) {
  const LayeredBody body = {{{1e-3, {{1e9, 0.4}, {{0.75, 2}}}}}, {{80e9, 0.3}}}; // times from 2 s to 8 s
  const CreepBasis basis(body);
  std::vector<double> amounts(basis.times().size());
  for (const double time : {2.0, 2.5, 4.0, 7.9, 8.0}) {
    std::vector<Complex> creep;
    for (const double omega : basis.frequencies()) creep.push_back(creep_at(omega, time));
    basis.fit(creep, amounts);
    for (const double omega : {0.0, 1e-3, 0.07, 0.3, 0.91, 5.0, 77.0, 1e5}) {
      Complex sum = 0;
      for (std::size_t m = 0; m < amounts.size(); ++m) sum += amounts[m] * creep_at(omega, basis.times()[m]);
      EXPECT_LT(std::abs(sum - creep_at(omega, time)), 1e-9) << time << " s at " << omega << " rad/s";
    }
  }
}

TEST(CreepBasis, OfElasticBodiesIsEmpty) {
  EXPECT_TRUE(CreepBasis({{{1e-3, {{1e9, 0.4}}}}, {{80e9, 0.3}}}).times().empty());
}

TEST(LayeredSpectrum, OfViscoelasticStacksIsTheirResponseAtEveryFrequency) {
  const LayeredBody body = polymer_on_steel();
  const LayeredSpectrum spectrum(body);
  std::vector<SurfaceResponse<double>> parts(spectrum.parts());
  for (const double k : {1.0, 200.0, 1e3, 4e3}) {
    spectrum.find(k, parts);
    for (const double omega : {0.0, 0.01, 0.4, 6.0, -6.0, 300.0, 1e5}) {
      const SurfaceResponse<Complex> exact = rest_of_response(stack_at(body, omega), k);
      const auto sum = [&](auto part) {
        Complex of = parts[0].*part;
        for (std::size_t m = 1; m < parts.size(); ++m) of += parts[m].*part * creep_at(omega, spectrum.times()[m - 1]);
        return of;
      };
      const double scale = std::abs(response(stack_at(body, omega), k).nn);
      EXPECT_LT(std::abs(sum(&SurfaceResponse<double>::nn) - exact.nn), 5e-9 * scale) << k << " " << omega;
      EXPECT_LT(std::abs(sum(&SurfaceResponse<double>::ll) - exact.ll), 5e-9 * scale) << k << " " << omega;
      EXPECT_LT(std::abs(sum(&SurfaceResponse<double>::tt) - exact.tt), 5e-9 * scale) << k << " " << omega;
      EXPECT_LT(std::abs(sum(&SurfaceResponse<double>::ln) - exact.ln), 5e-9 * scale) << k << " " << omega;
    }
  }
}

} // namespace
} // namespace microslip
