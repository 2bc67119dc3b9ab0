#pragma once

#include "microslip/error.hpp"

#include <gtest/gtest.h>

#include <string>

namespace microslip {

/// The call must throw an Error whose text begins with the field and its value, and ends with unit and range.
template <class Call> void expect_error(Call call, const std::string& field, const std::string& unit_and_range) {
  try {
    call();
    ADD_FAILURE() << "no Error for " << field << " " << unit_and_range;
  } catch (const Error& error) {
    const std::string text = error.what();
    EXPECT_EQ(text.find(field + " = "), 0U) << text;
    EXPECT_NE(text.find(" " + unit_and_range), std::string::npos) << text << "\nexpected: " << unit_and_range;
  }
}

} // namespace microslip
