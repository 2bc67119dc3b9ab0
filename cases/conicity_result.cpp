#include "cases/conicity_result.hpp"

#include "microslip/error.hpp"
#include "microslip/railway/geometry/wheelset_contact_quantities.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace microslip::cases {
namespace {

constexpr double curve_step = 1e-4; // m

WheelsetBase base_of(const ConicityInput& input) {
  return {input.contact_distance, input.wheelset.nominal_radius};
}

io::Json pairs(const std::vector<double>& x, const std::vector<double>& y) {
  auto array = io::Json::array();
  for (std::size_t k = 0; k < x.size(); ++k) array.push_back({io::json_number(x[k]), io::json_number(y[k])});
  return array;
}

/// The curve's value nearest to a lateral displacement.
const WheelsetContact& at(const WheelsetCurve& curve, double lateral) {
  return *std::min_element(curve.begin(), curve.end(), [&](const WheelsetContact& a, const WheelsetContact& b) {
    return std::abs(a.lateral - lateral) < std::abs(b.lateral - lateral);
  });
}

io::Json curve_document(const WheelsetCurve& curve, const WheelsetSearch::Side& left,
                        const WheelsetSearch::Side& right) {
  auto array = io::Json::array();
  const auto first = static_cast<int>(std::ceil(curve.front().lateral / curve_step - 1e-6));
  const auto last = static_cast<int>(std::floor(curve.back().lateral / curve_step + 1e-6));
  for (int k = first; k <= last; ++k) {
    const WheelsetContact& contact = at(curve, k * curve_step);
    io::Json row;
    for (const WheelsetContactQuantity& q : wheelset_contact_quantities())
      row[q.name] = io::json_number(q.value(contact, left, right));
    row["lateral"] = io::json_number(k * curve_step);
    array.push_back(std::move(row));
  }
  return array;
}

} // namespace

std::vector<double> amplitude_range(const std::string& field, double from, double to, double step) {
  constexpr double largest = 0.1;
  constexpr int most = 10000;
  require_positive(field, from, "m");
  require_between(field, to, "m", from, largest);
  require_positive(field, step, "m");
  const int count = require_count(field, static_cast<int>(std::min((to - from) / step + 1.0001, 1e6)), 1, most);
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) values.push_back(std::round((from + k * step) * 1e12) / 1e12);
  return values;
}

ConicityResult find_conicity(const ConicityInput& input, const WheelsetSearch::Side& left,
                             const WheelsetSearch::Side& right, bool sides_are_alike) {
  WheelsetSearch search(input.track, input.wheelset, left, right);
  ConicityResult result;
  result.gauge = input.track.gauge;
  result.curve = curve_of_amplitudes(search, input.amplitudes.back(), sides_are_alike, input.roll);
  const RollingRadiusDifference difference(result.curve);
  const WheelsetBase base = base_of(input);
  for (const double amplitude : input.amplitudes) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const auto motion = kinematic_oscillation(difference, amplitude, base);
    result.conicity.push_back(motion ? motion->conicity : none);
    result.wavelength.push_back(motion ? motion->wavelength : none);
  }
  result.nonlinearity = nonlinearity_parameter(difference, base);
  return result;
}

std::optional<double> steering_index(const ConicityInput& input, const ConicityResult& result) {
  if (!input.curve_radius) return std::nullopt;
  return radial_steering_index(RollingRadiusDifference(result.curve), input.amplitudes.back(), *input.curve_radius,
                               base_of(input));
}

io::Json conicity_document(const ConicityInput& input, const ConicityResult& result, const WheelsetSearch::Side& left,
                           const WheelsetSearch::Side& right) {
  io::Json document = {
      {"gauge", io::json_number(result.gauge)},
      {"equivalent_conicity", pairs(input.amplitudes, result.conicity)},
      {"wavelength", pairs(input.amplitudes, result.wavelength)},
      {"nonlinearity_parameter", result.nonlinearity ? io::json_number(*result.nonlinearity) : io::Json()},
      {"over_lateral_displacement", curve_document(result.curve, left, right)}};
  if (const auto index = steering_index(input, result)) document["radial_steering_index"] = io::json_number(*index);
  return document;
}

io::Json conicity_units() {
  io::Json units = {
      {"equivalent_conicity", "m, -"}, {"wavelength", "m, m"},    {"nonlinearity_parameter", "1/m"}, {"gauge", "m"},
      {"nominal_radius", "m"},         {"contact_distance", "m"}, {"radial_steering_index", "-"}};
  for (const WheelsetContactQuantity& q : wheelset_contact_quantities())
    units["over_lateral_displacement/" + q.name] = q.unit;
  return units;
}

} // namespace microslip::cases
