#include "c/growing_struct.hpp"
#include "c/names.hpp"
#include "microslip/contact/quantities.hpp"
#include "microslip/contact/warnings.hpp"
#include "microslip/description/words.hpp"
#include "microslip/railway/geometry/wheelset_contact_quantities.hpp"
#include "microslip/railway/vehicle/wheelset_quantities.hpp"

#include <limits>
#include <string>
#include <string_view>

using namespace microslip;
using namespace microslip::c;

namespace {

/// The index among the kinds of cases whose inputs a microslip_list has.
std::size_t kind_of_inputs(int list) {
  return static_cast<std::size_t>(list - MICROSLIP_BODIES_INPUT);
}

/// Hands the table behind a microslip_list on. Throws Error if there is no such list.
template <class Visit> auto with_list(int list, const Visit& visit) {
  switch (require_count("list", list, MICROSLIP_CONTACT_QUANTITY, MICROSLIP_WHEELSET_INPUT)) {
  case MICROSLIP_CONTACT_QUANTITY:
    return visit(quantities());
  case MICROSLIP_CONTACT_FIELD:
    return visit(field_quantities());
  case MICROSLIP_WHEEL_STATE:
    return visit(wheel_inputs());
  case MICROSLIP_WHEEL_RESULT:
    return visit(wheel_results());
  case MICROSLIP_WHEEL_DERIVATIVE:
    return visit(wheel_derivatives());
  case MICROSLIP_WHEEL_PATCH:
    return visit(patch_results());
  case MICROSLIP_WHEELSET_CONTACT:
    return visit(wheelset_contact_quantities());
  case MICROSLIP_WHEELSET_RESULT:
    return visit(wheelset_quantities());
  default:
    return visit(description::inputs_of(description::case_kinds[kind_of_inputs(list)]).named());
  }
}

// What the entries of tables tell. Their texts are literals or strings that last, which end with a zero.

constexpr double none = std::numeric_limits<double>::quiet_NaN();

microslip_quantity description_of(std::string_view name, std::string_view unit, std::string_view text) {
  return {.struct_size = sizeof(microslip_quantity),
          .name = name.data(),
          .symbol = "",
          .unit = unit.data(),
          .shift_unit = unit.data(),
          .description = text.data(),
          .range = "",
          .least = -std::numeric_limits<double>::infinity(),
          .largest = std::numeric_limits<double>::infinity(),
          .missing = none,
          .missing_word = "",
          .kind = MICROSLIP_NUMBER};
}

template <class Entry> microslip_quantity description_of(const Entry& q) {
  return description_of(q.name, q.unit, q.description);
}
template <class Entry>
requires requires(const Entry& q) {
  q.shift_unit;
}
microslip_quantity description_of(const Entry& q) {
  microslip_quantity out = description_of(q.name, q.unit, q.description);
  out.symbol = q.symbol.data();
  out.shift_unit = q.shift_unit.data();
  return out;
}
microslip_quantity description_of(const description::NamedInput& named) {
  const description::Input& input = *named.input;
  microslip_quantity out = description_of(named.path, input.unit.empty() ? "-" : input.unit, input.text);
  out.range = named.range.c_str();
  out.least = input.bounds.least();
  out.largest = input.bounds.largest();
  out.missing = input.missing.value_or(none);
  if (!input.missing_word.empty()) out.missing_word = input.missing_word.data();
  out.kind = static_cast<int>(input.kind);
  return out;
}
static_assert(static_cast<int>(description::InputKind::number) == MICROSLIP_NUMBER &&
              static_cast<int>(description::InputKind::word) == MICROSLIP_WORD);

} // namespace

size_t microslip_count(int list) {
  std::size_t count = 0;
  guarded(nullptr, [&] { count = with_list(list, [](auto table) { return table.size(); }); });
  return count;
}

int microslip_index(int list, const char* name, microslip_error* error) {
  int index = -1;
  guarded(error, [&] {
    const std::string_view wanted = require_pointer("name", name);
    index = static_cast<int>(with_list(list, [&](auto table) { return index_of(table, wanted); }));
  });
  return index;
}

microslip_code microslip_describe(int list, size_t index, microslip_quantity* quantity, microslip_error* error) {
  return guarded(error, [&] {
    const std::size_t size = require_pointer("quantity", quantity)->struct_size;
    const microslip_quantity known = with_list(list, [&](auto table) {
      if (index >= table.size())
        throw Error("index = " + std::to_string(index) + ": must be below " + std::to_string(table.size()));
      return description_of(table[index]);
    });
    write_growing("quantity", known, quantity, size);
  });
}

const char* microslip_warning(int k) {
  return k >= 0 && k < static_cast<int>(warning_count) ? warning_table()[static_cast<std::size_t>(k)].text.data()
                                                       : nullptr;
}
