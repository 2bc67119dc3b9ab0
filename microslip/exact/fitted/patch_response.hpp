#pragma once

#include "microslip/contact/force_response.hpp"
#include "microslip/exact/fitted/contact_change.hpp"
#include "microslip/exact/fitted/second_order_rolling.hpp"
#include "microslip/exact/normal/normal_problem.hpp"

#include <complex>
#include <vector>

namespace microslip {

/// Amplitudes of fx, fy, mz and of the work per metre of the surface (ForceResponse).
struct ResponseAmplitudes {
  std::complex<double> force[3] = {}, work = 0;
};

/// Of the tractions on a contact's elements as they are.
ResponseAmplitudes response_amplitudes(const FittedContact& contact, const FrictionSolution& steady,
                                       const RollingResponse::Change& change, double wavenumber);

/// A contact in steady rolling along +x at second order, with all that responses need.
struct RollingPatch {
  CombinedMaterial material{};
  ElementGrid grid{};
  std::vector<double> gap; ///< h - delta without load, delta being that of the normal solution [m]
  const NormalSolution* normal = nullptr;
  double capacity = 0; ///< mu Fn [N]
  RowVariation variation = {};
  SecondOrderRolling* rolling = nullptr;
  const SecondOrderSolution* solution = nullptr;
  TransformPlans plans{};
};

/// Responses of a contact of any shape. Those by creepages are RollingResponse's. With the load, and with roughness,
/// pressures change and the contact's edges move: the normal problem is solved for changes to either side, small enough
/// for edges to move by a tenth of an element, and elements follow them (refitted). With tractions that stay, the slip
/// between an element's point, where it is at t, and the end of its path, where that was a time d/V before, changes by
///
///     (du(x_I) - e^{-ikd} du(x_{I+1}))/d - s_u (e^{-ikd} dx_{I+1} - dx_I)/d + phi (dx_I + e^{-ikd} dx_{I+1})/2 (0, 1)
///
/// with du at places that move and s_u = (u(x_I) - u(x_{I+1}))/d (V4); forces are those of the tractions' changes, and
/// of the tractions on elements that change their size.
class PatchResponse {
public:
  /// Throws Stopped.
  PatchResponse(RollingPatch patch, const Progress& progress);

  /// dFn/d(delta) [N/m].
  double normal_stiffness() const { return stiffness_; }
  /// Throws Stopped. Cost: four complex linear solves; with roughness one more, four normal problems and operators.
  ForceResponse at(double wavenumber, ResponseTo causes, double tolerance, const Progress& progress);
  long products() const { return products_; }

private:
  /// A contact changed to either side.
  struct Pressed {
    NearbyContact contact;
    double normal_force = 0, approach = 0;
  };

  Pressed pressed(const NormalSolution& normal) const;
  ContactChange change(const Pressed& less, const Pressed& more, double step, const Progress& progress) const;
  void press(const Progress& progress);
  RollingResponse::Cause cause_of(const ContactChange& even, const ContactChange* odd, double wavenumber) const;
  ResponseAmplitudes amplitudes_of(const RollingResponse::Change& change, double wavenumber) const;
  void add_moved(const ContactChange& change, std::complex<double> factor, double wavenumber,
                 ResponseAmplitudes& out) const;
  ResponseAmplitudes respond_to(const ContactChange& even, const ContactChange* odd, double wavenumber,
                                double tolerance, const Progress& progress);
  void find_by_creepages(double wavenumber, double tolerance, ForceResponse& out, const Progress& progress);
  void find_by_roughness(double wavenumber, double tolerance, ForceResponse& out, const Progress& progress);

  RollingPatch patch_;
  std::vector<double> bound_;
  NormalProblem normal_problem_;
  double indentation_ = 0; ///< by which the bodies would overlap [m]
  double share_ = 0;       ///< of the load, by which it is changed
  double half_length_ = 0; ///< of the contact [m]
  double stiffness_ = 0;
  ContactChange by_load_;
  VectorField path_slip_; ///< of the tractions, over the elements' paths [-]
  long products_ = 0;
};

} // namespace microslip
