#include "microslip/contact/quantities.hpp"
#include "c/contact.hpp"
#include "c/guarded_call.hpp"

#include <algorithm>
#include <iterator>

namespace microslip::c {
namespace {

/// Those of microslip_field, in its order.
constexpr std::string_view field_names[] = {"x",  "y",  "area",  "bound",    "px", "py",
                                            "sx", "sy", "state", "pressure", "ux", "uy"};
static_assert(std::size(field_names) == MICROSLIP_FIELD_UY + 1);

[[noreturn]] void refuse(const char* kind, std::string_view name) {
  throw Refusal(MICROSLIP_NO_RESULT, std::string(kind) + " = " + std::string(name) + ": is none of these results");
}

} // namespace

const ContactSolution& require_solution(const std::optional<ContactSolution>& solution, const char* call) {
  if (!solution) throw Refusal(MICROSLIP_NO_RESULT, std::string(call) + " was not called yet");
  return *solution;
}

std::string_view field_name(int field) {
  if (field < 0 || field >= static_cast<int>(std::size(field_names))) refuse("field", std::to_string(field));
  return field_names[field];
}

void copy_field(const ContactSolution& solution, std::string_view name, std::span<double> values) {
  if (name == "state") {
    const auto& state = solution.fields.state;
    require_size("count", values.size(), state.size());
    std::ranges::transform(state, values.begin(), [](CellState s) { return static_cast<double>(s); });
    return;
  }
  const std::vector<double>& found = field_quantity(name).values(solution);
  require_size("count", values.size(), solution.elements.size());
  if (found.empty()) refuse("field", name);
  std::ranges::copy(found, values.begin());
}

double quantity_of(const ContactSolution& solution, std::string_view name) {
  const Quantity& wanted = quantity(name);
  if (!wanted.applies(solution)) refuse("quantity", name);
  return wanted.value(solution);
}

} // namespace microslip::c
