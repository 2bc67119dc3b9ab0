#include "microslip/contact/quantities.hpp"
#include "c/contact.hpp"
#include "c/guarded_call.hpp"

#include <algorithm>

namespace microslip::c {
namespace {

constexpr std::string_view state = "state"; ///< of cells, no number

} // namespace

void refuse(const char* kind, std::string_view name) {
  throw Refusal(MICROSLIP_NO_RESULT, std::string(kind) + " = " + std::string(name) + ": is none of these results");
}

const ContactSolution& require_solution(const std::optional<ContactSolution>& solution, const char* call) {
  if (!solution) throw Refusal(MICROSLIP_NO_RESULT, std::string(call) + " was not called yet");
  return *solution;
}

void require_field_name(std::string_view name) {
  if (name != state) field_quantity(name);
}

void copy_field(const ContactSolution& solution, std::string_view name, std::span<double> values) {
  if (name == state) {
    const auto& states = solution.fields.state;
    require_size("count", values.size(), states.size());
    std::ranges::transform(states, values.begin(), [](CellState s) { return static_cast<double>(s); });
    return;
  }
  const std::vector<double>& found = field_quantity(name).values(solution);
  require_size("count", values.size(), solution.elements.size());
  if (found.size() != values.size()) refuse("field", name);
  std::ranges::copy(found, values.begin());
}

double quantity_of(const ContactSolution& solution, std::string_view name) {
  const Quantity& wanted = quantity(name);
  if (!wanted.applies(solution)) refuse("quantity", name);
  return wanted.value(solution);
}

} // namespace microslip::c
