#include "compat/contact/wheel_rail/digits.hpp"

#include "compat/contact/control_integers.hpp"

namespace microslip::contact_program {
namespace {

/// All digits of module 1: those that module 3 shares, and the others.
struct AllDigits : Digits, WheelRailDigits {
  using WheelRailDigits::discns;
  using WheelRailDigits::force;
  using WheelRailDigits::varfrc;
};

constexpr Put<AllDigits> first_word[] = {put<AllDigits, &WheelRailDigits::config>,
                                         put<AllDigits, &Digits::pvtime>,
                                         put<AllDigits, &Digits::bound>,
                                         put<AllDigits, &Digits::tang>,
                                         put<AllDigits, &Digits::norm>,
                                         put<AllDigits, &WheelRailDigits::force>,
                                         put<AllDigits, &Digits::stress>};
constexpr Put<AllDigits> second_word[] = {
    put<AllDigits, &WheelRailDigits::varfrc>, put<AllDigits, &Digits::frclaw>, put<AllDigits, &WheelRailDigits::discns>,
    put<AllDigits, &Digits::inflcf>,          put<AllDigits, &Digits::mater>,  put<AllDigits, &WheelRailDigits::ztrack>,
    put<AllDigits, &WheelRailDigits::ewheel>};

} // namespace

WheelRailDigits read_digits(Words& words, Damping damping, Digits& digits) {
  AllDigits all;
  read_control_integers<AllDigits>(
      words, {{{"CPBTNFS", first_word}, {"VLDCMZE", second_word}, {"XHGIAOWR", third_word<AllDigits>}}}, damping, all,
      all);
  digits = all;
  return all;
}

} // namespace microslip::contact_program
