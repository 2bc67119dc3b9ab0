#include "fit/curve_evaluator.hpp"

#include "microslip/error.hpp"
#include "microslip/numerics/natural_spline.hpp"
#include "microslip/simplified/creepage_coefficients.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <variant>

namespace microslip::fit {
namespace {

auto conditions_of(const io::MeasuredPoint& point) {
  return std::tuple(point.run, point.speed, point.normal_force);
}

/// The creepages themselves if they are few; else as many as that, evenly over their logarithm.
std::vector<double> nodes_of(std::vector<double> creepages, std::size_t most) {
  std::sort(creepages.begin(), creepages.end());
  creepages.erase(std::unique(creepages.begin(), creepages.end()), creepages.end());
  if (creepages.size() <= most) return creepages;
  const double first = creepages.front(), last = creepages.back();
  std::vector<double> nodes;
  for (std::size_t k = 0; k < most; ++k)
    nodes.push_back(first * std::pow(last / first, static_cast<double>(k) / static_cast<double>(most - 1)));
  nodes.back() = last;
  return nodes;
}

/// The problem at a curve's load: by Hertz an ellipse grows with its third root.
void set_load(RollingProblem& problem, double force) {
  if (problem.load.given != NormalLoad::Given::force)
    throw Error("load.approach: needs load.normal_force where creep curves are fitted");
  if (auto* const ellipse = std::get_if<Ellipse>(&problem.geometry)) {
    const double scale = std::cbrt(force / problem.load.value);
    ellipse->a *= scale, ellipse->b *= scale;
  }
  problem.load.value = force;
}

/// Whether the curves of a model are solved by the exact theory.
bool is_solved_exactly(const CurveModel& model) {
  std::vector<double> start;
  for (const CurveParameter& one : model.parameters()) start.push_back(one.start);
  const io::CaseInputs inputs = model.inputs(start);
  return io::read_case(inputs.root()).method.theory == Theory::exact && !model.is_formula();
}

} // namespace

CreepCurveSolver::CreepCurveSolver(const io::MeasuredCurves& points, bool is_exact, int elements)
    : points_(points), elements_(elements) {
  for (std::size_t i = 0; i < points.points.size(); ++i) {
    const io::MeasuredPoint& point = points.points[i];
    auto found = std::find_if(curves_.begin(), curves_.end(), [&](const Curve& curve) {
      return conditions_of(curve.conditions) == conditions_of(point);
    });
    if (found == curves_.end())
      found = curves_.insert(curves_.end(), Curve{.conditions = point, .points = {}, .nodes = {}});
    found->points.push_back(i);
    found->nodes.push_back(point.creepage);
  }
  for (Curve& curve : curves_) curve.nodes = nodes_of(std::move(curve.nodes), is_exact ? 20 : 32);
}

RollingProblem CreepCurveSolver::problem_of(const io::RollingCase& input, const Curve& curve) const {
  RollingProblem problem = input.problem;
  if (problem.motion.kind != ContactMotion::steady) throw Error("motion.kind: must be steady for creep curves");
  set_load(problem, curve.conditions.normal_force);
  problem.motion.rolling_speed = curve.conditions.speed;
  problem.motion.force_x = problem.motion.force_y = std::nullopt;
  return problem;
}

bool CreepCurveSolver::solve(const io::RollingCase& input, std::span<double> coefficients,
                             std::optional<std::size_t> run) {
  std::vector<double> at_nodes;
  for (const Curve& curve : curves_) {
    if (run && curve.conditions.run != *run) continue;
    if (!solve_nodes(curve, input, at_nodes)) return false;
    interpolate(curve, at_nodes, coefficients);
  }
  return true;
}

void CreepCurveSolver::solve_by_formula(const io::RollingCase& input, std::pair<double, double> factors,
                                        std::span<double> coefficients, std::size_t run) {
  for (const Curve& curve : curves_)
    if (curve.conditions.run == run)
      interpolate(curve, formula(curve, factors, problem_of(input, curve)), coefficients);
}

bool CreepCurveSolver::solve_nodes(const Curve& curve, const io::RollingCase& input, std::vector<double>& at_nodes) {
  RollingProblem problem = problem_of(input, curve);
  Method method = input.method;
  if (method.theory == Theory::exact)
    method.mx = std::min(method.mx, elements_), method.my = std::min(method.my, elements_);
  if (!solver_ || solver_->method() != method) solver_.emplace(method);
  at_nodes.clear();
  for (const double creepage : curve.nodes) {
    (points_.is_lateral ? problem.motion.creepage.lateral : problem.motion.creepage.longitudinal) = creepage;
    const ContactForces forces = solver_->solve(problem).forces();
    if (forces.status != Status::ok) return false;
    at_nodes.push_back(-(points_.is_lateral ? forces.fy : forces.fx) / curve.conditions.normal_force);
  }
  return true;
}

CurveEvaluator::CurveEvaluator(const CurveModel& model, const io::MeasuredCurves& points, int elements)
    : model_(model), points_(points), is_exact_(is_solved_exactly(model)), solver_(points, is_exact_, elements) {}

bool CurveEvaluator::evaluate(std::span<const double> values, std::span<double> coefficients) {
  try {
    const std::size_t runs = points_.runs.size();
    std::vector<double> of_run(model_.parameters().size());
    std::copy(values.begin() + static_cast<std::ptrdiff_t>(runs), values.end(), of_run.begin() + 1);
    for (std::size_t run = 0; run < runs; ++run) {
      of_run.front() = values[run];
      const io::CaseInputs inputs = model_.inputs(of_run);
      const io::RollingCase input = io::read_case(inputs.root());
      if (model_.is_formula())
        solver_.solve_by_formula(input, model_.polach_factors(of_run), coefficients, run);
      else if (!solver_.solve(input, coefficients, run))
        return false;
    }
    return std::all_of(coefficients.begin(), coefficients.end(), [](double value) { return std::isfinite(value); });
  } catch (const Error&) { // values beyond the range of inputs
    return false;
  }
}

/// Polach 2005: f = 2 mu/pi (k_a e/(1 + (k_a e)^2) + atan(k_s e)), e = G pi a b C xi/(4 mu Fn), mu at the slip V xi.
std::vector<double> CreepCurveSolver::formula(const Curve& curve, std::pair<double, double> factors,
                                              const RollingProblem& problem) const {
  const EllipticContact contact = elliptic_contact(problem);
  const CreepageCoefficients c = creepage_coefficients(contact.a / contact.b, contact.poisson_ratio);
  const auto [k_a, k_s] = factors;
  std::vector<double> coefficients;
  for (const double creepage : curve.nodes) {
    const double mu = contact.friction.coefficient(contact.rolling_speed * creepage);
    const double e = contact.shear_modulus * std::numbers::pi * contact.a * contact.b * creepage *
                     (points_.is_lateral ? c.c22 : c.c11) / (4 * mu * contact.normal_force);
    coefficients.push_back(2 * mu / std::numbers::pi * (k_a * e / (1 + k_a * k_a * e * e) + std::atan(k_s * e)));
  }
  return coefficients;
}

void CreepCurveSolver::interpolate(const Curve& curve, const std::vector<double>& at_nodes,
                                   std::span<double> coefficients) const {
  const auto& nodes = curve.nodes;
  std::vector<double> steps, second(nodes.size());
  for (std::size_t k = 1; k < nodes.size(); ++k) steps.push_back(std::log(nodes[k] / nodes[k - 1]));
  if (nodes.size() > 1) natural_spline(steps, at_nodes, second);
  for (const std::size_t i : curve.points) {
    const double creepage = points_.points[i].creepage;
    const auto next = std::lower_bound(nodes.begin(), nodes.end(), creepage * (1 - 1e-12));
    const auto k = static_cast<std::size_t>(next - nodes.begin());
    if (k == 0) {
      coefficients[i] = at_nodes.front();
      continue;
    }
    const double h = steps[k - 1], q = std::min(std::log(creepage / nodes[k - 1]) / h, 1.), p = 1 - q;
    coefficients[i] = p * at_nodes[k - 1] + q * at_nodes[k] +
                      h * h / 6 * ((p * p * p - p) * second[k - 1] + (q * q * q - q) * second[k]);
  }
}

} // namespace microslip::fit
