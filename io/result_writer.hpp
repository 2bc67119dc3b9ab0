#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace microslip::io {

/// The format of result files and of the JSON documents with the same names: root attribute `format`. Raised when
/// names, shapes or meanings change so that readers of the one before would be wrong; not by what is added.
inline constexpr int result_format = 2;

/// Origin of a result: root attributes of every result file, beside `format`, those the build knows itself
/// (`version`, `commit`, `compiler`, `build_type`) and `created` (ISO 8601, UTC).
struct Provenance {
  std::string kind = {}; ///< what the file holds, e.g. "rolling_contact" or a study's name
  std::string title = {};
  std::string command_line = {};
  std::string case_file = {}; ///< path of the case file; empty if there is none
  std::string case_text = {}; ///< its text, verbatim
};

/// Attributes, those the build knows and the present time.
std::vector<std::pair<std::string, std::string>> provenance_attributes(const Provenance& provenance);

/// Destination of a result: numbers, texts and arrays by paths such as "creep_curve/fx", where each stroke opens a
/// group.
class ResultWriter {
public:
  ResultWriter() = default;
  ResultWriter(const ResultWriter&) = delete;
  ResultWriter& operator=(const ResultWriter&) = delete;
  virtual ~ResultWriter() = default;

  virtual void scalar(const std::string& path, double value, const std::string& unit,
                      const std::string& description) = 0;
  virtual void text(const std::string& path, const std::string& value, const std::string& description) = 0;

  /// Arrays, the last index fastest; `shape` empty means one dimension. Error if it does not fit the values.
  using Values = std::variant<std::span<const double>, std::span<const int>, std::span<const std::uint8_t>>;
  using Shape = std::vector<std::size_t>;
  virtual void array(const std::string& path, const Values& values, const std::string& unit,
                     const std::string& description, const Shape& shape = {}) = 0;

  /// A text attribute of a group or dataset that is there; "/" is the root.
  virtual void attribute(const std::string& path, const std::string& name, const std::string& value) = 0;
};

} // namespace microslip::io
