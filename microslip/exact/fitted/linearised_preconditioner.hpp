#pragma once

#include "microslip/exact/fitted/centred_slip.hpp"
#include "microslip/exact/halfspace/rolling_preconditioner.hpp"
#include "microslip/exact/newton/linearised_friction.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace microslip {

/// Right preconditioner of linearised steady rolling with slip at the elements' centres: (E36) with M^-1 (2 - T), on
/// the part of the tractions that slip can change.
template <class Real> class LinearisedPreconditioner {
public:
  LinearisedPreconditioner(RollingPreconditioner<Real> rolling, std::size_t elements)
      : rolling_(std::move(rolling)), n_(elements), free_(2 * n_), undone_(2 * n_), mapped_(2 * n_) {}

  /// Turns px and then py of the elements into unknowns.
  void apply(const LinearisedFriction<Real>& friction, CentredSlip<Real>& slip, std::span<Real> v) {
    friction.free_part(v, free_);
    const std::span<Real> in(undone_), out(mapped_);
    std::copy(free_.begin(), free_.end(), in.begin());
    slip.nearly_undo(in.first(n_));
    slip.nearly_undo(in.subspan(n_));
    rolling_.apply(in.first(n_), in.subspan(n_), out.first(n_), out.subspan(n_));
    for (std::size_t k = 0; k < 2 * n_; ++k) mapped_[k] += undone_[k] - free_[k];
    friction.free_part(mapped_, mapped_);
    for (std::size_t k = 0; k < 2 * n_; ++k) v[k] += mapped_[k];
  }

private:
  RollingPreconditioner<Real> rolling_;
  std::size_t n_;
  std::vector<Real> free_, undone_, mapped_;
};

} // namespace microslip
