#pragma once

#include "app/interrupt.hpp"
#include "app/progress_bar.hpp"
#include "cases/rolling_contact_result.hpp"
#include "cases/wheel_rail_result.hpp"

#include <string>

namespace microslip::app {

/// Calls `use` with the case that a text is: a RollingCase, a WheelRailCase or a WheelsetCase. `name` is the file's.
/// Throws Error as the readers of cases.
template <class Use> auto with_case(const std::string& text, const std::string& name, const Use& use) {
  if (io::is_wheelset_case(text, name)) return use(io::parse_wheelset_case(text, name));
  if (io::is_wheel_rail_case(text, name)) return use(io::parse_wheel_rail_case(text, name));
  return use(io::parse_case(text, name));
}

/// Solves it with a progress bar of this name. Throws Interrupted.
template <class Input> auto solve_with_progress(const Input& input, const std::string& name) {
  ProgressBar bar(name);
  auto result = cases::solve_case(input, [&](double fraction) {
    bar.update(fraction);
    InterruptGuard::throw_if_interrupted();
    return true;
  });
  InterruptGuard::throw_if_interrupted();
  return result;
}

} // namespace microslip::app
