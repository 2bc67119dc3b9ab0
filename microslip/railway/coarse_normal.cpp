#include "microslip/railway/coarse_normal.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace microslip {
namespace {

/// The corner function of a rectangle's displacement, x ln(y + r) + y ln(x + r) but for terms that cancel over the
/// corners: odd in x and y.
double corner_function(double x, double y) {
  return x * std::asinh(y / std::abs(x)) + y * std::asinh(x / std::abs(y));
}

/// Solves L L' x = b in place for two right-hand sides.
void substitute(const std::vector<double>& l, std::size_t n, std::size_t row, std::vector<double>& b,
                std::vector<double>& c) {
  for (std::size_t i = 0; i < n; ++i) {
    double sum_b = b[i], sum_c = c[i];
    for (std::size_t k = 0; k < i; ++k) sum_b -= l[i * row + k] * b[k], sum_c -= l[i * row + k] * c[k];
    b[i] = sum_b / l[i * row + i], c[i] = sum_c / l[i * row + i];
  }
  for (std::size_t i = n; i-- > 0;) {
    b[i] /= l[i * row + i], c[i] /= l[i * row + i];
    for (std::size_t k = 0; k < i; ++k) b[k] -= l[i * row + k] * b[i], c[k] -= l[i * row + k] * c[i];
  }
}

/// Cholesky's factor in place, of the lower triangle; `column` is memory for one column.
void factorise(std::vector<double>& a, std::size_t n, std::size_t row, std::vector<double>& column) {
  for (std::size_t k = 0; k < n; ++k) {
    const double root = std::sqrt(a[k * row + k]), inverse = 1 / root;
    a[k * row + k] = root;
    for (std::size_t i = k + 1; i < n; ++i) column[i] = a[i * row + k] *= inverse;
    for (std::size_t i = k + 1; i < n; ++i) {
      const double factor = column[i];
      double* line = &a[i * row];
      for (std::size_t j = k + 1; j <= i; ++j) line[j] -= factor * column[j];
    }
  }
}

} // namespace

CoarseNormal::CoarseNormal(std::size_t most_elements)
    : most_(most_elements), matrix_(most_ * most_), factor_(most_ * most_), corner_(4 * (most_ + 2)),
      offset_(4 * (most_ + 2)), gap_(most_), slope_(most_), weight_(most_), root_area_(most_), pressure_(most_),
      per_lowering_(most_), deformed_(most_), column_(most_), in_contact_(most_) {
  active_.reserve(most_);
}

void CoarseNormal::find_within(const CombinedMaterial& material, const ElementGrid& grid, std::size_t first) {
  const int mx = grid.mx, my = grid.my;
  const std::size_t stride = static_cast<std::size_t>(mx) + 1;
  // Corners at (i + 1/2) dx, (j + 1/2) dy; those on the other side of an axis by symmetry.
  for (int j = 0; j <= my; ++j)
    for (int i = 0; i <= mx; ++i)
      corner_[static_cast<std::size_t>(j) * stride + i] = corner_function((i + 0.5) * grid.dx, (j + 0.5) * grid.dy);
  const auto corner = [&](int i, int j) { // of the corner (i - 1/2, j - 1/2)
    const int k = i > 0 ? i - 1 : 0, l = j > 0 ? j - 1 : 0;
    return (i > 0 ? 1 : -1) * (j > 0 ? 1 : -1) * corner_[static_cast<std::size_t>(l) * stride + k];
  };
  const double unit = (1 - material.poisson_ratio) / (std::numbers::pi * material.shear_modulus);
  for (int j = 0; j < my; ++j)
    for (int i = 0; i < mx; ++i)
      offset_[static_cast<std::size_t>(j) * mx + i] =
          unit * (corner(i + 1, j + 1) - corner(i, j + 1) - corner(i + 1, j) + corner(i, j));
  for (int j = 0; j < my; ++j)
    for (int i = 0; i < mx; ++i) {
      double* line = &matrix_[(first + static_cast<std::size_t>(j) * mx + i) * most_ + first];
      for (int l = 0; l <= j; ++l)
        for (int k = 0; k < mx; ++k)
          line[static_cast<std::size_t>(l) * mx + k] = offset_[static_cast<std::size_t>(j - l) * mx + std::abs(i - k)];
    }
}

void CoarseNormal::find_between(const CombinedMaterial& material, const CoarsePatch& one, std::size_t first,
                                const CoarsePatch& other, std::size_t other_first) {
  const auto place = [](const CoarsePatch& patch, int i, int j) {
    return patch.origin + Vec3<double>{patch.grid.x(i), patch.grid.y(j) * std::cos(patch.angle),
                                       patch.grid.y(j) * std::sin(patch.angle)};
  };
  const double unit = (1 - material.poisson_ratio) / (std::numbers::pi * material.shear_modulus);
  for (std::size_t k = 0; k < one.gaps.size(); ++k) {
    const int mx = one.grid.mx;
    const Vec3<double> here = place(one, static_cast<int>(k) % mx, static_cast<int>(k) / mx);
    double* line = &matrix_[(first + k) * most_ + other_first];
    for (std::size_t l = 0; l < other.gaps.size(); ++l) {
      const int nx = other.grid.mx;
      const Vec3<double> way = place(other, static_cast<int>(l) % nx, static_cast<int>(l) / nx) - here;
      // No nearer than the middle of a square element as large is to its own load.
      const double nearest = 0.28 * std::sqrt(other.grid.element_area());
      const double distance = std::max(std::sqrt(dot(way, way)), nearest);
      line[l] = unit * std::cos(one.angle - other.angle) *
                std::sqrt(one.grid.element_area() * other.grid.element_area()) / distance;
    }
  }
}

void CoarseNormal::set_up(const CombinedMaterial& material, std::span<const CoarsePatch> patches) {
  std::size_t first = 0;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const CoarsePatch& patch = patches[i];
    find_within(material, patch.grid, first);
    for (std::size_t other = 0, other_first = 0; other < i; other_first += patches[other++].gaps.size())
      find_between(material, patch, first, patches[other], other_first);
    for (std::size_t k = 0; k < patch.gaps.size(); ++k) {
      const double root = std::sqrt(patch.grid.element_area());
      root_area_[first + k] = root;
      gap_[first + k] = root * patch.gaps[k];
      const double angle = patch.angles[k / patch.grid.mx], shear = patch.shear[k / patch.grid.mx];
      slope_[first + k] = root * std::cos(angle);
      weight_[first + k] = root * (std::cos(angle) + shear * std::sin(angle));
    }
    first += patch.gaps.size();
  }
  elements_ = first;
}

bool CoarseNormal::touches() const {
  return std::any_of(in_contact_.begin(), in_contact_.begin() + static_cast<std::ptrdiff_t>(elements_),
                     [](char in) { return in != 0; });
}

/// Elements that overlap by nearly half of the most: about those that Hertz has in contact.
void CoarseNormal::start() {
  const double least = *std::min_element(gap_.begin(), gap_.begin() + static_cast<std::ptrdiff_t>(elements_));
  for (std::size_t k = 0; k < elements_; ++k)
    in_contact_[k] = gap_[k] < std::min(0.45 * least, 0.0) || gap_[k] == least;
}

/// The unknowns of the active elements, and their change with zeta.
void CoarseNormal::solve_active() {
  active_.clear();
  for (std::size_t k = 0; k < elements_; ++k)
    if (in_contact_[k]) active_.push_back(k);
  const std::size_t n = active_.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t k = active_[i];
    for (std::size_t j = 0; j <= i; ++j) factor_[i * most_ + j] = matrix_[k * most_ + active_[j]];
    pressure_[i] = -gap_[k], per_lowering_[i] = slope_[k];
  }
  factorise(factor_, n, most_, column_);
  substitute(factor_, n, most_, pressure_, per_lowering_);
}

CoarseNormal::Result CoarseNormal::solve(const CombinedMaterial& material, std::span<const CoarsePatch> patches,
                                         std::optional<double> vertical_force, bool warm) noexcept {
  constexpr int most_sets = 40;
  Result result;
  const std::size_t before = elements_;
  set_up(material, patches);
  if (!warm || before != elements_ || !touches()) start();
  result.status = Status::not_converged;
  while (result.sets < most_sets && result.status != Status::ok) {
    ++result.sets;
    solve_active();
    const std::size_t n = active_.size();
    double force = 0;
    result.stiffness = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t k = active_[i];
      force += pressure_[i] * weight_[k];
      result.stiffness += per_lowering_[i] * weight_[k];
    }
    result.lowering = vertical_force && n > 0 ? (*vertical_force - force) / result.stiffness : 0;
    bool changed = false;
    double largest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      pressure_[i] += result.lowering * per_lowering_[i];
      largest = std::max(largest, pressure_[i]);
      if (pressure_[i] < 0) in_contact_[active_[i]] = 0, changed = true;
    }
    if (changed) continue;
    // Nothing pulls: what still overlaps comes into contact.
    const double tolerance = 1e-12 * largest * matrix_[0];
    for (std::size_t k = 0; k < elements_; ++k) {
      if (in_contact_[k]) continue;
      double e = gap_[k] - result.lowering * slope_[k];
      for (std::size_t i = 0; i < n; ++i)
        e += pressure_[i] * (active_[i] <= k ? matrix_[k * most_ + active_[i]] : matrix_[active_[i] * most_ + k]);
      if (e < -tolerance) in_contact_[k] = 1, changed = true;
    }
    if (!changed) result.status = Status::ok;
  }
  // From the active elements to all of them, from behind: no place is overwritten before it is read.
  std::size_t i = active_.size();
  for (std::size_t k = elements_; k-- > 0;)
    pressure_[k] = i > 0 && active_[i - 1] == k ? std::max(pressure_[--i], 0.0) / root_area_[k] : 0.0;
  return result;
}

} // namespace microslip
