#pragma once

#include <stdexcept>

namespace microslip::detail {

/// toml++ met an assertion of its own.
class TomlAssertion : public std::logic_error {
  using std::logic_error::logic_error;
};

[[noreturn]] inline void fail_toml_assertion(const char* condition) {
  throw TomlAssertion(condition);
}

} // namespace microslip::detail

// toml++ 3.3 asserts what some malformed texts do not fulfil, such as "[$]", and in release builds lets the compiler
// assume it. Here such a text throws.
#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(condition)                                                                                         \
  ((condition) ? static_cast<void>(0) : ::microslip::detail::fail_toml_assertion(#condition))
#define TOML_MAX_NESTED_VALUES 16
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")
