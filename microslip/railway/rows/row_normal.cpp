#include "microslip/railway/rows/row_normal.hpp"

#include "microslip/numerics/elimination.hpp"
#include "microslip/railway/rows/kernel/row_pair.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace microslip {
namespace {

constexpr double pi = std::numbers::pi;
/// Numbers of each of Newton's equations, with two sides.
constexpr std::size_t columns_of(std::size_t order) {
  constexpr std::size_t block = 8; // for eliminate()
  return (order + 2 + block - 1) / block * block;
}

} // namespace

RowNormal::RowNormal(std::size_t most_rows) : equations_(most_rows) {
  for (std::vector<double>* row :
       {&load_, &log_kappa_, &half_length_, &width_, &next_load_, &change_, &constant_, &turn_constant_})
    row->resize(most_rows);
  system_.resize(2 * most_rows * columns_of(2 * most_rows));
  right_.resize(2 * most_rows), per_lowering_.resize(2 * most_rows);
  in_contact_.resize(most_rows), times_left_.resize(most_rows);
  active_.reserve(most_rows), near_.reserve(most_rows), is_near_.resize(most_rows);
}

/// Half-lengths of the rows that overlap by 0.45 of the most, from there, as virtual penetration has them; kappa as
/// under a sphere, 4/pi E* A, E* = 1/(pi C).
void RowNormal::start(std::span<const NormalRow> rows) {
  double most = 0;
  for (const NormalRow& row : rows) most = std::max(most, -row.gap);
  for (std::size_t j = 0; j < count_; ++j) {
    const double square = std::max((-rows[j].gap - 0.45 * most) / rows[j].curvature, 1e-3 * most / rows[j].curvature);
    const double kappa = 4 / (pi * pi * unit_) * rows[j].curvature;
    log_kappa_[j] = std::log(kappa);
    load_[j] = pi / 2 * kappa * square;
    in_contact_[j] = -rows[j].gap > 0.45 * most;
  }
}

/// Each row has the load and the kappa of the row that it was. False if none of them carries a load.
bool RowNormal::start_from_last(std::span<const NormalRow> rows) {
  bool any = false;
  std::size_t old = 0; // new rows have the kappa of those beside them
  for (std::size_t k = 0; k < rows.size() && count_ > 0; ++k) {
    const bool known = rows[k].before < count_;
    if (known) old = rows[k].before;
    next_load_[k] = known ? load_[old] : 0;
    change_[k] = log_kappa_[old];
    in_contact_[k] = next_load_[k] > 0;
    any |= next_load_[k] > 0;
  }
  std::copy_n(next_load_.begin(), rows.size(), load_.begin());
  std::copy_n(change_.begin(), rows.size(), log_kappa_.begin());
  return any;
}

/// Adds the rows that are loaded or in contact and their neighbours, or all. Returns whether any is new.
bool RowNormal::choose_rows() {
  bool any = false;
  for (std::size_t k = 0; k < count_; ++k) any |= in_contact_[k] || load_[k] > 0;
  const auto taken = [&](std::size_t k) { return !any || in_contact_[k] || load_[k] > 0; };
  const std::size_t before = near_.size();
  near_.clear();
  for (std::size_t j = 0; j < count_; ++j) {
    is_near_[j] |= taken(j) || (j > 0 && taken(j - 1)) || (j + 1 < count_ && taken(j + 1));
    if (is_near_[j]) near_.push_back(j);
  }
  return near_.size() != before;
}

/// Changes ln(kappa) of all rows by the amount with which the mean of its residual vanishes, loads as weights.
void RowNormal::change_alike() {
  double sum = 0, by_all = 0;
  for (std::size_t j = 0; j < near_.size(); ++j) {
    const double load = equations_.load(j);
    sum += load * equations_.turn(j);
    for (std::size_t k = 0; k < near_.size(); ++k) by_all += load * equations_.turn_by_kappa(j, k);
  }
  std::fill_n(change_.begin(), count_, -sum / by_all);
}

/// Newton's equations of the active rows: loads over the largest one, then changes of ln(kappa) unless `linear`.
void RowNormal::fill_system(bool linear, double length) {
  const RowEquations& e = equations_;
  const double load = e.largest() / length, one = 1 / length;
  const std::size_t n = active_.size(), m = linear ? n : 2 * n, columns = columns_of(m);
  std::fill_n(system_.begin(), m * columns, 0.0);
  for (std::size_t l = 0; l < n; ++l) {
    const std::size_t k = active_[l];
    double* const by_load = &system_[l];
    for (std::size_t i = 0; i < n; ++i) by_load[i * columns] = e.gap_by_load(active_[i], k) * load;
    if (linear) continue;
    double *const by_kappa = by_load + n, *const turns = by_load + n * columns;
    for (std::size_t i = 0; i < n; ++i) by_kappa[i * columns] = e.gap_by_kappa(active_[i], k) * one;
    for (std::size_t i = 0; i < n; ++i) turns[i * columns] = e.turn_by_load(active_[i], k) * e.largest();
    for (std::size_t i = 0; i < n; ++i) turns[i * columns + n] = e.turn_by_kappa(active_[i], k);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = active_[i];
    double* const sides = &system_[i * columns + m];
    sides[0] = constant_[j] * one, sides[1] = e.level(j) * one;
    if (!linear) sides[n * columns] = turn_constant_[j];
  }
}

/// Solves for the change of the loads; without a solution they are NaN, and the next step starts anew.
void RowNormal::solve_system(bool linear) {
  const std::size_t m = linear ? active_.size() : 2 * active_.size(), columns = columns_of(m);
  const bool regular = eliminate(std::span(system_).first(m * columns), m, 2);
  for (std::size_t i = 0; i < m; ++i) {
    const double* const sides = &system_[i * columns + m];
    right_[i] = regular ? sides[0] : std::numeric_limits<double>::quiet_NaN();
    per_lowering_[i] = sides[1];
  }
}

/// Rows whose load would pull leave the contact, or else those that would overlap come into it. Returns whether any
/// does. Rows with a kappa that follows their load may fit neither in nor out, by next to nothing: after leaving a few
/// times they stay out unless they overlap by more than that.
bool RowNormal::change_contact(bool linear, double length, double lowering) {
  constexpr int few_times = 3;
  constexpr double rounding = 1e-12, next_to_nothing = 1e-3; // of the length
  const RowEquations& e = equations_;
  const std::size_t n = active_.size();
  bool changed = false;
  double largest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    largest = std::max(largest, right_[i]);
    const std::size_t row = near_[active_[i]];
    if (!(right_[i] > 0)) in_contact_[row] = 0, ++times_left_[row], changed = true;
  }
  if (changed && largest > 0) return true;
  for (std::size_t j = 0; j < near_.size(); ++j) {
    if (in_contact_[near_[j]]) continue;
    double gap = -constant_[j] - lowering * e.level(j);
    for (std::size_t i = 0; i < n; ++i) {
      gap += e.gap_by_load(j, active_[i]) * right_[i] * e.largest();
      if (!linear) gap += e.gap_by_kappa(j, active_[i]) * right_[n + i];
    }
    const double overlap = times_left_[near_[j]] < few_times ? rounding : next_to_nothing;
    if (gap < -overlap * length) in_contact_[near_[j]] = 1, changed = true;
  }
  return changed;
}

/// The complementarity problem of Newton's matrices. Returns whether its active set was found.
bool RowNormal::solve_active(std::optional<double> vertical_force, bool linear, Result& result) {
  constexpr int most_sets = 30;
  const RowEquations& e = equations_;
  const double length = std::abs(e.gap_by_load(0, 0)) * e.largest(); // about that of gaps
  for (std::size_t j = 0; j < near_.size(); ++j)                     // what e and the other equation have without loads
    constant_[j] = -e.gap(j), turn_constant_[j] = -e.turn(j);
  for (std::size_t k = 0; k < near_.size(); ++k)
    for (std::size_t j = 0; j < near_.size(); ++j) {
      constant_[j] += e.gap_by_load(j, k) * e.load(k);
      turn_constant_[j] += e.turn_by_load(j, k) * e.load(k);
    }
  std::fill_n(times_left_.begin(), count_, 0);
  for (int sets = 0; sets < most_sets; ++sets) {
    active_.clear();
    for (std::size_t j = 0; j < near_.size(); ++j)
      if (in_contact_[near_[j]]) active_.push_back(j);
    const std::size_t n = active_.size(), m = linear ? n : 2 * n;
    fill_system(linear, length);
    solve_system(linear);
    double force = 0;
    result.stiffness = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double weight = e.largest() * e.weight(active_[i]);
      force += right_[i] * weight, result.stiffness += per_lowering_[i] * weight;
    }
    result.lowering = vertical_force && n > 0 ? (*vertical_force - force) / result.stiffness : 0;
    for (std::size_t i = 0; i < m; ++i) right_[i] += result.lowering * per_lowering_[i];
    if (!change_contact(linear, length, result.lowering)) return true;
  }
  return false;
}

/// Takes the step from the active rows to all of them. Rows without load have the kappa over A of their neighbours.
void RowNormal::take_step(bool linear, Result& result) {
  const std::size_t n = active_.size();
  std::fill_n(next_load_.begin(), count_, 0.0);
  if (!linear) std::fill_n(change_.begin(), count_, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t row = near_[active_[i]];
    next_load_[row] = std::max(right_[i] * equations_.largest(), 0.0);
    if (!linear) change_[row] = right_[n + i];
  }
  const auto next = [&](std::size_t j) { return equations_.relative_kappa(j) + change_[near_[j]]; };
  for (std::size_t j = 0; j < near_.size(); ++j)
    if (!in_contact_[near_[j]] && equations_.has_greater_neighbour(j))
      change_[near_[j]] = equations_.mean_of_neighbours(j, next) - equations_.relative_kappa(j);
  double largest = 0;
  result.change = 0;
  for (std::size_t k = 0; k < count_; ++k) {
    largest = std::max(largest, next_load_[k]);
    result.change = std::max(result.change, std::abs(next_load_[k] - load_[k]));
  }
  result.change /= largest;
}

/// Takes the rows that are away from the loaded ones into the contact where they would overlap. Returns whether there
/// are any.
bool RowNormal::touch_elsewhere(std::span<const NormalRow> rows, double lowering) {
  bool any = false;
  for (std::size_t j = 0; j < count_; ++j) {
    if (is_near_[j]) continue;
    double gap = rows[j].gap - lowering * std::cos(rows[j].angle);
    for (std::size_t k = 0; k < count_ && gap < 0; ++k) {
      if (!(load_[k] > 0)) continue;
      const double d = distance_to_strip(rows[j], rows[k]), half = width_[k] / 2,
                   length = std::sqrt(2 * load_[k] / pi * std::exp(-log_kappa_[k]));
      gap += unit_ * std::cos(rows[j].angle - rows[k].angle) * load_[k] *
             detail::RowPair<double>::between(d - half, d + half, length, length).p;
    }
    in_contact_[j] = gap < 1e-7 * rows[j].gap;
    any |= in_contact_[j] != 0;
  }
  return any;
}

RowNormal::Result RowNormal::solve(const CombinedMaterial& material, std::span<const NormalRow> rows,
                                   std::optional<double> vertical_force, bool warm, int most_steps) noexcept {
  constexpr double enough = 1e-5, enough_turn = 1e-4, careful = 0.4, near = 0.01;
  constexpr int settling_steps = 16;
  Result result;
  unit_ = (1 - material.poisson_ratio) / (pi * material.shear_modulus);
  if (warm) warm = start_from_last(rows);
  count_ = rows.size();
  for (std::size_t k = 0; k < count_; ++k) width_[k] = rows[k].width;
  if (!warm) start(rows);
  near_.clear();
  std::fill_n(is_near_.begin(), count_, 0);
  double part = 1, most_turn = 0.5;
  int since_start = warm ? 2 : 0;
  result.status = Status::not_converged;
  while (result.steps < most_steps && result.status != Status::ok) {
    // The first two steps find loads and half-lengths in turn, each with the others held.
    const bool alone = since_start < 2;
    if (choose_rows()) equations_.set_rows(rows, near_, unit_);
    equations_.find(load_, log_kappa_, near_, alone);
    if (alone)
      change_alike();
    else
      equations_.hold_to_neighbours();
    const bool found = solve_active(vertical_force, alone, result);
    take_step(alone, result);
    double turned = 0;
    for (const std::size_t k : near_) turned = std::max(turned, std::abs(change_[k]));
    const double share = std::min(result.change < near ? 1 : part, most_turn / std::max(turned, most_turn));
    double largest = 0;
    for (std::size_t k = 0; k < count_; ++k) {
      load_[k] += share * (next_load_[k] - load_[k]), log_kappa_[k] += share * change_[k];
      largest = std::max(largest, load_[k]);
    }
    ++result.steps, ++since_start;
    // Where the steps do not settle, as rows come and go, a part of each, from the beginning.
    const bool unsettled = result.steps == settling_steps && result.change > enough;
    if (unsettled) part = careful, most_turn *= careful;
    if (unsettled || !(largest > 0) || !std::isfinite(result.change)) start(rows), since_start = 0;
    if (found && !alone && result.change < enough && turned < enough_turn && !touch_elsewhere(rows, result.lowering))
      result.status = Status::ok;
  }
  if (result.status != Status::ok && !(result.change > enough)) result.change = 1; // the active set has not settled
  for (std::size_t k = 0; k < count_; ++k) half_length_[k] = std::sqrt(2 * load_[k] / pi * std::exp(-log_kappa_[k]));
  return result;
}

} // namespace microslip
