#pragma once

#include "microslip/elasticity/material.hpp"
#include "microslip/railway/frame.hpp"
#include "microslip/railway/row_influence.hpp"
#include "microslip/status.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace microslip {

/// A row of a contact: a strip along x whose undeformed gap is h + A (x - x0)^2.
struct NormalRow {
  Vec3<double> place;   ///< of its centre, in track axes [m]
  double s = 0;         ///< of its centre, along the surface; rows are in ascending order [m]
  double angle = 0;     ///< of its plane against the track's y [rad]
  double width = 0;     ///< [m], > 0
  double gap = 0;       ///< h [m], along the row's normal, negative where the undeformed bodies overlap
  double curvature = 0; ///< A [1/m], > 0
  double shear = 0;     ///< force along s over the normal one [-]: it bears some of the weight

  /// The vertical force for each newton per metre of its load [m].
  double vertical_weight() const { return width * (std::cos(angle) + shear * std::sin(angle)); }
};

/// The normal problem of all rows of a wheel in one: in each row the pressure is semi-elliptic along x (Knothe & Le The
/// 1984), with a load q [N/m] for each unit of width and a half-length a. Loads and half-lengths are those of the least
/// complementary energy among all such pressures (Ritz): with U the mean displacement of row j for q_k = 1, C cosine P
/// of RowInfluence between the edges of row k,
///   by q_j: q >= 0, e = h + A a_j^2/4 - zeta cos(angle) + sum U_jk q_k >= 0, q e = 0,
///   by a_j: A a_j^2/2 + sum dU_jk/d(ln a_j) q_k = 0;
/// zeta [m] is by how much the wheel is lowered further, given as 0 or such that the vertical force is given: sum of
/// q width (cos(angle) + shear sin(angle)) = F. Planes of rows enter by the cosine of the angle between them, distances
/// are those of centres. Neighbouring patches influence one another as rows do, whatever their distance.
///
/// Unknowns are q and ln(kappa), kappa = (2 q/(pi a))/a the peak pressure over a, which is Hertz's for all rows of an
/// ellipse. Rows with less than 0.3 of a neighbour's load take part of their kappa from it, in proportion to A, all of
/// it below 0.05: the outermost rows' are ill-defined. Newton's method for both, with active sets in each step.
///
/// All memory is taken in the constructor; solve() allocates nothing.
class RowNormal {
public:
  explicit RowNormal(std::size_t most_rows);

  struct Result {
    double lowering = 0;  ///< zeta [m]
    double stiffness = 0; ///< change of the vertical force with zeta, with the half-lengths held [N/m]
    double change = 0;    ///< of the loads in the last step, over the largest one; 1 where rows come and go
    Status status = Status::ok;
    int steps = 0;
  };
  /// At most `most_steps` steps, fewer once the change is less than 1e-6, with which the next one's would be 1e-12.
  /// `vertical_force` [N]; without it the wheel stays where it is, zeta = 0. Starts from the last solve's loads at the
  /// same s if `warm`; at most as many rows as were promised. Status::not_converged where the change remains.
  Result solve(const CombinedMaterial& material, std::span<const NormalRow> rows, std::optional<double> vertical_force,
               bool warm, int most_steps) noexcept;

  /// q [N/m] and a [m] of the last solve's rows; a row without load has a half-length of next to nothing.
  std::span<const double> loads() const { return {load_.data(), count_}; }
  std::span<const double> half_lengths() const { return {half_length_.data(), count_}; }

private:
  /// Of a row; the row itself where there is none.
  struct Neighbours {
    std::array<std::size_t, 2> row{};
    std::array<double, 2> share{}; ///< in what they bear more than the row, together 1 if one does
    double rise = 0;               ///< the sum of that [N/m]

    double mean(const auto& of_row) const;
  };

  void start(std::span<const NormalRow> rows);
  bool start_from_last(std::span<const NormalRow> rows);
  void set_up(std::span<const NormalRow> rows);
  void find_half_lengths();
  void find_near();
  void find_influences(std::span<const NormalRow> rows);
  void find_curvatures(std::span<const NormalRow> rows);
  void find_neighbours();
  double relative_kappa(std::span<const NormalRow> rows, std::size_t j) const;
  void hold_to_neighbours(std::span<const NormalRow> rows);
  void change_alike();
  void assemble(bool linear);
  bool solve_active(std::optional<double> vertical_force, bool linear, Result& result);
  void take_step(std::span<const NormalRow> rows, bool linear, Result& result);
  bool touch_elsewhere(std::span<const NormalRow> rows, double lowering);
  double& at(std::vector<double>& matrix, std::size_t j, std::size_t k) const { return matrix[j * count_ + k]; }
  double at(const std::vector<double>& matrix, std::size_t j, std::size_t k) const { return matrix[j * count_ + k]; }

  RowInfluence influence_;
  std::size_t count_ = 0;
  double unit_ = 0;    ///< (1 - nu)/(pi G) [1/Pa]
  double largest_ = 0; ///< of the loads [N/m]
  // Of pairs of rows, a row of the matrix for each row of the contact.
  std::vector<double> distance_, cosine_;            ///< [m]; of the angle between both planes
  std::vector<double> gap_by_load_, gap_by_kappa_;   ///< of e
  std::vector<double> turn_by_load_, turn_by_kappa_; ///< of the residual of ln(kappa)
  std::vector<double> system_;                       ///< of the active rows
  // Of each row.
  std::vector<double> load_, log_kappa_, width_, s_;
  std::vector<double> half_length_;    ///< within a solve with a small load added to each, so that none is 0 [m]
  std::vector<double> by_load_;        ///< d ln(a)/dq
  std::vector<double> level_, weight_; ///< cos(angle), and the vertical force of q = 1 [m]
  std::vector<double> sine_;
  std::vector<double> gap_, turn_;         ///< e without zeta [m], and the residual of ln(kappa)
  std::vector<double> next_load_, change_; ///< of loads, and by how much ln(kappa) changes
  std::vector<double> right_, per_lowering_;
  std::vector<std::size_t> active_; ///< in contact
  std::vector<std::size_t> near_;   ///< loaded or in contact, with their neighbours: the others have no part in a step
  std::vector<Neighbours> neighbours_;
  std::vector<char> in_contact_;
};

} // namespace microslip
