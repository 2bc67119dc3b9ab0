#pragma once

#include "microslip/progress.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace microslip {

/// Many independent items, e.g. contacts, on several threads: the one engine behind every interface that solves many.
struct BatchOptions {
  std::size_t chunk = 1; ///< items that a thread takes at a time, >= 1; some milliseconds of work
  int threads = 1;       ///< 1 to most_threads
  /// Told by the calling thread only of the fraction of items done, ascending. False ends the batch: no further chunk
  /// is begun, and the workers' progress functions return false. What it throws does the same and is passed on.
  Progress progress = {};
  /// An item that throws Error leaves the others alone, and its reason is kept.
  bool keep_errors = false;
  /// Hands out chunks instead of the batch: the first item of the next one, ascending; `count` or more if none is
  /// left. For chunks that processes share. Any thread calls it; what it throws is passed on.
  std::function<std::size_t()> take = {};
};

/// A chunk whose worker threw an Error.
struct BatchError {
  std::size_t first; ///< the chunk's first item
  std::string reason;
};

/// Outcome of a batch.
struct BatchReport {
  bool complete = true;                ///< false if progress ended it: some items are not done, or not to their end
  std::vector<BatchError> errors = {}; ///< those kept, by their first items
};

/// Works on the items first to first + n - 1. A long one should pass the fraction of the chunk done to `progress` and
/// end early if that answers false.
using BatchWorker = std::function<void(std::size_t first, std::size_t n, const Progress& progress)>;

/// Works on items 0 to count - 1. Every thread calls `make_worker` once, for separate solvers and memory, and then
/// takes the next chunk whenever it has done one. Results do not depend on the number of threads if an item's do not
/// depend on its neighbours. Within the batch OpenMP has one thread for each worker.
///
/// Passes on the exception of the lowest item, on every number of threads the same one: chunks below it are finished,
/// those above it are ended. Throws Error if `threads` is out of range. Cost beside the work: some microseconds for a
/// thread, less than one for a chunk.
BatchReport run_batch(std::size_t count, const BatchOptions& options, const std::function<BatchWorker()>& make_worker);

} // namespace microslip
