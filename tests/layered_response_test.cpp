#include "microslip/elasticity/layered_response.hpp"

#include "microslip/numerics/elimination.hpp"
#include "validation/layer_on_half_space.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

namespace microslip {
namespace {

using Complex = std::complex<double>;
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr Material steel_like{80e9, 0.3};

LayeredBody body_of(std::vector<BodyLayer> layers, const Material& substrate) {
  return {std::move(layers), {substrate}};
}
SurfaceResponse<double> response_of(const LayeredBody& body, double k) {
  return response(instantaneous_stack(body), k);
}
std::vector<double> wavenumbers(double low, double high, int count) {
  std::vector<double> k;
  for (int n = 0; n < count; ++n) k.push_back(low * std::pow(high / low, n / (count - 1.0)));
  return k;
}
void expect_near(const SurfaceResponse<double>& a, const SurfaceResponse<double>& b, double tolerance) {
  const double scale = std::max({std::abs(b.nn), std::abs(b.ll), std::abs(b.tt)});
  EXPECT_NEAR(a.nn / scale, b.nn / scale, tolerance);
  EXPECT_NEAR(a.ll / scale, b.ll / scale, tolerance);
  EXPECT_NEAR(a.tt / scale, b.tt / scale, tolerance);
  EXPECT_NEAR(a.ln / scale, b.ln / scale, tolerance);
}

/// U, W, T, S at the depth z of the four waves of a layer of thickness h, and displacements of the surface found from
/// the equations of all interfaces at once: continuity, or nothing moves on a rigid core, and the surface's tractions.
struct AllInterfaces {
  using Wave = std::array<double, 4>;
  static std::array<Wave, 4> waves(const Material& m, double k, double z, double h) {
    const double q = k * z, e = std::exp(-q), up = std::exp(k * (z - h)), nu = m.poisson_ratio, g = m.shear_modulus * k;
    return {Wave{e, -e, -2 * g * e, 2 * g * e},
            Wave{-q * e, (3 - 4 * nu + q) * e, g * (2 - 4 * nu + 2 * q) * e, -g * (4 - 4 * nu + 2 * q) * e},
            Wave{up, up, 2 * g * up, 2 * g * up},
            Wave{-q * up, (3 - 4 * nu - q) * up, g * (2 - 4 * nu - 2 * q) * up, g * (4 - 4 * nu - 2 * q) * up}};
  }

  AllInterfaces(const LayeredBody& body, double k) {
    const std::size_t layers = body.layers.size();
    const bool rigid = body.substrate.is_rigid();
    const std::size_t n = 4 * layers + (rigid ? 0 : 2), width = n + 2;
    std::vector<double> rows(n * width);
    const auto set = [&](std::size_t row, std::size_t column, double sign, const Wave& wave, std::size_t from,
                         std::size_t count) {
      for (std::size_t c = 0; c < count; ++c) rows[(row + c) * width + column] += sign * wave[from + c];
    };
    const auto waves_of = [&](std::size_t layer, double z) {
      if (layer == layers) return waves(body.substrate.instantaneous, k, 0, 0);
      return waves(body.layers[layer].material.instantaneous, k, z, body.layers[layer].thickness);
    };
    for (std::size_t w = 0; w < (layers == 0 ? 2 : 4); ++w) set(0, w, 1, waves_of(0, 0)[w], 2, 2);
    for (std::size_t j = 0; j < layers; ++j) {
      const bool last = j + 1 == layers;
      const std::size_t count = last && rigid ? 2 : 4;
      for (std::size_t w = 0; w < 4; ++w)
        set(2 + 4 * j, 4 * j + w, 1, waves_of(j, body.layers[j].thickness)[w], 0, count);
      if (count == 4)
        for (std::size_t w = 0; w < (last ? 2 : 4); ++w)
          set(2 + 4 * j, 4 * (j + 1) + w, -1, waves_of(j + 1, 0)[w], 0, 4);
    }
    rows[width + n] = -1; // sigma_nn = -p_n
    rows[n + 1] = 1;      // sigma_ln = i, that is p_l = -i
    EXPECT_TRUE(eliminate(rows, n, 2));
    for (std::size_t w = 0; w < (layers == 0 ? 2 : 4); ++w) {
      const Wave wave = waves_of(0, 0)[w];
      for (std::size_t side = 0; side < 2; ++side) {
        u[side] += k * wave[0] * rows[w * width + n + side];
        v[side] += k * wave[1] * rows[w * width + n + side];
      }
    }
  }

  std::array<double, 2> u{}, v{}; ///< k U and k W from p_n = 1 and from T = 1
};

const std::vector<LayeredBody> stacks = {
    body_of({{1e-3, {steel_like}}}, {30e9, 0.25}),
    body_of({{1e-3, {steel_like}}}, {infinite, 0}),
    body_of({{2e-3, {{1e9, 0.5}}}}, {infinite, 0}),
    body_of({{1e-3, {{80e9, 0.3}}}, {2e-3, {{240e9, 0.4}}}, {0.5e-3, {{8e9, 0.5}}}}, {80e9, 0.2}),
};

TEST(LayeredResponse, IsTheSolutionOfTheEquationsOfAllInterfaces) {
  for (const LayeredBody& body : stacks)
    for (const double k : wavenumbers(100, 2e4, 9)) {
      const AllInterfaces all(body, k);
      const SurfaceResponse<double> found = response_of(body, k);
      const double scale = std::abs(found.nn) + std::abs(found.ll);
      EXPECT_NEAR(found.nn / scale, all.v[0] / scale, 1e-6);
      EXPECT_NEAR(found.ln / scale, all.u[0] / scale, 1e-6);
      EXPECT_NEAR(found.ll / scale, -all.u[1] / scale, 1e-6);
      EXPECT_NEAR(found.ln / scale, -all.v[1] / scale, 1e-6); // Betti's reciprocity
    }
}

TEST(LayeredResponse, EqualLayersAreAHalfSpace) {
  const LayeredBody layers = body_of({{1e-3, {steel_like}}, {3e-3, {steel_like}}, {0.2e-3, {steel_like}}}, steel_like);
  for (const double k : wavenumbers(1e-3, 1e6, 30))
    expect_near(response_of(layers, k), response_of(body_of({}, steel_like), k), 1e-14);
}

TEST(LayeredResponse, ALayerOnAHalfSpaceIsThatOfLiAndOthers) {
  const validation::YoungMaterial layer = {100e9, 0.3}, base = {200e9, 0.25}, soft = {3e9, 0.48};
  for (const auto& [top, below] : {std::pair{layer, base}, {base, layer}, {soft, base}, {base, soft}}) {
    const LayeredBody body = body_of({{1e-3, {Material::from_young(top.young_modulus, top.poisson_ratio)}}},
                                     Material::from_young(below.young_modulus, below.poisson_ratio));
    for (const double k : wavenumbers(1, 1e5, 40)) {
      const double closed = validation::layer_on_half_space(top, 1e-3, below, k);
      EXPECT_NEAR(response_of(body, k).nn / closed, 1, 1e-11) << k;
    }
  }
}

TEST(LayeredResponse, OfLongWavesALayerOnARigidCoreIsABedOfSprings) {
  const double e = 100e9, nu = 0.3, h = 1e-3, k = 0.01, g = e / (2 * (1 + nu));
  const SurfaceResponse<double> found = response_of(body_of({{h, {{g, nu}}}}, {infinite, 0}), k);
  EXPECT_NEAR(found.nn / k / (h * (1 + nu) * (1 - 2 * nu) / (e * (1 - nu))), 1, 1e-8);
  EXPECT_NEAR(found.ll / k / (h / g), 1, 1e-8);
  EXPECT_NEAR(found.tt / k / (h / g), 1, 1e-8);
}

TEST(LayeredResponse, AnIncompressibleLayerOnARigidCoreGivesWayAsTheCubeOfItsThickness) {
  const double g = 1e9, h = 1e-3, k = 5; // k h = 0.005: u_n = h^3 k^2/(3 G) p_n of a thin film
  const SurfaceResponse<double> found = response_of(body_of({{h, {{g, 0.5}}}}, {infinite, 0}), k);
  EXPECT_NEAR(found.nn / k / (h * h * h * k * k / (3 * g)), 1, 1e-4);
}

TEST(LayeredResponse, LongWavesSeeTheSubstrateAndShortOnesTheSurface) {
  for (const LayeredBody& body : {stacks[0], stacks[3]}) {
    const LayeredBody deep{{}, body.substrate}, surface{{}, body.layers[0].material};
    expect_near(response_of(body, 1e-6), response_of(deep, 1e-6), 1e-7);
    expect_near(response_of(body, 5e4), response_of(surface, 5e4), 1e-14);
  }
}

TEST(LayeredResponse, TheRestIsFoundWithoutCancellation) {
  // At k h = 16 it is 1e-12 of the response; of a half-space of other material on the other side the next reflections
  // are exp(-2 k h) smaller, so that its ratio to that of k h = 17 is known.
  const LayerStack<double> stack = instantaneous_stack(stacks[1]);
  const auto across = [&](double k) { return rest_of_response(stack, k).tt; };
  EXPECT_NEAR(across(16e3) / across(17e3), std::exp(2), 1e-11);
  EXPECT_NEAR(across(16e3) * 80e9, -2 * std::exp(-32), 1e-11 * std::exp(-32));
}

TEST(LayeredResponse, HasNoScaleOfItsOwn) {
  const double longer = 1.7e-3, stiffer = 3.1e-5;
  for (LayeredBody body : stacks)
    for (const double k : wavenumbers(1, 1e4, 5)) {
      const SurfaceResponse<double> before = response_of(body, k);
      LayeredBody scaled = body;
      for (BodyLayer& layer : scaled.layers) {
        layer.thickness *= longer;
        layer.material.instantaneous.shear_modulus *= stiffer;
      }
      scaled.substrate.instantaneous.shear_modulus *= stiffer;
      const SurfaceResponse<double> after = response_of(scaled, k / longer);
      expect_near({after.nn * stiffer, after.ll * stiffer, after.tt * stiffer, after.ln * stiffer}, before, 1e-12);
    }
}

TEST(LayeredResponse, AStifferLayerGivesWayLess) {
  for (const double k : wavenumbers(10, 1e4, 7)) {
    double before = infinite;
    for (const double modulus : {1e9, 1e10, 8e10, 1e12}) {
      const double nn = response_of(body_of({{1e-3, {{modulus, 0.3}}}}, steel_like), k).nn;
      EXPECT_LT(nn, before);
      before = nn;
    }
  }
}

TEST(LayeredResponse, OfAnElasticStackDoesNotDependOnTheFrequency) {
  for (const LayeredBody& body : stacks)
    for (const double omega : {0.0, 30.0}) {
      const SurfaceResponse<Complex> found = response(stack_at(body, omega), 1e3);
      const SurfaceResponse<double> real = response_of(body, 1e3);
      EXPECT_LT(std::abs(found.nn - real.nn), 1e-13 * real.nn);
      EXPECT_LT(std::abs(found.ln - real.ln), 1e-13 * real.nn);
    }
}

TEST(LayeredResponse, ViscoelasticLayersAreElasticAtBothEndsOfTime) {
  const PronySeries series = {{0.3, 1e-2}, {0.4, 2}};
  LayeredBody body = body_of({{1e-3, {{1e9, 0.45}, series}}, {2e-3, {{5e9, 0.4}, {{0.2, 1}}}}}, steel_like);
  LayeredBody relaxed = body;
  relaxed.layers[0].material = {{1e9 * 0.3, 0.45}};
  relaxed.layers[1].material = {{5e9 * 0.8, 0.4}};
  for (const double k : wavenumbers(10, 1e4, 6)) {
    const SurfaceResponse<Complex> slow = response(stack_at(body, 0), k), fast = response(stack_at(body, 1e12), k);
    expect_near({slow.nn.real(), slow.ll.real(), slow.tt.real(), slow.ln.real()}, response_of(relaxed, k), 1e-13);
    expect_near({fast.nn.real(), fast.ll.real(), fast.tt.real(), fast.ln.real()}, response_of(body, k), 1e-9);
    EXPECT_LT(response(stack_at(body, 3), k).nn.imag(), 0); // it lags behind
  }
}

} // namespace
} // namespace microslip
