#pragma once

#include "microslip/progress.hpp"

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>

namespace microslip::campaign {

/// The processes that share a campaign, here a single one. What all of them must call together is marked *all*.
class Ranks {
public:
  Ranks() = default;
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;
  virtual ~Ranks() = default;

  virtual int rank() const { return 0; }
  virtual int size() const { return 1; }
  bool is_first() const { return rank() == 0; }

  /// *All*: the common count is 0.
  virtual void begin() { taken_ = 0; }
  /// The common count, which it then raises by one. From any thread.
  virtual std::size_t take() { return taken_++; }
  /// The common count. From any thread.
  virtual std::size_t taken() { return taken_; }
  /// Ends the work: from now on `take` returns `none` or more, on all ranks.
  virtual void end() { taken_ = none; }
  static constexpr std::size_t none = std::size_t{1} << 62;

  /// *All*: the first rank's bytes.
  virtual std::string from_first(std::string bytes) { return bytes; }
  /// *All*: waits for all and returns the error of the lowest rank that has one, else nothing. While it waits it asks
  /// `progress` repeatedly, and throws Stopped if that returns false.
  virtual std::string common_error(std::string error, const Progress& progress = {}) {
    go_on(progress, 1);
    return error;
  }

  /// *All*: does something, after which all ranks go on, or all throw the Error of the lowest one that failed.
  void agree(const std::function<void()>& work, const Progress& progress = {});

private:
  std::atomic<std::size_t> taken_ = 0;
};

/// The ranks that mpirun, or another launcher, has started this process among; this one alone if there are none. Throws
/// Error if there are some and microslip was built without MPI. Once in a process.
std::unique_ptr<Ranks> launched_ranks();

} // namespace microslip::campaign
