#include "microslip/batch/batch.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>

#include <omp.h>

namespace microslip {
namespace {

/// Batch in progress. All that stops it, wholly or in part, is `end_`: items from there on need not be done.
class Batch {
public:
  Batch(std::size_t count, const BatchOptions& options) : options_(options), count_(count), end_(count) {}

  void run(const std::function<BatchWorker()>& make_worker) {
    const std::size_t chunks = (count_ + options_.chunk - 1) / options_.chunk;
    const auto threads = std::min<std::size_t>(options_.threads, chunks);
    if (threads == 0) return;
#pragma omp parallel num_threads(static_cast <int>(threads))
    {
      omp_set_num_threads(1); // of this thread, while it is here
      const bool is_caller = omp_get_thread_num() == 0;
      try {
        work(make_worker(), is_caller);
      } catch (...) {
        abandon();
      }
      if (is_caller && options_.progress)
        wait_for(omp_get_num_threads() - 1);
      else if (!is_caller)
        leave();
    }
    if (failure_) std::rethrow_exception(failure_);
    if (error_) std::rethrow_exception(error_);
  }

  BatchReport report() {
    std::sort(errors_.begin(), errors_.end(), [](const auto& e, const auto& f) { return e.first < f.first; });
    return {!ended_, std::move(errors_)};
  }

private:
  void work(const BatchWorker& worker, bool is_caller) {
    for (std::size_t first = take(); first < end_; first = take()) {
      const std::size_t n = std::min(options_.chunk, count_ - first);
      const Progress progress = [&](double fraction) {
        return (!is_caller || tell(fraction * static_cast<double>(n))) && first < end_;
      };
      try {
        worker(first, n, progress);
      } catch (const Error& error) {
        options_.keep_errors ? keep(first, error.what()) : fail(first);
      } catch (...) {
        fail(first);
      }
      done_ += n;
      if (is_caller) tell(0);
    }
  }

  std::size_t take() {
    return options_.take ? options_.take() : next_.fetch_add(options_.chunk);
  }

  /// Called by the calling thread only, with the items that it has done of its chunk; returns whether to go on.
  bool tell(double of_chunk) {
    if (!options_.progress || end_ == 0) return end_ > 0;
    try {
      told_ = std::max(told_, std::min(1.0, (static_cast<double>(done_) + of_chunk) / static_cast<double>(count_)));
      if (options_.progress(told_)) return true;
      ended_ = true;
      end_ = 0;
    } catch (...) {
      abandon();
    }
    return false;
  }

  void keep(std::size_t first, const char* reason) {
    const std::scoped_lock lock(mutex_);
    errors_.push_back({first, reason});
  }

  /// Chunks are handed out in their order: when one fails, all below it have begun, and their errors come first.
  void fail(std::size_t first) {
    const std::scoped_lock lock(mutex_);
    if (first >= end_) return;
    error_ = std::current_exception();
    end_ = first;
  }

  /// Ends the batch for what no item is to blame for.
  void abandon() {
    const std::scoped_lock lock(mutex_);
    if (!failure_) failure_ = std::current_exception();
    end_ = 0;
  }

  void leave() {
    const std::scoped_lock lock(mutex_);
    ++left_;
    has_left_.notify_one();
  }

  /// The caller goes on telling of the others' progress when there is nothing left for itself.
  void wait_for(int others) {
    constexpr auto apart = std::chrono::milliseconds(20);
    std::unique_lock lock(mutex_);
    while (!has_left_.wait_for(lock, apart, [&] { return left_ == others; })) {
      lock.unlock();
      tell(0);
      lock.lock();
    }
    lock.unlock();
    if (told_ < 1) tell(0);
  }

  const BatchOptions& options_;
  std::size_t count_;
  std::atomic<std::size_t> next_ = 0, done_ = 0, end_;
  double told_ = 0;
  bool ended_ = false; ///< by progress
  std::mutex mutex_;   ///< of what follows, and of what lowers `end_`
  std::exception_ptr failure_, error_;
  std::vector<BatchError> errors_;
  std::condition_variable has_left_;
  int left_ = 0;
};

} // namespace

BatchReport run_batch(std::size_t count, const BatchOptions& options, const std::function<BatchWorker()>& make_worker) {
  require_count("threads", options.threads, 1, most_threads);
  if (options.chunk == 0) throw Error("chunk", 0, "-", "at least 1");
  Batch batch(count, options);
  batch.run(make_worker);
  return batch.report();
}

} // namespace microslip
