#include "campaign/launcher.hpp"
#include "campaign/ranks.hpp"
#include "microslip/error.hpp"

#include <chrono>
#include <cstdint>
#include <mutex>
#include <thread>

#include <mpi.h>

namespace microslip::campaign {
namespace {

/// The common count is a number in the first rank's memory, which all others raise without its help: there is nobody
/// who waits for questions.
class MpiRanks final : public Ranks {
public:
  MpiRanks() {
    int given = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &given);
    if (given < MPI_THREAD_SERIALIZED) throw Error("this MPI allows no threads");
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
    MPI_Win_allocate(rank_ == 0 ? sizeof *count_ : 0, sizeof *count_, MPI_INFO_NULL, MPI_COMM_WORLD, &count_, &window_);
    MPI_Win_lock_all(MPI_MODE_NOCHECK, window_);
  }

  /// Ends with the others where all are known to end. Else this rank exits as it would without MPI, and the
  /// launcher ends the others.
  ~MpiRanks() override {
    if (!is_agreed_) return;
    MPI_Win_unlock_all(window_);
    MPI_Win_free(&window_);
    MPI_Finalize();
  }

  int rank() const override { return rank_; }
  int size() const override { return size_; }

  void begin() override {
    is_agreed_ = false;
    if (rank_ == 0) change(MPI_REPLACE, 0);
    MPI_Barrier(MPI_COMM_WORLD);
  }

  std::size_t take() override { return change(MPI_SUM, 1); }
  std::size_t taken() override { return change(MPI_NO_OP, 0); }
  void end() override { change(MPI_REPLACE, static_cast<std::int64_t>(none)); }

  std::string from_first(std::string bytes) override {
    std::uint64_t size = bytes.size();
    MPI_Bcast(&size, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
    bytes.resize(size);
    MPI_Bcast(bytes.data(), static_cast<int>(size), MPI_BYTE, 0, MPI_COMM_WORLD);
    return bytes;
  }

  std::string common_error(std::string error, const Progress& progress) override {
    int mine = error.empty() ? size_ : rank_, lowest = size_;
    MPI_Request request = MPI_REQUEST_NULL;
    {
      const std::scoped_lock lock(mutex_);
      MPI_Iallreduce(&mine, &lowest, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD, &request);
    }
    while (!is_done(request)) { // NOLINT(clang-analyzer-optin.mpi.MPI-Checker): waits by MPI_Test
      go_on(progress, 1);
      std::this_thread::sleep_for(std::chrono::milliseconds(1)); // MPI_Wait would keep a processor busy
    }
    is_agreed_ = true;
    if (lowest == size_) return "";
    std::uint64_t size = error.size();
    MPI_Bcast(&size, 1, MPI_UINT64_T, lowest, MPI_COMM_WORLD);
    error.resize(size);
    MPI_Bcast(error.data(), static_cast<int>(size), MPI_BYTE, lowest, MPI_COMM_WORLD);
    return error;
  }

private:
  /// Returns the common count as it was.
  std::size_t change(MPI_Op operation, std::int64_t operand) {
    const std::scoped_lock lock(mutex_);
    std::int64_t old = 0;
    MPI_Fetch_and_op(&operand, &old, MPI_INT64_T, 0, 0, operation, window_);
    MPI_Win_flush(0, window_);
    return static_cast<std::size_t>(old);
  }

  bool is_done(MPI_Request& request) {
    const std::scoped_lock lock(mutex_);
    int done = 0;
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    return done != 0;
  }

  int rank_ = 0, size_ = 1;
  bool is_agreed_ = true;
  std::int64_t* count_ = nullptr;
  MPI_Win window_ = MPI_WIN_NULL;
  std::mutex mutex_; ///< of MPI
};

} // namespace

std::unique_ptr<Ranks> launched_ranks() {
  if (!has_launcher()) return std::make_unique<Ranks>();
  return std::make_unique<MpiRanks>();
}

} // namespace microslip::campaign
