#include "binding/arrays.hpp"
#include "binding/bindings.hpp"
#include "binding/long_work.hpp"
#include "binding/profile.hpp"
#include "binding/value.hpp"
#include "binding/wheel_rail.hpp"
#include "binding/words.hpp"
#include "microslip/error.hpp"
#include "microslip/railway/geometry/conicity.hpp"
#include "microslip/railway/geometry/wheelset_contact_quantities.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace microslip::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr WheelsetBase usual;

/// A rail and a wheel on either side.
struct Sides {
  ProfileValue left_rail, left_wheel, right_rail, right_wheel;
  bool are_alike;

  WheelsetSearch::Side left() const { return {left_rail.profile(), left_wheel.profile()}; }
  WheelsetSearch::Side right() const { return {right_rail.profile(), right_wheel.profile()}; }
};

/// A wheelset on a track as rigid bodies.
struct WheelsetGeometry {
  Track track;
  Wheelset wheelset;
  Sides sides;
  double contact_distance;

  WheelsetSearch search(std::optional<double> gauge = {}) const {
    Track there = track;
    there.gauge = gauge.value_or(track.gauge);
    return {there, wheelset, sides.left(), sides.right()};
  }
  WheelsetBase base() const { return {contact_distance, wheelset.nominal_radius}; }
};

/// Contacts of both wheels in many positions of a wheelset.
struct WheelsetContacts {
  Shape shape;
  std::vector<WheelsetContact> contacts;
  Sides sides;
};

std::unique_ptr<WheelsetGeometry> make_geometry(const Track& track, const ProfileValue& rail, const Wheelset& wheelset,
                                                const ProfileValue& wheel,
                                                const std::optional<ProfileValue>& right_rail,
                                                const std::optional<ProfileValue>& right_wheel,
                                                double contact_distance) {
  require_positive("contact_distance", contact_distance, "m");
  for (const ProfileValue* profile :
       {&rail, &wheel, right_rail ? &*right_rail : &rail, right_wheel ? &*right_wheel : &wheel})
    io::require_one_section(profile->report(), profile->surface, "WheelsetGeometry");
  auto made = std::make_unique<WheelsetGeometry>(WheelsetGeometry{
      track,
      wheelset,
      {rail, wheel, right_rail.value_or(rail), right_wheel.value_or(wheel), !right_rail && !right_wheel},
      contact_distance});
  made->search();
  return made;
}

WheelsetContacts contact(const WheelsetGeometry& self, const py::object& lateral, const py::object& yaw, RollRule roll,
                         int threads) {
  auto laterals = real_array("lateral", lateral), yaws = real_array("yaw", yaw);
  WheelsetContacts found{{}, {}, self.sides};
  broadcast(found.shape, "lateral", laterals);
  broadcast(found.shape, "yaw", yaws);
  laterals = spread(laterals, found.shape), yaws = spread(yaws, found.shape);
  const auto y = span_of(laterals), psi = span_of(yaws);
  found.contacts.resize(y.size());
  const int count = thread_count(threads);
  run_batch(y.size(), 64, count, [&]() -> BatchWorker {
    return [&, search = std::make_shared<WheelsetSearch>(self.search())](std::size_t first, std::size_t n,
                                                                         const Progress&) {
      for (std::size_t i = first; i < first + n; ++i) found.contacts[i] = search->solve(y[i], psi[i], roll);
    };
  });
  return found;
}

WheelsetContacts curve(const WheelsetGeometry& self, double from, double to, RollRule roll, double yaw) {
  WheelsetContacts found{{}, {}, self.sides};
  found.contacts = long_work([&](const Progress& progress) {
    WheelsetSearch search = self.search();
    return wheelset_curve(search, from, to, roll, yaw, progress);
  });
  found.shape = {static_cast<py::ssize_t>(found.contacts.size())};
  return found;
}

/// Gauges and other numbers that broadcast, with one curve of rolling radii for each gauge.
class GaugeBroadcast {
public:
  /// `gauge` may be None: the track's. Throws Error unless the reach is positive.
  GaugeBroadcast(const WheelsetGeometry& geometry, const py::object& gauge, RollRule roll, const char* name,
                 const py::object& numbers, int threads)
      : numbers_(real_array(name, numbers)) {
    const RealArray given = real_array("gauge", gauge.is_none() ? py::float_(geometry.track.gauge) : gauge);
    broadcast(shape_, name, numbers_);
    broadcast(shape_, "gauge", given);
    double reach = 0;
    for (const double number : span_of(numbers_)) reach = std::max(reach, std::abs(number));
    numbers_ = spread(numbers_, shape_), gauges_ = spread(given, shape_);
    std::vector<double> gauges(gauges_.data(), gauges_.data() + gauges_.size());
    std::sort(gauges.begin(), gauges.end());
    gauges.erase(std::unique(gauges.begin(), gauges.end()), gauges.end());
    if (gauges.empty()) return;
    require_positive(name, reach, "m");
    std::vector<std::optional<RollingRadiusDifference>> found(gauges.size());
    run_batch(gauges.size(), 1, thread_count(threads), [&]() -> BatchWorker {
      return [&](std::size_t k, std::size_t, const Progress& progress) {
        WheelsetSearch search = geometry.search(gauges[k]);
        found[k].emplace(curve_of_amplitudes(search, reach, geometry.sides.are_alike, roll, progress));
      };
    });
    for (std::size_t k = 0; k < gauges.size(); ++k) differences_.emplace(gauges[k], *found[k]);
  }

  /// A function of the rolling radius difference and a number; a number for numbers.
  template <class Function> py::object map(const Function& function) const {
    return mapped("gauge", gauges_, "number", numbers_,
                  [&](double gauge, double number) { return function(differences_.at(gauge), number); });
  }

private:
  Shape shape_;
  RealArray numbers_, gauges_;
  std::map<double, RollingRadiusDifference> differences_;
};

double conicity(const RollingRadiusDifference& difference, double amplitude, const WheelsetBase& base) {
  const auto motion = kinematic_oscillation(difference, amplitude, base);
  return motion ? motion->conicity : none;
}
double wavelength(const RollingRadiusDifference& difference, double amplitude, const WheelsetBase& base) {
  const auto motion = kinematic_oscillation(difference, amplitude, base);
  return motion ? motion->wavelength : none;
}

/// Not a number beyond the ends.
double steering_index(const RollingRadiusDifference& difference, double lateral, double curve_radius,
                      const WheelsetBase& base) {
  const bool covered = lateral >= difference.from() && lateral <= difference.to();
  return covered ? radial_steering_index(difference, lateral, curve_radius, base) : none;
}

constexpr double nonlinearity_reach = 4e-3; ///< [m], the larger amplitude of nonlinearity_parameter

void bind_contacts(py::module_& module) {
  auto contacts = py::class_<WheelsetContacts>(
      module, "WheelsetContacts",
      "Contact points of both wheels of a rigid wheelset: arrays of the input's shape, NaN where there is no contact.");
  for (const WheelsetContactQuantity& q : wheelset_contact_quantities())
    contacts.def_property_readonly(
        q.name.c_str(),
        [&q](const WheelsetContacts& self) {
          return array_of<double>(self.shape, self.contacts, [&](const auto& contact) {
            return contact.status == Status::no_contact ? none
                                                        : q.value(contact, self.sides.left(), self.sides.right());
          });
        },
        text_of(q.description, q.unit, ", shape (...)").c_str());
  contacts
      .def_property_readonly(
          "status",
          [](const WheelsetContacts& self) {
            return array_of<std::uint8_t>(self.shape, self.contacts, [](const auto& c) { return c.status; });
          },
          "Codes of Status as uint8, shape (...) [-]; compare with Status.ok.")
      .def("__len__", [](const WheelsetContacts& self) { return self.contacts.size(); });
  add_description(contacts, {"lateral", "rolling_radius_difference", "contact_angle_difference", "roll", "status"});
  add_labelled_arrays(contacts);
}

using OfAmplitude = double (*)(const RollingRadiusDifference& difference, double amplitude, const WheelsetBase& base);

auto of_amplitude(OfAmplitude value) {
  return [value](const RollingRadiusDifference& self, const py::object& amplitude, double contact_distance,
                 double nominal_radius) {
    return mapped("amplitude", amplitude, "amplitude", py::float_(0.0), [&](double a, double) {
      return value(self, a, {contact_distance, nominal_radius});
    });
  };
}

/// Function of a geometry, for its gauge or others.
auto of_gauge(OfAmplitude value) {
  return [value](const WheelsetGeometry& self, const py::object& amplitude, const py::object& gauge, RollRule roll,
                 int threads) {
    return GaugeBroadcast(self, gauge, roll, "amplitude", amplitude, threads)
        .map([value, base = self.base()](const auto& dr, double a) { return value(dr, a, base); });
  };
}

void bind_rolling_radius_difference(py::module_& module) {
  py::class_<RollingRadiusDifference>(
      module, "RollingRadiusDifference",
      "The rolling radius difference of a wheelset over its lateral displacement, linear "
      "between values; what EN 15302 finds from it.")
      .def(py::init([](const py::object& lateral, const py::object& difference) {
             const RealArray y = real_array("lateral", lateral),
                             values = real_array("difference", difference, Shape{y.size()});
             std::vector<RollingRadiusDifference::Value> pairs;
             for (py::ssize_t k = 0; k < y.size(); ++k) pairs.push_back({y.data()[k], values.data()[k]});
             return RollingRadiusDifference(std::move(pairs));
           }),
           "lateral"_a, "difference"_a,
           "Left less right rolling radius [m], shape (n), at ascending lateral displacements [m], shape (n); two\n"
           "equal ones are a jump. Error for fewer than two.")
      .def(
          "at",
          [](const RollingRadiusDifference& self, const py::object& lateral) {
            return mapped("lateral", lateral, "lateral", py::float_(0.0),
                          [&](double y, double) { return y >= self.from() && y <= self.to() ? self.at(y) : none; });
          },
          "lateral"_a, "The difference [m] at lateral displacements [m], shape (...); NaN beyond the ends.")
      .def("equivalent_conicity", of_amplitude(conicity), "amplitude"_a, "contact_distance"_a = usual.contact_distance,
           "nominal_radius"_a = usual.nominal_radius,
           "Equivalent conicity [-] by EN 15302 at amplitudes [m], shape (...): that of conical wheels with the same\n"
           "kinematic wavelength; NaN where no such motion exists. contact_distance e [m] of both contacts.")
      .def(
          "wavelength", of_amplitude(wavelength), "amplitude"_a, "contact_distance"_a = usual.contact_distance,
          "nominal_radius"_a = usual.nominal_radius,
          "Wavelength [m] of the motion of a free wheelset with these amplitudes [m], shape (...), that rolls without\n"
          "slip.")
      .def(
          "nonlinearity_parameter",
          [](const RollingRadiusDifference& self, double contact_distance, double nominal_radius) {
            return nonlinearity_parameter(self, {contact_distance, nominal_radius}).value_or(none);
          },
          "contact_distance"_a = usual.contact_distance, "nominal_radius"_a = usual.nominal_radius,
          "Change of the equivalent conicity from 2 to 4 mm of amplitude, per metre [1/m]; the standard's is per mm.")
      .def(
          "radial_steering_index",
          [](const RollingRadiusDifference& self, const py::object& lateral, const py::object& curve_radius,
             double contact_distance, double nominal_radius) {
            return mapped("lateral", lateral, "curve_radius", curve_radius, [&](double y, double radius) {
              return steering_index(self, y, radius, {contact_distance, nominal_radius});
            });
          },
          "lateral"_a, "curve_radius"_a, "contact_distance"_a = usual.contact_distance,
          "nominal_radius"_a = usual.nominal_radius,
          "The difference at lateral displacements [m] over the one that rolls without slip through a curve of that\n"
          "radius [m], shape (...) [-]: from 1 on the wheelset can steer itself radially.");
}

} // namespace

void bind_wheelset_geometry(py::module_& module) {
  bind_contacts(module);
  bind_rolling_radius_difference(module);
  py::class_<WheelsetGeometry>(
      module, "WheelsetGeometry",
      "A rigid wheelset on a track by their profiles: where both wheels touch, and its conicity.")
      .def(py::init(&make_geometry), py::kw_only(), "track"_a, "rail"_a, "wheelset"_a, "wheel"_a,
           "right_rail"_a = py::none(), "right_wheel"_a = py::none(), "contact_distance"_a = usual.contact_distance,
           "The profiles of rail and wheel, as read_profile gives them, of both sides or of the left one;\n"
           "contact_distance e [m] between the contacts of both wheels. Error for values out of range and profiles\n"
           "that do not fit the track or the wheelset.")
      .def("contact", &contact, "lateral"_a, "yaw"_a = 0.0, py::kw_only(), "roll"_a = RollRule::equilibrium,
           "threads"_a = 0,
           "The WheelsetContacts at lateral displacements [m] and yaw angles [rad] that broadcast. With roll\n"
           "\"equilibrium\" both wheels touch, with \"none\" the roll angle is zero as in EN 15302. Ctrl-C ends it.")
      .def(
          "curve", &curve, "lateral_from"_a, "lateral_to"_a, py::kw_only(), "roll"_a = RollRule::equilibrium,
          "yaw"_a = 0.0,
          "The WheelsetContacts over lateral displacements [m], 0 between or at an end: 0.1 mm apart and as fine as "
          "the\n"
          "rolling radius difference needs to be linear in between within 1e-7 m. Jumps are two positions closer than\n"
          "1e-9 m. Ends early where a wheel leaves its rail; Error if there is no contact at 0.")
      .def("equivalent_conicity", of_gauge(conicity), "amplitude"_a, py::kw_only(), "gauge"_a = py::none(),
           "roll"_a = RollRule::equilibrium, "threads"_a = 0,
           "Equivalent conicity [-] by EN 15302 at amplitudes [m] and gauges [m], by default the track's, that\n"
           "broadcast: gauge[:, None] makes a map, shape (...). NaN where no periodic motion exists. Ctrl-C ends it.")
      .def("wavelength", of_gauge(wavelength), "amplitude"_a, py::kw_only(), "gauge"_a = py::none(),
           "roll"_a = RollRule::equilibrium, "threads"_a = 0,
           "Wavelength [m] of the motion that rolls without slip, as equivalent_conicity, shape (...).")
      .def(
          "nonlinearity_parameter",
          [](const WheelsetGeometry& self, const py::object& gauge, RollRule roll, int threads) {
            return GaugeBroadcast(self, gauge, roll, "amplitude", py::float_(nonlinearity_reach), threads)
                .map([base = self.base()](const auto& dr, double) {
                  return nonlinearity_parameter(dr, base).value_or(none);
                });
          },
          py::kw_only(), "gauge"_a = py::none(), "roll"_a = RollRule::equilibrium, "threads"_a = 0,
          "Change of the equivalent conicity from 2 to 4 mm of amplitude, per metre [1/m], shape (...).")
      .def(
          "radial_steering_index",
          [](const WheelsetGeometry& self, const py::object& lateral, double curve_radius, const py::object& gauge,
             RollRule roll, int threads) {
            require_positive("curve_radius", curve_radius, "m");
            return GaugeBroadcast(self, gauge, roll, "lateral", lateral, threads)
                .map([&, base = self.base()](const auto& dr, double y) {
                  return steering_index(dr, y, curve_radius, base);
                });
          },
          "lateral"_a, "curve_radius"_a, py::kw_only(), "gauge"_a = py::none(), "roll"_a = RollRule::equilibrium,
          "threads"_a = 0,
          "The rolling radius difference at lateral displacements [m] over the one that rolls without slip through a\n"
          "curve of that radius [m], shape (...) [-].");
}

} // namespace microslip::python
