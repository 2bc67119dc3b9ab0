// Many calls need no more memory than few.

#include "compat/libcontact/tests/library_test.hpp"
#include "tests/support/sanitized.hpp"

#include <malloc.h>

#include <gtest/gtest.h>

namespace microslip::libcontact {
namespace {

/// [bytes] that are allocated and not freed.
long in_use() {
  const auto info = mallinfo2();
  return static_cast<long>(info.uordblks + info.hblkhd);
}

constexpr long little = 64L * 1024;

class Memory : public LibraryTest {
protected:
  void SetUp() override {
#ifdef MICROSLIP_SANITIZED
    GTEST_SKIP() << "sanitizers have an allocator of their own";
#endif
  }
};

TEST_F(Memory, OfAMillionCallsDoesNotGrow) {
  ASSERT_EQ(initialize(1, 1), 0);
  ASSERT_EQ(set_up_wheel(1, true), 0);
  ASSERT_EQ(set_wheel_state(1, 3), 0);
  ASSERT_EQ(calculate(1), 0);
  const auto call = [](int times) {
    int one = 1, icp = whole, count = 24, code = CNTC_ic_tang, value = 3;
    double values[24];
    for (int k = 0; k < times; ++k) {
      cntc_getglobalforces(&one, &icp, &count, values);
      cntc_setflags(&one, &icp, &one, &code, &value);
      set_wheel_state(1, 1e-3 * (k % 100));
      calculate(2); // refused: it has no profiles
    }
  };
  call(10);
  const long before = in_use();
  call(200000); // of five each
  EXPECT_LT(in_use() - before, little);
}

TEST_F(Memory, OfManyCalculationsDoesNotGrow) {
  ASSERT_EQ(initialize(1, 1), 0);
  ASSERT_EQ(set_up_wheel(1, true), 0);
  const auto calculate_some = [](int times) {
    for (int k = 0; k < times; ++k) {
      set_profile(1, profiles + "s1002.prw", 1); // once more, as when it wears
      set_wheel_state(1, k % 7);
      EXPECT_EQ(calculate(1), 0);
    }
  };
  calculate_some(14);
  const long before = in_use();
  calculate_some(70);
  EXPECT_LT(in_use() - before, 1024 * 1024) << "a transform of another size more or less";
}

TEST_F(Memory, OfElementsThatComeAndGoDoesNotGrow) {
  const auto live = [](int times) {
    for (int k = 0; k < times; ++k) {
      initialize(5, 3);
      set_up_sphere(5, 1);
      calculate(5, 1);
      finalize(5);
      initialize(4, 1); // so that the library's log stays open
    }
  };
  initialize(4, 1);
  live(10);
  const long before = in_use();
  live(200);
  EXPECT_LT(in_use() - before, little);
}

} // namespace
} // namespace microslip::libcontact
