#pragma once

#include "microslip.h"

#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {

/// A problem that is set and solved through C.
class CProblem {
public:
  microslip_problem* pointer = nullptr;
  microslip_error error = {};
  microslip_code code; ///< of its making

  explicit CProblem(int kind) : code(microslip_problem_create(kind, &pointer, &error)) {}
  explicit CProblem(const std::string& text) : code(microslip_problem_read(text.c_str(), "w.toml", &pointer, &error)) {
    EXPECT_EQ(code, MICROSLIP_OK) << error.text;
  }
  ~CProblem() { microslip_problem_destroy(pointer); }
  CProblem(const CProblem&) = delete;
  CProblem& operator=(const CProblem&) = delete;

  microslip_code set(const std::string& path, double value) {
    return microslip_set(pointer, path.c_str(), value, &error);
  }
  microslip_code set(const std::string& path, const std::string& value) {
    return microslip_set_text(pointer, path.c_str(), value.c_str(), &error);
  }
  microslip_code set(const std::string& path, const std::vector<double>& values) {
    return microslip_set_array(pointer, path.c_str(), values.size(), values.data(), &error);
  }
  microslip_code get(const std::string& path, double& value) {
    return microslip_get(pointer, path.c_str(), &value, &error);
  }
  microslip_code get(const std::string& path, std::string& value) {
    char* text = nullptr;
    const microslip_code got = microslip_get_text(pointer, path.c_str(), &text, &error);
    if (text != nullptr) value = text;
    microslip_free_text(text);
    return got;
  }
  microslip_code get(const std::string& path, std::vector<double>& values) {
    std::size_t count = 0;
    const microslip_code got = microslip_get_array(pointer, path.c_str(), 0, nullptr, &count, &error);
    if (got != MICROSLIP_OK) return got;
    values.resize(count);
    return microslip_get_array(pointer, path.c_str(), count, values.data(), &count, &error);
  }
  microslip_code unset(const std::string& path) { return microslip_unset(pointer, path.c_str(), &error); }
  microslip_code solve() { return microslip_solve(pointer, &error); }
  /// A number of the result, which must be there.
  double number(const std::string& name) {
    double value = 0;
    EXPECT_EQ(microslip_number(pointer, name.c_str(), &value, &error), MICROSLIP_OK) << error.text;
    return value;
  }
  std::vector<double> field(const std::string& name) {
    std::size_t columns = 0, rows = 0;
    EXPECT_EQ(microslip_field_size(pointer, name.c_str(), &columns, &rows, &error), MICROSLIP_OK) << error.text;
    std::vector<double> values(columns * rows);
    EXPECT_EQ(microslip_field(pointer, name.c_str(), values.size(), values.data(), &error), MICROSLIP_OK) << error.text;
    return values;
  }
  /// The case file that it is.
  std::string text() {
    char* text = nullptr;
    EXPECT_EQ(microslip_problem_text(pointer, &text, nullptr), MICROSLIP_OK);
    std::string copy = text != nullptr ? text : "";
    microslip_free_text(text);
    return copy;
  }
};

} // namespace microslip
