#include "microslip/railway/row_normal.hpp"

#include "microslip/numerics/elimination.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace microslip {
namespace {

constexpr double pi = std::numbers::pi;
/// Rows without load have the half-length of this share of the largest load, for the case that they come into contact.
constexpr double first_load = 1e-2;
/// Rows with less than this share of another row's load enter that row's curvature in proportion.
constexpr double full_share = 0.06;

} // namespace

RowNormal::RowNormal(std::size_t most_rows) {
  for (std::vector<double>* matrix :
       {&distance_, &cosine_, &influence_matrix_, &by_kappa_, &curvature_by_load_, &system_})
    matrix->resize(most_rows * most_rows);
  for (std::vector<double>* row : {&load_, &log_kappa_, &half_length_, &width_, &s_, &level_, &weight_, &root_load_,
                                   &next_load_, &right_, &per_lowering_, &displacement_, &residual_, &slope_})
    row->resize(most_rows);
  in_contact_.resize(most_rows);
  active_.reserve(most_rows), loaded_.reserve(most_rows), near_.reserve(most_rows);
}

void RowNormal::set_up(std::span<const NormalRow> rows) {
  for (std::size_t j = 0; j < count_; ++j) {
    const double cosine = std::cos(rows[j].angle), sine = std::sin(rows[j].angle);
    width_[j] = rows[j].width, s_[j] = rows[j].s, level_[j] = cosine, slope_[j] = sine;
    weight_[j] = rows[j].vertical_weight();
  }
  for (std::size_t j = 0; j < count_; ++j)
    for (std::size_t k = 0; k < count_; ++k) {
      const Vec3<double> way = rows[j].place - rows[k].place;
      // To a strip it is the distance across, as long as it is alongside.
      const double across = way.y * way.y + way.z * way.z, square = across + way.x * way.x;
      const double reach = std::max(-rows[k].gap, 0.0) / (2 * rows[k].curvature);
      at(distance_, j, k) = std::sqrt(across + way.x * way.x * square / (square + reach + 1e-30));
      at(cosine_, j, k) = level_[j] * level_[k] + slope_[j] * slope_[k];
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
    residual_[k] = log_kappa_[old];
    in_contact_[k] = next_load_[k] > 0;
    any |= next_load_[k] > 0;
  }
  std::copy_n(next_load_.begin(), rows.size(), load_.begin());
  std::copy_n(residual_.begin(), rows.size(), log_kappa_.begin());
  return any;
}

void RowNormal::find_half_lengths() {
  const double first =
      first_load * *std::max_element(load_.begin(), load_.begin() + static_cast<std::ptrdiff_t>(count_));
  loaded_.clear();
  for (std::size_t j = 0; j < count_; ++j) {
    const bool loaded = load_[j] > 0;
    if (loaded) loaded_.push_back(j);
    half_length_[j] = std::sqrt(2 * (loaded ? load_[j] : first) / pi * std::exp(-log_kappa_[j]));
  }
  near_.clear();
  bool any = false;
  for (std::size_t k = 0; k < count_; ++k) any |= in_contact_[k] || load_[k] > 0;
  const auto taken = [&](std::size_t k) { return !any || in_contact_[k] || load_[k] > 0; };
  for (std::size_t j = 0; j < count_; ++j)
    if (taken(j) || (j > 0 && taken(j - 1)) || (j + 1 < count_ && taken(j + 1))) near_.push_back(j);
}

/// U of a pair of rows.
double RowNormal::displacement_under(std::size_t j, std::size_t k) const {
  const double inverse = 1 / half_length_[k], d = at(distance_, j, k), half = width_[k] / 2;
  return unit_ * 2 / pi * at(cosine_, j, k) *
         (influence_.at((d + half) * inverse).phi - influence_.at((d - half) * inverse).phi);
}

/// U and, unless it is to be linear in q, its derivatives with respect to q and ln(kappa), with a^2 = 2 q/(pi kappa):
/// d(U q)/dq = C 2/pi (Phi - delta f/2), d(U q)/d ln(kappa) = C 2/pi q delta f/2, between both edges of the strip.
void RowNormal::find_influences(bool linear) {
  for (std::size_t j : near_) {
    displacement_[j] = 0;
    for (std::size_t k : near_) {
      const double inverse = 1 / half_length_[k], d = at(distance_, j, k), half = width_[k] / 2;
      const double high = (d + half) * inverse, low = (d - half) * inverse;
      const RowInfluence::Values outer = influence_.at(high), inner = influence_.at(low);
      const double factor = unit_ * 2 / pi * at(cosine_, j, k);
      const double u = factor * (outer.phi - inner.phi);
      const double turn = linear ? 0 : factor / 2 * (high * outer.f - low * inner.f);
      if (load_[k] > 0) displacement_[j] += u * load_[k];
      at(influence_matrix_, j, k) = u - turn;
      at(by_kappa_, j, k) = turn * load_[k];
    }
  }
}

/// Residuals ln(C kappa S/(2 A)), S = sum of tau Psi between the edges of each strip, tau = min(1, q_k/(0.06 q_j)),
/// with all kappa equal to that of the row, and their derivatives.
void RowNormal::find_curvatures(std::span<const NormalRow> rows, bool alone) {
  for (std::size_t k : near_) root_load_[k] = half_length_[k] * std::exp(log_kappa_[k] / 2);
  for (std::size_t j : near_) {
    const double root = std::exp(log_kappa_[j] / 2);
    double sum = 0, by_own = 0, by_load = 0;
    for (std::size_t k : near_) {
      const double inverse = root / root_load_[k], d = at(distance_, j, k), half = width_[k] / 2;
      const double high = (d + half) * inverse, low = (d - half) * inverse;
      const RowInfluence::Values outer = influence_.at(high), inner = influence_.at(low);
      const double strip = at(cosine_, j, k) * (outer.psi - inner.psi);
      if (!(load_[k] > 0)) {
        if (!alone) at(curvature_by_load_, j, k) = load_[j] > 0 ? strip / (full_share * load_[j]) : 0;
        continue;
      }
      const bool full = load_[k] >= full_share * load_[j];
      const double share = full ? 1 : load_[k] / (full_share * load_[j]), part = share * strip;
      const double turn = share * at(cosine_, j, k) / 2 * (high * outer.curvature - low * inner.curvature);
      const double by_share = full ? 0 : part;
      sum += part, by_own += turn, by_load += by_share;
      if (!alone) at(curvature_by_load_, j, k) = (by_share - turn) / load_[k];
    }
    residual_[j] = log_kappa_[j] + std::log(unit_ * sum / (2 * rows[j].curvature));
    slope_[j] = 1 + by_own / sum;
    if (alone) continue;
    for (std::size_t k : near_) at(curvature_by_load_, j, k) /= sum;
    if (load_[j] > 0) at(curvature_by_load_, j, j) -= by_load / (load_[j] * sum);
  }
}

/// The Newton matrix for q, and the right-hand side of M q = right + zeta cos(angle).
void RowNormal::eliminate_curvatures(std::span<const NormalRow> rows, bool alone) {
  for (std::size_t j : near_) {
    double* const row = &at(influence_matrix_, j, 0);
    right_[j] = -rows[j].gap - displacement_[j];
    for (std::size_t l : loaded_) {
      if (alone) break;
      const double factor = at(by_kappa_, j, l) / slope_[l];
      const double* const curvature = &at(curvature_by_load_, l, 0);
      for (std::size_t k : near_) row[k] -= factor * curvature[k];
      right_[j] += factor * residual_[l];
    }
    for (std::size_t k : loaded_) right_[j] += row[k] * load_[k];
  }
}

/// The complementarity problem that the Newton matrix stands for. Returns whether its active set was found.
bool RowNormal::solve_active(std::optional<double> vertical_force, Result& result) {
  constexpr int most_sets = 30;
  for (int sets = 0; sets < most_sets; ++sets) {
    active_.clear();
    for (std::size_t k : near_)
      if (in_contact_[k]) active_.push_back(k);
    const std::size_t n = active_.size();
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) system_[i * n + j] = at(influence_matrix_, active_[i], active_[j]);
      next_load_[i] = right_[active_[i]], per_lowering_[i] = level_[active_[i]];
    }
    // Without a solution loads are no numbers, and the next step starts anew.
    if (!eliminate(std::span(system_).first(n * n),
                   {std::span(next_load_).first(n), std::span(per_lowering_).first(n)}))
      std::fill_n(next_load_.begin(), n, std::numeric_limits<double>::quiet_NaN());
    double force = 0;
    result.stiffness = 0;
    for (std::size_t i = 0; i < n; ++i) {
      force += next_load_[i] * weight_[active_[i]];
      result.stiffness += per_lowering_[i] * weight_[active_[i]];
    }
    result.lowering = vertical_force && n > 0 ? (*vertical_force - force) / result.stiffness : 0;
    bool changed = false;
    double largest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      next_load_[i] += result.lowering * per_lowering_[i];
      largest = std::max(largest, next_load_[i]);
      if (!(next_load_[i] > 0)) in_contact_[active_[i]] = 0, changed = true;
    }
    if (changed && largest > 0) continue;
    const double tolerance = 1e-12 * largest * at(influence_matrix_, near_.front(), near_.front());
    for (std::size_t k : near_) {
      if (in_contact_[k]) continue;
      double e = -right_[k] - result.lowering * level_[k];
      for (std::size_t i = 0; i < n; ++i) e += at(influence_matrix_, k, active_[i]) * next_load_[i];
      if (e < -tolerance) in_contact_[k] = 1, changed = true;
    }
    if (!changed) return true;
  }
  return false;
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
    for (std::size_t k = 0; k < count_ && e < 0; ++k)
      if (load_[k] > 0) e += displacement_under(j, k) * load_[k];
    in_contact_[j] = e < 1e-7 * rows[j].gap;
    any |= in_contact_[j] != 0;
  }
  return any;
}

/// Newton's step of ln(kappa) after that of q: slope change = -(residual + d(residual)/dq dq).
void RowNormal::change_curvatures() {
  constexpr double most = 1;
  for (std::size_t j : near_) {
    double rest = residual_[j];
    for (std::size_t k : near_) rest += at(curvature_by_load_, j, k) * (next_load_[k] - load_[k]);
    log_kappa_[j] -= std::clamp(rest / slope_[j], -most, most);
  }
}

RowNormal::Result RowNormal::solve(const CombinedMaterial& material, std::span<const NormalRow> rows,
                                   std::optional<double> vertical_force, bool warm, int most_steps) noexcept {
  constexpr double enough = 1e-6;
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
    // The first two steps find loads and half-lengths in turn.
    const bool linear = !warm && result.steps == 0, alone = !warm && result.steps < 2;
    find_influences(linear);
    if (!alone) find_curvatures(rows, alone);
    eliminate_curvatures(rows, alone);
    const bool found = solve_active(vertical_force, result);
    // From the active rows to all of them, from behind: nothing is overwritten before it is read.
    std::size_t i = active_.size();
    for (std::size_t k = count_; k-- > 0;)
      next_load_[k] = i > 0 && active_[i - 1] == k ? std::max(next_load_[--i], 0.0) : 0.0;
    double largest = 0;
    result.change = 0;
    for (std::size_t k = 0; k < count_; ++k) {
      largest = std::max(largest, next_load_[k]);
      result.change = std::max(result.change, std::abs(next_load_[k] - load_[k]));
    }
    result.change /= largest;
    // Where the steps do not settle, as rows come and go, half of each.
    if (result.steps >= settling_steps)
      for (std::size_t k = 0; k < count_; ++k) next_load_[k] = (next_load_[k] + load_[k]) / 2;
    if (!alone) change_curvatures();
    std::copy_n(next_load_.begin(), count_, load_.begin());
    if (alone) {
      find_half_lengths();
      find_curvatures(rows, alone);
      for (std::size_t k : near_) log_kappa_[k] -= std::clamp(residual_[k] / slope_[k], -1.0, 1.0);
    }
    ++result.steps;
    if (!(largest > 0) || !std::isfinite(result.change)) start(rows), warm = false;
    if (found && !alone && result.change < enough && !touch_elsewhere(rows, result.lowering))
      result.status = Status::ok;
    find_half_lengths();
  }
  if (result.status != Status::ok && !(result.change > enough)) result.change = 1; // the active set has not settled
  return result;
}

} // namespace microslip
