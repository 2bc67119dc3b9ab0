#include "compat/contact/wheel_rail/root_search.hpp"

#include <cmath>

namespace microslip::contact_program {

double RootSearch::next(double x, double value) {
  const Point point{x, value};
  if (bracketed_) {
    if (value * last_->value < 0)
      other_ = last_; // the sign has changed: the point before is the other side
    else
      other_->value *= 0.5;
    last_ = point;
  } else if (last_ && value * last_->value < 0) {
    bracketed_ = true;
    other_ = last_;
    last_ = point;
  } else {
    if (last_) step_ *= std::abs(value) > std::abs(last_->value) ? -2 : 2; // towards where it is nearer to zero
    last_ = point;
    return x + step_;
  }
  return last_->x - last_->value * (last_->x - other_->x) / (last_->value - other_->value);
}

std::optional<double> RootSearch::width() const {
  if (!bracketed_) return {};
  return std::abs(last_->x - other_->x);
}

} // namespace microslip::contact_program
