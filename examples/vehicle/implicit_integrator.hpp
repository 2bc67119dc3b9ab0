#pragma once

#include "vehicle.hpp"

#include <optional>
#include <vector>

/// Backward differentiation of second order (BDF2, variable steps) for a vehicle, whose velocities are the rates of its
/// coordinates: q' = u, M u' = f(q, u). With the history in the constants a and b of a step
///   u = a + g u'(q, u),  q = b + g u,  g = h (1 + w)/(1 + 2 w),  w = h over the step before,
/// and Newton's method has (M - g f_u - g^2 f_q) du = M (a + g u' - u). Derivatives of forces are those of SlopedForce;
/// what is left out of them, gyroscopic terms and the change of M, is small beside. It begins with one step of implicit
/// Euler's method that is short.
class ImplicitIntegrator {
public:
  struct Options {
    double step = 1e-3;                  ///< [s], the longest one
    std::optional<double> accuracy = {}; ///< of a step: 1 is 1 mm, 1 mrad, 1 m/s, 1 rad/s. None: steps are never
                                         ///< shortened but where Newton's method fails
    double newton_tolerance = 1e-5;      ///< of velocities [m/s], [rad/s]
    int most_iterations = 6;
    /// Iterations that slow down so far call for new derivatives [-].
    double slow = 0.2;
  };
  struct Counts {
    long steps = 0, rejected_by_error = 0, rejected_by_newton = 0, evaluations = 0, iterations = 0, jacobians = 0;
    long rejected_at_patch_change = 0; ///< of the rejected, where a wheel had other patches than at the step's begin
    double iterations_a_step() const {
      return steps ? static_cast<double>(iterations) / static_cast<double>(steps) : 0;
    }
  };

  ImplicitIntegrator(Vehicle& vehicle, const Options& options);
  void start(const SimTK::State& state);
  /// Goes on to a time [s] and ends there. Throws std::runtime_error for a step that had to be shortened to nothing.
  void step_to(double time);
  const SimTK::State& state() const { return state_; }
  const Counts& counts() const { return counts_; }
  void clear_counts() { counts_ = {}; }

private:
  struct Point {
    double time = 0;
    SimTK::Vector q, u, z;
  };
  bool try_step(double h);
  void predict(double h, SimTK::Vector& q, SimTK::Vector& u) const;
  void make_newton_matrix(double g);
  double error_of(const SimTK::Vector& q, const SimTK::Vector& u, double h) const;
  void set(double time, const SimTK::Vector& q, const SimTK::Vector& u);
  long patch_changes() const { return vehicle_.contacts().counts().patch_changes; }

  Vehicle& vehicle_;
  Options options_;
  SimTK::State state_;
  std::vector<Point> past_; ///< the last one first
  SpatialSlopes slopes_;
  SimTK::Matrix matrix_, mass_;
  SimTK::FactorLU factors_;
  double matrix_g_ = 0; ///< of the matrix that is factorised, 0: none
  double rate_ = 0.5;   ///< by which Newton's method reduced its steps lately
  double next_ = 0;     ///< step to try [s]
  double error_ = 0;
  SimTK::Vector predicted_q_, predicted_u_;
  Counts counts_;
};
