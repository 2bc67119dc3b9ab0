#include "validation/exact_cases.hpp"

#include "microslip/batch/batch.hpp"
#include "microslip/contact/limits.hpp"
#include "validation/hertzian_solve.hpp"

#include <memory>
#include <optional>

namespace microslip::validation {
namespace {

/// One thread's. Contacts with the same ellipse share influence coefficients and pressures.
class CaseSolver {
public:
  explicit CaseSolver(const ExactMethod& method)
      : method_(method), from_fastsim2_({.mx = method.n, .my = method.n, .discretisation = method.discretisation}) {}

  ExactCase solve(const EllipticContact& contact, const Progress& progress) {
    if (method_.start == Start::fastsim2) {
      const ContactSolution s = from_fastsim2_.solve(rolling_problem(contact), progress);
      return {s.forces(), s.report.residual, s.report.newton_steps, s.report.products};
    }
    if (!from_nothing_ || a_ != contact.a || b_ != contact.b) prepare(contact);
    TangentialInput input;
    input.creepage = contact.creepage;
    input.progress = progress;
    const ContactSolution s = from_nothing_->solve(contact.friction.static_coefficient(), input);
    return {s.forces(), s.report.residual, s.report.newton_steps, s.report.products};
  }

private:
  void prepare(const EllipticContact& contact) {
    const CombinedMaterial material = {contact.shear_modulus, contact.poisson_ratio, 0};
    const HertzContact hertz = hertz_from_ellipse(contact.a, contact.b, material, contact.normal_force);
    from_nothing_.emplace(material, ElementGrid::across_ellipse(contact.a, contact.b, method_.n, contact_margin),
                          hertz.gap, contact.normal_force);
    a_ = contact.a;
    b_ = contact.b;
  }

  ExactMethod method_;
  Solver from_fastsim2_;
  std::optional<HertzianSolve> from_nothing_;
  double a_ = 0, b_ = 0;
};

} // namespace

std::vector<ExactCase> solve_exactly(std::span<const EllipticContact> contacts, const ExactMethod& method,
                                     const StudyOptions& options) {
  std::vector<ExactCase> cases(contacts.size());
  // In chunks, so that an ellipse's influence coefficients are used often.
  const BatchOptions batch = {.chunk = 20, .threads = options.threads, .progress = options.progress};
  const BatchReport report = run_batch(contacts.size(), batch, [&]() -> BatchWorker {
    return [&, solver = std::make_shared<CaseSolver>(method)](std::size_t first, std::size_t n, const Progress& all) {
      for (std::size_t i = 0; i < n && all(double(i) / double(n)); ++i)
        cases[first + i] =
            solver->solve(contacts[first + i], part_of(all, double(i) / double(n), double(i + 1) / double(n)));
    };
  });
  if (!report.complete) cases.clear();
  return cases;
}

} // namespace microslip::validation
