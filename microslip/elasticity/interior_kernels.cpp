#include "microslip/elasticity/interior_kernels.hpp"

#include "microslip/numerics/bessel.hpp"
#include "microslip/numerics/hankel_nodes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace microslip {
namespace {

constexpr double panel_width = 0.5; // of asinh(r/s)
using Responses = std::vector<InteriorResponse<double>>;

void add_wave(const WaveNode& wave, double r, const Responses& responses, double* to) {
  static_assert(sizeof(InteriorPointState) == InteriorPointKernels::kinds * sizeof(double));
  const double angle = wave.wavenumber * r;
  const BesselFunctions of_angle = bessel_functions(angle);
  const auto [j0, j1, j2] = of_angle;
  const double j3 = bessel_j3(angle, of_angle);
  const double f = wave.weight / (2 * std::numbers::pi), g = f * wave.wavenumber;
  for (const auto& [n, a, t, tn, lt] : responses) {
    *to++ += f * n.n * j0;
    *to++ -= f * n.l * j1;
    *to++ += g * n.nn * j0;
    *to++ -= g * n.ln * j1;
    *to++ += g * (n.ll + n.tt) / 2 * j0;
    *to++ -= g * (n.ll - n.tt) / 2 * j2;
    *to++ += f * (a.l + t) / 2 * j0;
    *to++ -= f * (a.l - t) / 2 * j2;
    *to++ += f * a.n * j1;
    *to++ += g * a.nn * j1;
    *to++ += g * (a.ln + tn) / 2 * j0;
    *to++ -= g * (a.ln - tn) / 2 * j2;
    *to++ += g * (a.ll + a.tt) / 2 * j1;
    *to++ += g * ((a.ll - a.tt) / 4 - lt / 2) * j1;
    *to++ -= g * ((a.ll - a.tt) / 4 + lt / 2) * j3;
  }
}

/// cos and sin of theta, 2 theta and 3 theta.
struct Angles {
  double c, s, c2, s2, c3, s3;

  Angles(double x, double y) : Angles(x, y, std::hypot(x, y)) {}

private:
  Angles(double x, double y, double r)
      : c(r > 0 ? x / r : 1), s(r > 0 ? y / r : 0), c2(c * c - s * s), s2(2 * c * s), c3(c * c2 - s * s2),
        s3(s * c2 + c * s2) {}
};

PanelPolynomials point_kernels_of(const InteriorSpectrum& spectrum, double reach) {
  const double scale = spectrum.decay_distance(), farthest = reach + scale;
  const InteriorSpectrumTable table(spectrum, farthest);
  const std::size_t functions = InteriorPointKernels::kinds * spectrum.parts();
  const PanelPolynomials::Values at_nodes = [&](std::span<const double, PanelPolynomials::nodes> t,
                                                std::span<double> values) {
    Responses responses(spectrum.parts());
    const auto r = [&](double at) { return scale * std::sinh(at); };
    for (const WaveNode& wave : hankel_nodes(r(t.front()), r(t.back()), table.k_max())) {
      table.find(wave.wavenumber, responses);
      for (std::size_t node = 0; node < t.size(); ++node)
        add_wave(wave, r(t[node]), responses, values.data() + node * functions);
    }
  };
  return {0, std::asinh(farthest / scale), panel_width, functions, at_nodes};
}

void add_line_wave(const WaveNode& wave, double x, const Responses& responses, const Responses& limit, double fade,
                   double* to) {
  static_assert(sizeof(InteriorLineState) == InteriorLineKernels::kinds * sizeof(double));
  const double g = wave.weight / std::numbers::pi, angle = wave.wavenumber * x;
  const double c = g * std::cos(angle), s = g * std::sin(angle), uc = c / wave.wavenumber, us = s / wave.wavenumber;
  for (std::size_t m = 0; m < responses.size(); ++m) {
    const auto& [n, a, t, tn, lt] = responses[m];
    *to++ += uc * (n.n - fade * limit[m].normal.n);
    *to++ -= us * n.l;
    *to++ += c * n.nn;
    *to++ -= s * n.ln;
    *to++ += c * n.ll;
    *to++ += c * n.tt;
    *to++ += uc * (a.l - fade * limit[m].along.l);
    *to++ += us * a.n;
    *to++ += c * a.ln;
    *to++ += s * a.nn;
    *to++ += s * a.ll;
    *to++ += s * a.tt;
    *to++ += uc * (t - fade * limit[m].t);
    *to++ += c * tn;
    *to++ -= s * lt;
  }
}

void add_limit(double logarithm, const Responses& limit, std::span<double> values) {
  const double f = -logarithm / std::numbers::pi;
  double* to = values.data();
  for (const auto& [n, a, t, tn, lt] : limit) {
    to[0] += f * n.n, to[6] += f * a.l, to[12] += f * t;
    to += InteriorLineKernels::kinds;
  }
}

PanelPolynomials line_kernels_of(const InteriorSpectrum& spectrum, double reach, double far) {
  const double scale = spectrum.decay_distance(), farthest = reach + scale;
  const InteriorSpectrumTable table(spectrum, farthest);
  Responses limit(spectrum.parts());
  table.find_long(limit);
  const std::size_t functions = InteriorLineKernels::kinds * spectrum.parts();
  const PanelPolynomials::Values at_nodes = [&](std::span<const double, PanelPolynomials::nodes> t,
                                                std::span<double> values) {
    Responses responses(spectrum.parts());
    const auto x = [&](double at) { return scale * std::sinh(at); };
    for (const WaveNode& wave : hankel_nodes(x(t.front()), x(t.back()), table.k_max())) {
      table.find(wave.wavenumber, responses);
      const double fade = std::exp(-wave.wavenumber * scale);
      for (std::size_t node = 0; node < t.size(); ++node)
        add_line_wave(wave, x(t[node]), responses, limit, fade, values.data() + node * functions);
    }
    for (std::size_t node = 0; node < t.size(); ++node)
      add_limit(std::log(std::hypot(scale, x(t[node])) / far), limit, values.subspan(node * functions, functions));
  };
  return {0, std::asinh(farthest / scale), panel_width, functions, at_nodes};
}

} // namespace

InteriorInfluence InteriorPointState::at(double x, double y) const {
  const auto& n = normal;
  const auto& h = along;
  const Angles a(x, y);
  InteriorInfluence out;
  out.pn = {
      n.ur * a.c,
      n.ur * a.s,
      n.un,
      {n.mean + n.difference * a.c2, n.mean - n.difference * a.c2, n.nn, n.difference * a.s2, n.rn * a.c, n.rn * a.s}};
  out.px = {h.u_mean + h.u_difference * a.c2,
            h.u_difference * a.s2,
            h.un * a.c,
            {(h.m + h.e) * a.c + h.f * a.c3, (h.m - h.e) * a.c - h.f * a.c3, h.nn * a.c, h.e * a.s + h.f * a.s3,
             h.shear_mean + h.shear_difference * a.c2, h.shear_difference * a.s2}};
  out.py = {h.u_difference * a.s2,
            h.u_mean - h.u_difference * a.c2,
            h.un * a.s,
            {(h.m - h.e) * a.s + h.f * a.s3, (h.m + h.e) * a.s - h.f * a.s3, h.nn * a.s, h.e * a.c - h.f * a.c3,
             h.shear_difference * a.s2, h.shear_mean - h.shear_difference * a.c2}};
  return out;
}

InteriorInfluence InteriorLineState::at(double x) const {
  const double side = x < 0 ? -1 : 1;
  const auto& n = normal;
  const auto& h = along;
  InteriorInfluence out;
  out.pn = {side * n.ux, 0, n.un, {n.xx, n.yy, n.nn, 0, side * n.xn, 0}};
  out.px = {h.ux, 0, side * h.un, {side * h.xx, side * h.yy, side * h.nn, 0, h.xn, 0}};
  out.py = {0, uy, 0, {0, 0, 0, side * xy, 0, yn}};
  return out;
}

InteriorPointKernels::InteriorPointKernels(const InteriorSpectrum& spectrum, double reach)
    : scale_(spectrum.decay_distance()), parts_(spectrum.parts()), of_distance_(point_kernels_of(spectrum, reach)) {}

void InteriorPointKernels::evaluate(double r, std::span<InteriorPointState> parts) const {
  of_distance_.evaluate(std::asinh(r / scale_), {&parts[0].normal.un, kinds * parts.size()});
}

InteriorLineKernels::InteriorLineKernels(const InteriorSpectrum& spectrum, double reach, double far)
    : scale_(spectrum.decay_distance()), parts_(spectrum.parts()), of_distance_(line_kernels_of(spectrum, reach, far)) {
}

void InteriorLineKernels::evaluate(double x, std::span<InteriorLineState> parts) const {
  of_distance_.evaluate(std::asinh(x / scale_), {&parts[0].normal.un, kinds * parts.size()});
}

} // namespace microslip
