#include "explorer/core/request.hpp"

#include "io/nearest_word.hpp"
#include "io/option_words.hpp"
#include "microslip/error.hpp"

#include <algorithm>

namespace microslip::explorer {
namespace {

std::string field(const std::string& member) {
  return "request." + member;
}

[[noreturn]] void wrong_type(const std::string& member, const std::string& wanted) {
  throw Error(field(member) + ": must be " + wanted);
}

double number_of(const io::Json& value, const std::string& member) {
  if (!value.is_number()) wrong_type(member, "a number");
  return require_finite(field(member), value.get<double>(), "-");
}

std::string text_of(const io::Json& value, const std::string& member) {
  if (!value.is_string()) wrong_type(member, "a text");
  return value.get<std::string>();
}

} // namespace

Request::Request(std::string_view text) : members_(io::Json::parse(text, nullptr, false)) {
  if (!members_.is_object()) throw Error("request: must be a JSON object");
}

void Request::allow(const std::vector<std::string_view>& members) const {
  for (const auto& [name, value] : members_.items())
    if (name != "call" && std::find(members.begin(), members.end(), name) == members.end())
      throw Error(field(name) + ": unknown member" + io::suggestion(name, members));
}

const io::Json& Request::required(const std::string& member) const {
  const auto found = members_.find(member);
  if (found == members_.end()) throw Error(field(member) + ": is missing");
  return *found;
}

std::string Request::text(const std::string& member) const {
  return text_of(required(member), member);
}
std::string Request::text(const std::string& member, const std::string& missing) const {
  return has(member) ? text(member) : missing;
}

bool Request::flag(const std::string& member) const {
  if (!has(member)) return false;
  if (!required(member).is_boolean()) wrong_type(member, "true or false");
  return required(member).get<bool>();
}

double Request::number(const std::string& member) const {
  return number_of(required(member), member);
}

double Request::number(const std::string& member, const description::Input& input) const {
  const double value = number(member);
  input.bounds.require(field(member), value, input.unit);
  return value;
}

int Request::count(const std::string& member, const description::Bounds& bounds) const {
  const double value = number(member);
  bounds.require(field(member), value, "-");
  const int whole = static_cast<int>(value);
  if (whole != value) wrong_type(member, "a whole number");
  return whole;
}

std::optional<std::vector<double>> Request::numbers(const std::string& member, std::size_t count) const {
  if (!has(member)) return {};
  const io::Json& list = required(member);
  if (!list.is_array() || list.size() != count) wrong_type(member, "a list of " + std::to_string(count) + " numbers");
  std::vector<double> values;
  for (const io::Json& value : list) values.push_back(number_of(value, member));
  return values;
}

std::string_view Request::word(const std::string& member, std::span<const std::string_view> words) const {
  if (!has(member)) return words.front();
  const std::string given = text(member);
  io::require_word(field(member), given, words);
  return *std::find(words.begin(), words.end(), given);
}

std::vector<std::pair<std::string, std::string>> Request::texts(const std::string& member) const {
  std::vector<std::pair<std::string, std::string>> all;
  if (!has(member)) return all;
  if (!required(member).is_object()) wrong_type(member, "an object of texts");
  const std::string within = member + ".";
  for (const auto& [name, value] : required(member).items()) all.emplace_back(name, text_of(value, within + name));
  return all;
}

} // namespace microslip::explorer
