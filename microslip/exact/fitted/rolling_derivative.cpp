#include "microslip/exact/fitted/rolling_derivative.hpp"

#include "microslip/exact/fitted/linearised_preconditioner.hpp"
#include "microslip/exact/newton/semismooth_newton.hpp"
#include "microslip/numerics/precision.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace microslip {
namespace {

using Vector = std::vector<float>; // the x components of all elements, then the y components

void join(std::span<const double> x, std::span<const double> y, double factor, Vector& v) {
  convert(x, factor, std::span(v).first(x.size()));
  convert(y, factor, std::span(v).subspan(x.size()));
}

void split(const Vector& v, double factor, std::vector<double>& x, std::vector<double>& y) {
  x.resize(v.size() / 2), y.resize(v.size() / 2);
  convert(std::span(v).first(x.size()), factor, x);
  convert(std::span(v).subspan(x.size()), factor, y);
}

double largest(std::span<const double> v) {
  double most = 0;
  for (const double value : v) most = std::max(most, std::abs(value));
  return most;
}

} // namespace

/// Equations of LinearisedProblem. Tractions are counted in units of 1/rho, which makes slip of them.
class RollingDerivative::Equations {
public:
  using Real = float;

  Equations(const FittedOperator& fitted_operator, const FittedContact& contact, const TransformPlans& plans)
      : rho_(1 / fitted_operator.diagonal()), n_(contact.elements.size()),
        product_(fitted_operator.product(), rho_, plans),
        preconditioner_(rolling_preconditioner<float>(contact, plans), n_), friction_(n_) {}

  std::size_t size() const { return 2 * n_; }
  double rho() const { return rho_; }
  long products() const { return product_.products(); }

  void linearise(std::span<const double> bound, const FrictionSolution& s, CentredSlip<float> slip) {
    slip_ = std::move(slip);
    for (std::size_t k = 0; k < n_; ++k)
      friction_.set(k, s.traction.x[k] - rho_ * s.slip.x[k], s.traction.y[k] - rho_ * s.slip.y[k], bound[k]);
  }
  void respond(std::span<const float> v, std::span<float> slip) {
    product_.apply(v.first(n_), v.subspan(n_), slip.first(n_), slip.subspan(n_));
    slip_->move(slip.first(n_));
    slip_->move(slip.subspan(n_));
  }
  void derivative(std::span<const float> v, std::span<const float> slip, double, std::span<float> out) const {
    friction_.derivative(v, slip, 1, out);
  }
  void precondition(std::span<float> v) { preconditioner_.apply(friction_, *slip_, v); }

private:
  double rho_;
  std::size_t n_;
  FittedProduct<float> product_; ///< rho D
  LinearisedPreconditioner<float> preconditioner_;
  LinearisedFriction<float> friction_;
  std::optional<CentredSlip<float>> slip_;
};

struct RollingDerivative::Solver {
  Solver(const FittedOperator& fitted_operator, const FittedContact& contact, const TransformPlans& plans)
      : equations(fitted_operator, contact, plans), linearised(equations, gmres, equations.size()),
        change(equations.size()), slip(change), right(change) {}

  Equations equations;
  Gmres<float> gmres;
  LinearisedProblem<Equations> linearised;
  Vector change, slip, right;
};

RollingDerivative::RollingDerivative(const FittedOperator& fitted_operator, const FittedContact& contact,
                                     const TransformPlans& plans)
    : solver_(std::make_unique<Solver>(fitted_operator, contact, plans)) {}
RollingDerivative::RollingDerivative(RollingDerivative&&) noexcept = default;
RollingDerivative& RollingDerivative::operator=(RollingDerivative&&) noexcept = default;
RollingDerivative::~RollingDerivative() = default;

void RollingDerivative::linearise(std::span<const double> bound, const FrictionSolution& solution,
                                  CentredSlip<float> slip) {
  solver_->equations.linearise(bound, solution, std::move(slip));
}

RollingDerivative::Change RollingDerivative::solve(std::span<const double> dcx, std::span<const double> dcy,
                                                   double tolerance, const Progress& progress) {
  constexpr int most = 1000;
  auto& [equations, gmres, linearised, change, slip, right] = *solver_;
  const long products_before = equations.products();
  const double most_slip = std::max(largest(dcx), largest(dcy));
  const double unit = most_slip > 0 ? most_slip : 1; // of slip: squares of small lengths underflow in single precision
  std::fill(change.begin(), change.end(), 0.0F);
  join(dcx, dcy, -1 / unit, slip);
  equations.derivative(change, slip, 0, right);
  linearised.solve(right, 0, tolerance, most, change, {}, [&] { go_on(progress, 0); });
  Change out;
  split(change, unit * equations.rho(), out.px, out.py);
  out.products = equations.products() - products_before;
  return out;
}

} // namespace microslip
