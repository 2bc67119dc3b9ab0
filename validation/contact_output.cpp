#include "validation/contact_output.hpp"

#include <cmath>
#include <cstdlib>
#include <optional>
#include <set>
#include <sstream>

namespace microslip::validation {
namespace {

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream text(line);
  std::vector<std::string> words;
  for (std::string word; text >> word;) {
    const bool goes_on = !words.empty() && (words.back() == "CREEP" || words.back() == "SHIFT");
    goes_on ? (words.back() += ' ' + word) : words.emplace_back(word);
  }
  return words;
}

/// The words with one space in between.
std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// Returns true for "Case 3" and "Case 3, result element 2", which begin a case.
bool begins_case(const std::vector<std::string>& words) {
  if (words.size() < 2 || words[0] != "Case") return false;
  if (words.size() == 2) return printed_number(words[1]).has_value();
  return words.size() == 5 && words[2] == "result" && words[3] == "element";
}

/// Names of quantities that a line consists of; nothing for any other line.
std::vector<std::string> names_in(const std::string& line) {
  static const std::set<std::string> known = {
      "S_WS",   "Y_WS",        "Z_WS",        "ROLL_WS",   "YAW_WS",  "PITCH_WS",   "VX_WS",      "VY_WS",
      "VZ_WS",  "VROLL_WS",    "VYAW_WS",     "VPITCH_WS", "FX(TR)",  "FY(TR)",     "FZ(TR)",     "FX(WS)",
      "FY(WS)", "FZ(WS)",      "XCP(TR)",     "YCP(TR)",   "ZCP(TR)", "DELTCP(TR)", "YCP(R)",     "ZCP(R)",
      "XCP(W)", "YCP(W)",      "ZCP(W)",      "CHI",       "DQ",      "VELOC",      "CKSI",       "CETA",
      "CPHI",   "FN",          "FX",          "FS",        "MN",      "ELAST.EN.",  "FRIC.POWER", "FRIC.WORK",
      "FN/G",   "FX/FSTAT/FN", "FS/FSTAT/FN", "APPROACH",  "PMAX",    "MAX(T1,T2)", "NPOT",       "NCON",
      "NADH",   "NSLIP",       "NPLAST",      "INORM",     "ITANG",   "SPINXO",     "SPINYO",     "BAR_FN",
      "BAR_FX", "BAR_FS",      "TILDE_FN",    "FX/FN",     "FS/FN",   "FY",         "MZ",         "FY/FSTAT/FN",
      "FY/FN",  "CREEP X",     "CREEP Y",     "CREEP S",   "SHIFT X", "SHIFT Y",    "SHIFT S"};
  auto words = words_of(line);
  for (const auto& word : words)
    if (!known.contains(word)) return {};
  return words;
}

void add_numbers(PrintedNumbers& numbers, const std::vector<std::string>& names, const std::string& line) {
  const auto words = words_of(line);
  if (words.size() != names.size()) return;
  for (std::size_t k = 0; k < names.size(); ++k)
    if (const auto number = printed_number(words[k])) numbers[names[k]] = *number;
}

} // namespace

std::optional<PrintedNumber> printed_number(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (end == text.c_str() || *end != 0) return {};
  const auto exponent = text.find_first_of("Ee");
  const auto mantissa = text.substr(0, exponent);
  const auto point = mantissa.find('.');
  const int decimals = point == std::string::npos ? 0 : static_cast<int>(mantissa.size() - point - 1);
  const int power = exponent == std::string::npos ? 0 : std::atoi(text.c_str() + exponent + 1);
  return PrintedNumber{value, 0.5 * std::pow(10.0, power - decimals)};
}

std::vector<PrintedCase> read_contact_output(std::istream& in) {
  std::vector<PrintedCase> cases;
  std::vector<std::string> names;
  for (std::string line; std::getline(in, line);) {
    const auto words = words_of(line);
    if (begins_case(words)) {
      cases.push_back({.label = joined(words), .number = std::atoi(words[1].c_str())});
    } else if (!cases.empty() && line.find("DATA FOR CONTACT PATCH") != std::string::npos) {
      cases.back().patches.emplace_back();
    } else if (!cases.empty() && !names.empty()) {
      PrintedCase& now = cases.back();
      add_numbers(now.patches.empty() ? now.totals : now.patches.back(), names, line);
    }
    names = names_in(line);
  }
  return cases;
}

} // namespace microslip::validation
