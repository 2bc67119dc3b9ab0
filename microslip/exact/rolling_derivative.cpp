#include "microslip/exact/rolling_derivative.hpp"

#include "microslip/exact/semismooth_newton.hpp"

#include <cmath>

namespace microslip {
namespace {

using Vector = std::vector<float>; // the x components of all elements, then the y components

Vector joined(std::span<const double> x, std::span<const double> y, double factor) {
  Vector v;
  for (const auto& part : {x, y})
    for (const double value : part) v.push_back(static_cast<float>(factor * value));
  return v;
}

void split(const Vector& v, double factor, std::vector<double>& x, std::vector<double>& y) {
  const std::size_t n = v.size() / 2;
  for (std::size_t k = 0; k < n; ++k) x.push_back(factor * v[k]), y.push_back(factor * v[n + k]);
}

double norm(const Vector& v) {
  double sum = 0;
  for (const float value : v) sum += double(value) * value;
  return std::sqrt(sum);
}

} // namespace

/// What LinearisedProblem needs. Tractions are counted in units of 1/rho, which makes slip of them.
class RollingDerivative::Equations {
public:
  using Real = float;

  explicit Equations(RollingDerivative& of) : of_(of), n_(of.product_.elements()), free_(2 * n_), mapped_(2 * n_) {}

  std::size_t size() const { return 2 * n_; }

  void respond(std::span<const float> v, std::span<float> slip) {
    of_.product_.apply(v.first(n_), v.subspan(n_), slip.first(n_), slip.subspan(n_));
  }
  void derivative(std::span<const float> v, std::span<const float> slip, double, std::span<float> out) const {
    of_.friction_.derivative(v, slip, 1, out);
  }
  void precondition(std::span<float> v) {
    of_.friction_.free_part(v, free_);
    const std::span<const float> in(free_);
    const std::span<float> out(mapped_);
    of_.preconditioner_.apply(in.first(n_), in.subspan(n_), out.first(n_), out.subspan(n_));
    of_.friction_.free_part(mapped_, mapped_);
    for (std::size_t k = 0; k < 2 * n_; ++k) v[k] += mapped_[k];
  }

private:
  RollingDerivative& of_;
  std::size_t n_;
  Vector free_, mapped_;
};

RollingDerivative::RollingDerivative(const FittedResponse& response, const FittedContact& contact)
    : rho_(1 / response.diagonal()), product_(response.product(), rho_), preconditioner_(contact),
      friction_(contact.elements.size()) {}

void RollingDerivative::linearise(std::span<const double> bound, const FrictionSolution& s) {
  for (std::size_t k = 0; k < bound.size(); ++k)
    friction_.set(k, s.px[k] - rho_ * s.sx[k], s.py[k] - rho_ * s.sy[k], bound[k]);
}

RollingDerivative::Change RollingDerivative::solve(std::span<const double> dcx, std::span<const double> dcy,
                                                   double tolerance, const Change* start) {
  constexpr int most = 1000;
  const long products_before = product_.products();
  Equations equations(*this);
  const std::size_t size = equations.size();
  Vector total(size), slip = joined(dcx, dcy, 1), right(size), step(size), growth(size);
  equations.derivative(total, slip, 0, right);
  const double without_start = norm(right);
  if (start) {
    total = joined(start->px, start->py, 1 / rho_);
    slip = joined(start->sx, start->sy, 1);
    equations.derivative(total, slip, 0, right);
  }
  for (float& value : right) value = -value;
  const double fall = tolerance * without_start / norm(right);
  LinearisedProblem(equations, gmres_, size).solve(right, 0, fall, most, step, growth);
  for (std::size_t k = 0; k < size; ++k) total[k] += step[k], slip[k] += growth[k];
  Change out;
  split(total, rho_, out.px, out.py);
  split(slip, 1, out.sx, out.sy);
  out.products = product_.products() - products_before;
  return out;
}

} // namespace microslip
