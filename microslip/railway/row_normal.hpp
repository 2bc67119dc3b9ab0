#pragma once

#include "microslip/elasticity/material.hpp"
#include "microslip/railway/frame.hpp"
#include "microslip/railway/row_influence.hpp"
#include "microslip/status.hpp"

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

/// The normal problem of all rows of a wheel in one, after Knothe & Le The (1984): in each row the pressure is
/// semi-elliptic along x, with a load q [N/m] for each unit of width and a half-length a. For the rows' centres
///   q >= 0, e = h - zeta cos(angle) + sum U_jk q_k >= 0, q e = 0,
/// U the displacement under RowInfluence's strips, with the cosine of the angle between both planes and the distance
/// between both centres; zeta [m] by how much the wheel is lowered further, given as 0 or such that the vertical
/// force is given: sum of q width (cos(angle) + shear sin(angle)) = F. Neighbouring patches influence one another as
/// rows do, whatever their distance.
///
/// The half-lengths follow from kappa = (2 q/(pi a))/a, the peak pressure over a. A row's kappa is the one with which
/// the displacement's curvature along x at the row's centre is -2 A if all rows had that kappa: so on an ellipse
/// it is Hertz's, and where curvatures vary across the contact it is that of the row itself. Rows with less than 0.06
/// of the row's load enter in proportion to that: the shortest rows would have the greatest curvature.
///
/// Newton's method for q and ln(kappa), the latter eliminated, with active sets in each step. On ellipses with 12 rows
/// zeta, the peak pressure and the half-lengths err by 0.5 % for b/a from 0.3, by 2 to 5 % at 0.03.
///
/// All memory is taken in the constructor; solve() allocates nothing. Cost of each step some 40 ns for each pair of
/// rows.
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
  void start(std::span<const NormalRow> rows);
  bool start_from_last(std::span<const NormalRow> rows);
  void find_half_lengths();
  void set_up(std::span<const NormalRow> rows);
  void find_influences(bool linear);
  void find_curvatures(std::span<const NormalRow> rows, bool alone);
  void eliminate_curvatures(std::span<const NormalRow> rows, bool alone);
  bool solve_active(std::optional<double> vertical_force, Result& result);
  void change_curvatures();
  bool touch_elsewhere(std::span<const NormalRow> rows, double lowering);
  double displacement_under(std::size_t j, std::size_t k) const;
  double& at(std::vector<double>& matrix, std::size_t j, std::size_t k) const { return matrix[j * count_ + k]; }
  double at(const std::vector<double>& matrix, std::size_t j, std::size_t k) const { return matrix[j * count_ + k]; }

  RowInfluence influence_;
  std::size_t count_ = 0;
  double unit_ = 0; ///< (1 - nu)/(pi G) [1/Pa]
  // Of pairs of rows, a row of the matrix for each row of the contact.
  std::vector<double> distance_, cosine_; ///< [m]; of the angle between both planes
  std::vector<double> influence_matrix_;  ///< U [1/Pa], later the whole Newton matrix
  std::vector<double> by_kappa_;          ///< dU q/d ln(kappa)
  std::vector<double> curvature_by_load_; ///< d(residual of ln(kappa))/dq
  std::vector<double> system_;            ///< of the active rows
  // Of each row.
  std::vector<double> load_, log_kappa_, half_length_, width_, s_;
  std::vector<double> root_load_;      ///< sqrt(2 q/pi), a sqrt(kappa)
  std::vector<double> level_, weight_; ///< cos(angle), and the vertical force of q = 1 [m]
  std::vector<double> next_load_, right_, per_lowering_, displacement_;
  std::vector<double> residual_, slope_; ///< of ln(kappa), and its derivative with respect to itself
  std::vector<std::size_t> active_;      ///< in contact
  std::vector<std::size_t> loaded_;      ///< in the last step
  std::vector<std::size_t> near_;        ///< all of these with their neighbours: the others have no part in a step
  std::vector<char> in_contact_;
};

} // namespace microslip
