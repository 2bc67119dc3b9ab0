#include "fit/curve_fit.hpp"

#include "fit/curve_evaluator.hpp"
#include "fit/student.hpp"
#include "microslip/batch/batch.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <random>
#include <utility>

namespace microslip::fit {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr const char* not_solved = "the fitted curve is not solved between and beyond the points";
constexpr double told_apart = 2; // of Akaike's criterion: models that are closer are as good
constexpr double box = 6;        // about the start, in working coordinates: a factor of 400

/// The sum of squares of a fit's model over its free parameters, with an evaluator for one thread.
class Deviations {
public:
  Deviations(const CurveFit& fit, const io::MeasuredCurves& curves, std::vector<double> weights, int elements)
      : fit_(fit), curves_(curves), evaluator_(fit.model, curves, elements), values_(fit.values()),
        weights_(std::move(weights)) {
    problem_.count = curves.points.size();
    problem_.step = evaluator_.is_exact() ? 1e-2 : 1e-3; // more than what elements that begin to slip add
    problem_.residuals = [this](std::span<const double> t, std::span<double> r) { return find(t, r); };
    for (const std::size_t j : fit.free) {
      const CurveParameter& one = fit.parameters[j].parameter;
      const double start = one.to_working(one.start);
      problem_.lower.push_back(start - box), problem_.upper.push_back(start + box);
    }
  }
  Deviations(const Deviations&) = delete;
  Deviations& operator=(const Deviations&) = delete;

  const LeastSquares& problem() const { return problem_; }
  bool is_exact() const { return evaluator_.is_exact(); }
  void set_weights(std::vector<double> weights) { weights_ = std::move(weights); }

private:
  bool find(std::span<const double> working, std::span<double> residuals) {
    for (std::size_t j = 0; j < fit_.free.size(); ++j)
      values_[fit_.free[j]] = fit_.parameters[fit_.free[j]].parameter.from_working(working[j]);
    if (!evaluator_.evaluate(values_, residuals)) return false;
    for (std::size_t i = 0; i < residuals.size(); ++i)
      residuals[i] = (residuals[i] - curves_.points[i].coefficient) * std::sqrt(weights_[i]);
    return true;
  }

  const CurveFit& fit_;
  const io::MeasuredCurves& curves_;
  CurveEvaluator evaluator_;
  std::vector<double> values_, weights_;
  LeastSquares problem_;
};

std::vector<double> weights_of(const io::MeasuredCurves& curves) {
  std::vector<double> weights;
  for (const io::MeasuredPoint& point : curves.points) weights.push_back(1 / (point.sigma * point.sigma));
  return weights;
}

/// Huber's weights of deviations, times those they have anyway: min(1, 1.345 s/|r|), s = 1.4826 median |r|.
std::vector<double> huber_weights(const std::vector<double>& base, std::span<const double> deviations) {
  std::vector<double> sizes;
  for (std::size_t i = 0; i < base.size(); ++i) sizes.push_back(std::abs(deviations[i]) * std::sqrt(base[i]));
  std::vector<double> sorted = sizes;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const double bend = 1.345 * 1.4826 * *middle;
  std::vector<double> weights = base;
  for (std::size_t i = 0; i < base.size(); ++i)
    if (sizes[i] > bend) weights[i] *= bend / sizes[i];
  return weights;
}

/// Coordinates where search number `start` begins: the first at the model's start, others at random about it.
std::vector<double> start_of(const CurveFit& fit, int start) {
  std::mt19937 random(static_cast<unsigned>(start));
  std::vector<double> working;
  for (const std::size_t j : fit.free) {
    const CurveParameter& one = fit.parameters[j].parameter;
    const double shift = 1.2 * (static_cast<double>(random()) / static_cast<double>(std::mt19937::max()) - 0.5);
    working.push_back(one.to_working(one.start) + (start == 0 ? 0 : shift));
  }
  return working;
}

/// Whether the data have speeds that differ by more than half.
bool has_speeds(const io::MeasuredCurves& curves) {
  const auto [least, most] = std::minmax_element(curves.points.begin(), curves.points.end(),
                                                 [](auto& a, auto& b) { return a.speed < b.speed; });
  return most->speed > 1.5 * least->speed;
}

BatchOptions batch_options(const FitOptions& options) {
  return {.threads = options.threads, .progress = options.progress};
}

/// Fills in what follows from a minimum.
void conclude(CurveFit& fit, const LeastSquaresMinimum& minimum, const io::MeasuredCurves& curves) {
  const std::size_t n = curves.points.size(), k = fit.free.size();
  for (std::size_t j = 0; j < k; ++j) {
    FittedParameter& one = fit.parameters[fit.free[j]];
    one.value = one.parameter.from_working(minimum.parameters[j]);
  }
  fit.jacobian = minimum.jacobian;
  fit.coefficients.resize(n);
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double scale = 1 / std::sqrt(fit.weights[i]), deviation = minimum.residuals[i] * scale;
    fit.coefficients[i] = curves.points[i].coefficient + deviation;
    sum += deviation * deviation;
    for (std::size_t j = 0; j < k; ++j) fit.jacobian[i * k + j] *= scale;
  }
  const auto count = static_cast<double>(n), unknowns = static_cast<double>(k + 1); // the scatter is one
  fit.cost = minimum.cost;
  fit.rms = std::sqrt(sum / count);
  fit.aicc = count * std::log(minimum.cost / count) + 2 * unknowns +
             2 * unknowns * (unknowns + 1) / std::max(count - unknowns - 1, 1e-3);
}

/// One end of a parameter's interval: a walk along the profile to the threshold.
class ProfileEnd {
public:
  ProfileEnd(const CurveFit& fit, Deviations& deviations, std::size_t parameter, int side, double threshold,
             double guess)
      : fit_(fit), deviations_(deviations), at_(parameter), side_(side), threshold_(threshold), guess_(guess),
        best_(fit.working()), held_(best_.size(), false) {
    held_[at_] = true;
    jacobian_ = fit.jacobian;
    for (std::size_t i = 0; i < fit.weights.size(); ++i)
      for (std::size_t j = 0; j < best_.size(); ++j) jacobian_[i * best_.size() + j] *= std::sqrt(fit.weights[i]);
    good_ = best_;
    // Along the valley, by the derivatives.
    const std::size_t k = best_.size();
    const auto covariance = inverse_of(normal_matrix(fit.jacobian, fit.weights, k), k);
    direction_.resize(k);
    for (std::size_t j = 0; j < k; ++j) direction_[j] = covariance[j * k + at_] / covariance[at_ * k + at_];
  }

  /// The end as a working coordinate; infinite where the box ends before it.
  double find() {
    const LeastSquares& problem = deviations_.problem();
    const double limit = side_ > 0 ? problem.upper[at_] - best_[at_] : best_[at_] - problem.lower[at_];
    double inside = 0, outside = infinite, rise_inside = 0, rise_outside = 0;
    double distance = std::min(guess_, limit);
    for (int trial = 0; trial < 14; ++trial) {
      const double rise = rise_at(distance);
      if (rise < 1)
        inside = distance, rise_inside = rise;
      else
        outside = distance, rise_outside = rise;
      if (std::abs(rise - 1) < 0.01) return best_[at_] + side_ * distance;
      if (inside >= limit) return side_ * infinite;
      distance =
          std::isfinite(outside)
              ? inside + (outside - inside) * std::clamp((1 - rise_inside) / (rise_outside - rise_inside), 0.1, 0.9)
              : std::min(limit, distance * std::clamp(1.05 / std::max(rise, 1e-3), 1.2, 3.));
    }
    if (!std::isfinite(outside)) return side_ * infinite;
    const double share = std::clamp((1 - rise_inside) / (rise_outside - rise_inside), 0., 1.);
    return best_[at_] + side_ * (inside + (outside - inside) * share);
  }

private:
  /// Square root of the rise of the sum of squares over that allowed, which grows about linearly.
  double rise_at(double distance) {
    const std::size_t k = best_.size();
    std::vector<double> start(k);
    const double gone = std::abs(good_[at_] - best_[at_]);
    for (std::size_t j = 0; j < k; ++j)
      start[j] = gone > 0 ? best_[j] + (good_[j] - best_[j]) * distance / gone
                          : best_[j] + side_ * distance * std::clamp(direction_[j], -3., 3.);
    start[at_] = best_[at_] + side_ * distance;
    constexpr DescentEnd end = {.steps = 20, .gain = 1e-5, .is_confirmed = false};
    LeastSquaresMinimum found = minimise(deviations_.problem(), start, held_, jacobian_, end);
    if (gone > 0 && !std::isfinite(found.cost)) {
      start = good_;
      start[at_] = best_[at_] + side_ * distance;
      found = minimise(deviations_.problem(), start, held_, jacobian_, end);
    }
    if (!std::isfinite(found.cost)) return 100; // no solution: beyond the end
    const double rise = std::sqrt(std::max(found.cost - fit_.cost, 0.) / (threshold_ - fit_.cost));
    jacobian_ = std::move(found.jacobian);
    if (rise <= 1) good_ = std::move(found.parameters);
    return rise;
  }

  const CurveFit& fit_;
  Deviations& deviations_;
  std::size_t at_;
  int side_;
  double threshold_, guess_;
  std::vector<double> best_, good_, direction_, jacobian_;
  std::vector<bool> held_;
};

} // namespace

std::vector<double> CurveFit::values() const {
  std::vector<double> all;
  for (const FittedParameter& one : parameters) all.push_back(one.value);
  return all;
}

std::vector<double> CurveFit::working() const {
  std::vector<double> t;
  for (const std::size_t j : free) t.push_back(parameters[j].parameter.to_working(parameters[j].value));
  return t;
}

CurveFitter::CurveFitter(const io::MeasuredCurves& curves, FitOptions options)
    : curves_(curves), options_(std::move(options)) {}

/// A fit that is not solved, at the model's start. `held` marks parameters of the model.
CurveFit CurveFitter::prepare(const CurveModel& model, const std::vector<bool>& held) const {
  CurveFit fit{.model = model};
  const bool several = curves_.runs.size() > 1;
  for (std::size_t j = 0; j < model.parameters().size(); ++j) {
    const CurveParameter& one = model.parameters()[j];
    const std::size_t copies = j == 0 ? curves_.runs.size() : 1;
    for (std::size_t run = 0; run < copies; ++run) {
      if (!held[j]) fit.free.push_back(fit.parameters.size());
      fit.parameters.push_back({.parameter = one,
                                .run = j == 0 && several ? curves_.runs[run] : "",
                                .of_model = j,
                                .value = one.start,
                                .lower = one.start,
                                .upper = one.start,
                                .is_held = held[j]});
    }
  }
  fit.weights = weights_of(curves_);
  return fit;
}

std::vector<CurveFit> CurveFitter::fit(const std::vector<CurveModel>& models) const {
  std::vector<CurveFit> fits;
  const bool speeds = has_speeds(curves_);
  for (const CurveModel& model : models) {
    std::vector<bool> held;
    for (const CurveParameter& one : model.parameters()) held.push_back(one.needs_speeds && !speeds);
    fits.push_back(prepare(model, held));
  }
  const auto report = run_batch(fits.size(), batch_options(options_), [&] {
    return [&](std::size_t first, std::size_t, const Progress&) {
      CurveFit& one = fits[fits.size() - 1 - first]; // those with the most parameters, which take longest, begin
      if (curves_.points.size() > one.free.size() + 2) search(one, 5);
    };
  });
  if (!report.complete) throw Stopped();
  return fits;
}

void CurveFitter::search(CurveFit& fit, int most_starts) const {
  Deviations deviations(fit, curves_, fit.weights, options_.elements);
  const int starts = deviations.is_exact() ? std::min(most_starts, 2) : most_starts;
  LeastSquaresMinimum best{.cost = infinite};
  for (int start = 0; start < starts; ++start)
    if (LeastSquaresMinimum found = minimise(deviations.problem(), start_of(fit, start)); found.cost < best.cost)
      best = std::move(found);
  if (!std::isfinite(best.cost) || best.jacobian.empty()) return;
  for (int k = 0; options_.huber && k < 15; ++k) {
    std::vector<double> unweighted = best.residuals;
    for (std::size_t i = 0; i < unweighted.size(); ++i) unweighted[i] /= std::sqrt(fit.weights[i]);
    const auto before = best.parameters;
    fit.weights = huber_weights(weights_of(curves_), unweighted);
    deviations.set_weights(fit.weights);
    best = minimise(deviations.problem(), before);
    const bool is_steady = std::equal(before.begin(), before.end(), best.parameters.begin(),
                                      [](double a, double b) { return std::abs(a - b) < 1e-4; });
    if (is_steady) break;
  }
  conclude(fit, best, curves_);
}

Covariances covariances_of(const CurveFit& fit, const io::MeasuredCurves& curves) {
  const std::size_t n = fit.weights.size(), k = fit.free.size();
  const auto bread = inverse_of(normal_matrix(fit.jacobian, fit.weights, k), k);
  Covariances found{.robust = std::vector<double>(k * k, 0), .classical = bread, .leverages = std::vector<double>(n)};
  for (double& value : found.classical) value *= fit.cost / static_cast<double>(n - k);
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<double> reach(k, 0); // of a point's deviation on the parameters
    for (std::size_t p = 0; p < k; ++p)
      for (std::size_t q = 0; q < k; ++q) reach[p] += bread[p * k + q] * fit.jacobian[i * k + q];
    double leverage = 0;
    for (std::size_t p = 0; p < k; ++p) leverage += fit.weights[i] * fit.jacobian[i * k + p] * reach[p];
    found.leverages[i] = std::clamp(leverage, 0., 0.95);
    const double deviation = fit.coefficients[i] - curves.points[i].coefficient;
    const double scale = fit.weights[i] * deviation / (1 - found.leverages[i]);
    for (std::size_t p = 0; p < k; ++p)
      for (std::size_t q = 0; q < k; ++q) found.robust[p * k + q] += scale * scale * reach[p] * reach[q];
  }
  return found;
}

Collinearity collinearity_of(const CurveFit& fit) {
  const std::size_t k = fit.free.size();
  std::vector<double> normal = normal_matrix(fit.jacobian, fit.weights, k), scale(k);
  for (std::size_t p = 0; p < k; ++p) scale[p] = std::sqrt(std::max(normal[p * k + p], 1e-300));
  for (std::size_t p = 0; p < k; ++p)
    for (std::size_t q = 0; q < k; ++q) normal[p * k + q] /= scale[p] * scale[q];
  const auto inverse = inverse_of(normal, k);
  // The largest eigenvalue of the inverse by powers of it.
  std::vector<double> vector(k, 1), next(k);
  for (std::size_t p = 0; p < k; ++p) vector[p] += 0.1 * static_cast<double>(p); // no eigenvector by symmetry
  double length = 1;
  for (int step = 0; step < 100; ++step) {
    for (std::size_t p = 0; p < k; ++p) next[p] = std::inner_product(vector.begin(), vector.end(), &inverse[p * k], 0.);
    length = std::sqrt(std::inner_product(next.begin(), next.end(), next.begin(), 0.));
    for (std::size_t p = 0; p < k; ++p) vector[p] = next[p] / length;
  }
  Collinearity found{.index = std::sqrt(length)};
  for (std::size_t p = 0; p < k; ++p)
    if (std::abs(vector[p]) > 0.25) found.parameters.push_back(fit.free[p]);
  return found;
}

void CurveFitter::find_intervals(CurveFit& fit) const {
  const std::size_t k = fit.free.size(), n = fit.weights.size();
  const Covariances covariances = covariances_of(fit, curves_);
  const double t = student_quantile(0.95, static_cast<int>(n - k)), share = t * t / static_cast<double>(n - k);
  std::vector<double> ends(2 * k);
  const auto report = run_batch(2 * k, batch_options(options_), [&] {
    const auto deviations = std::make_shared<Deviations>(fit, curves_, fit.weights, options_.elements);
    return [&, deviations](std::size_t item, std::size_t, const Progress&) {
      const std::size_t j = item / 2;
      const double classical = covariances.classical[j * k + j], robust = covariances.robust[j * k + j];
      const double raised = std::clamp(robust / classical, 1., 2.);
      const double guess = std::clamp(t * std::sqrt(raised * classical), 1e-4, 1.);
      ends[item] =
          ProfileEnd(fit, *deviations, j, item % 2 == 0 ? -1 : 1, fit.cost * (1 + share * raised), guess).find();
    };
  });
  if (!report.complete) throw Stopped();
  const double widest = std::log(4.);
  for (std::size_t j = 0; j < k; ++j) {
    FittedParameter& one = fit.parameters[fit.free[j]];
    one.lower = one.parameter.from_working(ends[2 * j]); // of an infinite coordinate 0, or infinite
    one.upper = one.parameter.from_working(ends[2 * j + 1]);
    if (one.parameter.sign < 0) std::swap(one.lower, one.upper);
    one.is_identified = ends[2 * j + 1] - ends[2 * j] < widest;
  }
}

CurveFit CurveFitter::hold_unidentified(const CurveFit& fit) const {
  CurveFit now = fit;
  std::vector<bool> held(fit.model.parameters().size());
  for (const FittedParameter& one : fit.parameters) held[one.of_model] = one.is_held;
  std::vector<bool> unidentified(held.size(), false);
  for (;;) {
    std::size_t worst = held.size();
    double width = 0;
    for (const FittedParameter& one : now.parameters) {
      if (one.is_held || one.is_identified || one.of_model == 0) continue;
      const auto coordinate = [&](double end) {
        return one.parameter.to_working(one.parameter.sign * std::clamp(one.parameter.sign * end, 1e-300, 1e300));
      };
      const double wide = std::abs(coordinate(one.upper) - coordinate(one.lower));
      if (wide > width) width = wide, worst = one.of_model;
    }
    if (worst == held.size()) return now;
    held[worst] = unidentified[worst] = true;
    CurveFit next = prepare(fit.model, held);
    search(next, 2);
    if (!next.is_solved()) return now;
    find_intervals(next);
    for (FittedParameter& one : next.parameters)
      if (unidentified[one.of_model]) one.is_identified = false;
    now = std::move(next);
  }
}

CurveValues curve_values(const CurveFit& fit, const io::MeasuredCurves& points, int elements) {
  io::MeasuredCurves at = points;
  for (io::MeasuredPoint& point : at.points) point.coefficient = 0;
  Deviations deviations(fit, at, std::vector<double>(at.points.size(), 1), elements);
  CurveValues values{.coefficients = std::vector<double>(at.points.size()), .jacobian = {}};
  const auto working = fit.working();
  if (!deviations.problem().residuals(working, values.coefficients)) throw Error(not_solved);
  auto jacobian = find_jacobian(deviations.problem(), working, values.coefficients);
  if (!jacobian) throw Error(not_solved);
  values.jacobian = std::move(*jacobian);
  return values;
}

double rms_of_case(const CurveFit& fit, const io::MeasuredCurves& curves) {
  std::vector<double> coefficients(curves.points.size());
  if (!CurveEvaluator(fit.model, curves, std::numeric_limits<int>::max()).evaluate(fit.values(), coefficients))
    return std::numeric_limits<double>::quiet_NaN();
  double sum = 0;
  for (std::size_t i = 0; i < coefficients.size(); ++i)
    sum += std::pow(coefficients[i] - curves.points[i].coefficient, 2);
  return std::sqrt(sum / static_cast<double>(coefficients.size()));
}

CurveFit CurveFitter::freed(const CurveFit& fit, const std::vector<std::size_t>& free) const {
  CurveFit found = fit;
  found.free = free;
  found.jacobian = curve_values(found, curves_, options_.elements).jacobian;
  return found;
}

std::size_t preferred(const std::vector<CurveFit>& fits) {
  std::vector<std::size_t> candidates;
  for (const bool formulas : {false, true})
    for (std::size_t k = 0; k < fits.size() && (candidates.empty() || !formulas); ++k)
      if (fits[k].is_solved() && fits[k].model.is_formula() == formulas) candidates.push_back(k);
  if (candidates.empty()) throw Error("no model could be fitted: there are too few points, or the case was not solved");
  const auto by_criterion = [&](std::size_t a, std::size_t b) { return fits[a].aicc < fits[b].aicc; };
  const double best = fits[*std::min_element(candidates.begin(), candidates.end(), by_criterion)].aicc;
  std::erase_if(candidates, [&](std::size_t k) { return fits[k].aicc > best + told_apart; });
  const auto rank = [&](std::size_t k) { return std::pair(fits[k].free.size(), fits[k].aicc); };
  return *std::min_element(candidates.begin(), candidates.end(),
                           [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
}

std::vector<std::size_t> not_told_apart(const std::vector<CurveFit>& fits, std::size_t taken) {
  std::vector<std::size_t> others;
  for (std::size_t k = 0; k < fits.size(); ++k)
    if (k != taken && fits[k].is_solved() && fits[k].aicc <= fits[taken].aicc + told_apart) others.push_back(k);
  std::sort(others.begin(), others.end(), [&](std::size_t a, std::size_t b) { return fits[a].aicc < fits[b].aicc; });
  return others;
}

} // namespace microslip::fit
