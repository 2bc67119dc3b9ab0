#pragma once

#include "microslip/exact/newton/newton_budget.hpp"
#include "microslip/numerics/gmres.hpp"
#include "microslip/progress.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace microslip {

/// When Newton's method ends.
struct NewtonLimits {
  double goal; ///< of |F|
  int most_steps;
  NewtonBudget* budget = nullptr; ///< of the whole solve; none: that of this iteration alone
  Progress progress = {};         ///< called after each step and before each product; false ends the iteration
  double shortest_step = 0;       ///< over Newton's: where |F| falls only by a shorter one the iteration ends
};

/// Ends a linear solve when the progress function returns false.
struct LinearSolveStopped {};

/// State of the iteration.
struct NewtonState {
  double norm = 0; ///< |F|
  int steps = 0;
  bool stopped = false; ///< by the progress function
};

/// The equations F'(x) v = right of a linearised problem F(x) = 0, solved by GMRES. `Problem` has a type Real,
/// size(), precondition(v), respond(v, response) and derivative(v, response, damping, out), as in FrictionEquations;
/// and it may have is_rough() and respond_roughly(v, response), a response in single precision for the products.
template <class Problem> class LinearisedProblem {
public:
  using Real = typename Problem::Real;
  using Field = std::vector<Real>;

  LinearisedProblem(Problem& problem, Gmres<Real>& gmres, std::size_t responses)
      : problem_(problem), gmres_(gmres), change_(problem.size()), responses_(responses) {}

  /// v and, unless `response_of_v` is empty, its response, which costs no product more: it is summed of those that the
  /// products had; only with many_unknowns, where these take too much memory, or where these are rough, it costs one.
  /// `before_product` is called before each of them. Returns |F' v - right|.
  template <class BeforeProduct>
  double solve(std::span<const Real> right, double damping, double tolerance, int most, std::span<Real> v,
               std::span<Real> response_of_v, const BeforeProduct& before_product) {
    const bool rough = !response_of_v.empty() && is_rough();
    const bool sums = !response_of_v.empty() && !rough && right.size() < many_unknowns;
    std::size_t count = 0;
    const auto product = [&](std::span<const Real> in, std::span<Real> out) {
      before_product();
      if (responses_of_products_.size() <= count) responses_of_products_.emplace_back();
      Field& response = responses_of_products_[sums ? count++ : 0];
      response.resize(responses_);
      std::copy(in.begin(), in.end(), change_.begin());
      problem_.precondition(change_);
      respond(change_, response, rough);
      problem_.derivative(change_, response, damping, out);
    };
    const auto result = gmres_.solve(product, right, v, tolerance, most, rough ? Precision::single : Precision::full);
    problem_.precondition(v);
    if (sums) combine(result.weights, responses_of_products_, response_of_v);
    if (!sums && !response_of_v.empty()) {
      before_product();
      problem_.respond(v, response_of_v);
    }
    return result.residual;
  }

private:
  static constexpr bool may_be_rough = requires(const Problem& problem) { problem.is_rough(); };

  bool is_rough() const {
    if constexpr (may_be_rough)
      return problem_.is_rough();
    else
      return false;
  }
  void respond(std::span<const Real> v, std::span<Real> response, [[maybe_unused]] bool rough) {
    if constexpr (may_be_rough)
      if (rough) return problem_.respond_roughly(v, response);
    problem_.respond(v, response);
  }

  Problem& problem_;
  Gmres<Real>& gmres_;
  Field change_;
  std::size_t responses_;
  std::vector<Field> responses_of_products_; ///< of the products' vectors
};

/// Takes semi-smooth Newton steps for F(x) = 0 until a limit is reached, and leaves the best iterate in `x` and
/// `response`; steps count on from `state`. F depends on x and on a response that is affine in x and costs a product.
/// `Problem` has what LinearisedProblem needs and scale(), evaluate(x, response, f), which returns |F|, linearise(x,
/// response) and mean_alpha(). The linear systems are solved by GMRES as well as they predicted the last step, but not
/// better than to the square of the last one's accuracy: what is predicted well need not be again (Eisenstat & Walker
/// 1996, choice 1 with a safeguard). Steps are halved until |F| falls.
template <class Problem>
void take_newton_steps(Problem& problem, Gmres<double>& gmres, const NewtonLimits& limits, std::vector<double>& x,
                       std::vector<double>& response, NewtonState& state) {
  using Field = std::vector<double>;
  /// Found by trial: with 0.03 and 0.1 all of 14,000 seeded problems converge to 1e-10; with 0.001, 0.01 and 0.3 one to
  /// three of them do not.
  constexpr double most_damping = 0.05;
  constexpr double roughest = 0.3; // of the linear equations' residual
  constexpr int most_halvings = 12;
  const std::size_t n = problem.size();
  Field f(n), step(n), response_change(response.size()), trial(n), trial_response(response.size()), trial_f(n), best_x,
      best_response;
  LinearisedProblem<Problem> linearised(problem, gmres, response.size());
  double& norm = state.norm = problem.evaluate(x, response, f);
  double best_norm = norm, misfit = roughest;
  const double first_norm = norm;
  double done = 0;
  const auto before_product = [&] {
    if (limits.budget) limits.budget->take_product();
    if (limits.progress && !limits.progress(done)) throw LinearSolveStopped();
  };
  const auto may_go_on = [&] { return state.steps < limits.most_steps && !is_spent(limits.budget) && !state.stopped; };
  for (; norm > limits.goal && may_go_on(); ++state.steps) {
    if (limits.budget) limits.budget->take_step();
    problem.linearise(x, response);
    for (double& value : f) value = -value; // the right side, which f is not needed beside
    const double damping = most_damping * problem.mean_alpha() * std::min(1.0, norm / problem.scale());
    const double least = std::min(0.8 * limits.goal / norm, roughest);
    const double accuracy = std::clamp(misfit, least, roughest);
    double linear_norm = 0;
    try {
      linear_norm = linearised.solve(f, damping, accuracy, most_gmres_products, step, response_change, before_product);
    } catch (const LinearSolveStopped&) {
      state.stopped = true;
      break;
    }

    double length = 1, trial_norm = norm;
    for (int halving = 0; halving < most_halvings && length >= limits.shortest_step; ++halving, length /= 2) {
      for (std::size_t k = 0; k < n; ++k) trial[k] = x[k] + length * step[k];
      for (std::size_t k = 0; k < response_change.size(); ++k)
        trial_response[k] = response[k] + length * response_change[k];
      trial_norm = problem.evaluate(trial, trial_response, trial_f);
      if (trial_norm < (1 - 1e-4 * length) * norm) break;
    }
    if (length < limits.shortest_step) {
      ++state.steps;
      break;
    }
    if (!(trial_norm < norm) && norm <= best_norm) { // a short step uphill often leads on
      best_norm = norm;
      best_x = x;
      best_response = response;
    }
    misfit = std::max(std::abs(trial_norm - linear_norm) / norm, accuracy * accuracy);
    std::swap(x, trial);
    std::swap(response, trial_response);
    std::swap(f, trial_f);
    norm = trial_norm;
    done = digits_done(first_norm, norm, limits.goal);
    state.stopped = limits.progress && !limits.progress(done);
  }
  if (norm <= best_norm || best_x.empty()) return;
  x = std::move(best_x);
  response = std::move(best_response);
  norm = best_norm;
}

} // namespace microslip
