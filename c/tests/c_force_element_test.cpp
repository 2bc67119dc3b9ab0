#include "microslip.h"
#include "microslip/response/force_element.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace {

/// A real pole and a pair, of Fx by xi and Fn.
std::string fit_text() {
  microslip::ForceElementFit fit;
  fit.steady = {{1e-3, 0, 0.1}, 80e3};
  fit.forces = {-8e3, 100, -2};
  fit.poles = {{-50, 0}, {-200, 300}};
  fit.residues.resize(2);
  fit.residues[0][0] = -4e8, fit.residues[1][0] = {-1e9, 3e8};
  fit.residues[0][3] = -2;
  fit.constants[0] = -1e5;
  return text_of(fit);
}

struct Element {
  microslip_force_element* handle = nullptr;
  explicit Element(const std::string& text) {
    microslip_error error;
    EXPECT_EQ(microslip_force_element_create(text.c_str(), &handle, &error), MICROSLIP_OK) << error.text;
  }
  ~Element() { microslip_force_element_destroy(handle); }
  Element(const Element&) = delete;
  Element& operator=(const Element&) = delete;
};

TEST(CForceElement, IsTheLibrarys) {
  const Element element(fit_text());
  microslip::ForceElement own(microslip::force_element_from(fit_text()));
  double forces[3];
  for (int i = 1; i < 20; ++i) {
    const double input[4] = {1e-3 + 1e-5 * std::sin(i), 0, 0.1, 80e3 + 10 * i};
    ASSERT_EQ(microslip_force_element_step(element.handle, 1e-3, input, forces), MICROSLIP_OK);
    const auto expected = own.step(1e-3, {{input[0], input[1], input[2]}, input[3]});
    EXPECT_EQ(forces[0], expected.fx);
    EXPECT_EQ(forces[2], expected.mz);
  }
  ASSERT_EQ(microslip_force_element_reset(element.handle, nullptr), MICROSLIP_OK);
  const double steady[4] = {1e-3, 0, 0.1, 80e3};
  ASSERT_EQ(microslip_force_element_step(element.handle, 1, steady, forces), MICROSLIP_OK);
  EXPECT_DOUBLE_EQ(forces[0], -8e3);
  EXPECT_DOUBLE_EQ(forces[1], 100);
}

TEST(CForceElement, GoesBackToAState) {
  const Element element(fit_text());
  const double input[4] = {1.1e-3, 0, 0.1, 81e3}, other[4] = {0.9e-3, 0, 0.1, 80e3};
  double once[3], again[3];
  ASSERT_EQ(microslip_force_element_step(element.handle, 1e-3, input, once), MICROSLIP_OK);
  std::vector<double> state(microslip_force_element_state_size(element.handle));
  ASSERT_EQ(state.size(), 20u);
  ASSERT_EQ(microslip_force_element_get_state(element.handle, state.size(), state.data()), MICROSLIP_OK);
  ASSERT_EQ(microslip_force_element_step(element.handle, 1e-3, other, once), MICROSLIP_OK);
  ASSERT_EQ(microslip_force_element_set_state(element.handle, state.size(), state.data()), MICROSLIP_OK);
  ASSERT_EQ(microslip_force_element_step(element.handle, 1e-3, other, again), MICROSLIP_OK);
  EXPECT_EQ(once[0], again[0]);
}

TEST(CForceElement, RefusesWhatIsWrong) {
  microslip_force_element* none = nullptr;
  microslip_error error;
  EXPECT_EQ(microslip_force_element_create("no fit", &none, &error), MICROSLIP_INVALID_OPTION);
  EXPECT_NE(std::string(error.text).find("line 1"), std::string::npos) << error.text;
  EXPECT_EQ(microslip_force_element_create(nullptr, &none, &error), MICROSLIP_NULL_POINTER);
  const Element element(fit_text());
  const double input[4] = {1e-3, 0, 0.1, 80e3}, bad[4] = {NAN, 0, 0.1, 80e3};
  double forces[3], state[3] = {};
  EXPECT_EQ(microslip_force_element_step(element.handle, -1, input, forces), MICROSLIP_INVALID_INPUT);
  EXPECT_EQ(microslip_force_element_step(element.handle, 1, bad, forces), MICROSLIP_INVALID_INPUT);
  EXPECT_EQ(microslip_force_element_step(nullptr, 1, input, forces), MICROSLIP_NULL_POINTER);
  EXPECT_EQ(microslip_force_element_step(element.handle, 1, nullptr, forces), MICROSLIP_NULL_POINTER);
  EXPECT_EQ(microslip_force_element_reset(element.handle, bad), MICROSLIP_INVALID_INPUT);
  EXPECT_EQ(microslip_force_element_set_state(element.handle, 3, state), MICROSLIP_WRONG_SIZE);
  EXPECT_EQ(microslip_force_element_state_size(nullptr), 0u);
}

} // namespace
