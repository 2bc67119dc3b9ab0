#include "validation/report.hpp"

#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ostream.h>

namespace microslip::validation {
namespace {

/// The number at the end of a text.
double number_in(std::string_view text) {
  return std::stod(std::string(text.substr(text.rfind(' ') + 1)));
}

bool keeps_to(std::string_view bound, double value) {
  const double limit = number_in(bound);
  if (bound.starts_with("<=") || bound.starts_with("at most")) return value <= limit;
  if (bound.starts_with(">=") || bound.starts_with("at least")) return value >= limit;
  return bound.starts_with("<") ? value < limit : value > limit;
}

} // namespace

std::string signed_lines(std::string_view study, const std::vector<Figure>& figures) {
  std::string lines;
  for (const Figure& figure : figures)
    if (figure.met && !figure.is_time)
      lines += fmt::format("{}\t{}\t{}\t{}\t{}\t{}\n", study, figure.section, figure.name, figure.computed,
                           figure.expected, *figure.met ? "met" : "not met");
  return lines;
}

void Report::heading(std::string_view text) {
  fmt::print(out_, "\n{}\n", text);
  section_ = text;
}

void Report::line(std::string_view text) {
  fmt::print(out_, "  {}\n", text);
}

void Report::figure(std::string_view name, std::string_view computed, std::string_view expected, bool met) {
  fmt::print(out_, "  {:<52} {:>12}  {:<16} {}\n", name, computed, expected, met ? "ok" : "NOT MET");
  all_as_stated_ = all_as_stated_ && met;
  keep({section_, std::string(name), std::string(computed), std::string(expected), met});
}

void Report::known_limit(std::string_view name, std::string_view computed, std::string_view expected,
                         const KnownLimit& known) {
  const std::string limit = fmt::format("known limit: {}, {}", known.bound, known.page);
  fmt::print(out_, "  {:<52} {:>12}  {:<16} NOT MET, {}\n", name, computed, expected, limit);
  keep({section_, std::string(name), std::string(computed), std::string(expected), false, limit, true});
}

void Report::bounded(std::string_view name, std::string_view format, double value, std::string_view bound) {
  figure(name, fmt::format(fmt::runtime(format), value), bound, keeps_to(bound, value));
}

void Report::bounded(std::string_view name, std::string_view format, double value, std::string_view bound,
                     const KnownLimit& known) {
  if (keeps_to(bound, value) || !keeps_to(known.bound, value)) return bounded(name, format, value, bound);
  known_limit(name, fmt::format(fmt::runtime(format), value), bound, known);
}

void Report::bounded_time(std::string_view name, std::string_view format, double value, std::string_view bound,
                          const KnownLimit& known) {
  is_time_ = true;
  bounded(name, format, value, bound, known);
  is_time_ = false;
}

void Report::near(std::string_view name, std::string_view format, double value, std::string_view expected,
                  double tolerance) {
  figure(name, fmt::format(fmt::runtime(format), value), expected, std::abs(value - number_in(expected)) <= tolerance);
}

void Report::near(std::string_view name, std::string_view format, double value, std::string_view expected_format,
                  double expected, double tolerance) {
  figure(name, fmt::format(fmt::runtime(format), value), fmt::format(fmt::runtime(expected_format), expected),
         std::abs(value - expected) <= tolerance);
}

void Report::count(std::string_view name, long long found, long long expected) {
  figure(name, std::to_string(found), std::to_string(expected), found == expected);
}

void Report::remark(std::string_view name, std::string_view computed, std::string_view expected, std::string_view why) {
  fmt::print(out_, "  {:<52} {:>12}  {:<16} {}\n", name, computed, expected, why);
  keep({section_, std::string(name), std::string(computed), std::string(expected), std::nullopt, std::string(why)});
}

void Report::keep(Figure figure) {
  figure.is_time = is_time_;
  if (figures_ != nullptr) figures_->push_back(std::move(figure));
}

} // namespace microslip::validation
