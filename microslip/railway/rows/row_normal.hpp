#pragma once

#include "microslip/elasticity/material.hpp"
#include "microslip/railway/rows/row_equations.hpp"
#include "microslip/status.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace microslip {

/// The normal problem of all rows of a wheel in one: in each row the pressure is semi-elliptic along x (Knothe & Le The
/// 1984), with a load q [N/m] for each unit of width and a half-length a. Loads and half-lengths are those of the least
/// complementary energy among all such pressures (Ritz, (W6)): with U the mean displacement of row j for q_k = 1, C
/// cosine P of detail::RowPair between the edges of row k,
///   by q_j: q >= 0, e = h + A a_j^2/4 - zeta cos(angle) + sum U_jk q_k >= 0, q e = 0,
///   by a_j: A a_j^2/2 + sum dU_jk/d(ln a_j) q_k = 0;
/// zeta [m] is by how much the wheel is lowered further, given as 0 or such that the vertical force is given: sum of
/// q width (cos(angle) + shear sin(angle)) = F. Planes of rows enter by the cosine of the angle between them, distances
/// are those of centres. Neighbouring patches influence one another as rows do, whatever their distance.
///
/// Unknowns are q and ln(kappa), kappa = (2 q/(pi a))/a the peak pressure over a, which is Hertz's for all rows of an
/// ellipse. Rows with less load than their neighbours take part of their kappa from these, in proportion to A, half of
/// it at a fifth of the load at the end of a contact: there their own is ill-defined. So it is where rows are much
/// narrower than long, and neighbours hold each other's kappa. Newton's method for both, with active sets in each step.
///
/// All memory is taken in the constructor; solve() allocates nothing.
class RowNormal {
public:
  explicit RowNormal(std::size_t most_rows);

  struct Result {
    double lowering = 0;  ///< zeta [m]
    double stiffness = 0; ///< change of the vertical force with zeta, and what follows from it [N/m]
    double change = 0;    ///< of the loads in the last step, over the largest one; 1 where rows come and go
    Status status = Status::ok;
    int steps = 0;
  };
  /// Solves in at most `most_steps` steps, fewer once the change is less than 1e-5 and the next one's would be 1e-10.
  /// `vertical_force` [N]; without it the wheel keeps its height, zeta = 0. Starts from the last solve's loads of the
  /// rows `before` if `warm`; at most as many rows as were promised. Status::not_converged where the change remains.
  Result solve(const CombinedMaterial& material, std::span<const NormalRow> rows, std::optional<double> vertical_force,
               bool warm, int most_steps) noexcept;

  /// q [N/m] and a [m] of the last solve's rows; a row without load has a half-length of next to nothing.
  std::span<const double> loads() const { return {load_.data(), count_}; }
  std::span<const double> half_lengths() const { return {half_length_.data(), count_}; }

private:
  void start(std::span<const NormalRow> rows);
  bool start_from_last(std::span<const NormalRow> rows);
  bool choose_rows();
  void change_alike();
  bool solve_active(std::optional<double> vertical_force, bool linear, Result& result);
  void fill_system(bool linear, double length);
  void solve_system(bool linear);
  bool change_contact(bool linear, double length, double lowering);
  void take_step(bool linear, Result& result);
  bool touch_elsewhere(std::span<const NormalRow> rows, double lowering);

  RowEquations equations_;
  std::size_t count_ = 0;
  double unit_ = 0; ///< (1 - nu)/(pi G) [1/Pa]
  // Of each row.
  std::vector<double> load_, log_kappa_, half_length_, width_;
  std::vector<double> next_load_, change_; ///< of loads, and by how much ln(kappa) changes
  std::vector<char> in_contact_;
  std::vector<int> times_left_;   ///< the contact, in a step
  std::vector<std::size_t> near_; ///< those of the equations: the others have no part in a step
  std::vector<char> is_near_;
  std::vector<std::size_t> active_; ///< those of the equations that are in contact
  std::vector<double> system_;      ///< Newton's equations: a matrix with two sides behind, those of the next line
  std::vector<double> right_, per_lowering_, constant_, turn_constant_;
};

} // namespace microslip
