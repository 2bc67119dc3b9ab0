#include "c/contact.hpp"
#include "c/guarded_call.hpp"
#include "c/problem.hpp"
#include "cases/contact_damage.hpp"
#include "microslip/rolling/solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace microslip::c {
namespace {

class SolvedBodies final : public SolvedCase {
public:
  Ending solve(const io::CaseInputs& inputs, const Progress& progress) override {
    io::RollingCase input = read(inputs);
    ContactSolution found = solver_->solve(input.problem, progress);
    return keep(std::move(input), std::move(found));
  }

  Ending differentiate(const io::CaseInputs& inputs, const Progress& progress, std::span<double, 9> jacobian) override {
    io::RollingCase input = read(inputs);
    require_differentiable(input.problem);
    const ExactDerivatives found = solver_->differentiate(input.problem, progress);
    const bool has_result = std::isfinite(found.solution.totals.fx);
    for (std::size_t k = 0; k < jacobian.size(); ++k)
      jacobian[k] = has_result ? found.jacobian[k / 3][k % 3] : std::numeric_limits<double>::quiet_NaN();
    return keep(std::move(input), found.solution);
  }

  double number(std::string_view name) const override {
    const DamageQuantity* const of_damage = find_damage_quantity(name);
    if (of_damage == nullptr) return quantity_of(solution(), name);
    const double value = damage()(*of_damage);
    if (std::isnan(value) && std::isfinite(solution().totals.fx)) refuse("quantity", name);
    return value;
  }

  FieldSize field_size(std::string_view name) const override {
    if (find_damage_field(name) == nullptr) require_field_name(name);
    const Elements& elements = solution().elements;
    return {static_cast<std::size_t>(elements.mx()), static_cast<std::size_t>(elements.my())};
  }

  void copy_field(std::string_view name, std::span<double> values) override {
    if (const DamageField* const of_damage = find_damage_field(name)) {
      const std::vector<double> found = damage()(*of_damage);
      require_size("count", values.size(), solution().elements.size());
      if (found.size() != values.size()) refuse("field", name);
      std::ranges::copy(found, values.begin());
      return;
    }
    if (name == "gap") find_gap();
    c::copy_field(solution(), name, values);
  }

private:
  /// The case. The solver is kept while its method stays the same; what another one has solved is forgotten.
  io::RollingCase read(const io::CaseInputs& inputs) {
    io::RollingCase input = io::read_case(inputs.root(), tables_);
    const Method& method = input.method;
    require_compatible(input.problem, method);
    if (!solver_ || !(solver_->method() == method)) {
      solver_ = Solver(method);
      solution_.reset();
    }
    return input;
  }

  Ending keep(io::RollingCase input, ContactSolution found) {
    input_ = std::move(input);
    solution_ = std::move(found);
    return {solution_->report.status, solution_->report.reason};
  }

  const ContactSolution& solution() const { return require_solution(solution_, "microslip_solve"); }

  /// What the solution does to the surface that [material] is of.
  cases::CaseDamage damage() const {
    const ContactSolution& of = solution();
    if (!input_.strength) throw Refusal(MICROSLIP_NO_RESULT, "wear and fatigue need inputs of material");
    return {input_, hertz_contact(input_.problem), of};
  }

  /// Finds the bodies' distance from the normal problem on the solution's grid, if the solution has none.
  void find_gap() {
    if (!solution_ || solution_->elements.size() == 0 || !solution_->fields.gap.empty()) return;
    if (solver_->method().theory == Theory::exact) solution_->fields.gap = solver_->deformed_gap(input_.problem).gap;
  }

  io::CreepTables tables_;
  std::optional<Solver> solver_;
  io::RollingCase input_; ///< of the solution
  std::optional<ContactSolution> solution_;
};

} // namespace

std::unique_ptr<SolvedCase> solved_bodies() {
  return std::make_unique<SolvedBodies>();
}

} // namespace microslip::c
