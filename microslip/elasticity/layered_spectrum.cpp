#include "microslip/elasticity/layered_spectrum.hpp"

namespace microslip {
namespace {

const LayeredBody& checked(const LayeredBody& body) {
  check("body", body);
  return body;
}

} // namespace

LayeredSpectrum::LayeredSpectrum(const LayeredBody& body)
    : basis_(checked(body)), instantaneous_(instantaneous_stack(body)) {
  for (const double omega : basis_.frequencies()) stacks_.push_back(stack_at(body, omega));
}

void LayeredSpectrum::find(double k, std::span<SurfaceResponse<double>> rest) const {
  rest[0] = rest_of_response(instantaneous_, k);
  if (stacks_.empty()) return;
  std::vector<SurfaceResponse<std::complex<double>>> responses;
  responses.reserve(stacks_.size());
  for (const auto& stack : stacks_) responses.push_back(rest_of_response(stack, k));
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
