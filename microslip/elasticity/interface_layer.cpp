#include "microslip/elasticity/interface_layer.hpp"

#include "microslip/error.hpp"

namespace microslip {

void check(const InterfaceLayer& layer) {
  require_between("layer.flexibility", layer.flexibility, "m/Pa", 0, std::numeric_limits<double>::max());
  if (!(layer.yield_stress > 0)) throw Error("layer.yield_stress", layer.yield_stress, "Pa", "positive, or infinite");
  require_finite("layer.hardening", layer.hardening, "Pa/m");
}

} // namespace microslip
