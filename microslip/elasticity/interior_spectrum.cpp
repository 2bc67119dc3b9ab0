#include "microslip/elasticity/interior_spectrum.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace microslip {
namespace {

constexpr std::size_t kinds = InteriorResponse<double>::count;
constexpr double wave_width = 0.35;   // of ln k
constexpr double longest_wave = 1e10; // in units of the reach

using Complex = std::complex<double>;

const LayeredBody& checked(const LayeredBody& body, double depth) {
  check("body", body);
  if (layer_at(body, depth).layer == body.layers.size() && body.substrate.is_rigid())
    throw Error("depth", depth, "m", "at most that of the layers, whose core is rigid");
  return body;
}

bool is_in_top(const LayeredBody& body, double depth) {
  return layer_at(body, depth).layer == 0;
}

double decay_distance_at(const LayeredBody& body, double depth) {
  const bool has_closed_form = !body.layers.empty() && is_in_top(body, depth) && body.is_elastic();
  return has_closed_form ? 2 * body.layers.front().thickness - depth : depth;
}

/// What is left of the response where a half-space of the surface's material is taken away from that at once.
template <class Number>
InteriorResponse<Number> without_half_space(const LayerStack<Number>& stack, const LayerDepth& at, double k) {
  return stack.layers.empty() ? InteriorResponse<Number>{} : interior_response(stack, at, k);
}

/// Response of a half-space of the surface's material.
template <class Number>
InteriorResponse<Number> half_space_below(const LayerStack<Number>& stack, const LayerDepth& at, double k) {
  return interior_response(LayerStack<Number>{{}, stack.top()}, at, k);
}

/// Numbers of a response, of which it consists.
template <class Number> std::span<Number, kinds> numbers(InteriorResponse<Number>& response) {
  static_assert(sizeof(InteriorResponse<Number>) == kinds * sizeof(Number));
  return std::span<Number, kinds>(&response.normal.l, kinds);
}

template <class Number> void add(InteriorResponse<Number>& sum, InteriorResponse<Number> response) {
  for (std::size_t kind = 0; kind < kinds; ++kind) numbers(sum)[kind] += numbers(response)[kind];
}

PanelPolynomials table_of(const InteriorSpectrum& spectrum, double k_min, double k_max) {
  const PanelPolynomials::Values at_nodes = [&](std::span<const double, PanelPolynomials::nodes> ln_k,
                                                std::span<double> values) {
    std::vector<InteriorResponse<double>> responses(spectrum.parts());
    double* to = values.data();
    for (const double at : ln_k) {
      spectrum.find(std::exp(at), responses);
      to = std::copy_n(&responses[0].normal.l, kinds * responses.size(), to);
    }
  };
  return {std::log(k_min), std::log(k_max), wave_width, kinds * spectrum.parts(), at_nodes};
}

} // namespace

InteriorSpectrum::InteriorSpectrum(const LayeredBody& body, double depth)
    : basis_(checked(body, depth)), at_(layer_at(body, depth)), instantaneous_(instantaneous_stack(body)),
      decay_distance_(decay_distance_at(body, depth)) {
  for (const double omega : basis_.frequencies()) stacks_.push_back(stack_at(body, omega));
}

void InteriorSpectrum::find(double k, std::span<InteriorResponse<double>> parts) const {
  const bool in_top = at_.layer == 0;
  parts[0] = in_top ? without_half_space(instantaneous_, at_, k) : interior_response(instantaneous_, at_, k);
  if (stacks_.empty()) return;
  InteriorResponse<double> at_once = parts[0];
  if (in_top) add(at_once, half_space_below(instantaneous_, at_, k));
  std::vector<InteriorResponse<Complex>> responses;
  for (const auto& stack : stacks_) {
    responses.push_back(in_top ? without_half_space(stack, at_, k) : interior_response(stack, at_, k));
    if (in_top) add(responses.back(), half_space_below(stack, at_, k));
  }
  std::vector<Complex> creep(stacks_.size());
  std::vector<double> amounts(times().size());
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    for (std::size_t n = 0; n < creep.size(); ++n) creep[n] = numbers(responses[n])[kind] - numbers(at_once)[kind];
    basis_.fit(creep, amounts);
    for (std::size_t m = 0; m < amounts.size(); ++m) numbers(parts[m + 1])[kind] = amounts[m];
  }
}

InteriorSpectrumTable::InteriorSpectrumTable(const InteriorSpectrum& spectrum, double reach)
    : k_max_(40 / spectrum.decay_distance()), of_logarithm_(table_of(spectrum, 1 / (longest_wave * reach), k_max_)) {}

void InteriorSpectrumTable::find(double k, std::span<InteriorResponse<double>> parts) const {
  of_logarithm_.evaluate(std::log(k), {&parts[0].normal.l, kinds * parts.size()});
}

} // namespace microslip
