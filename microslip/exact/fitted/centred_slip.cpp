#include "microslip/exact/fitted/centred_slip.hpp"

#include <algorithm>
#include <cstddef>

namespace microslip {

template <class Real>
CentredSlip<Real>::CentredSlip(const FittedContact& contact, std::span<const char> centred)
    : behind_(centred.size(), 0), own_(centred.size(), 1), ahead_(behind_), ways_(centred.size() + 2) {
  const auto way = [&](std::size_t k) { return contact.elements[k].end - contact.elements[k].point; };
  for (std::size_t k = 0; k < centred.size(); ++k) {
    const FittedElement& e = contact.elements[k];
    if (!centred[k] || e.leads) continue;
    const double own = way(k), ahead = way(k + 1);
    if (e.trails) {
      ahead_[k] = static_cast<Real>(-own / (own + ahead));
    } else { // the derivative of the cubic through the displacement's growth from path to path, in Newton's form
      const double behind = way(k - 1), third = behind * own / (behind + own + ahead);
      behind_[k] = static_cast<Real>((own - third) / (behind + own));
      ahead_[k] = static_cast<Real>(-third / (own + ahead));
    }
    own_[k] = 1 - behind_[k] - ahead_[k];
  }
}

template <class Real> void CentredSlip<Real>::move(std::span<Real> slip) {
  std::copy(slip.begin(), slip.end(), ways_.begin() + 1);
  const Real* way = ways_.data();
#pragma omp simd
  for (std::size_t k = 0; k < slip.size(); ++k)
    slip[k] = behind_[k] * way[k] + own_[k] * way[k + 1] + ahead_[k] * way[k + 2];
}

template <class Real> void CentredSlip<Real>::nearly_undo(std::span<Real> slip) {
  move(slip);
  const Real* way = ways_.data() + 1;
#pragma omp simd
  for (std::size_t k = 0; k < slip.size(); ++k) slip[k] = 2 * way[k] - slip[k];
}

template class CentredSlip<double>;
template class CentredSlip<float>;

} // namespace microslip
