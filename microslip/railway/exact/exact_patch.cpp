#include "microslip/railway/exact/exact_patch.hpp"

#include "microslip/error.hpp"
#include "microslip/exact/classical/classical_solution.hpp"
#include "microslip/exact/classical/tangential_totals.hpp"
#include "microslip/exact/halfspace/layered_influence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace microslip {
namespace {

constexpr int margin = 1, margin_of_rolling = 4; ///< elements ahead and behind: second order needs three

/// Elements with one centre at 0 from before `low` to beyond `high`.
std::pair<int, int> covering(double low, double high, double size, int spare) {
  return {static_cast<int>(std::floor(low / size)) - spare, static_cast<int>(std::ceil(high / size)) + spare};
}

ElementGrid cover(const PatchOutline& o, Vec2 element, bool rolls) {
  const auto [left, right] = covering(o.x_low, o.x_high, element.x, rolls ? margin_of_rolling : margin);
  const auto [low, high] = covering(o.s_low, o.s_high, element.y, margin);
  return {.mx = right - left + 1,
          .my = high - low + 1,
          .x0 = left * element.x,
          .y0 = low * element.y,
          .dx = element.x,
          .dy = element.y};
}

/// Displacement of a half-space's surface by a unit of force at a unit of distance [m^2/N].
double far_field(const CombinedMaterial& material) {
  return (1 - material.poisson_ratio) / (std::numbers::pi * material.shear_modulus);
}

double length(const Vec3<double>& v) {
  return std::sqrt(dot(v, v));
}

constexpr int most_corrections = 60;
constexpr double settled = 1e-7; ///< change of the displacements that the rows' angles add, over the largest one

double largest(const std::vector<double>& field) {
  double most = 0;
  for (const double value : field) most = std::max(most, std::abs(value));
  return most;
}

double largest_change(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0;
  for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, std::abs(a[k] - b[k]));
  return most;
}

std::shared_ptr<const InfluenceTable> table_of(const std::optional<LayeredBodies>& layered, const ElementGrid& grid,
                                               const Progress& progress) {
  return layered ? layered_table(*layered, grid, essential_part(progress, 0, 0)) : nullptr;
}

} // namespace

ExactPatch::ExactPatch(const CombinedMaterial& material, const std::optional<LayeredBodies>& layered,
                       const PatchSurface& surface, const PatchOutline& outline, const Shape& shape, Vec2 element,
                       const Motion& motion, Progress progress)
    : material_(material), progress_(std::move(progress)), frame_(outline.frame), motion_(motion),
      grid_(cover(outline, element, shape.rolls)), gaps_(grid_.count()), layered_(layered),
      table_(table_of(layered, grid_, progress_)),
      normal_(table_ ? NormalProblem(*table_, grid_) : NormalProblem(material, grid_, progress_)),
      conformity_(shape.conformity) {
  const auto mx = static_cast<std::size_t>(grid_.mx);
  std::vector<double> x;
  x.reserve(mx);
  for (int i = 0; i < grid_.mx; ++i) x.push_back(grid_.x(i));
  PatchRow near = surface.first_row(frame_, outline.wheel_s);
  for (int j = 0; j < grid_.my; ++j) {
    go_on(progress_, 0);
    PatchRow row = surface.row(frame_, shape.surface, grid_.y(j), near);
    surface.find_gaps(row, x, std::span(gaps_).subspan(static_cast<std::size_t>(j) * mx, mx));
    near = row;
    rows_.push_back(row);
    creepage_.push_back(surface.creepage(frame_, shape.surface, row, motion.contact_gap, motion.speed));
  }
  if (conformity_ > 0) correct_angles(material);
  least_ = *std::min_element(gaps_.begin(), gaps_.end());
  for (double& h : gaps_) h -= least_;
  lifted_ = gaps_;
}

Vec3<double> ExactPatch::place(std::size_t element) const {
  const std::size_t mx = grid_.mx;
  return rows_[element / mx].point + Vec3<double>{grid_.x(static_cast<int>(element % mx)), 0, 0};
}

void ExactPatch::apply_lift(std::span<const PointLoad> loads) {
  lifted_ = gaps_;
  for (const PointLoad& load : loads) {
    const double factor = far_field(material_) * load.force * std::cos(load.angle - frame_.angle);
    for (int j = 0; j < grid_.my; ++j) {
      const Vec3<double> offset = row(j).point - load.place;
      const double across = offset.y * offset.y + offset.z * offset.z;
      double* h = &lifted_[static_cast<std::size_t>(j) * grid_.mx];
      for (int i = 0; i < grid_.mx; ++i) {
        const double x = offset.x + grid_.x(i);
        h[i] += factor / std::sqrt(x * x + across);
      }
    }
  }
}

double ExactPatch::lift_by(const PointLoad& other) const {
  return far_field(material_) * other.force * std::cos(other.angle - load_.angle) / length(other.place - load_.place);
}

bool ExactPatch::holds_contact() const {
  constexpr int to_spare = 3; // columns, as fit_contact needs them
  for (std::size_t k = 0; k < pressed_.pressure.size(); ++k) {
    const int i = static_cast<int>(k % grid_.mx);
    if (pressed_.pressure[k] > 0 && (i < to_spare || i >= grid_.mx - to_spare)) return false;
  }
  return !pressed_.touches_border;
}

std::optional<ExactPatch::Extent> ExactPatch::extent(double near) const {
  if (!(pressed_.normal_force > 0)) return {};
  int left = grid_.mx, right = 0, low = grid_.my, high = 0;
  for (std::size_t k = 0; k < pressed_.gap.size(); ++k) {
    if (!(pressed_.pressure[k] > 0 || pressed_.gap[k] < near)) continue;
    const int i = static_cast<int>(k % grid_.mx), j = static_cast<int>(k / grid_.mx);
    left = std::min(left, i), right = std::max(right, i), low = std::min(low, j), high = std::max(high, j);
  }
  return Extent{grid_.x(left) - 1.5 * grid_.dx, grid_.x(right) + 1.5 * grid_.dx, grid_.y(low) - 1.5 * grid_.dy,
                grid_.y(high) + 1.5 * grid_.dy};
}

void ExactPatch::expect(std::span<const PressureRow> rows) {
  expected_.assign(grid_.count(), 0);
  const auto set_row = [&](int j, const PressureRow& row) {
    for (int i = 0; i < grid_.mx; ++i) {
      const double t = (grid_.x(i) - row.centre) / row.half_length;
      if (std::abs(t) < 1) expected_[static_cast<std::size_t>(j) * grid_.mx + i] = row.peak * std::sqrt(1 - t * t);
    }
  };
  for (std::size_t k = 0; k + 1 < rows.size(); ++k) {
    const auto& [low, high] = std::minmax(rows[k], rows[k + 1], [](auto& a, auto& b) { return a.s < b.s; });
    for (int j = 0; j < grid_.my; ++j) {
      const double t = (grid_.y(j) - low.s) / (high.s - low.s);
      if (!(t >= 0 && t <= 1)) continue;
      const auto between = [t, &a = low, &b = high](double PressureRow::*part) {
        return (1 - t) * a.*part + t * b.*part;
      };
      set_row(j, {grid_.y(j), between(&PressureRow::centre), between(&PressureRow::half_length),
                  between(&PressureRow::peak)});
    }
  }
  if (!(largest(expected_) > 0)) expected_.clear();
}

void ExactPatch::find_loads() {
  constexpr int side = 6; // elements of a block along either axis
  // Blocks stay where they are in the frame when the contact grows or the elements reach further.
  const auto before = [](double centre, double size) {
    const int number = static_cast<int>(std::lround(centre / size)) % side;
    return number < 0 ? number + side : number;
  };
  const int i0 = before(grid_.x0, grid_.dx), j0 = before(grid_.y0, grid_.dy);
  const int columns = (i0 + grid_.mx + side - 1) / side, rows = (j0 + grid_.my + side - 1) / side;
  loads_.assign(static_cast<std::size_t>(columns) * rows, {{}, 0, frame_.angle});
  for (std::size_t k = 0; k < pressed_.pressure.size(); ++k) {
    const double force = pressed_.pressure[k] * grid_.element_area();
    if (!(force > 0)) continue;
    const std::size_t column = (i0 + k % grid_.mx) / side, row = (j0 + k / grid_.mx) / side;
    PointLoad& sum = loads_[row * columns + column];
    sum.force += force, sum.place = sum.place + force * place(k);
  }
  std::erase_if(loads_, [](const PointLoad& sum) { return !(sum.force > 0); });
  load_ = {{}, 0, frame_.angle};
  for (PointLoad& sum : loads_) {
    load_.force += sum.force, load_.place = load_.place + sum.place;
    sum.place = 1 / sum.force * sum.place;
  }
  load_.place = load_.force > 0 ? 1 / load_.force * load_.place : frame_.origin;
}

void ExactPatch::correct_angles(const CombinedMaterial& material) {
  RowInclination inclination;
  for (const PatchRow& row : rows_) inclination.angle.push_back(row.angle);
  const auto [least, most] = std::minmax_element(inclination.angle.begin(), inclination.angle.end());
  if (*least == *most) return;
  correction_.emplace(material, grid_, inclination);
  on_grid_.fill(std::vector<double>(grid_.count()));
  added_ = on_grid_;
}

/// Displacements by the last tractions and the present pressures.
ExactPatch::Fields ExactPatch::added_displacements() {
  on_grid_[2] = pressed_.pressure;
  Fields added = correction_->find(on_grid_);
  for (auto& field : added)
    for (double& u : field) u *= conformity_;
  return added;
}

/// Solves with the half-space's displacements alone.
void ExactPatch::solve_plane(const NormalLoad& load, double tolerance) {
  std::vector<double> gap = lifted_;
  if (correction_)
    for (std::size_t k = 0; k < gap.size(); ++k) gap[k] += added_[2][k];
  std::vector<double> start = pressed_.contact_elements > 0 ? std::move(pressed_.pressure) : std::move(expected_);
  pressed_ = start.empty() ? normal_.solve(gap, load, tolerance, progress_)
                           : normal_.solve_from(std::move(start), gap, load, tolerance, progress_);
  expected_.clear();
}

/// Solves; what the rows' angles add is taken from the last pressures until it stays.
void ExactPatch::solve(const NormalLoad& load, double tolerance) {
  solve_plane(load, tolerance);
  for (int k = 0; correction_; ++k) {
    const double scale = largest(pressed_.displacement);
    const Fields before = std::exchange(added_, added_displacements());
    if (largest_change(added_[2], before[2]) <= std::max(tolerance, settled) * scale) break;
    solve_plane(load, tolerance);
    if (k == most_corrections && pressed_.status == Status::ok) pressed_.status = Status::not_converged;
    if (pressed_.status != Status::ok) break;
  }
  known_ = added_[2];
  find_loads();
}

void ExactPatch::solve_normal(double approach, double tolerance) {
  solve({NormalLoad::Given::approach, approach - least_}, tolerance);
}

void ExactPatch::press_with(double normal_force, double tolerance) {
  solve({NormalLoad::Given::force, normal_force}, tolerance);
}

void ExactPatch::scale_to(double normal_force) {
  const double factor = normal_force / pressed_.normal_force;
  // As far as the pressure differs from a multiple the gap does not close: after Hertz a third of the change.
  pressed_.approach += 2.0 / 3 * (factor - 1) * pressed_.approach;
  for (double& p : pressed_.pressure) p *= factor;
  for (double& u : pressed_.displacement) u *= factor;
  pressed_.normal_force = normal_force, pressed_.peak_pressure *= factor;
  pressed_.elastic_energy *= factor * factor;
  find_loads();
}

/// Each element's traction goes to the two elements of the grid between whose centres it lies, with its moment.
void ExactPatch::keep_tractions(const ContactSolution& solution) {
  tractions_ = solution.fields.traction;
  if (!correction_) return;
  for (const std::size_t i : {0, 1}) std::fill(on_grid_[i].begin(), on_grid_[i].end(), 0.0);
  for (std::size_t k = 0; k < solution.elements.size(); ++k) {
    const double share = solution.elements.area[k] / grid_.element_area();
    const double column = std::clamp((solution.elements.x[k] - grid_.x0) / grid_.dx, 0.0, grid_.mx - 1.001);
    const std::size_t left = k / grid_.mx * grid_.mx + static_cast<std::size_t>(column);
    const double right_share = column - std::floor(column);
    for (const auto& [to, traction] : {std::pair{&on_grid_[0], tractions_.x[k]}, {&on_grid_[1], tractions_.y[k]}}) {
      (*to)[left] += (1 - right_share) * share * traction;
      (*to)[left + 1] += right_share * share * traction;
    }
  }
}

/// Addition of the rows' angles to the tangential displacements, by cubic polynomials along rows and straight lines
/// across.
Vec2 ExactPatch::added_at(double x, double y) const {
  const double j = std::clamp((y - grid_.y0) / grid_.dy, 0.0, grid_.my - 1.0), i = (x - grid_.x0) / grid_.dx;
  const auto first = static_cast<int>(std::clamp(std::floor(i) - 1, 0.0, grid_.mx - 4.0));
  const double t = i - first;
  const std::array weights = {(t - 1) * (t - 2) * (3 - t) / 6, t * (t - 2) * (t - 3) / 2, t * (t - 1) * (3 - t) / 2,
                              t * (t - 1) * (t - 2) / 6};
  const auto row = static_cast<int>(j), next = std::min(row + 1, grid_.my - 1);
  const auto along = [&](const std::vector<double>& u, int of) {
    const double* from = &u[static_cast<std::size_t>(of) * grid_.mx + first];
    double sum = 0;
    for (std::size_t n = 0; n < weights.size(); ++n) sum += weights[n] * from[n];
    return sum;
  };
  const auto at = [&](const std::vector<double>& u) {
    return j == row ? along(u, row) : (row + 1 - j) * along(u, row) + (j - row) * along(u, next);
  };
  return {at(added_[0]), at(added_[1])};
}

/// Rolls with what the rows' angles add, taken from the last tractions until it stays.
ContactSolution ExactPatch::roll_plane(PatchRollingMotion motion) {
  constexpr int settling = 4;
  if (correction_) {
    motion.variation.displacement = [this](double x, double y) { return added_at(x, y); };
    added_ = added_displacements();
  }
  for (int k = 0;; ++k) {
    motion.start = tractions_;
    motion.near_last |= k > settling; // elements that begin to slide and to adhere in turn would never settle
    ContactSolution out = rolling_->solve(motion);
    keep_tractions(out);
    if (!correction_) return out;
    const double scale = largest(pressed_.displacement);
    const Fields before = std::exchange(added_, added_displacements());
    unsettled_ = scale > 0 ? largest_change(added_[2], known_) / scale : 0;
    const double change = std::max(largest_change(added_[0], before[0]), largest_change(added_[1], before[1]));
    if (change <= std::max(settled, 0.1 * motion.tolerance) * scale || out.report.status != Status::ok) return out;
    if (k == most_corrections) {
      out.report.status = Status::not_converged;
      return out;
    }
  }
}

ContactSolution ExactPatch::roll_on_layers(const std::function<double(double angle)>& friction, double tolerance) {
  ContactStep step;
  step.grid = grid_;
  step.bodies = layered_->surfaces();
  step.response.table = table_;
  step.gap = lifted_;
  step.load = {NormalLoad::Given::force, normal_force()};
  step.warm_start = true;
  step.motion.direction = motion_.direction;
  step.motion.rolling_speed = motion_.speed > 0 ? motion_.speed : 1;
  step.motion.tolerance = tolerance;
  const double ahead = step.motion.spin_offset * signed_step(step.motion, grid_);
  for (int j = 0; j < grid_.my; ++j) {
    const auto& [xi, eta, phi] = creepage_[static_cast<std::size_t>(j)]; // about (0, y)
    step.friction.push_back(FrictionLaw::coulomb(friction(row(j).angle)));
    for (int i = 0; i < grid_.mx; ++i) {
      step.extra_slip_x.push_back(xi);
      step.extra_slip_y.push_back(eta + phi * (grid_.x(i) + ahead));
    }
  }
  return solve_steps(sequence_, std::move(step), 1, progress_);
}

/// Creepages and friction of the rows, linear between their middles. Lives as long as `friction`.
PatchRollingMotion ExactPatch::motion_with(const std::function<double(double angle)>& friction,
                                           double tolerance) const {
  const auto between = [this](double y, const auto& values, auto number) {
    const double position = std::clamp((y - grid_.y0) / grid_.dy, 0.0, grid_.my - 1.0),
                 t = position - std::floor(position);
    const auto j = static_cast<std::size_t>(position);
    return t == 0 ? number(values[j]) : (1 - t) * number(values[j]) + t * number(values[j + 1]);
  };
  const double mu = friction(rows_[rows_.size() / 2].angle);
  PatchRollingMotion motion{.friction = mu,
                            .rolling_speed = motion_.speed > 0 ? motion_.speed : 1,
                            .tolerance = tolerance,
                            .progress = progress_};
  motion.variation.creepage = [this, between](double y) {
    return Creepage{between(y, creepage_, [](const Creepage& w) { return w.longitudinal; }),
                    between(y, creepage_, [](const Creepage& w) { return w.lateral; }),
                    between(y, creepage_, [](const Creepage& w) { return w.spin; })};
  };
  motion.variation.friction = [this, between, &friction, mu](double y) {
    return friction(between(y, rows_, [](const PatchRow& row) { return row.angle; })) / mu;
  };
  return motion;
}

ContactSolution ExactPatch::roll(const std::function<double(double angle)>& friction, double same_elements,
                                 double tolerance) {
  if (layered_) return roll_on_layers(friction, tolerance);
  constexpr double same_shape = 1e-4; // of what the rows' angles add to the displacements
  const bool same = rolling_ && std::abs(normal_force() - fitted_force_) < same_elements * fitted_force_ &&
                    largest_change(known_, fitted_known_) <= same_shape * largest(pressed_.displacement);
  if (same) {
    rolling_->reload(pressed_);
  } else {
    rolling_.emplace(material_, grid_, pressed_, motion_.direction, progress_);
    fitted_force_ = normal_force();
    fitted_known_ = known_;
  }
  for (std::vector<double>* field : {&tractions_.x, &tractions_.y})
    for (double& traction : *field) traction *= normal_force() / rolled_force_;
  PatchRollingMotion motion = motion_with(friction, tolerance);
  motion.near_last = same;
  ContactSolution out = roll_plane(std::move(motion));
  rolled_force_ = normal_force();
  return out;
}

FrequencyResponse ExactPatch::respond(const std::function<double(double angle)>& friction,
                                      std::span<const double> wavenumbers, double tolerance) {
  constexpr double normal_tolerance = 1e-8;
  if (layered_) throw Error("responses: not of bodies with layers");
  press_with(normal_force(), normal_tolerance);
  roll(friction, 0, tolerance);
  PatchRollingMotion motion = motion_with(friction, tolerance);
  if (correction_) motion.variation.displacement = [this](double x, double y) { return added_at(x, y); };
  motion.start = tractions_;
  return rolling_->respond(motion, wavenumbers, ResponseTo::roughness_too);
}

} // namespace microslip
