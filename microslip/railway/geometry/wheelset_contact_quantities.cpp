#include "microslip/railway/geometry/wheelset_contact_quantities.hpp"

#include <vector>

namespace microslip {
namespace {

using Quantity = WheelsetContactQuantity;
using Contact = const WheelsetContact&;
using Point = const ContactPoint&;
using Side = const WheelsetSearch::Side&;

struct OfWheelset {
  const char *name, *unit, *description;
  Quantity::OfWheelset value;
};
constexpr OfWheelset of_wheelset[] = {
    {"lateral", "m", "displacement of the wheelset's centre, to the left positive",
     [](Contact c) { return c.lateral; }},
    {"roll", "rad", "roll of the wheelset; positive raises the left wheel", [](Contact c) { return c.roll; }},
    {"vertical", "m", "height of the wheelset's centre above the nominal radius where the wheels touch",
     [](Contact c) { return c.vertical; }},
    {"rolling_radius_difference", "m", "left less right rolling radius",
     [](Contact c) { return c.rolling_radius_difference(); }},
    {"contact_angle_difference", "rad", "left less right inclination, each positive where it rises to the field side",
     [](Contact c) { return c.contact_angle_difference(); }}};

struct OfWheel {
  const char *name, *unit, *description;
  Quantity::OfWheel value;
};
constexpr OfWheel of_wheel[] = {
    {"rail_y", "m", "on the rail's profile, in its own axes: to the field side positive",
     [](Point p, Side of, double) { return of.rail.at(p.s_rail).value.y; }},
    {"wheel_y", "m", "on the wheel's profile, in its own axes",
     [](Point p, Side of, double) { return of.wheel.at(p.s_wheel).value.y; }},
    {"rolling_radius", "m", "of the wheel there", [](Point p, Side, double) { return p.radius; }},
    {"contact_angle", "rad", "inclination of the surfaces against the track plane; positive rises to the left",
     [](Point p, Side, double side) { return side * p.inclination; }},
    {"place_x", "m", "along the track, ahead of the wheelset's centre",
     [](Point p, Side, double) { return p.place.x; }},
    {"place_y", "m", "to the left of the track's centre", [](Point p, Side, double side) { return side * p.place.y; }}};

std::vector<Quantity> make_quantities() {
  std::vector<Quantity> all;
  for (const OfWheelset& q : of_wheelset) all.push_back({q.name, q.unit, q.description, q.value});
  for (const OfWheel& q : of_wheel) {
    const std::string name = q.name, description = q.description;
    all.push_back({"left_" + name, q.unit, "of the left wheel: " + description, nullptr, q.value});
    all.push_back({"right_" + name, q.unit, "of the right wheel: " + description, nullptr, nullptr, q.value});
  }
  return all;
}

} // namespace

double Quantity::value(const WheelsetContact& contact, const WheelsetSearch::Side& left,
                       const WheelsetSearch::Side& right) const {
  if (of_wheelset) return of_wheelset(contact);
  return of_left ? of_left(contact.left, left, 1) : of_right(contact.right, right, -1);
}

std::span<const Quantity> wheelset_contact_quantities() {
  static const std::vector<Quantity> all = make_quantities();
  return all;
}

} // namespace microslip
