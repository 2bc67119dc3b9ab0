// Result elements on separate threads have the bits that they have alone; two threads on one element get a code.

#include "compat/libcontact/tests/library_test.hpp"

#include <atomic>
#include <thread>

#include <gtest/gtest.h>

namespace microslip::libcontact {
namespace {

using Threads = LibraryTest;

/// What a wheel has over some states: forces and all pressures, one behind the other. Empty if something fails.
Values history(int ire, bool is_right) {
  Values all;
  if (initialize(ire, 1) != 0 || set_up_wheel(ire, is_right) != 0) return {};
  for (const double y : {0.0, 1.5, 3.0, 6.0}) {
    if (set_wheel_state(ire, y) != 0 || calculate(ire) != 0) return {};
    const Values forces = list(cntc_getglobalforces, ire, whole, 24),
                 pressures = field(ire, 1, CNTC_fld_pn, elements(ire, 1));
    all.insert(all.end(), forces.begin(), forces.end());
    all.insert(all.end(), pressures.begin(), pressures.end());
  }
  return all;
}

TEST_F(Threads, HaveTheSameBits) {
  const Values wanted[] = {history(1, false), history(2, true)};
  ASSERT_FALSE(wanted[0].empty());
  ASSERT_NE(wanted[0], wanted[1]);
  constexpr std::size_t count = 8;
  std::vector<Values> found(count);
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < count; ++k)
    threads.emplace_back([&found, k] { found[k] = history(10 + static_cast<int>(k), k % 2 == 1); });
  for (auto& thread : threads) thread.join();
  for (std::size_t k = 0; k < count; ++k) EXPECT_EQ(found[k], wanted[k % 2]) << k;
}

/// Problems of one element of module 3 count as well.
TEST_F(Threads, MayWorkOnProblemsOfOneElement) {
  ASSERT_EQ(initialize(3, 3), 0);
  std::vector<int> codes(9);
  std::vector<std::thread> threads;
  for (int icp = 1; icp <= 9; ++icp)
    threads.emplace_back([&codes, icp] {
      int& code = codes[static_cast<std::size_t>(icp) - 1];
      code = set_up_sphere(3, icp);
      for (int k = 0; k < 5 && code == 0; ++k) code = calculate(3, icp);
    });
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(codes, std::vector<int>(9, 0));
}

/// While one works the other one gets a code; both get on afterwards.
TEST_F(Threads, OnOneElementGetACode) {
  ASSERT_EQ(initialize(1, 1), 0);
  ASSERT_EQ(set_up_wheel(1, true), 0);
  ASSERT_EQ(set_wheel_state(1, 3), 0);
  std::atomic<int> done{0}, refused{0}, other{0};
  const auto work = [&] {
    for (int k = 0; k < 30; ++k) {
      for (const int code :
           {set_wheel_state(1, 3), calculate(1), list(cntc_getglobalforces, 1, whole, 24).empty() ? -99 : 0})
        ++(code == 0 ? done : code == CNTC_err_other ? refused : other);
    }
  };
  std::thread first(work), second(work);
  first.join();
  second.join();
  EXPECT_EQ(done + refused, 180);
  EXPECT_EQ(other, 0);
  EXPECT_GE(done, 30) << "somebody always gets on";
  EXPECT_EQ(calculate(1), 0);
}

/// All of them begin with a problem that is not there, and then look at results while others calculate: either a code,
/// or the numbers that one thread has alone.
TEST_F(Threads, OnOneProblemHaveACodeOrRightNumbers) {
  ASSERT_EQ(set_up_sphere(2, 1), 0);
  ASSERT_EQ(calculate(2, 1), 0);
  const Values wanted = scalars(cntc_getcontactforces, 2, 1), pressures = field(2, 1, CNTC_fld_pn, 441);
  std::atomic<int> done{0}, wrong{0};
  const auto on_threads = [](auto work) {
    std::vector<std::thread> threads;
    for (int k = 0; k < 6; ++k) threads.emplace_back(work);
    for (auto& thread : threads) thread.join();
  };
  on_threads([&] {
    const int code = set_up_sphere(3, 1);
    wrong += code != 0 && code != CNTC_err_other;
  });
  ASSERT_EQ(set_up_sphere(3, 1), 0);
  ASSERT_EQ(calculate(3, 1), 0);
  on_threads([&] {
    for (int k = 0; k < 30; ++k) {
      for (const int code : {set_up_sphere(3, 1), calculate(3, 1)}) wrong += code != 0 && code != CNTC_err_other;
      int ire = 3, icp = 1, count = 441, pn = CNTC_fld_pn;
      Values forces(4, -1), found(441, -1);
      if (cntc_getcontactforces(&ire, &icp, &forces[0], &forces[1], &forces[2], &forces[3]) == 0) {
        wrong += forces != wanted;
        ++done;
      } else {
        wrong += forces != Values(4, 0);
      }
      const int code = cntc_getfielddata(&ire, &icp, &pn, &count, found.data());
      wrong += found != (code == 0 ? pressures : Values(441, 0));
    }
  });
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(done, 0) << "somebody always gets on";
}

TEST_F(Threads, MayEndAnElementThatOthersWorkOn) {
  std::atomic<bool> wrong{false};
  for (int round = 0; round < 20; ++round) {
    ASSERT_EQ(initialize(1, 3), 0);
    ASSERT_EQ(set_up_sphere(1, 1), 0);
    std::thread worker([&wrong] {
      for (int k = 0; k < 3; ++k) {
        const int code = calculate(1, 1); // of a new element after the end: without a potential contact
        if (code != 0 && code != CNTC_err_discr) wrong = true;
      }
    });
    finalize(1);
    worker.join();
  }
  EXPECT_FALSE(wrong);
}

} // namespace
} // namespace microslip::libcontact
