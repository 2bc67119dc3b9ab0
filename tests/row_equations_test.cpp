#include "microslip/railway/rows/row_equations.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

namespace microslip {
namespace {

constexpr double unit = 1 / (std::numbers::pi * 110e9);

/// Two lobes with a valley between them, on a curved rail, and a small load at one end.
class Lobes : public testing::Test {
protected:
  Lobes() {
    const std::vector<double> shares = {0.02, 0.3, 0.9, 1, 0.6, 0.06, 0.15, 0.5, 0.45, 0.1};
    for (std::size_t k = 0; k < shares.size(); ++k) {
      const double y = 0.8e-3 * static_cast<double>(k), width = k % 2 == 0 ? 0.9e-3 : 0.7e-3;
      rows.push_back({{1e-5 * static_cast<double>(k), y, 0}, y, 0.02 * static_cast<double>(k), width, -5e-5, 1.1, 0.1});
      load.push_back(1.5e7 * shares[k]);
      log_kappa.push_back(std::log(2 * 1.5e7 / std::numbers::pi / 36e-6) + 0.1 * std::sin(3.0 * y * 1e3));
    }
    places.resize(rows.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    equations.set_rows(rows, places, unit);
  }

  /// Residuals of row j, of the gap over 0.1 mm.
  std::array<double, 2> residuals(std::size_t j, bool hold) {
    equations.find(load, log_kappa, places, false);
    if (hold) equations.hold_to_neighbours();
    return {equations.gap(j) / 1e-4, equations.turn(j)};
  }
  void expect_derivatives(bool hold, double tolerance) {
    constexpr double h = 1e-5;
    for (std::size_t j = 0; j < rows.size(); ++j)
      for (std::size_t k = 0; k < rows.size(); ++k) {
        residuals(j, hold);
        const double scale = load[k]; // a relative change of the load
        const std::array<double, 2> by_load = {equations.gap_by_load(j, k) * scale / 1e-4,
                                               equations.turn_by_load(j, k) * scale},
                                    by_kappa = {equations.gap_by_kappa(j, k) / 1e-4, equations.turn_by_kappa(j, k)};
        const auto difference = [&](double& number, double step) {
          const double here = number;
          number = here + step;
          const auto more = residuals(j, hold);
          number = here - step;
          const auto less = residuals(j, hold);
          number = here;
          return std::array{(more[0] - less[0]) / (2 * h), (more[1] - less[1]) / (2 * h)};
        };
        const auto by_load_found = difference(load[k], h * scale), by_kappa_found = difference(log_kappa[k], h);
        for (std::size_t i = 0; i < 2; ++i) {
          EXPECT_NEAR(by_load[i], by_load_found[i], tolerance) << j << ' ' << k << ' ' << i;
          EXPECT_NEAR(by_kappa[i], by_kappa_found[i], tolerance) << j << ' ' << k << ' ' << i;
        }
      }
  }

  std::vector<NormalRow> rows;
  std::vector<double> load, log_kappa;
  std::vector<std::size_t> places;
  RowEquations equations{16};
};

TEST_F(Lobes, HaveDerivatives) {
  expect_derivatives(false, 1e-6);
}

TEST_F(Lobes, HaveDerivativesWhereRowsAreHeldToTheirNeighbours) {
  expect_derivatives(true, 1e-6);
}

TEST_F(Lobes, AreTheSameToTheLastBitWithEveryInstructionSet) {
  equations.find(load, log_kappa, places, false);
  for (const InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
    if (!is_available(set)) continue;
    RowEquations others(16, set);
    others.set_rows(rows, places, unit);
    others.find(load, log_kappa, places, false);
    for (std::size_t j = 0; j < rows.size(); ++j) {
      EXPECT_EQ(others.gap(j), equations.gap(j));
      for (std::size_t k = 0; k < rows.size(); ++k)
        EXPECT_EQ(others.turn_by_kappa(j, k), equations.turn_by_kappa(j, k));
    }
  }
}

TEST_F(Lobes, OfWhichSomeRowsAreLeftOutAreThoseRows) {
  equations.find(load, log_kappa, places, false);
  RowEquations some(16);
  const std::vector<std::size_t> chosen = {1, 2, 3, 4};
  std::vector<double> only(load.size(), 0.0);
  for (const std::size_t k : chosen) only[k] = load[k];
  some.set_rows(rows, chosen, unit);
  some.find(only, log_kappa, chosen, false);
  equations.find(only, log_kappa, places, false);
  for (std::size_t j = 0; j < chosen.size(); ++j) {
    EXPECT_EQ(some.gap(j), equations.gap(chosen[j]));
    EXPECT_EQ(some.turn_by_load(j, 0), equations.turn_by_load(chosen[j], chosen[0]));
  }
}

} // namespace
} // namespace microslip
