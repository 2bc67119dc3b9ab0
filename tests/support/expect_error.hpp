#pragma once

#include "microslip/error.hpp"

#include <gtest/gtest.h>

#include <string>

namespace microslip {

/// The text of the Error that the call throws, or "no error".
template <class Call> std::string error_of(Call call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

/// The call must throw an Error with these words.
template <class Call> void expect_words(Call call, const std::string& words) {
  const std::string text = error_of(call);
  EXPECT_NE(text.find(words), std::string::npos) << text << "\nexpected: " << words;
}

/// The call must throw an Error whose text begins with the field and its value, and ends with unit and range.
template <class Call> void expect_error(Call call, const std::string& field, const std::string& unit_and_range) {
  SCOPED_TRACE(field + " " + unit_and_range);
  const std::string text = error_of(call);
  EXPECT_EQ(text.find(field + " = "), 0U) << text;
  EXPECT_NE(text.find(" " + unit_and_range), std::string::npos) << text << "\nexpected: " << unit_and_range;
}

} // namespace microslip
