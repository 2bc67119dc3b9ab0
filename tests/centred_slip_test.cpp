#include "microslip/exact/fitted/centred_slip.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using Field = std::vector<double>;

const FittedContact& contact() {
  static const FittedContact fitted = fit_ellipse(9e-3, 6e-3, 14, 11);
  return fitted;
}

std::vector<char> all(char value) {
  return std::vector<char>(contact().elements.size(), value);
}

/// Mean of x^n over an element's path.
double mean_of_power(const FittedElement& e, int n) {
  return (std::pow(e.end, n + 1) - std::pow(e.centre(), n + 1)) / ((n + 1) * (e.end - e.centre()));
}

TEST(CentredSlip, ParabolasAreMovedExactly) {
  const auto& elements = contact().elements;
  CentredSlip<double> slip(contact(), all(1));
  std::size_t seen = 0;
  for (int power = 0; power <= 2; ++power) {
    Field s;
    for (const FittedElement& e : elements) s.push_back(mean_of_power(e, power));
    slip.move(s);
    for (std::size_t k = 0; k < s.size(); ++k)
      if (!elements[k].trails && !elements[k].leads) {
        EXPECT_NEAR(s[k], std::pow(elements[k].centre(), power), 1e-14 * std::pow(9e-3, power)) << power << ' ' << k;
        ++seen;
      }
  }
  EXPECT_GT(seen, elements.size());
}

TEST(CentredSlip, TrailingElementsAreExtrapolatedLeadingOnesKeepTheirs) {
  const auto& elements = contact().elements;
  CentredSlip<double> slip(contact(), all(1));
  Field s;
  for (const FittedElement& e : elements) s.push_back(mean_of_power(e, 1));
  const Field before = s;
  slip.move(s);
  for (std::size_t k = 0; k < s.size(); ++k) {
    if (elements[k].leads) {
      EXPECT_EQ(s[k], before[k]);
    } else if (elements[k].trails) {
      EXPECT_NEAR(s[k], elements[k].centre(), 1e-16);
    }
  }
}

TEST(CentredSlip, OthersKeepTheirs) {
  CentredSlip<double> none(contact(), all(0));
  Field s(contact().elements.size());
  for (std::size_t k = 0; k < s.size(); ++k) s[k] = std::sin(double(k));
  const Field before = s;
  none.move(s);
  EXPECT_EQ(s, before);
  none.nearly_undo(s);
  EXPECT_EQ(s, before);
  auto some = all(0);
  some[40] = 1;
  CentredSlip<double>(contact(), some).move(s);
  for (std::size_t k = 0; k < s.size(); ++k) EXPECT_EQ(s[k] == before[k], k != 40) << k;
}

/// Rows do not see each other.
TEST(CentredSlip, StaysWithinARow) {
  const auto& elements = contact().elements;
  CentredSlip<double> slip(contact(), all(1));
  for (int row = 0; row < contact().grid.my; ++row) {
    Field s(elements.size(), 0.0);
    for (std::size_t k = 0; k < s.size(); ++k) s[k] = elements[k].row == row;
    slip.move(s);
    for (std::size_t k = 0; k < s.size(); ++k) EXPECT_NEAR(s[k], elements[k].row == row, 1e-15) << row << ' ' << k;
  }
}

/// Slip that changes its sign from path to path, the roughest there is, keeps two thirds of its size.
TEST(CentredSlip, LeavesNothingOut) {
  const auto& elements = contact().elements;
  Field s(elements.size());
  for (std::size_t k = 0; k < s.size(); ++k) s[k] = k % 2 == 0 ? 1 : -1;
  const Field before = s;
  CentredSlip<double>(contact(), all(1)).move(s);
  std::size_t seen = 0;
  for (std::size_t k = 0; k < s.size(); ++k) {
    if (elements[k].trails || elements[k].leads || elements[k + 1].leads || elements[k + 2].leads) continue;
    EXPECT_NEAR(s[k], before[k] * 2 / 3, 1e-12);
    ++seen;
  }
  EXPECT_GT(seen, s.size() / 2);
}

/// (2 - T) T = 1 - (1 - T)^2.
TEST(CentredSlip, NearlyUndone) {
  CentredSlip<double> slip(contact(), all(1));
  Field s(contact().elements.size());
  for (std::size_t k = 0; k < s.size(); ++k) s[k] = std::cos(0.3 * double(k * k));
  const auto missing = [&](Field v) { // (1 - T) v
    Field moved = v;
    slip.move(moved);
    for (std::size_t k = 0; k < v.size(); ++k) v[k] -= moved[k];
    return v;
  };
  const Field square = missing(missing(s));
  Field undone = s;
  slip.move(undone);
  slip.nearly_undo(undone);
  for (std::size_t k = 0; k < s.size(); ++k) EXPECT_NEAR(undone[k], s[k] - square[k], 1e-14);
}

TEST(CentredSlip, InSinglePrecision) {
  auto sliding = all(0);
  for (std::size_t k = 0; k < sliding.size(); ++k) sliding[k] = k % 3 != 0;
  Field s(sliding.size());
  std::vector<float> single(s.size());
  for (std::size_t k = 0; k < s.size(); ++k) s[k] = single[k] = static_cast<float>(std::sin(double(k)));
  CentredSlip<double>(contact(), sliding).move(s);
  CentredSlip<float>(contact(), sliding).move(single);
  for (std::size_t k = 0; k < s.size(); ++k) EXPECT_NEAR(single[k], s[k], 5e-7);
}

} // namespace
} // namespace microslip
