#include "validation/report.hpp"

#include <utility>

#include <fmt/ostream.h>

namespace microslip::validation {

void Report::heading(std::string_view text) {
  fmt::print(out_, "\n{}\n", text);
  section_ = text;
}

void Report::line(std::string_view text) {
  fmt::print(out_, "  {}\n", text);
}

void Report::figure(std::string_view name, std::string_view computed, std::string_view expected, bool met) {
  fmt::print(out_, "  {:<52} {:>12}  {:<16} {}\n", name, computed, expected, met ? "ok" : "NOT MET");
  all_met_ = all_met_ && met;
  keep({section_, std::string(name), std::string(computed), std::string(expected), met});
}

void Report::remark(std::string_view name, std::string_view computed, std::string_view expected, std::string_view why) {
  fmt::print(out_, "  {:<52} {:>12}  {:<16} {}\n", name, computed, expected, why);
  keep({section_, std::string(name), std::string(computed), std::string(expected), std::nullopt, std::string(why)});
}

void Report::keep(Figure figure) {
  if (figures_ != nullptr) figures_->push_back(std::move(figure));
}

} // namespace microslip::validation
