#pragma once

#include "io/json.hpp"
#include "microslip/description/input.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace microslip::explorer {

/// What is asked of the explorer: a JSON object whose members are read and checked one by one. What is wrong throws an
/// Error that names the member, its value and what it may be: `request.extent = "al": must be full or solution`.
class Request {
public:
  /// Error for what is no JSON object.
  explicit Request(std::string_view text);

  /// Error for a member but these and `call`.
  void allow(const std::vector<std::string_view>& members) const;
  bool has(const std::string& member) const { return members_.contains(member); }

  /// Error without it.
  std::string text(const std::string& member) const;
  std::string text(const std::string& member, const std::string& missing) const;
  bool flag(const std::string& member) const; ///< false without it
  double number(const std::string& member) const;
  /// Within the bounds of an input of case files.
  double number(const std::string& member, const description::Input& input) const;
  int count(const std::string& member, const description::Bounds& bounds) const;
  /// A list of so many numbers; none without it.
  std::optional<std::vector<double>> numbers(const std::string& member, std::size_t count) const;
  /// One of some words; the first one without it.
  std::string_view word(const std::string& member, std::span<const std::string_view> words) const;
  /// Texts by their names, of an object.
  std::vector<std::pair<std::string, std::string>> texts(const std::string& member) const;

private:
  const io::Json& required(const std::string& member) const;

  io::Json members_;
};

} // namespace microslip::explorer
