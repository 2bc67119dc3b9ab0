#include "microslip/simplified/fastrip.hpp"

#include "microslip/contact/conclude.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace microslip {
namespace {

double square(double x) {
  return x * x;
}

/// sqrt of what is negative by rounding only, or outside.
double root(double x) {
  return std::sqrt(std::max(x, 0.0));
}

SimplifiedOptions checked(const SimplifiedOptions& options) {
  if (options.precision == Precision::single) throw Error("precision: single is for FASTSIM and FASTSIM2");
  if (options.bound != TractionBound::elliptic) throw Error("bound = parabolic: must be elliptic for FaStrip");
  if (options.slope_reduction.initial != 1 || options.slope_reduction.at_infinity != 1)
    throw Error("slope_reduction: FaStrip has none");
  return options;
}

/// The cells of row j of a grid.
StripRow row_of(ContactSolution& solution, int j, const EllipticContact& contact) {
  const Elements& e = solution.elements;
  SurfaceFields& f = solution.fields;
  const std::size_t n = static_cast<std::size_t>(e.mx()), first = e.index(0, j);
  const auto part = [&](auto& field) { return std::span(field).subspan(first, n); };
  const double y = e.y[first], half_length = contact.a * root(1 - square(y / contact.b));
  return {y,
          0,
          half_length,
          std::span(e.x).subspan(first, n),
          part(f.bound),
          part(f.traction.x),
          part(f.traction.y),
          part(f.slip.x),
          part(f.slip.y),
          part(f.state)};
}

/// Tractions above the bound are drawn back to it.
void keep_within_bound(SurfaceFields& f) {
  auto& [px, py] = f.traction;
  for (std::size_t k = 0; k < px.size(); ++k) {
    const double size = std::sqrt(square(px[k]) + square(py[k]));
    if (!(size > f.bound[k])) continue;
    px[k] *= f.bound[k] / size;
    py[k] *= f.bound[k] / size;
    f.state[k] = CellState::slip;
  }
}

/// The cells' areas do not add up to the ellipse's.
void set_totals(ContactSolution& solution, const EllipticContact& contact) {
  Totals& t = solution.totals =
      find_totals(solution.elements, solution.fields, solution.creepage, contact.rolling_speed);
  const double ellipse = std::numbers::pi * contact.a * contact.b;
  t.slip_area *= ellipse / (t.adhesion_area + t.slip_area);
  t.adhesion_area = ellipse - t.slip_area;
}

} // namespace

/// Strip theory's solution for a row, (S19) to (S21).
struct StripTheory::Strip {
  double slip_length;            ///< d, half the length of the sliding part [m]
  double kappa, lambda, lambda2; ///< shares of the two roots in px, py
};

StripTheory::StripTheory(const EllipticContact& contact, double friction, RollingDirection direction,
                         CreepageTable table)
    : a_(contact.a), one_less_nu_(1 - contact.poisson_ratio), mirror_(direction == RollingDirection::forward ? 1 : -1) {
  constexpr double pi = std::numbers::pi;
  const CreepageCoefficients c = creepage_coefficients(contact.a / contact.b, contact.poisson_ratio, table);
  const double area = contact.a * contact.b;
  peak_ = friction * 1.5 * contact.normal_force / (pi * area);
  const double stiffness = contact.shear_modulus / (2 * peak_);
  const double translation = -4 * one_less_nu_ * stiffness / (pi * pi),
               rotation = -3 * stiffness * std::sqrt(area) / pi;
  longitudinal_ = mirror_ * translation * c.c11 * contact.creepage.longitudinal;
  lateral_ = translation * c.c22 * contact.creepage.lateral;
  lateral_per_metre_ = translation * c.c22 * contact.creepage.spin;
  spin_ = mirror_ * rotation * c.c23 * contact.creepage.spin;
}

StripTheory::Strip StripTheory::strip(const StripRow& row) const {
  const double q = longitudinal_ - spin_ * row.y / a_, across = lateral_ + lateral_per_metre_ * row.middle;
  const double rest = 1 - spin_ * spin_, size2 = square(across) + rest * square(q);
  Strip s = {row.half_length, 0, 0, 0};
  if (std::abs(rest) > 1e-6 && size2 >= 0) {
    const double length = a_ / one_less_nu_ * (std::sqrt(size2) + across * spin_) / rest;
    if (length >= 0) s.slip_length = std::min(length, row.half_length);
  }
  const double r = across + spin_ * s.slip_length / a_, size = std::hypot(q, r);
  if (size > 0) {
    s.kappa = q / size;
    s.lambda = r / size;
  }
  s.lambda2 = s.lambda - spin_;
  return s;
}

/// Traction at a cell: strip theory's where that adheres, else g along FASTSIM's.
Vec2 StripTheory::traction(const Strip& strip, const StripRow& row, std::size_t cell) const {
  const double x = mirror_ * (row.x[cell] - row.middle), half = row.half_length, d = strip.slip_length;
  if (x > 2 * d - half) {
    const double all = root(square(half) - square(x)) / a_, adhesion = root(square(half - d) - square(x - d)) / a_;
    return {mirror_ * peak_ * strip.kappa * (all - adhesion), peak_ * (strip.lambda * all - strip.lambda2 * adhesion)};
  }
  const double size = std::sqrt(square(row.px[cell]) + square(row.py[cell]));
  if (!(size > 0)) return {};
  return {row.px[cell] * (row.bound[cell] / size), row.py[cell] * (row.bound[cell] / size)};
}

void StripTheory::solve(const StripRow& row) const {
  const Strip strip = this->strip(row);
  for (std::size_t k = 0; k < row.x.size(); ++k) {
    const Vec2 p = traction(strip, row, k);
    if (square(p.x) + square(p.y) > square(peak_)) return;
  }
  for (std::size_t k = 0; k < row.x.size(); ++k) {
    const Vec2 p = traction(strip, row, k);
    row.px[k] = p.x;
    row.py[k] = p.y;
    const bool adheres = mirror_ * (row.x[k] - row.middle) > 2 * strip.slip_length - row.half_length;
    row.state[k] = adheres ? CellState::adhesion : CellState::slip;
    if (adheres) row.sx[k] = row.sy[k] = 0;
  }
}

Fastrip::Fastrip(const SimplifiedOptions& options) : fastsim_(MarchingScheme::fastsim, checked(options)) {}

void Fastrip::solve(std::span<const EllipticContact> contacts, std::span<ContactForces> forces) {
  for (std::size_t k = 0; k < contacts.size(); ++k) forces[k] = solve(contacts[k]);
}

ContactSolution Fastrip::fields(const EllipticContact& contact) {
  if (contact.friction.kind() != FrictionLaw::Kind::coulomb)
    return solution_without_result(Status::invalid_input, "friction: must be Coulomb's for FaStrip");
  ContactSolution out = fastsim_.fields(contact);
  const double friction = contact.friction.static_coefficient();
  if (out.report.status != Status::ok || !(friction > 0)) return out;
  const StripTheory theory(contact, friction, options().direction, options().creepage_table);
  for (int j = 0; j < out.elements.my(); ++j) theory.solve(row_of(out, j, contact));
  keep_within_bound(out.fields);
  set_totals(out, contact);
  conclude(out, 0); // nothing is iterated
  return out;
}

} // namespace microslip
