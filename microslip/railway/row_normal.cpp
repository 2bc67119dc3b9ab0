#include "microslip/railway/row_normal.hpp"

#include "microslip/numerics/elimination.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace microslip {
namespace {

constexpr double pi = std::numbers::pi;
/// Share of the largest load below which a row's half-length in the influences falls no further.
constexpr double least_load = 3e-3;
/// Shares of a neighbour's load between which a row's kappa becomes its own.
constexpr double held_share = 0.05, free_share = 0.3;
/// Share of the largest load below which it does so less and less.
constexpr double small_load = 1e-2;

} // namespace

RowNormal::RowNormal(std::size_t most_rows) {
  for (std::vector<double>* matrix :
       {&distance_, &cosine_, &gap_by_load_, &gap_by_kappa_, &turn_by_load_, &turn_by_kappa_})
    matrix->resize(most_rows * most_rows);
  system_.resize(4 * most_rows * most_rows);
  for (std::vector<double>* row : {&load_, &log_kappa_, &width_, &s_, &half_length_, &by_load_, &level_, &weight_,
                                   &sine_, &gap_, &turn_, &next_load_, &change_})
    row->resize(most_rows);
  right_.resize(2 * most_rows), per_lowering_.resize(2 * most_rows);
  in_contact_.resize(most_rows);
  active_.reserve(most_rows), near_.reserve(most_rows), neighbours_.resize(most_rows);
}

void RowNormal::set_up(std::span<const NormalRow> rows) {
  for (std::size_t j = 0; j < count_; ++j) {
    width_[j] = rows[j].width, s_[j] = rows[j].s;
    level_[j] = std::cos(rows[j].angle), sine_[j] = std::sin(rows[j].angle);
    weight_[j] = rows[j].vertical_weight();
  }
  for (std::size_t j = 0; j < count_; ++j)
    for (std::size_t k = 0; k < count_; ++k) {
      const Vec3<double> way = rows[j].place - rows[k].place;
      // To a strip it is the distance across, as long as it is alongside.
      const double across = way.y * way.y + way.z * way.z, square = across + way.x * way.x;
      const double reach = std::max(-rows[k].gap, 0.0) / (2 * rows[k].curvature);
      at(distance_, j, k) = std::sqrt(across + way.x * way.x * square / (square + reach + 1e-30));
      at(cosine_, j, k) = level_[j] * level_[k] + sine_[j] * sine_[k];
    }
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

/// Each row has the load and the kappa of the last solve's row that holds its centre. False if none of them bears a
/// load.
bool RowNormal::start_from_last(std::span<const NormalRow> rows) {
  std::size_t old = 0;
  bool any = false;
  for (std::size_t k = 0; k < rows.size() && count_ > 0; ++k) {
    while (old + 1 < count_ && rows[k].s > s_[old] + width_[old] / 2) ++old;
    const bool inside = std::abs(rows[k].s - s_[old]) <= 0.5001 * width_[old];
    next_load_[k] = inside ? load_[old] : 0;
    change_[k] = log_kappa_[old];
    in_contact_[k] = next_load_[k] > 0;
    any |= next_load_[k] > 0;
  }
  std::copy_n(next_load_.begin(), rows.size(), load_.begin());
  std::copy_n(change_.begin(), rows.size(), log_kappa_.begin());
  return any;
}

void RowNormal::find_half_lengths() {
  largest_ = *std::max_element(load_.begin(), load_.begin() + static_cast<std::ptrdiff_t>(count_));
  for (std::size_t j = 0; j < count_; ++j) {
    // (q + root)/2, a smooth max(q, least).
    const double root = std::sqrt(load_[j] * load_[j] + 4 * std::pow(least_load * largest_, 2));
    half_length_[j] = std::sqrt((load_[j] + root) / pi * std::exp(-log_kappa_[j])), by_load_[j] = 0.5 / root;
  }
}

void RowNormal::find_near() {
  near_.clear();
  bool any = false;
  for (std::size_t k = 0; k < count_; ++k) any |= in_contact_[k] || load_[k] > 0;
  const auto taken = [&](std::size_t k) { return !any || in_contact_[k] || load_[k] > 0; };
  for (std::size_t j = 0; j < count_; ++j)
    if (taken(j) || (j > 0 && taken(j - 1)) || (j + 1 < count_ && taken(j + 1))) near_.push_back(j);
}

/// e, the residual ln(-2 T/(A a^2)) of ln(kappa), T = sum of dU/d(ln a) q, and the derivatives of both, with
/// ln(a) = ln(2 q/(pi kappa))/2.
void RowNormal::find_influences(std::span<const NormalRow> rows) {
  for (std::size_t j : near_) {
    double displacement = 0, turn = 0, turn_by_own = 0;
    for (std::size_t k : near_) {
      const double d = at(distance_, j, k), half = width_[k] / 2, load = load_[k];
      const RowInfluence::Values v = influence_.between(d - half, d + half, half_length_[j], half_length_[k]);
      const double factor = unit_ * at(cosine_, j, k);
      displacement += factor * v.p * load, turn -= factor * v.by_a * load, turn_by_own -= factor * v.by_aa * load;
      at(gap_by_load_, j, k) = factor * (v.p + load * v.by_b * by_load_[k]);
      at(gap_by_kappa_, j, k) = -factor * load * v.by_b / 2;
      at(turn_by_load_, j, k) = -factor * (v.by_a + load * v.by_ab * by_load_[k]);
      at(turn_by_kappa_, j, k) = factor * load * v.by_ab / 2;
    }
    const double curvature = rows[j].curvature * half_length_[j] * half_length_[j];
    gap_[j] = rows[j].gap + curvature / 4 + displacement;
    turn_[j] = std::log(2 * turn / curvature);
    for (std::size_t k : near_) at(turn_by_load_, j, k) /= turn, at(turn_by_kappa_, j, k) /= turn;
    const double by_own = turn_by_own / turn - 2;
    at(turn_by_load_, j, j) += by_own * by_load_[j], at(turn_by_kappa_, j, j) -= by_own / 2;
    // What a_j does to e_j vanishes with the other condition.
    const double by_length = curvature / 2 - turn;
    at(gap_by_load_, j, j) += by_length * by_load_[j], at(gap_by_kappa_, j, j) -= by_length / 2;
  }
}

/// The neighbours of each row, which touch it or nearly so: those that bear more, with shares in proportion to by how
/// much, and the other one.
void RowNormal::find_neighbours() {
  for (std::size_t i = 0; i < near_.size(); ++i) {
    const std::size_t j = near_[i];
    Neighbours& n = neighbours_[j];
    n = {{j, j}, {0, 0}};
    for (std::size_t side = 0; side < 2; ++side) {
      const std::size_t next = side == 0 ? i - 1 : i + 1;
      if (next >= near_.size()) continue;
      const std::size_t k = near_[next];
      if (at(distance_, j, k) > 0.75 * (width_[j] + width_[k])) continue;
      n.row[side] = k, n.share[side] = std::max(load_[k] - load_[j], 0.0);
    }
    n.rise = n.share[0] + n.share[1];
    for (double& share : n.share) share = n.rise > 0 ? share / n.rise : 0;
  }
}

/// ln(kappa/A) of a row.
double RowNormal::relative_kappa(std::span<const NormalRow> rows, std::size_t j) const {
  return log_kappa_[j] - std::log(rows[j].curvature);
}

/// The mean of the neighbours of a row that bear more.
double RowNormal::Neighbours::mean(const auto& of_row) const {
  return share[0] * of_row(row[0]) + share[1] * of_row(row[1]);
}

/// Rows with little load beside their neighbours have their kappa over A: a share of it that falls with u = q/q', q'
/// the load of the neighbour, or of the lesser one if both bear more than the row. If one bears less, q", the row is
/// free earlier: u = q^2/(q'(q - q")). Rows with next to no load are held in any case.
void RowNormal::hold_to_neighbours(std::span<const NormalRow> rows) {
  for (std::size_t j : near_) {
    const Neighbours& n = neighbours_[j];
    if (!(n.rise > 0)) continue;
    const std::size_t first = n.share[0] > 0 && !(n.share[1] > 0 && load_[n.row[1]] < load_[n.row[0]]) ? 0 : 1;
    const std::size_t other = n.row[first], back = n.row[1 - first];
    const double load = load_[j], above = load_[other], rest = load_[back] < load ? load_[back] : 0;
    const double u = load > 0 ? load * load / (above * (load - rest)) : 0;
    const double part = std::clamp((u - held_share) / (free_share - held_share), 0.0, 1.0),
                 size = std::min(load / (small_load * largest_), 1.0), own = part * size;
    if (own == 1) continue;
    const auto relative = [&](std::size_t k) { return relative_kappa(rows, k); };
    const double mean = n.mean(relative), apart = relative(j) - mean, change = turn_[j] - apart;
    turn_[j] = own * turn_[j] + (1 - own) * apart;
    for (std::size_t k : near_) at(turn_by_load_, j, k) *= own, at(turn_by_kappa_, j, k) *= own;
    at(turn_by_kappa_, j, j) += 1 - own;
    for (std::size_t side = 0; side < 2; ++side) {
      if (!(n.share[side] > 0)) continue;
      const double by_share = (1 - own) * (relative(n.row[side]) - mean) / n.rise;
      at(turn_by_kappa_, j, n.row[side]) -= (1 - own) * n.share[side];
      at(turn_by_load_, j, n.row[side]) -= by_share, at(turn_by_load_, j, j) += by_share;
    }
    if (size < 1) at(turn_by_load_, j, j) += part * change / (small_load * largest_);
    if (!(part > 0 && part < 1)) continue;
    const double by_u = size * change / (free_share - held_share) * u;
    at(turn_by_load_, j, j) += by_u * (2 / load - 1 / (load - rest));
    at(turn_by_load_, j, other) -= by_u / above;
    if (rest > 0) at(turn_by_load_, j, back) += by_u / (load - rest);
  }
}

/// The same change of ln(kappa) for all rows, with which the mean of its residual vanishes, loads as weights.
void RowNormal::change_alike() {
  double sum = 0, by_all = 0;
  for (std::size_t j : near_) {
    sum += load_[j] * turn_[j];
    for (std::size_t k : near_) by_all += load_[j] * at(turn_by_kappa_, j, k);
  }
  std::fill_n(change_.begin(), count_, -sum / by_all);
}

/// The complementarity problem of Newton's matrices. Returns whether its active set was found.
bool RowNormal::solve_active(std::optional<double> vertical_force, bool linear, Result& result) {
  constexpr int most_sets = 30;
  const double length = std::abs(gap_by_load_[near_.front() * (count_ + 1)]) * largest_; // about that of gaps
  // What the equations have without changes, and with zero loads.
  const auto constant = [&](const std::vector<double>& residual, const std::vector<double>& by_load, std::size_t j) {
    double sum = -residual[j];
    for (std::size_t k : near_) sum += at(by_load, j, k) * load_[k];
    return sum;
  };
  for (int sets = 0; sets < most_sets; ++sets) {
    active_.clear();
    for (std::size_t k : near_)
      if (in_contact_[k]) active_.push_back(k);
    const std::size_t n = active_.size(), m = linear ? n : 2 * n;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = active_[i];
      right_[i] = constant(gap_, gap_by_load_, j) / length, per_lowering_[i] = level_[j] / length;
      for (std::size_t l = 0; l < n; ++l) {
        const std::size_t k = active_[l];
        system_[i * m + l] = at(gap_by_load_, j, k) * largest_ / length;
        if (linear) continue;
        system_[i * m + n + l] = at(gap_by_kappa_, j, k) / length;
        system_[(n + i) * m + l] = at(turn_by_load_, j, k) * largest_;
        system_[(n + i) * m + n + l] = at(turn_by_kappa_, j, k);
      }
      if (linear) continue;
      right_[n + i] = constant(turn_, turn_by_load_, j), per_lowering_[n + i] = 0;
    }
    // Without a solution loads are no numbers, and the next step starts anew.
    if (!eliminate(std::span(system_).first(m * m), {std::span(right_).first(m), std::span(per_lowering_).first(m)}))
      std::fill_n(right_.begin(), m, std::numeric_limits<double>::quiet_NaN());
    double force = 0;
    result.stiffness = 0;
    for (std::size_t i = 0; i < n; ++i) {
      force += right_[i] * largest_ * weight_[active_[i]];
      result.stiffness += per_lowering_[i] * largest_ * weight_[active_[i]];
    }
    result.lowering = vertical_force && n > 0 ? (*vertical_force - force) / result.stiffness : 0;
    for (std::size_t i = 0; i < m; ++i) right_[i] += result.lowering * per_lowering_[i];
    bool changed = false;
    double largest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      largest = std::max(largest, right_[i]);
      if (!(right_[i] > 0)) in_contact_[active_[i]] = 0, changed = true;
    }
    if (changed && largest > 0) continue;
    for (std::size_t k : near_) {
      if (in_contact_[k]) continue;
      double e = -constant(gap_, gap_by_load_, k) - result.lowering * level_[k];
      for (std::size_t i = 0; i < n; ++i) {
        e += at(gap_by_load_, k, active_[i]) * right_[i] * largest_;
        if (!linear) e += at(gap_by_kappa_, k, active_[i]) * right_[n + i];
      }
      if (e < -1e-12 * length) in_contact_[k] = 1, changed = true;
    }
    if (!changed) return true;
  }
  return false;
}

/// From the active rows to all of them.
void RowNormal::take_step(std::span<const NormalRow> rows, bool linear, Result& result) {
  const std::size_t n = active_.size();
  std::fill_n(next_load_.begin(), count_, 0.0);
  if (!linear) std::fill_n(change_.begin(), count_, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    next_load_[active_[i]] = std::max(right_[i] * largest_, 0.0);
    if (!linear) change_[active_[i]] = right_[n + i];
  }
  const auto next = [&](std::size_t k) { return relative_kappa(rows, k) + change_[k]; };
  for (std::size_t k : near_)
    if (!in_contact_[k] && neighbours_[k].rise > 0) change_[k] = neighbours_[k].mean(next) - relative_kappa(rows, k);
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
  auto near = near_.begin();
  for (std::size_t j = 0; j < count_; ++j) {
    if (near != near_.end() && *near == j) {
      ++near;
      continue;
    }
    double e = rows[j].gap - lowering * level_[j];
    for (std::size_t k = 0; k < count_ && e < 0; ++k) {
      if (!(load_[k] > 0)) continue;
      const double d = at(distance_, j, k), half = width_[k] / 2;
      e += unit_ * at(cosine_, j, k) * load_[k] *
           influence_.between(d - half, d + half, half_length_[j], half_length_[k]).p;
    }
    in_contact_[j] = e < 1e-7 * rows[j].gap;
    any |= in_contact_[j] != 0;
  }
  return any;
}

RowNormal::Result RowNormal::solve(const CombinedMaterial& material, std::span<const NormalRow> rows,
                                   std::optional<double> vertical_force, bool warm, int most_steps) noexcept {
  constexpr double enough = 1e-6, most_turn = 0.5;
  constexpr int settling_steps = 15;
  Result result;
  unit_ = (1 - material.poisson_ratio) / (pi * material.shear_modulus);
  if (warm) warm = start_from_last(rows);
  count_ = rows.size();
  set_up(rows);
  if (!warm) start(rows);
  result.status = Status::not_converged;
  find_half_lengths();
  for (result.steps = 0; result.steps < most_steps && result.status != Status::ok;) {
    // The first two steps find loads and half-lengths in turn, each with the others held.
    const bool alone = !warm && result.steps < 2;
    if (alone) std::fill_n(by_load_.begin(), count_, 0.0);
    find_near();
    find_neighbours();
    find_influences(rows);
    if (alone)
      change_alike();
    else
      hold_to_neighbours(rows);
    const bool found = solve_active(vertical_force, alone, result);
    take_step(rows, alone, result);
    double turned = 0;
    for (std::size_t k : near_) turned = std::max(turned, std::abs(change_[k]));
    // Where the steps do not settle, as rows come and go, half of each.
    const double share = std::min(result.steps >= settling_steps ? 0.5 : 1.0, most_turn / std::max(turned, most_turn));
    for (std::size_t k = 0; k < count_; ++k) {
      next_load_[k] = load_[k] + share * (next_load_[k] - load_[k]);
      log_kappa_[k] += share * change_[k];
    }
    std::copy_n(next_load_.begin(), count_, load_.begin());
    ++result.steps;
    find_half_lengths();
    if (!(largest_ > 0) || !std::isfinite(result.change)) start(rows), find_half_lengths(), warm = false;
    if (found && !alone && result.change < enough && turned < 1e-3 && !touch_elsewhere(rows, result.lowering))
      result.status = Status::ok;
  }
  if (result.status != Status::ok && !(result.change > enough)) result.change = 1; // the active set has not settled
  for (std::size_t k = 0; k < count_; ++k) half_length_[k] = std::sqrt(2 * load_[k] / pi * std::exp(-log_kappa_[k]));
  return result;
}

} // namespace microslip
