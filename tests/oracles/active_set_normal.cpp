#include "tests/oracles/active_set_normal.hpp"

#include "microslip/error.hpp"
#include "microslip/exact/halfspace/offset_kernel.hpp"
#include "microslip/exact/normal/normal_totals.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace microslip {
namespace {

constexpr int most_contacts = 200;

using Field = std::vector<double>;

class Norm {
public:
  Norm(const CombinedMaterial& material, const ElementGrid& grid, std::span<const double> gap, const NormalLoad& load,
       double tolerance)
      : grid_(grid), kernel_(normal_kernel(material, grid)), gap_(gap),
        by_force_(load.given == NormalLoad::Given::force), value_(load.value), tolerance_(tolerance),
        contact_(grid.count()), distance_(grid.count()), direction_(grid.count()), growth_(grid.count()) {
    s_.pressure.assign(grid.count(), 0.0);
    s_.displacement.assign(grid.count(), 0.0);
  }

  NormalSolution run() {
    // Where the undeformed bodies overlap; with the force given everywhere.
    for (std::size_t k = 0; k < gap_.size(); ++k) contact_[k] = by_force_ || gap_[k] < value_;
    s_.approach = by_force_ ? 0 : value_;
    if (std::none_of(contact_.begin(), contact_.end(), [](char c) { return c; })) return finish(Status::no_contact);
    if (by_force_) spread_force();
    while (s_.iterations < most_contacts) {
      ++s_.iterations;
      solve_equations();
      if (drop_negative() || add_overlapping()) continue;
      s_.residual = find_residual();
      return finish(s_.residual <= tolerance_ ? Status::ok : Status::not_converged);
    }
    find_distance();
    s_.residual = find_residual();
    return finish(Status::not_converged);
  }

private:
  /// out = A_zz in, over the elements where `in` is not zero.
  void apply(const Field& in, Field& out) {
    std::fill(out.begin(), out.end(), 0.0);
    for (int from_j = 0; from_j < grid_.my; ++from_j)
      for (int from = 0; from < grid_.mx; ++from) {
        const double p = in[index(from, from_j)];
        if (p == 0) continue;
        for (int j = 0; j < grid_.my; ++j) {
          const double* const zz = kernel_.row(j - from_j) - from;
          double* const u = out.data() + index(0, j);
          for (int i = 0; i < grid_.mx; ++i) u[i] += zz[i] * p;
        }
      }
    ++s_.products;
  }

  std::size_t index(int i, int j) const { return static_cast<std::size_t>(j) * grid_.mx + i; }

  void spread_force() {
    double sum = 0;
    for (const double p : s_.pressure) sum += p;
    const double wanted = value_ / grid_.element_area();
    const auto n = static_cast<double>(std::count(contact_.begin(), contact_.end(), 1));
    for (std::size_t k = 0; k < contact_.size(); ++k)
      if (contact_[k]) s_.pressure[k] = sum > 0 ? s_.pressure[k] * (wanted / sum) : wanted / n;
  }

  double mean_in_contact(const Field& of) const {
    double sum = 0;
    int n = 0;
    for (std::size_t k = 0; k < of.size(); ++k)
      if (contact_[k]) sum += of[k], ++n;
    return sum / n;
  }

  /// e = h - delta + u; with the force given delta is such that e is zero on the average over the contact.
  void find_distance() {
    apply(s_.pressure, s_.displacement);
    for (std::size_t k = 0; k < distance_.size(); ++k) distance_[k] = gap_[k] + s_.displacement[k];
    if (by_force_) s_.approach = mean_in_contact(distance_);
    for (double& e : distance_) e -= s_.approach;
  }

  double largest_displacement() const {
    double largest = 0;
    for (const double u : s_.displacement) largest = std::max(largest, std::abs(u));
    return largest;
  }

  double find_residual() const {
    double worst = 0;
    for (std::size_t k = 0; k < distance_.size(); ++k)
      worst = std::max(worst, contact_[k] ? std::abs(distance_[k]) : -distance_[k]);
    return worst / largest_displacement();
  }

  /// e = 0 in the assumed contact, by conjugate gradients; the directions keep the force where it is given.
  void solve_equations() {
    std::fill(direction_.begin(), direction_.end(), 0.0);
    double last = 1;
    for (std::size_t k = 0; k <= 2 * grid_.count(); ++k) {
      find_distance();
      double size2 = 0, worst = 0;
      for (std::size_t i = 0; i < distance_.size(); ++i)
        if (contact_[i]) size2 += distance_[i] * distance_[i], worst = std::max(worst, std::abs(distance_[i]));
      if (worst <= 0.1 * tolerance_ * largest_displacement()) return;
      for (std::size_t i = 0; i < direction_.size(); ++i)
        direction_[i] = contact_[i] ? distance_[i] + (k > 0 ? size2 / last : 0) * direction_[i] : 0;
      last = size2;
      apply(direction_, growth_);
      double slope = 0, curvature = 0;
      for (std::size_t i = 0; i < direction_.size(); ++i) {
        slope += distance_[i] * direction_[i];
        curvature += growth_[i] * direction_[i];
      }
      for (std::size_t i = 0; i < direction_.size(); ++i) s_.pressure[i] -= slope / curvature * direction_[i];
    }
  }

  bool drop_negative() {
    bool any = false;
    for (std::size_t k = 0; k < contact_.size(); ++k) {
      if (!contact_[k] || s_.pressure[k] >= 0) continue;
      contact_[k] = 0;
      s_.pressure[k] = 0;
      any = true;
    }
    if (any && by_force_) spread_force();
    return any;
  }

  bool add_overlapping() {
    const double overlap = tolerance_ * largest_displacement();
    bool any = false;
    for (std::size_t k = 0; k < contact_.size(); ++k) {
      if (contact_[k] || distance_[k] >= -overlap) continue;
      contact_[k] = 1;
      any = true;
    }
    return any;
  }

  NormalSolution finish(Status status) {
    s_.status = status;
    find_totals(grid_, gap_, s_);
    return std::move(s_);
  }

  const ElementGrid& grid_;
  OffsetTable kernel_;
  std::span<const double> gap_;
  bool by_force_;
  double value_, tolerance_;
  std::vector<char> contact_;
  Field distance_, direction_, growth_;
  NormalSolution s_;
};

} // namespace

NormalSolution solve_norm(const CombinedMaterial& material, const ElementGrid& grid, std::span<const double> gap,
                          const NormalLoad& load, double tolerance) {
  check(grid, gap, load);
  require_positive("tolerance", tolerance, "-");
  return Norm(material, grid, gap, load, tolerance).run();
}

} // namespace microslip
