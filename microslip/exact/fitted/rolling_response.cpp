#include "microslip/exact/fitted/rolling_response.hpp"

#include "microslip/exact/fitted/linearised_preconditioner.hpp"
#include "microslip/exact/newton/semismooth_newton.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace microslip {

using Complex = std::complex<double>;
using Vector = std::vector<double>; // the real parts of px and py of all elements, then the imaginary parts

/// Equations of LinearisedProblem. Tractions are counted in units of 1/rho, which makes slip of them.
class RollingResponse::Equations {
public:
  using Real = double;

  Equations(const FittedOperator& fitted_operator, const FittedContact& contact, const TransformPlans& plans)
      : contact_(contact), rho_(1 / fitted_operator.diagonal()), n_(contact.elements.size()),
        product_(fitted_operator.product(), rho_, plans),
        preconditioner_(rolling_preconditioner<double>(contact, plans), n_), friction_(n_), from_end_(n_), along_(n_),
        real_(2 * n_), imaginary_(2 * n_) {}

  std::size_t size() const { return 4 * n_; }
  std::size_t elements() const { return n_; }
  double rho() const { return rho_; }
  long products() const { return product_.products(); }

  void linearise(std::span<const double> bound, const FrictionSolution& s, std::span<const char> centred) {
    centred_.emplace(contact_, centred);
    for (std::size_t k = 0; k < n_; ++k)
      friction_.set(k, s.traction.x[k] - rho_ * s.slip.x[k], s.traction.y[k] - rho_ * s.slip.y[k], bound[k]);
  }
  void set_wavenumber(double wavenumber) {
    for (std::size_t k = 0; k < n_; ++k) {
      const FittedElement& e = contact_.elements[k];
      from_end_[k] = std::polar(1.0, -wavenumber * (e.end - e.point));
      along_[k] = std::polar(1.0, -wavenumber * e.point);
    }
  }
  void respond(std::span<const double> v, std::span<double> slip) {
    for (const std::size_t part : {std::size_t(0), 2 * n_}) {
      const std::span<double> x = slip.subspan(part, n_), y = slip.subspan(part + n_, n_);
      product_.apply(v.subspan(part, n_), v.subspan(part + n_, n_), x, y);
      const std::span<double> over(part == 0 ? real_ : imaginary_);
      product_.find_displacement_over_way(over.first(n_), over.subspan(n_));
    }
    for (std::size_t k = 0; k < 2 * n_; ++k) {
      const Complex phase = from_end_[k % n_];
      put(slip, k, phase * at(slip, k) + (1.0 - phase) * Complex(real_[k], imaginary_[k]));
    }
    move(slip);
  }
  /// Moves slip to the elements' centres, along the paths of particles in time.
  void move(std::span<double> slip) {
    for (std::size_t k = 0; k < 2 * n_; ++k) put(slip, k, at(slip, k) * along_[k % n_]);
    for (std::size_t part = 0; part < 4; ++part) centred_->move(slip.subspan(part * n_, n_));
    for (std::size_t k = 0; k < 2 * n_; ++k) put(slip, k, at(slip, k) * std::conj(along_[k % n_]));
  }
  void derivative(std::span<const double> v, std::span<const double> slip, double, std::span<double> out) const {
    for (const std::size_t part : {std::size_t(0), 2 * n_})
      friction_.derivative(v.subspan(part, 2 * n_), slip.subspan(part, 2 * n_), 1, out.subspan(part, 2 * n_));
  }
  void precondition(std::span<double> v) {
    for (const std::size_t part : {std::size_t(0), 2 * n_})
      preconditioner_.apply(friction_, *centred_, v.subspan(part, 2 * n_));
  }

  Complex at(std::span<const double> v, std::size_t k) const { return {v[k], v[2 * n_ + k]}; }
  void put(std::span<double> v, std::size_t k, Complex value) const {
    v[k] = value.real(), v[2 * n_ + k] = value.imag();
  }

private:
  FittedContact contact_;
  double rho_;
  std::size_t n_;
  FittedProduct<double> product_; ///< rho D
  LinearisedPreconditioner<double> preconditioner_;
  LinearisedFriction<double> friction_;
  std::optional<CentredSlip<double>> centred_;
  ComplexField from_end_, along_; ///< e^{-i k d} and e^{-i k x} of the elements
  Vector real_, imaginary_;       ///< parts of the displacement over the way
};

struct RollingResponse::Solver {
  Solver(const FittedOperator& fitted_operator, const FittedContact& contact, const TransformPlans& plans)
      : equations(fitted_operator, contact, plans), linearised(equations, gmres, equations.size()),
        change(equations.size()), slip(change), right(change), response(change), nx(equations.elements()), ny(nx) {}

  Equations equations;
  Gmres<double> gmres;
  LinearisedProblem<Equations> linearised;
  Vector change, slip, right, response, nx, ny; ///< n: direction of the tractions in slip, 0 in adhesion
};

RollingResponse::RollingResponse(const FittedOperator& fitted_operator, const FittedContact& contact,
                                 const TransformPlans& plans)
    : solver_(std::make_unique<Solver>(fitted_operator, contact, plans)) {}
RollingResponse::RollingResponse(RollingResponse&&) noexcept = default;
RollingResponse& RollingResponse::operator=(RollingResponse&&) noexcept = default;
RollingResponse::~RollingResponse() = default;

void RollingResponse::linearise(std::span<const double> bound, const FrictionSolution& solution,
                                std::span<const char> centred) {
  auto& [equations, gmres, linearised, change, slip, right, response, nx, ny] = *solver_;
  equations.linearise(bound, solution, centred);
  for (std::size_t k = 0; k < nx.size(); ++k) {
    const double px = solution.traction.x[k], py = solution.traction.y[k], size = std::hypot(px, py);
    const bool slides = solution.sliding[k] && size > 0;
    nx[k] = slides ? px / size : 0, ny[k] = slides ? py / size : 0;
  }
}

RollingResponse::Change RollingResponse::solve(double wavenumber, const Cause& cause, double tolerance,
                                               const Progress& progress) {
  constexpr int most = 1000;
  auto& [equations, gmres, linearised, change, slip, right, response, nx, ny] = *solver_;
  const std::size_t n = equations.elements();
  const long products_before = equations.products();
  equations.set_wavenumber(wavenumber);
  std::fill(change.begin(), change.end(), 0.0);
  for (std::size_t k = 0; k < n; ++k) equations.put(slip, k, -cause.cx[k]), equations.put(slip, n + k, -cause.cy[k]);
  equations.move(slip);
  equations.derivative(change, slip, 0, right);
  for (std::size_t k = 0; k < cause.bound.size(); ++k) {
    const Complex bound = cause.bound[k] / equations.rho();
    equations.put(right, k, equations.at(right, k) + nx[k] * bound);
    equations.put(right, n + k, equations.at(right, n + k) + ny[k] * bound);
  }
  linearised.solve(right, 0, tolerance, most, change, response, [&] { go_on(progress, 0); });
  Change out{ComplexField(n), ComplexField(n), ComplexField(n), ComplexField(n),
             equations.products() - products_before};
  for (std::size_t k = 0; k < n; ++k) {
    out.px[k] = equations.rho() * equations.at(change, k), out.py[k] = equations.rho() * equations.at(change, n + k);
    out.sx[k] = equations.at(response, k) - equations.at(slip, k);
    out.sy[k] = equations.at(response, n + k) - equations.at(slip, n + k);
  }
  return out;
}

} // namespace microslip
