#pragma once

#include "campaign/journal.hpp"
#include "campaign/ranks.hpp"
#include "campaign/rows.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace microslip::campaign {

/// Fills the row of a case; returns why it is not to be trusted, or nothing. It must depend on the index alone, not on
/// the cases that the same worker had before: then rows are the same to the last bit on any threads and ranks. An Error
/// that it throws is the case's reason, its row NaN. Long work should end early if `progress` answers false.
using RowWorker = std::function<std::string(std::size_t index, std::span<double> row, const Progress& progress)>;

struct CampaignOptions {
  int threads = 1; ///< of this process, 1 to most_threads
  /// Told by the calling thread, on every rank, of the fraction of all cases that has been handed out. False ends this
  /// rank's work.
  Progress progress = {};
};

/// Many cases computed once: on the threads of one process or of many, with a checkpoint that outlives them. Each
/// process adds its finished chunks to its Journal in the checkpoint's folder; a campaign that is made anew
/// with the same plan and folder, by any number of processes, goes on with what is missing. Chunks are handed out by a
/// count that all share, to the next that asks.
class Campaign {
public:
  /// Opens the checkpoint `folder` or creates it, on *all* ranks, and takes away chunks cut off by the death of their
  /// process. Throws Error, on all of them, if another run is writing to the folder or there is something in it that is
  /// not of this plan (see find_chunks), or for a plan out of range. `ranks` must outlive the campaign.
  Campaign(std::filesystem::path folder, const CampaignPlan& plan, Ranks& ranks);
  Campaign(const Campaign&) = delete;
  Campaign& operator=(const Campaign&) = delete;
  ~Campaign();

  const CampaignPlan& plan() const { return plan_; }
  /// Cases that the checkpoint had when the campaign was made.
  std::size_t kept_cases() const;
  /// Numbers of the chunks that it did not have, ascending.
  const std::vector<std::size_t>& missing_chunks() const { return missing_; }

  /// Computes what is missing, on *all* ranks; every thread makes a worker. False if progress ended it: some chunks
  /// are not done, and those that were finished are kept. Throws Error, on all ranks, if one cannot write its journal
  /// (with all earlier chunks kept) or make a worker. Memory does not grow with the number of cases, but by a number
  /// for each chunk; cost beside the work: some microseconds for a chunk.
  bool run(const CampaignOptions& options, const std::function<RowWorker()>& make_worker);

  /// Keeps a chunk that was computed elsewhere. One thread at a time.
  void keep(const CampaignRows& rows);

  /// Visits all rows by ascending cases, on the first rank, when nothing is missing any more. Throws Error otherwise.
  void read(const std::function<void(const CampaignRows&)>& visit) const;

  /// Removes the checkpoint, on the first rank, when its rows are safe elsewhere.
  void remove();

private:
  class Lock;
  class Writer;

  std::vector<std::filesystem::path> journals() const;
  void find_missing();
  Writer& writer();
  bool compute_missing(const CampaignOptions& options, const std::function<RowWorker()>& make_worker);

  std::filesystem::path folder_;
  CampaignPlan plan_;
  Ranks& ranks_;
  std::unique_ptr<Lock> lock_;
  std::unique_ptr<Writer> writer_;
  std::vector<std::size_t> missing_;
};

/// The rows of a chunk, in this thread; false if progress ended the work, which leaves them without meaning. Outside of
/// a batch solvers may use several threads, on which their last bits depend.
bool compute_chunk(const CampaignPlan& plan, std::size_t number, const RowWorker& worker, const Progress& progress,
                   CampaignRows& rows);

} // namespace microslip::campaign
