#pragma once

#include "fit/curve_model.hpp"
#include "io/case_file.hpp"
#include "io/measured_curve.hpp"
#include "microslip/rolling/solver.hpp"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace microslip::fit {

/// Adhesion coefficients of cases at points of creep curves, by the theory of the case.
///
/// Many points of a curve are interpolated by a cubic spline over the logarithm of the creepage, from 32 that are
/// solved, or 20 by the exact theory: the error is some 1e-4. Cost: with FASTSIM2 a millisecond for each curve, with
/// the exact theory some 10 on 16 elements.
class CreepCurveSolver {
public:
  /// `points` must outlive it. `elements`: the most that the exact theory may have across the ellipse, whatever the
  /// case asks for.
  CreepCurveSolver(const io::MeasuredCurves& points, bool is_exact, int elements);

  /// Writes a coefficient for each point of a run, which has this case; of all runs by default. Returns false where the
  /// case is not solved. Throws Error for a case that has no creep curve.
  bool solve(const io::RollingCase& input, std::span<double> coefficients, std::optional<std::size_t> run = {});
  /// The same by Polach's formula with these factors.
  void solve_by_formula(const io::RollingCase& input, std::pair<double, double> factors, std::span<double> coefficients,
                        std::size_t run);

private:
  /// Points of one run, speed and load.
  struct Curve {
    io::MeasuredPoint conditions;
    std::vector<std::size_t> points;
    std::vector<double> nodes; ///< creepages that are solved, ascending
  };

  RollingProblem problem_of(const io::RollingCase& input, const Curve& curve) const;
  bool solve_nodes(const Curve& curve, const io::RollingCase& input, std::vector<double>& at_nodes);
  void interpolate(const Curve& curve, const std::vector<double>& at_nodes, std::span<double> coefficients) const;
  std::vector<double> formula(const Curve& curve, std::pair<double, double> factors,
                              const RollingProblem& problem) const;

  const io::MeasuredCurves& points_;
  int elements_;
  std::vector<Curve> curves_;
  std::optional<Solver> solver_;
};

/// Adhesion coefficients of a model at points of creep curves, by the theory of its case.
class CurveEvaluator {
public:
  /// `model` and `points` must outlive it. `elements` as above.
  CurveEvaluator(const CurveModel& model, const io::MeasuredCurves& points, int elements);

  /// Returns whether its curves are solved by the exact theory.
  bool is_exact() const { return is_exact_; }

  /// Writes a coefficient for each point; `values` are the static coefficients of the runs and then the model's other
  /// parameters. Returns false where a value is out of range or a case not solved.
  bool evaluate(std::span<const double> values, std::span<double> coefficients);

private:
  const CurveModel& model_;
  const io::MeasuredCurves& points_;
  bool is_exact_;
  CreepCurveSolver solver_;
};

} // namespace microslip::fit
