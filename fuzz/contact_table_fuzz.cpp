#include "io/contact_table.hpp"
#include "microslip/error.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace microslip;

struct Table {
  std::vector<EllipticContact> contacts;
  std::string text; ///< the columns and the rows' fields
};

Table read_table(const std::string& csv) {
  std::istringstream stream(csv);
  io::ContactTableReader reader(stream, "name");
  Table table;
  for (const std::string& name : reader.columns()) table.text.append(table.text.empty() ? "" : ",").append(name);
  io::TextChunk chunk;
  while (reader.read(chunk)) {
    const auto rows = reader.parse(chunk);
    std::size_t begin = 0;
    for (const auto end : rows.ends) {
      table.text.append("\n").append(rows.text, begin, end - begin);
      begin = end;
    }
    table.contacts.insert(table.contacts.end(), rows.contacts.begin(), rows.contacts.end());
  }
  return table;
}

bool is_sound(const EllipticContact& contact) {
  const auto is_positive = [](double value) { return value > 0 && std::isfinite(value); };
  return is_positive(contact.a) && is_positive(contact.b) && is_positive(contact.shear_modulus) &&
         is_positive(contact.normal_force) && contact.poisson_ratio >= 0 && contact.poisson_ratio <= 0.5 &&
         std::isfinite(contact.creepage.longitudinal) && std::isfinite(contact.creepage.lateral) &&
         std::isfinite(contact.creepage.spin);
}

} // namespace

/// Any text is either a table of sound contacts, whose text reads as the same table again, or refused with a message
/// that begins with the file's name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Table table;
  try {
    table = read_table({reinterpret_cast<const char*>(data), size});
  } catch (const Error& error) {
    if (!std::string_view(error.what()).starts_with("name:")) std::abort();
    return 0;
  }
  for (const auto& contact : table.contacts)
    if (!is_sound(contact)) std::abort();
  if (read_table(table.text).text != table.text) std::abort();
  return 0;
}
