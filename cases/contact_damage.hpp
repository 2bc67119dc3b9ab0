#pragma once

#include "io/case_file.hpp"
#include "microslip/damage/contact_damage.hpp"

#include <vector>

namespace microslip::cases {

/// What a solution of a case does to the surface whose strength the case has. A solution without pressures, as the
/// simplified theory's, has Hertz's.
class CaseDamage {
public:
  /// Throws Error for a case without a strength.
  CaseDamage(const io::RollingCase& input, const HertzContact& hertz, const ContactSolution& solution);

  /// NaN where it needs a strength that is not given, or fields that the solution does not have.
  double operator()(const DamageQuantity& quantity) const;
  /// Empty likewise.
  std::vector<double> operator()(const DamageField& field) const;

private:
  SurfaceStrength strength_;
  ContactSolution solution_;
  double rolling_speed_, normal_force_, peak_pressure_;
  bool is_line_;
};

} // namespace microslip::cases
