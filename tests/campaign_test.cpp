// Campaigns: rows computed once, kept whatever happens to their process, the same on any threads.

#include "campaign/campaign.hpp"

#include "campaign/hash.hpp"
#include "microslip/error.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/file_size_limit.hpp"
#include "tests/support/program_run.hpp"
#include "tests/support/same_bits.hpp"
#include "tests/support/temporary_folder.hpp"

#include <atomic>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <functional>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

namespace microslip {
namespace {

namespace fs = std::filesystem;

campaign::CampaignPlan small_plan(std::size_t count = 103, std::size_t chunk = 4) {
  return {.identity = campaign::hash_of("a test"), .count = count, .width = 3, .chunk = chunk};
}

/// Every seventh case fails with a reason, every eleventh by an Error.
std::string fill(std::size_t index, std::span<double> row, const Progress&) {
  if (index % 11 == 10) throw Error("case " + std::to_string(index) + " makes no sense");
  const auto x = static_cast<double>(index);
  row[0] = x;
  row[1] = std::sin(x);
  row[2] = std::exp(-x);
  return index % 7 == 6 ? "reason of " + std::to_string(index) : "";
}

std::function<campaign::RowWorker()> always(const campaign::RowWorker& worker) {
  return [worker] { return worker; };
}

struct AllRows {
  std::vector<double> values;
  std::vector<campaign::FailedCase> failed;
};

AllRows rows_of(const campaign::Campaign& campaign) {
  AllRows all;
  campaign.read([&](const campaign::CampaignRows& rows) {
    EXPECT_EQ(rows.number * campaign.plan().chunk * campaign.plan().width, all.values.size());
    all.values.insert(all.values.end(), rows.values.begin(), rows.values.end());
    all.failed.insert(all.failed.end(), rows.failed.begin(), rows.failed.end());
  });
  return all;
}

void expect_right(const campaign::Campaign& campaign) {
  const AllRows all = rows_of(campaign);
  const auto& plan = campaign.plan();
  ASSERT_EQ(all.values.size(), plan.count * plan.width);
  std::size_t failed = 0;
  std::vector<double> row(3);
  for (std::size_t i = 0; i < plan.count; ++i) {
    std::string reason;
    try {
      reason = fill(i, row, {});
      EXPECT_TRUE(same_bits(row, std::span(all.values).subspan(3 * i, 3))) << i;
    } catch (const Error& error) {
      reason = error.what();
      EXPECT_TRUE(std::isnan(all.values[3 * i])) << i;
    }
    if (reason.empty()) continue;
    ASSERT_LT(failed, all.failed.size());
    EXPECT_EQ(all.failed[failed], (campaign::FailedCase{i, reason}));
    ++failed;
  }
  EXPECT_EQ(failed, all.failed.size());
}

/// Keeps the first chunks of the plan, as a run that was ended leaves them.
void begin(const fs::path& folder, const campaign::CampaignPlan& plan, std::size_t chunks) {
  campaign::Ranks alone;
  campaign::Campaign campaign(folder, plan, alone);
  campaign::CampaignRows rows;
  for (std::size_t number = 0; number < chunks; ++number) {
    ASSERT_TRUE(campaign::compute_chunk(plan, number, fill, {}, rows));
    campaign.keep(rows);
  }
}

TEST(Campaign, SameRowsOnAnyThreadsAndChunks) {
  for (const std::size_t chunk : {1, 4, 103, 1000})
    for (const int threads : {1, 2, 7}) {
      const TemporaryFolder folder;
      campaign::Ranks alone;
      campaign::Campaign campaign(folder / "c", small_plan(103, chunk), alone);
      EXPECT_EQ(campaign.kept_cases(), 0u);
      ASSERT_TRUE(campaign.run({.threads = threads}, always(fill)));
      expect_right(campaign);
      campaign.remove();
      EXPECT_TRUE(folder.entries().empty());
    }
}

TEST(Campaign, OfOneCase) {
  const TemporaryFolder folder;
  campaign::Ranks alone;
  campaign::Campaign campaign(folder / "c", small_plan(1), alone);
  ASSERT_TRUE(campaign.run({}, always(fill)));
  expect_right(campaign);
}

TEST(Campaign, PlansOutOfRange) {
  const TemporaryFolder folder;
  campaign::Ranks alone;
  const auto make = [&](const campaign::CampaignPlan& plan) {
    return [&] { const campaign::Campaign c(folder / "c", plan, alone); };
  };
  expect_words(make(small_plan(0)), "cases");
  expect_words(make(small_plan(2'000'000'001, 1000)), "cases");
  expect_words(make(small_plan(1'000'000'000, 1)), "chunks");
  EXPECT_TRUE(folder.entries().empty());
}

TEST(Campaign, GoesOnWithWhatIsMissing) {
  const TemporaryFolder folder;
  const auto plan = small_plan();
  begin(folder / "c", plan, 5);
  campaign::Ranks alone;
  campaign::Campaign campaign(folder / "c", plan, alone);
  EXPECT_EQ(campaign.kept_cases(), 20u);
  std::atomic<std::size_t> computed = 0;
  const auto worker = [&](std::size_t index, std::span<double> row, const Progress& progress) {
    EXPECT_GE(index, 20u);
    ++computed;
    return fill(index, row, progress);
  };
  ASSERT_TRUE(campaign.run({.threads = 3}, always(worker)));
  EXPECT_EQ(computed, plan.count - 20);
  expect_right(campaign);
}

/// A campaign that was begun, with its journal.
struct Begun {
  TemporaryFolder folder;
  campaign::CampaignPlan plan = small_plan(5, 2);
  fs::path journal = folder / "c/rank-0";
  std::string whole;

  Begun() {
    begin(folder / "c", plan, 3);
    whole = contents(journal);
  }
};

TEST(Campaign, ACheckpointCutOffAnywhereIsRecovered) {
  const Begun begun;
  const campaign::CampaignPlan& plan = begun.plan;
  std::size_t last = plan.count;
  for (std::size_t size = begun.whole.size() + 1; size-- > 0;) {
    save(begun.journal, begun.whole.substr(0, size));
    campaign::Ranks alone;
    campaign::Campaign campaign(begun.folder / "c", plan, alone);
    EXPECT_LE(campaign.kept_cases(), last);
    last = campaign.kept_cases();
    if (size % 16 != 0) continue;
    ASSERT_TRUE(campaign.run({}, always(fill))) << size;
    expect_right(campaign);
  }
  EXPECT_EQ(last, 0u);
}

TEST(Campaign, ADamagedByteAnywhereIsNamed) {
  const Begun begun;
  const campaign::CampaignPlan& plan = begun.plan;
  for (std::size_t place = 0; place < begun.whole.size(); ++place) {
    std::string damaged = begun.whole;
    damaged[place] = static_cast<char>(damaged[place] ^ 0x10);
    save(begun.journal, damaged);
    campaign::Ranks alone;
    expect_words([&] { const campaign::Campaign campaign(begun.folder / "c", plan, alone); }, "rank-0: ");
    EXPECT_EQ(contents(begun.journal), damaged);
  }
  fs::remove(begun.journal);
  campaign::Ranks alone;
  campaign::Campaign campaign(begun.folder / "c", plan, alone);
  ASSERT_TRUE(campaign.run({}, always(fill)));
  expect_right(campaign);
}

TEST(Campaign, ForeignCheckpointsAreNamed) {
  const TemporaryFolder folder;
  const auto plan = small_plan(12);
  begin(folder / "c", plan, 3);
  const auto refused = [&](const campaign::CampaignPlan& other, const std::string& what) {
    campaign::Ranks alone;
    expect_words([&] { const campaign::Campaign campaign(folder / "c", other, alone); }, what);
  };
  auto other = plan;
  other.identity ^= 1;
  refused(other, "belongs to another campaign");
  other = plan;
  other.count = 13;
  refused(other, "belongs to another campaign");
  const auto journal = folder / "c/rank-0";
  const std::string whole = contents(journal);
  const auto changed = [&](std::size_t place, std::string_view bytes) {
    std::string text = whole;
    save(journal, text.replace(place, bytes.size(), bytes));
  };
  changed(8, std::string_view("\0\0\0\0", 4));
  refused(plan, "has format 0 of checkpoints; this version of microslip reads and writes 1");
  changed(12, "\x01\x02\x03\x04");
  refused(plan, "another byte order");
  save(journal, "x,y\n1,2\n");
  refused(plan, "is no checkpoint of microslip");
  fs::remove(journal);
  save(folder / "c/notes.txt", "mine");
  refused(plan, "notes.txt: is no checkpoint of microslip");
}

/// What a child process does with a checkpoint; returns its status.
int in_child(const std::function<void()>& work) {
  const pid_t child = fork();
  if (child == 0) {
    work();
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

TEST(Campaign, TwoRunsOnOneCheckpointAreRefused) {
  const TemporaryFolder folder;
  campaign::Ranks alone;
  campaign::Campaign campaign(folder / "c", small_plan(), alone);
  const int status = in_child([&] {
    campaign::Ranks other;
    try {
      const campaign::Campaign second(folder / "c", small_plan(), other);
    } catch (const Error& error) {
      const std::string expected = "another run is writing to it, process " + std::to_string(getppid());
      _exit(std::strstr(error.what(), expected.c_str()) != nullptr ? 3 : 4);
    }
  });
  EXPECT_EQ(WEXITSTATUS(status), 3);
}

TEST(Campaign, KilledAtAnyMomentItLosesNothingAndComputesNothingTwice) {
  const TemporaryFolder folder;
  const auto plan = small_plan(400, 4);
  std::mt19937 random(7);
  std::size_t kept = 0;
  int kills = 0;
  while (kept < plan.count) {
    const auto journal = folder / "computed";
    const int after = std::uniform_int_distribution(1, 60)(random);
    const int status = in_child([&] {
      campaign::Ranks alone;
      campaign::Campaign campaign(folder / "c", plan, alone);
      if (campaign.kept_cases() < kept) _exit(5); // something is lost
      std::atomic<int> computed = 0;
      const auto worker = [&](std::size_t index, std::span<double> row, const Progress& progress) {
        if (++computed == after) kill(getpid(), SIGKILL);
        return fill(index, row, progress);
      };
      campaign.run({.threads = 1}, always(worker));
    });
    kills += WIFSIGNALED(status) ? 1 : 0;
    if (!WIFSIGNALED(status)) {
      EXPECT_EQ(WEXITSTATUS(status), 0);
    }
    campaign::Ranks alone;
    const campaign::Campaign campaign(folder / "c", plan, alone);
    // All chunks that were finished before the one that died.
    if (WIFSIGNALED(status)) {
      EXPECT_EQ(campaign.kept_cases(), kept + static_cast<std::size_t>(after - 1) / 4 * 4);
    }
    kept = campaign.kept_cases();
  }
  EXPECT_GT(kills, 5);
  campaign::Ranks alone;
  const campaign::Campaign campaign(folder / "c", plan, alone);
  expect_right(campaign);
}

TEST(Campaign, AFullDiskIsAnErrorThatLosesNothing) {
  const TemporaryFolder folder;
  const auto plan = small_plan(400, 4);
  {
    campaign::Ranks alone;
    campaign::Campaign campaign(folder / "c", plan, alone);
    const FileSizeLimit limit(5000);
    expect_words([&] { campaign.run({.threads = 2}, always(fill)); }, "rank-0: cannot be written: ");
  }
  campaign::Ranks alone;
  campaign::Campaign campaign(folder / "c", plan, alone);
  EXPECT_GT(campaign.kept_cases(), 0u);
  EXPECT_LT(campaign.kept_cases(), 200u);
  ASSERT_TRUE(campaign.run({.threads = 2}, always(fill)));
  expect_right(campaign);
}

TEST(Campaign, ProgressTellsOfAllCasesAndEndsTheRun) {
  const TemporaryFolder folder;
  const auto plan = small_plan(1000, 10);
  begin(folder / "c", plan, 50);
  campaign::Ranks alone;
  campaign::Campaign campaign(folder / "c", plan, alone);
  double last = 0;
  const auto tell = [&](double fraction) {
    EXPECT_GE(fraction, std::max(last, 0.5));
    EXPECT_LE(fraction, 1);
    last = fraction;
    return fraction < 0.7;
  };
  const auto slow = [](std::size_t index, std::span<double> row, const Progress& progress) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return fill(index, row, progress);
  };
  EXPECT_FALSE(campaign.run({.threads = 2, .progress = tell}, always(slow)));
  EXPECT_GE(last, 0.7);
  const campaign::Campaign rest(folder / "c", plan, alone);
  EXPECT_GT(rest.kept_cases(), 500u);
  EXPECT_LT(rest.kept_cases(), 1000u);
  expect_words([&] { rest.read([](const campaign::CampaignRows&) {}); }, "not all cases are computed");
}

TEST(Campaign, ChunksComputedElsewhereAreKept) {
  const TemporaryFolder folder;
  const auto plan = small_plan();
  campaign::Ranks alone;
  {
    campaign::Campaign campaign(folder / "c", plan, alone);
    ASSERT_EQ(campaign.missing_chunks().size(), plan.chunks());
    auto chunks = campaign.missing_chunks();
    std::shuffle(chunks.begin(), chunks.end(), std::mt19937(3));
    campaign::CampaignRows rows;
    for (const std::size_t number : chunks) {
      ASSERT_TRUE(campaign::compute_chunk(plan, number, fill, {}, rows));
      campaign.keep(rows);
    }
  }
  const campaign::Campaign campaign(folder / "c", plan, alone);
  EXPECT_TRUE(campaign.missing_chunks().empty());
  expect_right(campaign);
}

} // namespace
} // namespace microslip
