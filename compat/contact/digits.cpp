#include "compat/contact/digits.hpp"

#include <span>
#include <type_traits>

namespace microslip::contact_program {
namespace {

/// Gives one digit its value.
using Put = void (*)(const Words& words, const char* control, int value, Digits& digits);

template <auto member> void put(const Words& words, const char* control, int value, Digits& digits) {
  using Choice = std::remove_reference_t<decltype(digits.*member)>;
  const std::string field = std::string("digit ") + values_of<Choice>.name + " of " + control;
  digits.*member = to_choice<Choice>(words, field, value);
}

constexpr Put first_word[] = {put<&Digits::pvtime>, put<&Digits::bound>, put<&Digits::tang>,
                              put<&Digits::norm>,   put<&Digits::force>, put<&Digits::stress>};
constexpr Put second_word[] = {put<&Digits::varfrc>, put<&Digits::frclaw>, put<&Digits::discns>, put<&Digits::inflcf>,
                               put<&Digits::mater>,  put<&Digits::rznorm>, put<&Digits::exrhs>};
constexpr Put third_word[] = {put<&Digits::xflow>,  put<&Digits::heat>,   put<&Digits::gausei>, put<&Digits::iestim>,
                              put<&Digits::matfil>, put<&Digits::output>, put<&Digits::flow>,   put<&Digits::solve>};

void read_control(Words& words, const char* control, std::span<const Put> puts, Digits& digits) {
  const auto values = words.control(control, puts.size());
  for (std::size_t k = 0; k < puts.size(); ++k) puts[k](words, control, values[k], digits);
}

} // namespace

void check_value(const Words& words, const std::string& field, int value, const Values& values) {
  const auto end = values.list.begin() + values.count;
  if (std::find(values.list.begin(), end, value) != end) return;
  std::string text;
  for (auto allowed = values.list.begin(); allowed != end; ++allowed)
    text += (text.empty() ? "" : ", ") + std::to_string(*allowed);
  words.fail(field, value, "must be one of " + text);
}

Digits read_digits(Words& words, Damping damping) {
  using Limits = std::numeric_limits<int>;
  Digits d;
  read_control(words, "PBTNFS", first_word, d);
  words.end_record();
  read_control(words, "VLDCMZE", second_word, d);
  const int given = words.optional_integer("M2", number(damping), Limits::min(), Limits::max());
  d.damping = to_choice<Damping>(words, "M2", given);
  words.end_record();
  read_control(words, "XHGIAOWR", third_word, d);
  words.end_record();
  if (d.xflow == Trace::none) return d;
  words.control("PSFLCIN", 9); // versions differ in the number of digits
  words.end_record();
  return d;
}

} // namespace microslip::contact_program
