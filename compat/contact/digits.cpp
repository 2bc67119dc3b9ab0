#include "compat/contact/digits.hpp"
#include "compat/contact/control_integers.hpp"

namespace microslip::contact_program {
namespace {

constexpr Put<Digits> first_word[] = {put<Digits, &Digits::pvtime>, put<Digits, &Digits::bound>,
                                      put<Digits, &Digits::tang>,   put<Digits, &Digits::norm>,
                                      put<Digits, &Digits::force>,  put<Digits, &Digits::stress>};
constexpr Put<Digits> second_word[] = {put<Digits, &Digits::varfrc>, put<Digits, &Digits::frclaw>,
                                       put<Digits, &Digits::discns>, put<Digits, &Digits::inflcf>,
                                       put<Digits, &Digits::mater>,  put<Digits, &Digits::rznorm>,
                                       put<Digits, &Digits::exrhs>};

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
  Digits d;
  read_control_integers<Digits>(
      words, {{{"PBTNFS", first_word}, {"VLDCMZE", second_word}, {"XHGIAOWR", third_word<Digits>}}}, damping, d, d);
  return d;
}

} // namespace microslip::contact_program
