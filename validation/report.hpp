#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace microslip::validation {

/// A figure of a study as it is printed.
struct Figure {
  std::string section, name; ///< `section` is the heading above it
  std::string computed, expected;
  std::optional<bool> met; ///< none: it is shown but not judged
  std::string remark = {}; ///< why it is not, or the known limit that a figure that is not met keeps to
  bool is_known = false;   ///< not met, for a reason that the documentation gives, and within the limit stated there
  bool is_time = false;    ///< another one each time
};

/// A line for each figure of a study that a signature stands for: those that are judged and come out the same each
/// time.
std::string signed_lines(std::string_view study, const std::vector<Figure>& figures);

/// What a figure that misses its mark keeps to all the same, and the page of the documentation that says why it does.
struct KnownLimit {
  std::string bound;     ///< in words, as that of `bounded`
  std::string_view page; ///< in docs/, "limits.md"
};

/// Prints figures of a study, computed beside published or expected, and remembers whether all are as stated: met, or
/// within a known limit.
class Report {
public:
  /// Figures are also added to `figures`, unless that is nullptr.
  Report(std::ostream& out, std::vector<Figure>* figures) : out_(out), figures_(figures) {}

  void heading(std::string_view text);
  void line(std::string_view text);
  /// `name computed expected`, and `ok` or `NOT MET`.
  void figure(std::string_view name, std::string_view computed, std::string_view expected, bool met);
  /// A figure that is not met and keeps to a known limit: `name computed expected`, `NOT MET` and the limit.
  void known_limit(std::string_view name, std::string_view computed, std::string_view expected,
                   const KnownLimit& known);
  /// A value printed by `format` that must keep to a bound in words: "<= 1e-3", "at least 2".
  void bounded(std::string_view name, std::string_view format, double value, std::string_view bound);
  /// The same; a value that misses the bound may keep to a known limit.
  void bounded(std::string_view name, std::string_view format, double value, std::string_view bound,
               const KnownLimit& known);
  /// The same for a time, or a ratio of times.
  void bounded_time(std::string_view name, std::string_view format, double value, std::string_view bound,
                    const KnownLimit& known);
  /// A value printed by `format` that must differ from the one expected by no more than `tolerance`.
  void near(std::string_view name, std::string_view format, double value, std::string_view expected, double tolerance);
  /// The same where the one expected is printed by a format of its own.
  void near(std::string_view name, std::string_view format, double value, std::string_view expected_format,
            double expected, double tolerance);
  /// A number that must be the one expected.
  void count(std::string_view name, long long found, long long expected);
  /// A figure that is shown but not judged, and why.
  void remark(std::string_view name, std::string_view computed, std::string_view expected, std::string_view why);

  bool all_as_stated() const { return all_as_stated_; }

private:
  void keep(Figure figure);

  std::ostream& out_;
  std::vector<Figure>* figures_;
  std::string section_ = {};
  bool is_time_ = false; ///< of the next figure
  bool all_as_stated_ = true;
};

} // namespace microslip::validation
