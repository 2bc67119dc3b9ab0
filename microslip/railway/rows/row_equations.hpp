#pragma once

#include "microslip/numerics/instruction_set.hpp"
#include "microslip/railway/geometry/frame.hpp"
#include "microslip/railway/rows/kernel/row_pairs.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace microslip {

inline constexpr std::size_t no_row = static_cast<std::size_t>(-1);

/// A row of a contact: a strip along x whose undeformed gap is h + A (x - x0)^2.
struct NormalRow {
  Vec3<double> place;          ///< of its centre, in track axes [m]
  double s = 0;                ///< of its centre, along the surface; rows are in ascending order [m]
  double angle = 0;            ///< of its plane against the track's y [rad]
  double width = 0;            ///< [m], > 0
  double gap = 0;              ///< h [m], along the row's normal, negative where the undeformed bodies overlap
  double curvature = 0;        ///< A [1/m], > 0
  double shear = 0;            ///< force along s over the normal one [-]: it carries some of the weight
  std::size_t before = no_row; ///< the row of the last position that it was, if any
};

/// Distance [m] at which a row feels the pressure of another one.
double distance_to_strip(const NormalRow& row, const NormalRow& loaded);

/// The equations of the normal problem for some of a wheel's rows, see RowNormal: residuals and derivatives. Takes its
/// memory in the constructor. Indices count these rows.
class RowEquations {
public:
  explicit RowEquations(std::size_t most_rows, InstructionSet instruction_set = best_instruction_set());

  /// Sets the rows with the indices `active`, in ascending order; `unit` is (1 - nu)/(pi G) [1/Pa].
  void set_rows(std::span<const NormalRow> rows, std::span<const std::size_t> active, double unit);
  std::size_t size() const { return count_; }
  /// Finds all below at the loads [N/m] and ln(kappa) of all rows of the wheel; the active ones count.
  /// Half-lengths are held at those of the loads if `held`: then the equations are linear in the loads. Cost some 10 to
  /// 40 ns for each pair of rows.
  void find(std::span<const double> load, std::span<const double> log_kappa, std::span<const std::size_t> active,
            bool held);

  double load(std::size_t j) const { return load_[j]; }
  double level(std::size_t j) const { return level_[j]; }   ///< cos(angle)
  double weight(std::size_t j) const { return weight_[j]; } ///< the vertical force of q = 1 [m]
  double relative_kappa(std::size_t j) const { return log_kappa_[j] - log_curvature_[j]; } ///< ln(kappa/A)
  double largest() const { return largest_; }                                              ///< of the loads [N/m]

  /// e without zeta [m], and the residual of ln(kappa).
  double gap(std::size_t j) const { return gap_[j]; }
  double turn(std::size_t j) const { return turn_[j]; }
  /// Their derivatives with respect to q and ln(kappa) of row k.
  double gap_by_load(std::size_t j, std::size_t k) const { return gap_by_load_[k * stride_ + j]; }
  double gap_by_kappa(std::size_t j, std::size_t k) const { return gap_by_kappa_[k * stride_ + j]; }
  double turn_by_load(std::size_t j, std::size_t k) const { return turn_by_load_[k * stride_ + j]; }
  double turn_by_kappa(std::size_t j, std::size_t k) const { return turn_by_kappa_[k * stride_ + j]; }

  /// Tells if a row has neighbours that carry more, and the mean of a number of these, weighted by how much.
  bool has_greater_neighbour(std::size_t j) const { return neighbours_[j].rise > 0; }
  double mean_of_neighbours(std::size_t j, const auto& of_row) const {
    const Neighbours& n = neighbours_[j];
    return n.share[0] * of_row(n.row[0]) + n.share[1] * of_row(n.row[1]);
  }
  /// Gives rows with little load beside their neighbours the equation ln(kappa/A) = the mean of theirs, in part or as a
  /// whole, and lets neighbours hold the kappa of narrow rows.
  void hold_to_neighbours();

private:
  /// Neighbours of a row; the row itself where there is none.
  struct Neighbours {
    std::array<std::size_t, 2> row{};
    std::array<double, 2> share{}; ///< in what they carry more than the row, together 1 if one does
    double rise = 0;               ///< the sum of that [N/m]
  };
  /// Share of a row's equation that is its own.
  struct OwnShare {
    double share = 1, by_load = 0;        ///< and its derivatives with respect to the row's load,
    double by_largest = 0;                ///< the largest one
    std::array<double, 2> by_neighbour{}; ///< and the neighbours'
  };

  void find_half_lengths(bool held);
  void add_largest();
  void find_neighbours();
  void smooth_kappa();
  OwnShare own_share(std::size_t j) const;

  detail::FindRowPairs find_pairs_;
  std::size_t count_ = 0, stride_ = 0;
  std::size_t largest_row_ = 0;
  double largest_ = 0;
  // Of pairs of rows, as detail::RowPairs has them.
  std::vector<double> distance_, factor_, gap_by_load_, gap_by_kappa_, turn_by_load_, turn_by_kappa_;
  // Of each row.
  std::vector<double> level_, sine_, weight_, half_width_, given_gap_, curvature_, log_curvature_;
  std::vector<double> load_, log_kappa_;
  std::vector<double> half_length_; ///< with a least load, so that none is 0 [m]
  std::vector<double> by_load_;     ///< d ln(a)/dq, 0 where half-lengths are held
  std::vector<double> by_largest_;  ///< the same by the largest load
  std::vector<double> gap_, turn_, inverse_turn_, turn_by_length_;
  std::vector<Neighbours> neighbours_;
};

} // namespace microslip
