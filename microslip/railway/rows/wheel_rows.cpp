#include "microslip/railway/rows/wheel_rows.hpp"

#include "microslip/simplified/load_moments.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace microslip {

WheelRows::WheelRows(const WheelRailBodies& bodies, const NominalPlacement& nominal, const EquivalentRail* equivalent)
    : bodies_(bodies), nominal_(nominal), search_(bodies.rail, bodies.wheel),
      penetration_(bodies.rail, bodies.wheel, most_wheel_rows),
      rows_(bodies.rail, bodies.wheel, most_wheel_rows, equivalent), normal_(most_wheel_rows), shear_(most_wheel_rows),
      last_shear_(most_wheel_rows) {
  normal_rows_.reserve(most_wheel_rows);
}

void WheelRows::put(double vertical) {
  WheelState<double> there = state_;
  there.vertical = vertical;
  placement_ = place(nominal_, there);
}

/// Finds all points at most `reach` [m] above the lowest one of the gap, which is returned.
ContactPoint WheelRows::search(double reach) {
  ContactPoint lowest;
  lowest.gap = std::numeric_limits<double>::infinity();
  put(state_.vertical);
  searched_ = reach;
  penetration_.start();
  points_ = search_.find(placement_, reach);
  for (const ContactPoint& point : points_)
    if (point.gap < lowest.gap) lowest = point;
  return lowest;
}

ContactPoint WheelRows::touch(const WheelState<double>& state) {
  constexpr double first_search = 3e-4; // [m]
  state_ = state;
  const ContactPoint lowest = search(first_search);
  clearance_ = lowest.gap;
  return lowest;
}

/// Regions and overlap of the wheel where it is, lowered by so much from where it was searched.
void WheelRows::take_overlap(double depth, double lowering) {
  depth_ = depth;
  regions_ = search_.regions(lowering);
  penetration_.sample(placement_, regions_.first(std::min(regions_.size(), most_wheel_rows)), depth);
}

void WheelRows::sample(double depth) {
  if (depth > searched_) search(2 * depth);
  put(state_.vertical - clearance_ - depth);
  take_overlap(depth, clearance_ + depth);
}

/// The rows of the overlap that was sampled, with what the last ones know of them.
void WheelRows::take_rows() {
  complete_ = rows_.place(placement_, regions_, penetration_);
  normal_rows_.clear();
  std::swap(shear_, last_shear_);
  for (const ContactRow& row : rows_.rows()) {
    normal_rows_.push_back(row.normal);
    const bool known = has_loads_ && row.normal.before != no_row;
    shear_[normal_rows_.size() - 1] = normal_rows_.back().shear = known ? last_shear_[row.normal.before] : 0;
  }
  if (normal_rows_.empty() || !complete_) has_loads_ = false;
}

void WheelRows::lower_to(double depth) {
  sample(depth);
  take_rows();
}

double WheelRows::predict_depth(double from, double vertical_force) {
  sample(from);
  return penetration_.depth_for(vertical_force, bodies_.material.contact_modulus(), placement_.radius);
}

void WheelRows::shift(const WheelState<double>& state) {
  move(state);
  penetration_.start();
  clearance_ = search_.shift(placement_);
  take_overlap(-clearance_, 0);
  take_rows();
}

void WheelRows::move(const WheelState<double>& state) {
  state_ = state;
  put(state.vertical);
}

void WheelRows::lower_by(double lowering) {
  depth_ += lowering;
  put(vertical());
}

RowNormal::Result WheelRows::find_loads(std::optional<double> vertical_force, int steps) {
  RowNormal::Result found = normal_.solve(bodies_.material, normal_rows_, vertical_force, has_loads_, steps);
  has_loads_ = std::isfinite(found.lowering) && std::isfinite(found.change) && std::isfinite(found.stiffness) &&
               found.stiffness > 0;
  if (!has_loads_) // as for contacts larger than their bodies: less depth, from the beginning
    found = {-0.3 * depth_, vertical_force.value_or(1) / depth_, 1, Status::not_converged, found.steps};
  if (found.status == Status::ok) found.change = 0;
  return found;
}

double WheelRows::load(std::size_t row) const {
  return has_loads_ ? normal_.loads()[row] * normal_rows_[row].width : 0;
}

double WheelRows::contact_gap(std::size_t row) const {
  const auto overlap = [&](std::size_t k) { return std::max(-normal_rows_[k].gap, 0.0); };
  const double own = overlap(row);
  double most = own, least = own;
  const auto see = [&](std::size_t k) {
    const double other = overlap(k);
    least = std::min(least, other);
    if (other > own) most = std::max(most, own + std::min(1.0, detail::united * least / own) * (other - own));
  };
  for (std::size_t k = row + 1; k < count() && rows()[k].joined && least > 0; ++k) see(k);
  least = own;
  for (std::size_t k = row; k-- > 0 && rows()[k + 1].joined && least > 0;) see(k);
  return own > 0 ? -most : normal_rows_[row].gap;
}

double WheelRows::least_gap(const ContactRegion& region) const {
  double least = 0;
  for (const ContactPoint& point : points_.subspan(region.first, region.count))
    least = std::min(least, (point.gap - clearance_ - depth_) * std::cos(point.inclination));
  return least;
}

} // namespace microslip
