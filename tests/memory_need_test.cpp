#include "microslip/exact/halfspace/memory_need.hpp"
#include "microslip/numerics/toeplitz.hpp"

#include "microslip/error.hpp"
#include "microslip/exact/classical/tangential_problem.hpp"
#include "microslip/exact/normal/normal_contact.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/steel.hpp"

#include <gtest/gtest.h>

#include <string>

namespace microslip {
namespace {

constexpr ContactProblem problems[] = {ContactProblem::normal, ContactProblem::tangential};

ElementGrid grid_of(int mx, int my) {
  return {.mx = mx, .my = my, .x0 = 0, .y0 = 0, .dx = 1e-3, .dy = 1e-3, .line = false};
}

TEST(MemoryNeed, IsProportionalToTheElements) {
  for (const int n : {100, 1000, 10000, 1000000}) {
    const double elements = double(n) * n;
    EXPECT_NEAR(memory_need(ContactProblem::normal, grid_of(n, n)) / elements, 192, 12);
    EXPECT_NEAR(memory_need(ContactProblem::tangential, grid_of(n, n)) / elements, 5900, 100);
  }
}

/// In complex numbers of a padded transform, entries of a table of offsets and elements.
TEST(MemoryNeed, Formulas) {
  const double n = 41 * 41, padded = static_cast<double>(ToeplitzTransform::padded_size(41, 41)), table = 81 * 81;
  EXPECT_GE(padded, 41 * 81);
  EXPECT_LE(padded, 2 * 41 * 81);
  EXPECT_EQ(memory_need(ContactProblem::normal, grid_of(41, 41)), 48 * padded + 8 * table + 64 * n);
  EXPECT_EQ(memory_need(ContactProblem::tangential, grid_of(41, 41)), 288 * padded + 32 * table + (400 + 4816) * n);
}

TEST(MemoryNeed, LargestGridFitsAndTheNextDoesNot) {
  for (const ContactProblem problem : problems)
    for (const double memory : {1e6, 1e9, 3e10})
      for (const ElementGrid& grid : {grid_of(1000000, 1000000), grid_of(3000000, 100000), grid_of(1, 100000000)}) {
        const ElementGrid fits = largest_grid(problem, grid, memory);
        EXPECT_LE(memory_need(problem, fits), memory);
        ElementGrid more = fits;
        more.mx += 1 + more.mx / 10; // transforms have sizes that are fast, so that the need grows in steps
        more.my += 1 + more.my / 10;
        EXPECT_GT(memory_need(problem, more), memory);
        if (fits.mx > 1) {
          EXPECT_NEAR(double(fits.mx) / fits.my, double(grid.mx) / grid.my, 1.1 / fits.my * grid.mx / grid.my);
        }
      }
  EXPECT_EQ(largest_grid(ContactProblem::normal, grid_of(30, 20), 1e9).mx, 30);
  EXPECT_EQ(largest_grid(ContactProblem::normal, grid_of(300, 200), 1).count(), 1U);
}

/// 1e12 elements: refused at once, with the need, what there is and the largest grid that fits.
TEST(MemoryNeed, GridsBeyondTheMachineAreRefused) {
  const ElementGrid huge = grid_of(1000000, 1000000);
  const auto refused = [](auto call, const std::string& need) {
    const std::string text = error_of(call);
    EXPECT_EQ(text.find("grid: the "), 0U) << text;
    EXPECT_NE(text.find("1000000 x 1000000 elements needs " + need), std::string::npos) << text;
    EXPECT_NE(text.find("this machine has "), std::string::npos) << text;
    EXPECT_NE(text.find("; the largest grid of this shape that fits has "), std::string::npos) << text;
  };
  refused([&] { require_memory(ContactProblem::normal, huge); }, "1.79e+05 GiB");
  refused([&] { NormalProblem(steel, huge); }, "1.79e+05 GiB");
  refused([&] { TangentialProblem(steel, huge); }, "5.");
  refused(
      [&] {
        solve_normal_contact(steel, [](double, double) { return 0.0; }, huge, {NormalLoad::Given::force, 1});
      },
      "1.79e+05 GiB");
}

TEST(MemoryNeed, SmallGridsPass) {
  EXPECT_GT(physical_memory(), 0x1p28);
  const ElementGrid grid = grid_of(100, 100);
  for (const ContactProblem problem : problems) EXPECT_EQ(&require_memory(problem, grid), &grid);
  EXPECT_THROW(require_memory(ContactProblem::normal, ElementGrid{}), Error);
}

} // namespace
} // namespace microslip
