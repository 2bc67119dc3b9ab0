#pragma once

#include "microslip/exact/classical/contact_step.hpp"

#include <optional>
#include <span>
#include <vector>

namespace microslip {

/// What a solution of coupled bodies tells of the next one on the same grid, where the contact is another one: pressure
/// over that without tractions, and tractions over their bound, are as they were at points that lie alike in both
/// contacts. So it is, but for the elements, in a compression as that of Spence (1975), whose contact grows evenly.
class CoupledForecast {
public:
  using Field = std::vector<double>;

  /// Takes the tractions and the pressure of a solution, and the pressure without tractions.
  void remember(TangentialState solution, Field pressure_alone);
  /// The next ones, if `now` is that solution and the pressure without tractions changes.
  std::optional<TangentialState> next(const ElementGrid& grid, std::span<const double> friction,
                                      const TangentialState& now, const Field& pressure_alone) const;

private:
  TangentialState last_;
  Field pressure_alone_; ///< with it
};

} // namespace microslip
