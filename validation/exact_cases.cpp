#include "validation/exact_cases.hpp"

#include "validation/hertzian_solve.hpp"

#include <atomic>
#include <optional>

#include <omp.h>

namespace microslip::validation {
namespace {

/// One thread's. Contacts with the same ellipse share influence coefficients and pressures.
class CaseSolver {
public:
  explicit CaseSolver(const ExactMethod& method)
      : method_(method), from_fastsim2_({.mx = method.n, .my = method.n, .discretisation = method.discretisation}) {}

  ExactCase solve(const EllipticContact& contact) {
    if (method_.start == Start::fastsim2) {
      const ContactSolution s = from_fastsim2_.solve(contact);
      return {s.forces(), s.report.residual, s.report.newton_steps, s.report.products};
    }
    if (!from_nothing_ || a_ != contact.a || b_ != contact.b) prepare(contact);
    TangentialInput input;
    input.creepage = contact.creepage;
    const TangentialSolution s = from_nothing_->solve(contact.friction.static_coefficient(), input);
    return {s.forces, s.residual, s.newton_steps, s.products};
  }

private:
  void prepare(const EllipticContact& contact) {
    const CombinedMaterial material = {contact.shear_modulus, contact.poisson_ratio, 0};
    const HertzContact hertz = hertz_from_ellipse(contact.a, contact.b, material, contact.normal_force);
    from_nothing_.emplace(material, ElementGrid::across_ellipse(contact.a, contact.b, method_.n, 2), hertz.gap,
                          contact.normal_force);
    a_ = contact.a;
    b_ = contact.b;
  }

  ExactMethod method_;
  EllipticContactSolver from_fastsim2_;
  std::optional<HertzianSolve> from_nothing_;
  double a_ = 0, b_ = 0;
};

} // namespace

std::vector<ExactCase> solve_exactly(std::span<const EllipticContact> contacts, const ExactMethod& method,
                                     const StudyOptions& options) {
  std::vector<ExactCase> cases(contacts.size());
  std::atomic<int> done = 0;
  std::atomic<bool> stopped = false;
#pragma omp parallel num_threads(options.threads)
  {
    CaseSolver solver(method);
// In blocks, so that an ellipse's influence coefficients are used often.
#pragma omp for schedule(dynamic, 20)
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      if (stopped) continue;
      cases[i] = solver.solve(contacts[i]);
      const double fraction = ++done / double(contacts.size());
      if (omp_get_thread_num() == 0 && options.progress && !options.progress(fraction)) stopped = true;
    }
  }
  if (stopped) cases.clear();
  return cases;
}

} // namespace microslip::validation
