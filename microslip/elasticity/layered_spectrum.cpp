#include "microslip/elasticity/layered_spectrum.hpp"

namespace microslip {
namespace {

const LayeredBody& checked(const LayeredBody& body) {
  check("body", body);
  return body;
}

/// The rest of the response of endlessly long waves, times k.
template <class Number> SurfaceResponse<Number> rest_of_long_waves(const LayerStack<Number>& stack) {
  SurfaceResponse<Number> below{};
  if (stack.substrate) below = half_space_response(*stack.substrate);
  const SurfaceResponse<Number> top = half_space_response(stack.top());
  return {below.nn - top.nn, below.ll - top.ll, below.tt - top.tt, below.ln - top.ln};
}

} // namespace

LayeredSpectrum::LayeredSpectrum(const LayeredBody& body)
    : basis_(checked(body)), instantaneous_(instantaneous_stack(body)) {
  for (const double omega : basis_.frequencies()) stacks_.push_back(stack_at(body, omega));
}

void LayeredSpectrum::find(double k, std::span<SurfaceResponse<double>> rest) const {
  find_parts([k](const auto& stack) { return rest_of_response(stack, k); }, rest);
}

void LayeredSpectrum::find_long(std::span<SurfaceResponse<double>> rest) const {
  find_parts([](const auto& stack) { return rest_of_long_waves(stack); }, rest);
}

template <class Response>
void LayeredSpectrum::find_parts(const Response& of, std::span<SurfaceResponse<double>> rest) const {
  rest[0] = of(instantaneous_);
  if (stacks_.empty()) return;
  std::vector<SurfaceResponse<std::complex<double>>> responses;
  responses.reserve(stacks_.size());
  for (const auto& stack : stacks_) responses.push_back(of(stack));
  std::vector<std::complex<double>> creep(stacks_.size());
  std::vector<double> amounts(times().size());
  const auto fit = [&](auto complex_part, auto part) {
    for (std::size_t n = 0; n < creep.size(); ++n) creep[n] = responses[n].*complex_part - rest[0].*part;
    basis_.fit(creep, amounts);
    for (std::size_t m = 0; m < amounts.size(); ++m) rest[m + 1].*part = amounts[m];
  };
  using Complex = SurfaceResponse<std::complex<double>>;
  using Real = SurfaceResponse<double>;
  fit(&Complex::nn, &Real::nn);
  fit(&Complex::ll, &Real::ll);
  fit(&Complex::tt, &Real::tt);
  fit(&Complex::ln, &Real::ln);
}

} // namespace microslip
