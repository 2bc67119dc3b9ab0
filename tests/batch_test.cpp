// One engine for many items on many threads: who works on what, who is told, and how it ends.

#include "microslip/batch/batch.hpp"

#include "microslip/batch/solve_parallel.hpp"
#include "microslip/error.hpp"
#include "tests/support/expect_error.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <omp.h>

namespace microslip {
namespace {

/// A worker without memory.
std::function<BatchWorker()> always(const BatchWorker& worker) {
  return [worker] { return worker; };
}

void sleep_shortly() {
  std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

/// Waits until `condition` holds; true if it ever did.
template <class Condition> bool comes_true(const Condition& condition) {
  for (int k = 0; k < 60000 && !condition(); ++k) sleep_shortly();
  return condition();
}

TEST(Batch, WorksOnEveryItemOnce) {
  for (const std::size_t count : {0, 1, 7, 1000})
    for (const std::size_t chunk : {1, 3, 256})
      for (const int threads : {1, 2, 5}) {
        std::vector<int> times(count, 0);
        std::atomic<int> workers = 0;
        const BatchReport report = run_batch(count, {.chunk = chunk, .threads = threads}, [&]() -> BatchWorker {
          ++workers;
          return [&](std::size_t first, std::size_t n, const Progress&) {
            EXPECT_EQ(first % chunk, 0u);
            EXPECT_EQ(n, std::min(chunk, count - first));
            for (std::size_t i = first; i < first + n; ++i) ++times[i];
          };
        });
        EXPECT_TRUE(report.complete);
        EXPECT_TRUE(report.errors.empty());
        EXPECT_EQ(times, std::vector<int>(count, 1));
        EXPECT_LE(workers, threads);
        EXPECT_LE(workers, static_cast<int>((count + chunk - 1) / chunk));
      }
}

TEST(Batch, GivesInnerSolversOneThread) {
  const int before = omp_get_max_threads();
  for (const int threads : {1, 3}) {
    std::atomic<int> most = 0;
    run_batch(20, {.threads = threads}, always([&](std::size_t, std::size_t, const Progress&) {
                if (omp_get_max_threads() > 1) ++most;
#pragma omp parallel
                if (omp_get_num_threads() > 1) ++most;
              }));
    EXPECT_EQ(most, 0);
    EXPECT_EQ(omp_get_max_threads(), before);
  }
}

TEST(Batch, PassesOnTheErrorOfTheLowestItem) {
  for (const int threads : {1, 2, 5}) {
    std::vector<char> done(500, 0);
    const auto worker = always([&](std::size_t i, std::size_t, const Progress&) {
      if (i == 30 || i >= 33) throw std::runtime_error(std::to_string(i));
      if (i < 30) sleep_shortly(); // the others throw first
      done[i] = 1;
    });
    try {
      run_batch(done.size(), {.threads = threads}, worker);
      FAIL() << "nothing is thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "30");
    }
    EXPECT_EQ(std::count(done.begin(), done.begin() + 30, 1), 30);
  }
}

TEST(Batch, TheErrorOfAnItemEndsThoseAboveItOnly) {
  std::atomic<bool> has_begun = false, lower_goes_on = false, upper_ends = false;
  const auto worker = always([&](std::size_t i, std::size_t, const Progress& progress) {
    if (i == 1) {
      EXPECT_TRUE(comes_true([&] { return has_begun.load(); }));
      throw std::runtime_error("1");
    }
    if (i == 2) {
      has_begun = true;
      upper_ends = comes_true([&] { return !progress(0); });
    }
    if (i == 0) {
      EXPECT_TRUE(comes_true([&] { return upper_ends.load(); }));
      lower_goes_on = progress(0.5);
    }
  });
  EXPECT_THROW(run_batch(3, {.threads = 3}, worker), std::runtime_error);
  EXPECT_TRUE(upper_ends);
  EXPECT_TRUE(lower_goes_on);
}

TEST(Batch, KeepsTheErrorsOfItemsIfAsked) {
  for (const int threads : {1, 4}) {
    std::atomic<int> done = 0;
    const auto worker = always([&](std::size_t i, std::size_t, const Progress&) {
      if (i % 10 == 3) throw Error("item " + std::to_string(i));
      ++done;
    });
    const BatchReport report = run_batch(40, {.threads = threads, .keep_errors = true}, worker);
    EXPECT_TRUE(report.complete);
    EXPECT_EQ(done, 36);
    ASSERT_EQ(report.errors.size(), 4u);
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_EQ(report.errors[k].first, 10 * k + 3);
      EXPECT_EQ(report.errors[k].reason, "item " + std::to_string(10 * k + 3));
    }
    const auto no_error = always([](std::size_t, std::size_t, const Progress&) { throw std::bad_alloc(); });
    EXPECT_THROW(run_batch(40, {.threads = threads, .keep_errors = true}, no_error), std::bad_alloc);
  }
}

TEST(Batch, TellsTheCallingThreadOfTheFractionDone) {
  const auto caller = std::this_thread::get_id();
  for (const int threads : {1, 3}) {
    std::vector<double> told;
    const Progress progress = [&](double fraction) {
      EXPECT_EQ(std::this_thread::get_id(), caller);
      told.push_back(fraction);
      return true;
    };
    const auto worker = always([](std::size_t, std::size_t, const Progress& own) {
      EXPECT_TRUE(own(0.5));
      sleep_shortly();
    });
    EXPECT_TRUE(run_batch(25, {.chunk = 2, .threads = threads, .progress = progress}, worker).complete);
    ASSERT_FALSE(told.empty());
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_GE(told.front(), 0);
    EXPECT_EQ(told.back(), 1);
    if (threads == 1) {
      EXPECT_EQ(told.front(), 1.0 / 25);
    }
  }
}

TEST(Batch, TheCallerIsToldWhileOthersWork) {
  std::atomic<int> told = 0;
  std::atomic<bool> other_has_begun = false, caller_has_ended = false;
  const auto caller = std::this_thread::get_id();
  const Progress progress = [&](double) {
    ++told;
    return true;
  };
  const auto worker = always([&](std::size_t, std::size_t, const Progress&) {
    if (std::this_thread::get_id() == caller) {
      EXPECT_TRUE(comes_true([&] { return other_has_begun.load(); }));
      caller_has_ended = true;
      return;
    }
    other_has_begun = true;
    EXPECT_TRUE(comes_true([&] { return caller_has_ended && told >= 5; }));
  });
  EXPECT_TRUE(run_batch(2, {.threads = 2, .progress = progress}, worker).complete);
}

TEST(Batch, EndsWhenProgressAsksForIt) {
  for (const int threads : {1, 2, 4}) {
    std::atomic<int> begun = 0;
    const Progress progress = [&](double) { return false; };
    const auto worker = always([&](std::size_t, std::size_t, const Progress& own) {
      ++begun;
      EXPECT_TRUE(comes_true([&] { return !own(0.1); }));
    });
    const BatchReport report = run_batch(1000, {.threads = threads, .progress = progress}, worker);
    EXPECT_FALSE(report.complete);
    EXPECT_LE(begun, threads);
  }
}

TEST(Batch, PassesOnWhatProgressAndTheMakerThrow) {
  for (const int threads : {1, 3}) {
    const Progress thrower = [](double) -> bool { throw std::logic_error("interrupted"); };
    const auto worker = always([](std::size_t, std::size_t, const Progress& own) {
      EXPECT_TRUE(comes_true([&] { return !own(0); })); // nothing is thrown through a solver
      throw std::runtime_error("an item, later");
    });
    EXPECT_THROW(run_batch(100, {.threads = threads, .progress = thrower}, worker), std::logic_error);
    const auto maker = []() -> BatchWorker { throw std::length_error("no memory"); };
    EXPECT_THROW(run_batch(100, {.threads = threads}, maker), std::length_error);
  }
}

TEST(Batch, RefusesOptionsOutOfRange) {
  const auto idle = always([](std::size_t, std::size_t, const Progress&) {});
  expect_error([&] { run_batch(1, {.threads = 0}, idle); }, "threads", "must be in [1, 1024]");
  expect_error([&] { run_batch(1, {.threads = 1025}, idle); }, "threads", "must be in [1, 1024]");
  expect_error([&] { run_batch(1, {.chunk = 0}, idle); }, "chunk", "must be at least 1");
  std::vector<ContactForces> forces(2);
  const RowSolver solver(MarchingScheme::fastsim2, {});
  EXPECT_THROW(solve_parallel(solver, {}, forces, 1), Error);
}

} // namespace
} // namespace microslip
