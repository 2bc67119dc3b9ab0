#pragma once

#include "fit/curve_bands.hpp"
#include "fit/curve_fit.hpp"
#include "fit/further_measurements.hpp"
#include "io/json.hpp"

#include <optional>
#include <string>
#include <vector>

namespace microslip::fit {

/// Measured creep curves with all that is fitted to them.
struct FittedCurves {
  io::MeasuredCurves curves;
  std::vector<CurveFit> fits;                  ///< all models, without intervals
  std::size_t taken;                           ///< index of the one that is taken
  CurveFit full;                               ///< that with intervals, before parameters were held
  CurveFit best;                               ///< and after
  Collinearity collinearity;                   ///< of `full`
  std::vector<CurveBand> bands;                ///< of `best`, with the variances of what `full` has free
  std::vector<std::size_t> others;             ///< models that the data do not tell from it
  std::optional<LargestDifference> difference; ///< from the best of these
  std::optional<FurtherMeasurement> further;
  double rms_of_case; ///< of `best`, by the elements that the case asks for

  /// Mean of the fitted less the measured coefficients.
  double bias() const;
  /// The case with the fitted values to six digits and the friction of the first run; none of a formula.
  std::optional<io::CaseInputs> inputs() const;
};

/// Name of a parameter with its run, where there are several.
std::string name_of(const FittedParameter& one);

/// Fits the models, takes the preferred one and finds what it says, see CurveFitter. Throws Error where none can be
/// fitted, Stopped if progress ends it.
FittedCurves fit_creep_curves(io::MeasuredCurves curves, const std::vector<CurveModel>& models,
                              const FitOptions& options);

/// Members of a JSON object: `points`, `runs`, `model`, `rms`, `bias`, `aicc`, `parameters` with `value` and
/// `interval`, `curves`, `models`, and what the data do not tell.
io::Json fitted_document(const FittedCurves& fitted);

/// Conditions of points that have no columns of them: those of the case. Throws Error for a case that is not one of
/// steady rolling under a force.
io::MeasuringConditions conditions_of(const io::CaseInputs& base);
/// The models of `curve_models`, or the one of a name, from the starting values of a name; empty: all, those of the
/// case. Throws Error for an unknown name.
std::vector<CurveModel> chosen_models(const io::CaseInputs& base, const std::string& model, const std::string& start);

} // namespace microslip::fit
