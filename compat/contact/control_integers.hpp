#pragma once

#include "compat/contact/digits.hpp"

#include <array>
#include <limits>
#include <span>
#include <string>
#include <type_traits>

namespace microslip::contact_program {

/// Gives one digit its value in what holds the digits.
template <class Owner> using Put = void (*)(const Words& words, const char* control, int value, Owner& owner);

/// Range of the choice that `owner.*member` is.
template <class Owner, auto member> void put(const Words& words, const char* control, int value, Owner& owner) {
  using Choice = std::remove_reference_t<decltype(owner.*member)>;
  const std::string field = std::string("digit ") + values_of<Choice>.name + " of " + control;
  owner.*member = to_choice<Choice>(words, field, value);
}

/// A control integer: its name, and what its digits are from the left.
template <class Owner> struct ControlInteger {
  const char* name;
  std::span<const Put<Owner>> digits;
};

/// Digits of the third one, which are the same in modules 1 and 3.
template <class Owner>
inline constexpr Put<Owner> third_word[] = {
    put<Owner, &Digits::xflow>,  put<Owner, &Digits::heat>,   put<Owner, &Digits::gausei>, put<Owner, &Digits::iestim>,
    put<Owner, &Digits::matfil>, put<Owner, &Digits::output>, put<Owner, &Digits::flow>,   put<Owner, &Digits::solve>};

/// Reads the three control integers, with M2 behind the second one and the line that X asks for behind the third.
template <class Owner>
void read_control_integers(Words& words, const std::array<ControlInteger<Owner>, 3>& integers, Damping damping,
                           Owner& owner, Digits& digits) {
  using Limits = std::numeric_limits<int>;
  for (std::size_t k = 0; k < integers.size(); ++k) {
    const auto& [name, puts] = integers[k];
    const auto values = words.control(name, puts.size());
    for (std::size_t i = 0; i < puts.size(); ++i) puts[i](words, name, values[i], owner);
    if (k == 1) {
      const int given = words.optional_integer("M2", number(damping), Limits::min(), Limits::max());
      digits.damping = to_choice<Damping>(words, "M2", given);
    }
    words.end_record();
  }
  if (digits.xflow == Trace::none) return;
  words.control("PSFLCIN", 9); // versions differ in the number of digits
  words.end_record();
}

} // namespace microslip::contact_program
