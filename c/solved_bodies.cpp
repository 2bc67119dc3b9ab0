#include "c/contact.hpp"
#include "c/problem.hpp"
#include "io/case_file.hpp"
#include "microslip/rolling/solver.hpp"

#include <cmath>
#include <limits>
#include <optional>

namespace microslip::c {
namespace {

class SolvedBodies final : public SolvedCase {
public:
  Ending solve(const io::CaseInputs& inputs, const Progress& progress) override {
    const RollingProblem problem = read(inputs);
    return keep(problem, solver_->solve(problem, progress));
  }

  Ending differentiate(const io::CaseInputs& inputs, const Progress& progress, std::span<double, 9> jacobian) override {
    const RollingProblem problem = read(inputs);
    require_differentiable(problem);
    const ExactDerivatives found = solver_->differentiate(problem, progress);
    const bool has_result = std::isfinite(found.solution.totals.fx);
    for (std::size_t k = 0; k < jacobian.size(); ++k)
      jacobian[k] = has_result ? found.jacobian[k / 3][k % 3] : std::numeric_limits<double>::quiet_NaN();
    return keep(problem, found.solution);
  }

  double number(std::string_view name) const override { return quantity_of(solution(), name); }

  FieldSize field_size(std::string_view name) const override {
    require_field_name(name);
    const Elements& elements = solution().elements;
    return {static_cast<std::size_t>(elements.mx()), static_cast<std::size_t>(elements.my())};
  }

  void copy_field(std::string_view name, std::span<double> values) override {
    if (name == "gap") find_gap();
    c::copy_field(solution(), name, values);
  }

private:
  /// The problem. The solver is kept while its method stays the same; what another one has solved is forgotten.
  RollingProblem read(const io::CaseInputs& inputs) {
    const io::RollingCase input = io::read_case(inputs.root(), tables_);
    const Method& method = input.method;
    require_compatible(input.problem, method);
    if (!solver_ || !(solver_->method() == method)) {
      solver_ = Solver(method);
      solution_.reset();
    }
    return input.problem;
  }

  Ending keep(const RollingProblem& problem, ContactSolution found) {
    problem_ = problem;
    solution_ = std::move(found);
    return {solution_->report.status, solution_->report.reason};
  }

  const ContactSolution& solution() const { return require_solution(solution_, "microslip_solve"); }

  /// Finds the bodies' distance from the normal problem on the solution's grid, if the solution has none.
  void find_gap() {
    if (!solution_ || solution_->elements.size() == 0 || !solution_->fields.gap.empty()) return;
    if (solver_->method().theory == Theory::exact) solution_->fields.gap = solver_->deformed_gap(problem_).gap;
  }

  io::CreepTables tables_;
  std::optional<Solver> solver_;
  RollingProblem problem_; ///< of the solution
  std::optional<ContactSolution> solution_;
};

} // namespace

std::unique_ptr<SolvedCase> solved_bodies() {
  return std::make_unique<SolvedBodies>();
}

} // namespace microslip::c
