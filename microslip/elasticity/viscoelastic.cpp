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

void check(const std::string& name, const Creep& creep) {
  require_between(name + ".ratio", creep.ratio, "-", 0, 1e6);
  require_between(name + ".time", creep.time, "s", 0, std::numeric_limits<double>::max());
}

} // namespace

bool Bodies::are_coupled() const {
  return is_coupled(material) ||
         std::any_of(delayed.begin(), delayed.end(), [](const DelayedPart& d) { return is_coupled(d.material); });
}

Bodies viscoelastic(const Material& body1, const Creep& creep1, const Material& body2, const Creep& creep2,
                    double speed) {
  check("creep1", creep1);
  check("creep2", creep2);
  require_finite("speed", speed, "m/s");
  if (speed == 0) throw Error("speed", speed, "m/s", "not zero");
  Bodies bodies = combine(body1, body2);
  if (creep1.ratio == creep2.ratio && creep1.time == creep2.time) {
    if (creep1.ratio > 0) bodies.delayed.push_back({bodies.material, creep1.ratio, speed * creep1.time});
    return bodies;
  }
  // A body's own deformation is that of its contact with a rigid one.
  const Material rigid = {std::numeric_limits<double>::infinity(), 0};
  if (creep1.ratio > 0) bodies.delayed.push_back({combine(body1, rigid), creep1.ratio, speed * creep1.time});
  if (creep2.ratio > 0) bodies.delayed.push_back({combine(rigid, body2), creep2.ratio, speed * creep2.time});
  return bodies;
}

} // namespace microslip
