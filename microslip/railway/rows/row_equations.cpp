#include "microslip/railway/rows/row_equations.hpp"

#include "microslip/numerics/kernel/dispatch.hpp"

#include <algorithm>
#include <numbers>

namespace microslip {
namespace detail {
MICROSLIP_DECLARE_KERNEL(FindRowPairs find_row_pairs())
static FindRowPairs row_pairs_kernel(InstructionSet instruction_set) {
  return MICROSLIP_CALL_KERNEL(instruction_set, find_row_pairs());
}
} // namespace detail
namespace {

constexpr double pi = std::numbers::pi;
/// Share of the largest load below which a row's half-length in the influences falls no further.
constexpr double least_load = 3e-3;
/// Share of a neighbour's load at which half of a row's kappa is its own.
constexpr double half_share = 0.2;
constexpr double smoothing = 0.02; // of kappa, times a half-length over the distance of rows
/// Share of the largest load below which it does so less and less.
constexpr double small_load = 2e-3;

std::size_t filled_up(std::size_t count) {
  return (count + detail::row_block - 1) / detail::row_block * detail::row_block;
}

} // namespace

/// Distance across to a strip, as long as the row is alongside.
double distance_to_strip(const NormalRow& row, const NormalRow& loaded) {
  const double reach = std::max(-loaded.gap, 0.0) / (2 * loaded.curvature);
  const Vec3<double> offset = row.place - loaded.place;
  const double across = offset.y * offset.y + offset.z * offset.z, along = offset.x * offset.x, square = across + along;
  return std::sqrt(along > 0 ? across + along * square / (square + reach + 1e-30) : across);
}

RowEquations::RowEquations(std::size_t most_rows, InstructionSet instruction_set)
    : find_pairs_(detail::row_pairs_kernel(instruction_set)), neighbours_(most_rows) {
  const std::size_t most = filled_up(most_rows);
  for (std::vector<double>* pairs :
       {&distance_, &factor_, &gap_by_load_, &gap_by_kappa_, &turn_by_load_, &turn_by_kappa_})
    pairs->resize(most_rows * most);
  for (std::vector<double>* row :
       {&level_, &sine_, &weight_, &half_width_, &given_gap_, &curvature_, &log_curvature_, &load_, &log_kappa_,
        &half_length_, &by_load_, &by_largest_, &gap_, &turn_, &inverse_turn_, &turn_by_length_})
    row->resize(most);
}

void RowEquations::set_rows(std::span<const NormalRow> rows, std::span<const std::size_t> active, double unit) {
  count_ = active.size(), stride_ = filled_up(count_);
  for (std::size_t j = 0; j < count_; ++j) {
    const NormalRow& row = rows[active[j]];
    level_[j] = std::cos(row.angle), sine_[j] = std::sin(row.angle);
    weight_[j] = row.width * (level_[j] + row.shear * sine_[j]);
    half_width_[j] = row.width / 2, given_gap_[j] = row.gap;
    curvature_[j] = row.curvature, log_curvature_[j] = std::log(row.curvature);
  }
  for (std::size_t k = 0; k < count_; ++k) {
    for (std::size_t j = 0; j < count_; ++j) {
      distance_[k * stride_ + j] = distance_to_strip(rows[active[j]], rows[active[k]]);
      factor_[k * stride_ + j] = unit * (level_[j] * level_[k] + sine_[j] * sine_[k]);
    }
    for (std::size_t j = count_; j < stride_; ++j) distance_[k * stride_ + j] = 1, factor_[k * stride_ + j] = 0;
  }
}

void RowEquations::find_half_lengths(bool held) {
  const auto largest = std::max_element(load_.begin(), load_.begin() + static_cast<std::ptrdiff_t>(count_));
  largest_row_ = static_cast<std::size_t>(largest - load_.begin()), largest_ = *largest;
  for (std::size_t j = 0; j < count_; ++j) {
    // (q + root)/2, a smooth max(q, least).
    const double least = least_load * largest_, root = std::sqrt(load_[j] * load_[j] + 4 * least * least);
    half_length_[j] = std::sqrt((load_[j] + root) / pi * std::exp(-log_kappa_[j]));
    by_load_[j] = held ? 0 : 0.5 / root;
    by_largest_[j] = held ? 0 : 2 * least_load * least / (root * (load_[j] + root));
  }
  std::fill(half_length_.begin() + static_cast<std::ptrdiff_t>(count_),
            half_length_.begin() + static_cast<std::ptrdiff_t>(stride_), 1.0);
}

/// The residual of ln(kappa) is ln(-2 T/(A a^2)), T = sum of dU/d(ln a) q; ln(a) = ln(2 q/(pi kappa))/2.
void RowEquations::find(std::span<const double> load, std::span<const double> log_kappa,
                        std::span<const std::size_t> active, bool held) {
  for (std::size_t j = 0; j < count_; ++j) load_[j] = load[active[j]], log_kappa_[j] = log_kappa[active[j]];
  find_half_lengths(held);
  find_neighbours();
  find_pairs_({static_cast<int>(count_), static_cast<int>(stride_), distance_.data(), factor_.data(),
               half_length_.data(), half_width_.data(), load_.data(), by_load_.data(), gap_by_load_.data(),
               gap_by_kappa_.data(), turn_by_load_.data(), turn_by_kappa_.data(), gap_.data(), turn_.data(),
               turn_by_length_.data()});
  for (std::size_t j = 0; j < count_; ++j) inverse_turn_[j] = 1 / turn_[j];
  for (std::size_t k = 0; k < count_; ++k)
    for (std::size_t j = 0; j < count_; ++j) {
      turn_by_load_[k * stride_ + j] *= inverse_turn_[j], turn_by_kappa_[k * stride_ + j] *= inverse_turn_[j];
    }
  for (std::size_t j = 0; j < count_; ++j) {
    const double curvature = curvature_[j] * half_length_[j] * half_length_[j];
    const double by_own = turn_by_length_[j] * inverse_turn_[j] - 2, by_length = curvature / 2 - turn_[j];
    const std::size_t own = j * stride_ + j;
    turn_by_load_[own] += by_own * by_load_[j], turn_by_kappa_[own] -= by_own / 2;
    // What a_j does to e_j vanishes with the other condition.
    gap_by_load_[own] += by_length * by_load_[j], gap_by_kappa_[own] -= by_length / 2;
    gap_[j] += given_gap_[j] + curvature / 4;
    turn_[j] = std::log(2 * turn_[j] / curvature);
  }
  add_largest();
}

/// All half-lengths depend on the largest load, that of rows with next to none more than slightly. Their logarithms
/// have the derivatives -1/2 by ln(kappa).
void RowEquations::add_largest() {
  constexpr double slight = 1e-7;
  const std::size_t at = largest_row_ * stride_;
  for (std::size_t k = 0; k < count_; ++k) {
    if (!(by_largest_[k] * largest_ > slight)) continue;
    for (std::size_t j = 0; j < count_; ++j) {
      gap_by_load_[at + j] -= 2 * by_largest_[k] * gap_by_kappa_[k * stride_ + j];
      turn_by_load_[at + j] -= 2 * by_largest_[k] * turn_by_kappa_[k * stride_ + j];
    }
  }
}

/// The neighbours of each row, which touch it or nearly so.
void RowEquations::find_neighbours() {
  for (std::size_t j = 0; j < count_; ++j) {
    Neighbours& n = neighbours_[j];
    n = {{j, j}, {0, 0}};
    for (std::size_t side = 0; side < 2; ++side) {
      const std::size_t k = side == 0 ? j - 1 : j + 1;
      if (k >= count_ || distance_[k * stride_ + j] > 1.5 * (half_width_[j] + half_width_[k])) continue;
      n.row[side] = k, n.share[side] = std::max(load_[k] - load_[j], 0.0);
    }
    n.rise = n.share[0] + n.share[1];
    for (double& share : n.share) share = n.rise > 0 ? share / n.rise : 0;
  }
}

/// Share u/(u + 0.2), where u = q^2/(q'(q - q")) beside a neighbour that carries more, q', and one that carries less,
/// q", and q/(q' - q) between two that carry more, q' the lesser load; less for rows with next to no load, and more for
/// those that carry hardly less than their neighbours.
RowEquations::OwnShare RowEquations::own_share(std::size_t j) const {
  const Neighbours& n = neighbours_[j];
  const double load = load_[j];
  if (!(load > 0)) return {0};
  const bool valley = n.share[0] > 0 && n.share[1] > 0;
  const std::size_t first = valley ? load_[n.row[1]] < load_[n.row[0]] : n.share[1] > 0, second = 1 - first;
  const double above = load_[n.row[first]];
  double u = 0, by_load = 0; // and its logarithmic derivatives
  std::array<double, 2> by_neighbour{};
  if (valley) {
    u = load / (above - load);
    by_load = 1 / load + 1 / (above - load), by_neighbour[first] = -1 / (above - load);
  } else {
    const bool has_other = n.row[second] != j;
    const double rest = has_other ? load - load_[n.row[second]] : load;
    u = load * load / (above * rest);
    by_load = 2 / load - 1 / rest, by_neighbour[first] = -1 / above;
    if (has_other) by_neighbour[second] = 1 / rest;
  }
  const double part = std::isfinite(u) ? u / (u + half_share) : 1, small = small_load * largest_,
               size = load / (load + small), both = n.rise + load, less = n.rise / both, held = 1 - part * size;
  OwnShare own{1 - held * less};
  own.by_largest = -less * part * small_load * load / ((load + small) * (load + small));
  own.by_load = less * part * small / ((load + small) * (load + small)) + held * n.rise / (both * both);
  const double by_u = std::isfinite(u) ? less * size * part * (1 - part) : 0;
  own.by_load += by_u * by_load;
  for (std::size_t side = 0; side < 2; ++side) {
    const double by_rise = n.share[side] > 0 ? held * load / (both * both) : 0;
    own.by_neighbour[side] = by_u * by_neighbour[side] - by_rise, own.by_load += by_rise;
  }
  return own;
}

/// Rows much narrower than long have no kappa of their own either: a neighbour at the distance d holds it with
/// 0.02 a/d, in proportion to its share of both loads.
void RowEquations::smooth_kappa() {
  for (std::size_t j = 0; j < count_; ++j) {
    if (!(load_[j] > 0)) continue;
    double sum = 0;
    for (const std::size_t k : neighbours_[j].row) {
      if (k == j || !(load_[k] > 0)) continue;
      const double both = load_[j] + load_[k], apart = relative_kappa(j) - relative_kappa(k);
      const double stiffness = smoothing * half_length_[j] / distance_[k * stride_ + j],
                   held = stiffness * load_[k] / both;
      sum += held * apart;
      turn_by_kappa_[j * stride_ + j] += held, turn_by_kappa_[k * stride_ + j] -= held;
      const double by_load = stiffness * apart / (both * both);
      turn_by_load_[j * stride_ + j] -= by_load * load_[k], turn_by_load_[k * stride_ + j] += by_load * load_[j];
    }
    turn_[j] += sum;
    turn_by_load_[j * stride_ + j] += sum * by_load_[j], turn_by_kappa_[j * stride_ + j] -= sum / 2;
    turn_by_load_[largest_row_ * stride_ + j] += sum * by_largest_[j];
  }
}

void RowEquations::hold_to_neighbours() {
  smooth_kappa();
  for (std::size_t j = 0; j < count_; ++j) {
    const Neighbours& n = neighbours_[j];
    if (!(n.rise > 0)) continue;
    const OwnShare own = own_share(j);
    if (own.share == 1) continue;
    const auto relative = [this](std::size_t k) { return relative_kappa(k); };
    const double mean = mean_of_neighbours(j, relative), apart = relative(j) - mean, change = turn_[j] - apart,
                 held = 1 - own.share;
    turn_[j] = own.share * turn_[j] + held * apart;
    for (std::size_t k = 0; k < count_; ++k)
      turn_by_load_[k * stride_ + j] *= own.share, turn_by_kappa_[k * stride_ + j] *= own.share;
    turn_by_kappa_[j * stride_ + j] += held, turn_by_load_[j * stride_ + j] += change * own.by_load;
    turn_by_load_[largest_row_ * stride_ + j] += change * own.by_largest;
    for (std::size_t side = 0; side < 2; ++side) {
      const std::size_t k = n.row[side];
      const double by_share = n.share[side] > 0 ? held * (relative(k) - mean) / n.rise : 0;
      turn_by_kappa_[k * stride_ + j] -= held * n.share[side];
      turn_by_load_[k * stride_ + j] += change * own.by_neighbour[side] - by_share;
      turn_by_load_[j * stride_ + j] += by_share;
    }
  }
}

} // namespace microslip
