#pragma once

#include <iosfwd>
#include <string_view>

namespace microslip::validation {

/// Prints figures of a study, computed beside published or expected, and remembers whether all are met.
class Report {
public:
  explicit Report(std::ostream& out) : out_(out) {}

  void heading(std::string_view text);
  void line(std::string_view text);
  /// `name computed expected`, and `ok` or `NOT MET`.
  void figure(std::string_view name, std::string_view computed, std::string_view expected, bool met);
  /// A figure that is shown but not judged, and why.
  void remark(std::string_view name, std::string_view computed, std::string_view expected, std::string_view why);

  bool all_met() const { return all_met_; }

private:
  std::ostream& out_;
  bool all_met_ = true;
};

} // namespace microslip::validation
