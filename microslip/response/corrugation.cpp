#include "microslip/response/corrugation.hpp"

#include "microslip/decimal.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace microslip {

using Complex = std::complex<double>;

Receptance::Receptance(std::vector<double> frequencies, std::vector<Complex> values)
    : frequencies_(std::move(frequencies)), values_(std::move(values)) {
  if (frequencies_.empty() || frequencies_.size() != values_.size())
    throw Error("receptance: must have a value for each of its frequencies, and one at least");
  for (std::size_t k = 0; k < frequencies_.size(); ++k) {
    require_finite("receptance.frequency", frequencies_[k], "Hz");
    require_finite("receptance.real", values_[k].real(), "m/N");
    require_finite("receptance.imaginary", values_[k].imag(), "m/N");
    if (frequencies_[k] < 0 || (k > 0 && !(frequencies_[k] > frequencies_[k - 1])))
      throw Error("receptance: frequencies must ascend from 0 on");
  }
}

Complex Receptance::at(double frequency) const {
  constexpr double rounding = 1e-9;
  const double span = rounding * largest_frequency();
  if (!(frequency >= least_frequency() - span && frequency <= largest_frequency() + span))
    throw Error("receptance: " + rounded_text(frequency, 4) + " Hz is beyond its frequencies, " +
                rounded_text(least_frequency(), 4) + " to " + rounded_text(largest_frequency(), 4) + " Hz");
  const auto above = std::lower_bound(frequencies_.begin(), frequencies_.end(), frequency);
  const auto next = static_cast<std::size_t>(above - frequencies_.begin());
  if (next == 0) return values_.front();
  if (next == frequencies_.size()) return values_.back();
  const double t = (frequency - frequencies_[next - 1]) / (frequencies_[next] - frequencies_[next - 1]);
  return (1 - t) * values_[next - 1] + t * values_[next];
}

std::vector<CorrugationGrowth> corrugation_growth(const FrequencyResponse& response, double speed,
                                                  const Receptance& receptance, const WorkWear& wear) {
  require_positive("rolling_speed", speed, "m/s");
  require_positive("wear coefficient", wear.coefficient, "m^3/J");
  require_positive("width of the running band", wear.width, "m");
  std::vector<CorrugationGrowth> out;
  for (const ForceResponse& r : response.at) {
    if (r.load_by_roughness == 0.0) throw Error("growth: needs responses to roughness, too");
    const Complex G = receptance.at(speed * r.wavenumber / (2 * std::numbers::pi));
    const Complex force = r.load_by_roughness / (1.0 + response.normal_stiffness * G);
    const Complex work = r.work_by_roughness - r.work_by_load * response.normal_stiffness * G * force;
    out.push_back({force, work, -wear.coefficient / wear.width * work});
  }
  return out;
}

} // namespace microslip
