#pragma once

#include "compat/contact/case.hpp"
#include "microslip/railway/geometry/frame.hpp"

#include <optional>

namespace microslip::contact_program {

/// State for a contact's damping force at its next case: the forces of this one, and at the time
/// before. Forces on body 1 in the contact's axes [N].
class ForceHistory {
public:
  /// Begins a case: digit P says which force is that of the time before.
  void begin(Continuation from);
  /// Its force, once it is solved.
  void end(const Vec3<double>& force) { last_ = force; }
  /// Nothing at the beginning of a sequence.
  const std::optional<Vec3<double>>& before() const { return before_; }

private:
  std::optional<Vec3<double>> last_, before_;
};

/// The force of the time before that counts for digit P, of what a contact bore then: of the pressure alone with P = 1.
std::optional<Vec3<double>> carried_force(Continuation from, const std::optional<Vec3<double>>& last);

/// Damping forces of a case with M2 > 0, C dF/dt [N]: from the change of the force in its time step, `step` [m] over
/// VELOC in rolling and 1 s otherwise, whose rate is limited to DFTMAX in x and y and to DFNMAX. Zero without a force
/// before.
std::optional<Vec3<double>> damping_force(const Case& c, double step, const Vec3<double>& force,
                                          const std::optional<Vec3<double>>& before);

} // namespace microslip::contact_program
