#include "validation/report.hpp"

#include <fmt/ostream.h>

namespace microslip::validation {

void Report::heading(std::string_view text) {
  fmt::print(out_, "\n{}\n", text);
}

void Report::line(std::string_view text) {
  fmt::print(out_, "  {}\n", text);
}

void Report::figure(std::string_view name, std::string_view computed, std::string_view expected, bool met) {
  fmt::print(out_, "  {:<52} {:>12}  {:<16} {}\n", name, computed, expected, met ? "ok" : "NOT MET");
  all_met_ = all_met_ && met;
}

void Report::remark(std::string_view name, std::string_view computed, std::string_view expected, std::string_view why) {
  fmt::print(out_, "  {:<52} {:>12}  {:<16} {}\n", name, computed, expected, why);
}

} // namespace microslip::validation
