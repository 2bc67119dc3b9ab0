#pragma once

#include "fit/curve_model.hpp"
#include "fit/least_squares.hpp"
#include "io/measured_curve.hpp"
#include "microslip/progress.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace microslip::fit {

/// How models are fitted.
struct FitOptions {
  bool huber = false; ///< Huber's loss with 1.345 standard deviations, these from the median of the deviations
  int elements = 12;  ///< most elements across the ellipse by the exact theory while a curve is fitted
  int threads = 1;
  Progress progress = {}; ///< false ends a fit with Stopped
};

/// Fitted parameter: one of the model, the friction of each run for itself.
struct FittedParameter {
  CurveParameter parameter;
  std::string run = {};     ///< of a run's friction, if there are several
  std::size_t of_model = 0; ///< index among the model's parameters
  double value = 0;
  /// Ends of the 95 % interval, from the profile of the sum of squares; where it is open the one that is further from 0
  /// is infinite, the other one 0. Those of a held parameter are its value.
  double lower = 0, upper = 0;
  bool is_held = false;      ///< at its start, not fitted
  bool is_identified = true; ///< false: its interval is open or wider than a factor of 4 (of p/(1 - p) for a share), or
                             ///< it was held for that
};

/// Parameters that depend on each other so much that the data hardly tell them apart.
struct Collinearity {
  double index = 0; ///< Brun's: 1 over the smallest singular value of the derivatives, each column of length 1
  std::vector<std::size_t> parameters = {}; ///< those that take part, as indices of `parameters` of the fit
};

/// Fit of a model to measured curves.
struct CurveFit {
  CurveModel model;
  std::vector<FittedParameter> parameters = {}; ///< static coefficients of the runs, then the others of the model
  std::vector<std::size_t> free = {};           ///< indices of those that are fitted, k of them
  std::vector<double> coefficients = {};        ///< of the model at the points
  std::vector<double> weights = {};             ///< of the squared deviations: 1/sigma^2, times Huber's
  std::vector<double> jacobian = {};            ///< derivatives of the coefficients by the working coordinates, n by k
  double rms = 0;                               ///< of the deviations [-], without weights
  double aicc = 0;                              ///< Akaike's criterion, corrected for few points
  double cost = 0;                              ///< weighted sum of squares

  bool is_solved() const { return !coefficients.empty(); }
  std::vector<double> values() const;
  std::vector<double> working() const; ///< coordinates of the free parameters
};

/// Covariance of the working coordinates, k by k.
struct Covariances {
  std::vector<double> robust;    ///< sandwich HC3, which holds where the scatter differs from point to point
  std::vector<double> classical; ///< for equal scatter
  std::vector<double> leverages; ///< of the points, below 1
};
Covariances covariances_of(const CurveFit& fit, const io::MeasuredCurves& curves);
Collinearity collinearity_of(const CurveFit& fit);

/// A fitted curve at any points, and its derivatives by the working coordinates of the free parameters, points by k.
struct CurveValues {
  std::vector<double> coefficients, jacobian;
};
/// Only conditions and creepages of `points` count; their runs are those of the fit. Throws Error where a point is not
/// solved. Cost: that of k + 1 curves.
CurveValues curve_values(const CurveFit& fit, const io::MeasuredCurves& points, int elements);

/// Root mean square deviation of a fit's values where the exact theory has as many elements as the case asks for; NaN
/// where that is not solved.
double rms_of_case(const CurveFit& fit, const io::MeasuredCurves& curves);

/// Fits models to measured curves by least squares, all points alike unless they have a sigma.
class CurveFitter {
public:
  CurveFitter(const io::MeasuredCurves& curves, FitOptions options);

  /// Best of five starts for each model (two by the exact theory), without intervals. Not solved where the model has as
  /// many parameters as there are points, or no start leads anywhere. Throws Stopped if progress ends it.
  std::vector<CurveFit> fit(const std::vector<CurveModel>& models) const;
  /// Sets the intervals: where the sum of squares with all other parameters fitted anew has risen by the factor 1 +
  /// F(0.95; 1, n - k)/(n - k), F raised by the ratio of both variances, 1 to 2, for unequal scatter. And what is
  /// identified.
  void find_intervals(CurveFit& fit) const;
  /// Fits again with each parameter that is not identified held at its start, the worst first, until all that are left
  /// are; the friction is always fitted.
  CurveFit hold_unidentified(const CurveFit& fit) const;
  /// The same values with other parameters free, `free` by their indices: for variances that count what is held because
  /// the data do not identify it. Its derivatives are found anew. Throws Error where they cannot be.
  CurveFit freed(const CurveFit& fit, const std::vector<std::size_t>& free) const;

private:
  CurveFit prepare(const CurveModel& model, const std::vector<bool>& held) const;
  void search(CurveFit& fit, int most_starts) const;

  const io::MeasuredCurves& curves_;
  FitOptions options_;
};

/// Index of the model to take: among those that a case can have, formulas only where there are no others, and within 2
/// of the smallest criterion the one with the fewest free parameters, of these the best. Throws Error if none is
/// solved.
std::size_t preferred(const std::vector<CurveFit>& fits);
/// Indices of the other models whose criterion is at most 2 above that of the one taken, the best first.
std::vector<std::size_t> not_told_apart(const std::vector<CurveFit>& fits, std::size_t taken);

} // namespace microslip::fit
