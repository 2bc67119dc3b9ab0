#include "app/progress_bar.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

namespace microslip::app {
namespace {

constexpr int width = 40;

std::string duration(double seconds) {
  const auto whole = std::lround(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

} // namespace

ProgressBar::ProgressBar(std::string label, double begun)
    : label_(std::move(label)), begun_(begun), visible_(::isatty(STDERR_FILENO) == 1), start_(Clock::now()),
      drawn_(start_) {}

ProgressBar::~ProgressBar() {
  clear();
}

void ProgressBar::clear() {
  if (visible_) std::fputs("\r\033[K", stderr);
}

void ProgressBar::update(double fraction) {
  const auto now = Clock::now();
  if (!visible_ || now - drawn_ < std::chrono::milliseconds(100)) return;
  drawn_ = now;
  fraction = std::clamp(fraction, 0.0, 1.0);
  const auto full = static_cast<int>(fraction * width);
  const std::chrono::duration<double> elapsed = now - start_;
  const double done = fraction - begun_;
  const auto left = done > 0 ? duration(elapsed.count() * (1 - fraction) / done) + " left" : "";
  fmt::print(stderr, "\r{} [{:#<{}}{:-<{}}] {:3.0f} % {}\033[K", label_, "", full, "", width - full, 100 * fraction,
             left);
  std::fflush(stderr);
}

} // namespace microslip::app
