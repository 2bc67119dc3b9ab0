#include "microslip/elasticity/layered_response.hpp"

#include "microslip/elasticity/layer_waves.hpp"

#include <complex>

namespace microslip {

template <class Number> SurfaceResponse<Number> rest_of_response(const LayerStack<Number>& stack, double k) {
  const LayerReflections<Number> reflections(stack, k);
  const Matrix2<Number>& rest = reflections.rest;
  return {-rest.d, -rest.a, reflections.rest_across, -rest.b};
}

template SurfaceResponse<double> rest_of_response(const LayerStack<double>&, double);
template SurfaceResponse<std::complex<double>> rest_of_response(const LayerStack<std::complex<double>>&, double);

} // namespace microslip
