#include "microslip/elasticity/viscoelastic.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace microslip {
namespace {

constexpr double as_good_as_similar = 1e-6; // K that rounding of the constants makes

bool is_coupled(const CombinedMaterial& m) {
  return std::abs(m.dissimilarity) >= as_good_as_similar;
}

/// `name` is the creep's in messages.
Retardation retardation_of(const std::string& name, const MaterialCreep& creep, double speed) {
  require_between(name + ".ratio", creep.ratio, "-", 0, 1e6);
  require_between(name + ".time", creep.time, "s", 0, std::numeric_limits<double>::max());
  require_finite("speed", speed, "m/s");
  if (speed == 0) throw Error("speed", speed, "m/s", "not zero");
  return {creep.ratio, speed * creep.time};
}

} // namespace

bool Bodies::are_coupled() const {
  return is_coupled(material) ||
         std::any_of(retarded.begin(), retarded.end(), [](const RetardedPart& d) { return is_coupled(d.material); });
}

Retardation retardation_of(const MaterialCreep& creep, double speed) {
  return retardation_of("creep", creep, speed);
}

Bodies viscoelastic(const Material& body1, const MaterialCreep& creep1, const Material& body2,
                    const MaterialCreep& creep2, double speed) {
  const Retardation retardation1 = retardation_of("creep1", creep1, speed),
                    retardation2 = retardation_of("creep2", creep2, speed);
  Bodies bodies = combine(body1, body2);
  if (creep1.ratio == creep2.ratio && creep1.time == creep2.time) {
    if (creep1.ratio > 0) bodies.retarded.push_back({bodies.material, retardation1});
    return bodies;
  }
  // The deformation of one body is that of its contact with a rigid one.
  const Material rigid = {std::numeric_limits<double>::infinity(), 0};
  if (creep1.ratio > 0) bodies.retarded.push_back({combine(body1, rigid), retardation1});
  if (creep2.ratio > 0) bodies.retarded.push_back({combine(rigid, body2), retardation2});
  return bodies;
}

} // namespace microslip
