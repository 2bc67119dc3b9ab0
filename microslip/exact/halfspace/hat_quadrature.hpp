#pragma once

#include "microslip/elasticity/influence.hpp"
#include "microslip/exact/halfspace/cell_quadrature.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace microslip {

/// Integrals of an influence over a cell with the weights of the bilinear elements at its corners: of the corner a
/// along x and b along y, 0 or 1, at a + 2 b. The weights add up to 1.
struct CornerInfluence {
  std::array<Influence, 4> at = {};
};

inline void add(CornerInfluence& sum, double factor, const CornerInfluence& a) {
  for (std::size_t k = 0; k < a.at.size(); ++k) add(sum.at[k], factor, a.at[k]);
}

/// Shares out `low` and `high`, integrals across a cell with the weights of its lower and upper corners, along x at the
/// place `rise` in [0, 1] between them.
inline CornerInfluence shared_out(const Influence& low, const Influence& high, double rise) {
  CornerInfluence out;
  add(out.at[0], 1 - rise, low);
  add(out.at[1], rise, low);
  add(out.at[2], 1 - rise, high);
  add(out.at[3], rise, high);
  return out;
}

/// Rows of cells between the centres of bilinear elements of rolled bodies, which have their corners at multiples of
/// dx and dy. With the weight w along a cell that begins at x a retarded part's integral is that of
/// W(t) = integral from 0 to t of w(t') exp(-(t - t')/l)/l dt' times the kernel, and W(dx) S(x + dx), where S is that
/// of RolledRows: for w = 1 the weight is 1 - exp(-t/l), for w = t/dx it is (t - l (1 - exp(-t/l)))/dx. An object for
/// each thread.
template <class Hats> class RolledHats {
public:
  /// `lengths` [m] of the memory of the parts 1, 2 ..., `beyond`: columns_beyond the last cell.
  RolledHats(const Hats& hats, const std::vector<double>& lengths, std::vector<Cell> beyond)
      : lengths_(lengths), beyond_(std::move(beyond)), quadrature_(hats, lengths), integrals_(hats.parts()),
        sums_(hats.parts()) {}

  /// Calls found(i, u) for the cells from x = i dx to (i + 1) dx, i = last ... first, and from y to y + dy.
  template <class Found> void find(int first, int last, double y, double dx, double dy, const Found& found) {
    std::fill(sums_.begin(), sums_.end(), Across{});
    for (auto cell = beyond_.rbegin(); cell != beyond_.rend(); ++cell) {
      quadrature_.integrate({cell->x, y, cell->width, dy}, integrals_);
      continue_sums(cell->width);
    }
    for (int i = last; i >= first; --i) {
      quadrature_.integrate({i * dx, y, dx, dy}, integrals_);
      found(i, displacement(dx));
      continue_sums(dx);
    }
  }

private:
  using Across = std::array<Influence, 2>; ///< by corners along y, of both along x

  CornerInfluence displacement(double dx) const {
    constexpr double endless = 1e-8; // dx/l of which both corners have half: the error is a twelfth, rounding as much
    CornerInfluence sum = integrals_.whole[0];
    for (std::size_t m = 1; m < sums_.size(); ++m) {
      const double z = dx / lengths_[m - 1], risen = z > endless ? 1 + std::expm1(-z) / z : z / 2;
      for (std::size_t b = 0; b < 2; ++b) {
        Influence late{}, rising{}; // w = 1 and w = t/dx
        for (std::size_t k = 2 * b; k < 2 * b + 2; ++k) {
          add(late, 1, integrals_.whole[m].at[k]);
          add(late, -1, integrals_.fading[m].at[k]);
        }
        if (z > endless) {
          add(rising, 1, integrals_.whole[m].at[2 * b + 1]);
          add(rising, -1 / z, late);
        } else {
          add(rising, 0.5, late);
        }
        add(late, -std::expm1(-z), sums_[m][b]);
        add(rising, risen, sums_[m][b]);
        add(sum.at[2 * b], 1, late);
        add(sum.at[2 * b], -1, rising);
        add(sum.at[2 * b + 1], 1, rising);
      }
    }
    return sum;
  }
  void continue_sums(double width) {
    for (std::size_t m = 1; m < sums_.size(); ++m)
      for (std::size_t b = 0; b < 2; ++b) {
        Influence next{};
        add(next, std::exp(-width / lengths_[m - 1]), sums_[m][b]);
        for (std::size_t a = 0; a < 2; ++a) add(next, 1, integrals_.fading[m].at[2 * b + a]);
        sums_[m][b] = next;
      }
  }

  std::vector<double> lengths_;
  std::vector<Cell> beyond_;
  CellQuadrature<Hats> quadrature_;
  CellIntegrals<CornerInfluence> integrals_;
  std::vector<Across> sums_; ///< S
};

} // namespace microslip
