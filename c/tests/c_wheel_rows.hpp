#pragma once

#include "microslip.h"

#include "tests/support/case_text.hpp"

#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {

/// A case that is solved through C.
struct CWheelRailCase {
  microslip_wheel_rail* pointer = nullptr;
  microslip_error error = {};
  microslip_code code;

  explicit CWheelRailCase(const std::string& text = wheel_rail_text) {
    microslip_problem* problem = nullptr;
    code = microslip_problem_read(text.c_str(), "w.toml", &problem, &error);
    if (code == MICROSLIP_OK) code = microslip_wheel_rail_create(problem, &pointer, &error);
    microslip_problem_destroy(problem);
  }
  ~CWheelRailCase() { microslip_wheel_rail_destroy(pointer); }
  CWheelRailCase(const CWheelRailCase&) = delete;
  CWheelRailCase& operator=(const CWheelRailCase&) = delete;
};

/// Rows of an array in the order of a microslip_list, whose numbers have names.
class Rows {
public:
  Rows(int list, std::size_t count, double value = 0)
      : list_(list), width_(microslip_count(list)), values_(count * width_, value) {}
  std::size_t width() const { return width_; }
  std::size_t count() const { return values_.size() / width_; }
  double* data() { return values_.data(); }
  double* row(std::size_t k) { return values_.data() + k * width_; }
  double& at(std::size_t k, const char* name) {
    microslip_error error = {};
    const int index = microslip_index(list_, name, &error);
    EXPECT_GE(index, 0) << error.text;
    return row(k)[index < 0 ? 0 : index];
  }

private:
  int list_;
  std::size_t width_;
  std::vector<double> values_;
};

/// Rows of a case's first state.
inline Rows first_states(const microslip_wheel_rail* wheel_rail, std::size_t count = 1) {
  Rows states(MICROSLIP_WHEEL_STATE, count);
  for (std::size_t k = 0; k < count; ++k)
    EXPECT_EQ(microslip_wheel_rail_state(wheel_rail, states.width(), states.row(k)), MICROSLIP_OK);
  return states;
}

/// Results of solved states.
struct SolvedRows {
  explicit SolvedRows(std::size_t count, double unwritten = 0)
      : results(MICROSLIP_WHEEL_RESULT, count, unwritten), status(count, -1),
        jacobians(count * microslip_count(MICROSLIP_WHEEL_DERIVATIVE) * microslip_count(MICROSLIP_WHEEL_STATE),
                  unwritten) {}
  microslip_code solve(microslip_wheel_rail* wheel_rail, Rows& states) {
    return microslip_wheel_rail_solve(wheel_rail, states.count(), states.width(), states.data(), results.width(),
                                      results.data(), status.data());
  }
  microslip_code go_on(microslip_wheel_rail* wheel_rail, Rows& states) {
    return microslip_wheel_rail_continue(wheel_rail, states.count(), states.width(), states.data(), results.width(),
                                         results.data(), status.data());
  }
  microslip_code differentiate(microslip_wheel_rail* wheel_rail, Rows& states) {
    return microslip_wheel_rail_differentiate(
        wheel_rail, states.count(), states.width(), states.data(), results.width(), results.data(), status.data(),
        microslip_count(MICROSLIP_WHEEL_DERIVATIVE), states.width(), jacobians.data());
  }
  double derivative(std::size_t k, const char* of, const char* by) const {
    const int row = microslip_index(MICROSLIP_WHEEL_DERIVATIVE, of, nullptr);
    const int column = microslip_index(MICROSLIP_WHEEL_STATE, by, nullptr);
    EXPECT_TRUE(row >= 0 && column >= 0) << of << ", " << by;
    const std::size_t rows = microslip_count(MICROSLIP_WHEEL_DERIVATIVE);
    return jacobians[(k * rows + static_cast<std::size_t>(row)) * microslip_count(MICROSLIP_WHEEL_STATE) +
                     static_cast<std::size_t>(column)];
  }

  Rows results;
  std::vector<int> status;
  std::vector<double> jacobians;
};

/// The patches of the state last solved.
inline Rows patches_of(const microslip_wheel_rail* wheel_rail) {
  std::size_t count = 0;
  EXPECT_EQ(microslip_wheel_rail_patches(wheel_rail, 0, 0, nullptr, &count, nullptr), MICROSLIP_OK);
  Rows patches(MICROSLIP_WHEEL_PATCH, count);
  EXPECT_EQ(microslip_wheel_rail_patches(wheel_rail, patches.width(), count, patches.data(), &count, nullptr),
            MICROSLIP_OK);
  return patches;
}

} // namespace microslip
