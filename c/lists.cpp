#include "c/growing_struct.hpp"
#include "c/guarded_call.hpp"
#include "io/nearest_word.hpp"
#include "microslip/contact/quantities.hpp"
#include "microslip/contact/warnings.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"
#include "microslip/railway/wheelset_contact_quantities.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

using namespace microslip;
using namespace microslip::c;

namespace {

/// Hands the table behind a microslip_list on. Throws Error if there is no such list.
template <class Visit> auto with_list(int list, const Visit& visit) {
  switch (require_count("list", list, MICROSLIP_CONTACT_QUANTITY, MICROSLIP_WHEELSET_CONTACT)) {
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
  default:
    return visit(wheelset_contact_quantities());
  }
}

// What the entries of tables tell. Their texts are literals or strings that last, which end with a zero.

template <class Entry> std::string_view name_of(const Entry& entry) {
  return entry.name;
}
std::string_view name_of(const WheelDerivative& entry) {
  return entry.of->name;
}

template <class Entry> microslip_quantity description_of(const Entry& q) {
  return {sizeof(microslip_quantity), q.name.data(), "", q.unit.data(), q.unit.data(), q.description.data()};
}
template <class Entry>
requires requires(const Entry& q) {
  q.shift_unit;
}
microslip_quantity description_of(const Entry& q) {
  return {sizeof(microslip_quantity), q.name.data(),       q.symbol.data(), q.unit.data(),
          q.shift_unit.data(),        q.description.data()};
}
microslip_quantity description_of(const WheelDerivative& entry) {
  return description_of(*entry.of);
}

template <class Entry> std::size_t place_of(std::span<const Entry> table, std::string_view name) {
  std::vector<std::string_view> names;
  for (const Entry& entry : table) {
    if (name_of(entry) == name) return names.size();
    names.push_back(name_of(entry));
  }
  throw Error("name = " + io::printable(name) + ": is none of this list" + io::suggestion(name, names));
}

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
    index = static_cast<int>(with_list(list, [&](auto table) { return place_of(table, wanted); }));
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
