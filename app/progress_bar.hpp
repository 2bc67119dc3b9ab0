#pragma once

#include <chrono>
#include <string>

namespace microslip::app {

/// A bar with the time left on standard error, if that is a terminal; nothing otherwise. Erases itself at the end.
class ProgressBar {
public:
  /// `begun`: the fraction that was done before, which tells nothing of the time left.
  explicit ProgressBar(std::string label, double begun = 0);
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar();

  /// Shows the fraction done, 0 to 1; draws at most ten times a second. From one thread only.
  void update(double fraction);
  /// Clears the bar for a line of output; the next update draws the bar again.
  void clear();

private:
  using Clock = std::chrono::steady_clock;

  std::string label_;
  double begun_;
  bool visible_;
  Clock::time_point start_, drawn_;
};

} // namespace microslip::app
