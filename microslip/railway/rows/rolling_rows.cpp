#include "microslip/railway/rows/rolling_rows.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {
namespace {

constexpr int cells = 10; // of each row, for FASTSIM2

/// Rows of equal width in a patch's frame that carry what the given rows carry, which are of any width. Lengths,
/// middles, friction and creepages are means over the load.
std::vector<LoadedRow> even_rows(std::span<const LoadedRow> rows, const PatchFrame& frame) {
  constexpr int count = 40; // narrower than the given rows, so that few of them are cut
  const auto loaded = [](const LoadedRow& row) { return row.load > 0; };
  const auto first = std::find_if(rows.begin(), rows.end(), loaded);
  const auto last = std::find_if(rows.rbegin(), rows.rend(), loaded);
  const double low = first->y - first->width / 2, width = (last->y + last->width / 2 - low) / count;
  double load = 0, given = 0; // the rows' widths are those of the surface, their positions those of its parameter
  std::vector<LoadedRow> even;
  for (int k = 0; k < count; ++k) {
    LoadedRow sum{.y = low + (k + 0.5) * width - frame.rail_s, .width = width};
    double square = 0;
    for (const LoadedRow& row : rows) {
      const double from = std::max(row.y - row.width / 2, low + k * width);
      const double to = std::min(row.y + row.width / 2, low + (k + 1) * width);
      if (!(to > from) || !loaded(row)) continue;
      const double part = row.load * (to - from) / row.width, centre = row.centre - frame.origin.x;
      const Creepage& w = row.creepage;
      sum.load += part, sum.centre += part * centre, sum.friction += part * row.friction;
      square += part * row.half_length * row.half_length;
      sum.creepage.longitudinal += part * w.longitudinal, sum.creepage.spin += part * w.spin;
      sum.creepage.lateral += part * (w.lateral + w.spin * frame.origin.x);
    }
    sum.half_length = width;
    if (sum.load > 0) {
      for (double* mean :
           {&sum.centre, &sum.friction, &sum.creepage.longitudinal, &sum.creepage.lateral, &sum.creepage.spin})
        *mean /= sum.load;
      sum.half_length = std::sqrt(square / sum.load);
    }
    load += sum.load;
    even.push_back(sum);
  }
  for (const LoadedRow& row : rows) given += row.load;
  for (LoadedRow& row : even) row.load *= given / load;
  return even;
}

} // namespace

double friction_at(std::span<const InclinedFriction> friction, double angle) {
  const auto after =
      std::find_if(friction.begin(), friction.end(), [angle](const InclinedFriction& f) { return f.angle > angle; });
  if (after == friction.begin()) return friction.front().coefficient;
  if (after == friction.end()) return friction.back().coefficient;
  const InclinedFriction &low = *(after - 1), &high = *after;
  return low.coefficient + (angle - low.angle) / (high.angle - low.angle) * (high.coefficient - low.coefficient);
}

double rolling_speed(const WheelPlacement<double>& p, const Vec3<double>& place) {
  const double over_rail = p.wheel.velocity.x - p.rail.velocity_at(place).x;
  const double by_turning = cross(p.wheel.angular_velocity, place - p.wheel.frame.origin).x;
  return (std::abs(over_rail) + std::abs(by_turning)) / 2;
}

RollingRows::RollingRows(const WheelRailBodies& bodies, const WheelRailMethod& method)
    : bodies_(bodies), forward_(cells, most_wheel_rows), backward_(cells, most_wheel_rows, RollingDirection::backward),
      loaded_(most_wheel_rows), forces_(most_wheel_rows), forces_with_(most_wheel_rows), speed_(most_wheel_rows) {
  if (method.theory == Theory::table) look_up_.emplace(method.table, most_wheel_rows);
}

/// Rows as FASTSIM2 takes them, with their creepages about x = 0 of the track axes.
void RollingRows::load(const WheelRows& rows, const PatchSurface& surface) {
  constexpr double shortest = 1e-9; // [m]
  count_ = rows.count();
  for (std::size_t k = 0; k < count_; ++k) {
    const ContactRow& row = rows.rows()[k];
    const NormalRow& normal = rows.normal(k);
    loaded_[k] = {.y = row.at.s,
                  .width = normal.width,
                  .centre = normal.place.x,
                  .half_length = std::max(rows.half_length(k), shortest),
                  .load = rows.load(k),
                  .friction = friction_at(bodies_.friction, normal.angle),
                  .joined = row.joined};
    if (!(loaded_[k].load > 0)) continue;
    speed_[k] = rolling_speed(rows.placement(), normal.place);
    loaded_[k].creepage = surface.creepage({}, PatchShape::curved, row.at, rows.contact_gap(k), speed_[k]);
  }
}

double RollingRows::roll(WheelRows& rows, const PatchSurface& surface) {
  load(rows, surface);
  const bool forward = rows.rolls_forward();
  const CombinedMaterial& material = bodies_.material;
  if (look_up_)
    look_up_->solve(material, loaded(), forward ? 1 : -1, forces_);
  else
    fastsim2(forward).solve(material.shear_modulus, material.poisson_ratio, loaded(), forces_);
  double change = 0;
  for (std::size_t k = 0; k < count_; ++k) {
    const double load = loaded_[k].load, lateral = forces_[k].fy;
    double& shear = rows.shear(k);
    change += (lateral - shear * load) * std::sin(rows.normal(k).angle);
    shear = load > 0 ? lateral / load : 0;
  }
  return change;
}

std::span<const RowForces> RollingRows::forces_with(std::span<const LoadedRow> rows, bool forward) {
  fastsim2(forward).solve(bodies_.material.shear_modulus, bodies_.material.poisson_ratio, rows, forces_with_);
  return std::span(forces_with_).first(rows.size());
}

ContactSolution RollingRows::fields(std::span<const LoadedRow> rows, const PatchFrame& frame, double speed,
                                    bool forward) {
  return fastsim2(forward).solve_with_fields(bodies_.material.shear_modulus, bodies_.material.poisson_ratio,
                                             even_rows(rows, frame), speed);
}

} // namespace microslip
