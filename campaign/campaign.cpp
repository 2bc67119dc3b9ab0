#include "campaign/campaign.hpp"

#include "microslip/batch/batch.hpp"
#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <limits>
#include <mutex>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace microslip::campaign {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view journal_name = "rank-", lock_name = "lock";

[[noreturn]] void fail(const fs::path& path, int error_number) {
  throw Error(path.string() + ": cannot be written: " + std::generic_category().message(error_number));
}

void check(const CampaignPlan& plan) {
  require_between("cases", static_cast<double>(plan.count), "-", 1, most_cases);
  require_between("numbers of a row", static_cast<double>(plan.width), "-", 1, 1e6);
  require_between("chunk", static_cast<double>(plan.chunk), "-", 1, most_cases);
  require_between("chunks", static_cast<double>(plan.chunks()), "-", 1, static_cast<double>(most_chunks));
}

/// Lets the progress of chunks that take microseconds through some hundred times a second.
class RareLook {
public:
  bool is_due() {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::milliseconds(2)) return false;
    last_ = now;
    return true;
  }

private:
  std::chrono::steady_clock::time_point last_{};
};

void create(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) fail(folder, error.value());
}

} // namespace

/// Keeps other runs away from a checkpoint, until the process ends, for whatever reason. The first rank has byte 0 of a
/// file, rank r byte r: a new run needs all of it for a moment, so that it does not begin while a rank of an old one
/// still writes. Locks by fcntl are not inherited by child processes and work over NFS; where a file system has none,
/// nothing is locked.
class Campaign::Lock {
public:
  explicit Lock(const fs::path& path)
      : path_(path), descriptor_(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
    if (descriptor_ < 0) fail(path, errno);
  }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;
  ~Lock() { ::close(descriptor_); }

  void take_first() {
    if (!set(F_WRLCK, 0, 0)) {
      struct flock other = range(F_WRLCK, 0, 0);
      ::fcntl(descriptor_, F_GETLK, &other);
      throw Error(path_.parent_path().string() + ": another run is writing to it, process " +
                  std::to_string(other.l_pid));
    }
    set(F_UNLCK, 1, 0);
  }
  void take(int rank) {
    if (rank > 0) set(F_WRLCK, rank, 1);
  }

private:
  /// `length` 0: to the end.
  static struct flock range(int type, int start, int length) {
    struct flock lock {};
    lock.l_type = static_cast<short>(type);
    lock.l_whence = SEEK_SET;
    lock.l_start = start;
    lock.l_len = length;
    return lock;
  }
  bool set(int type, int start, int length) {
    const struct flock lock = range(type, start, length);
    return ::fcntl(descriptor_, F_SETLK, &lock) == 0 || (errno != EACCES && errno != EAGAIN);
  }

  fs::path path_;
  int descriptor_;
};

/// The journal of this process, for all its threads.
class Campaign::Writer {
public:
  Writer(const fs::path& path, const CampaignPlan& plan) : journal_(path, plan) {}

  void add(const CampaignRows& rows) {
    const std::scoped_lock lock(mutex_);
    journal_.add(rows);
    if (std::chrono::steady_clock::now() - synced_ > interval) sync();
  }
  void sync() {
    journal_.sync();
    synced_ = std::chrono::steady_clock::now();
  }

private:
  static constexpr std::chrono::seconds interval{5}; ///< what a crash of the machine may cost

  std::mutex mutex_;
  Journal journal_;
  std::chrono::steady_clock::time_point synced_ = std::chrono::steady_clock::now();
};

Campaign::Campaign(fs::path folder, const CampaignPlan& plan, Ranks& ranks)
    : folder_(std::move(folder)), plan_(plan), ranks_(ranks) {
  check(plan);
  std::string missing;
  ranks_.agree([&] {
    if (!ranks_.is_first()) return;
    create(folder_);
    lock_ = std::make_unique<Lock>(folder_ / lock_name);
    lock_->take_first();
    find_missing();
    missing.assign(reinterpret_cast<const char*>(missing_.data()), missing_.size() * sizeof(std::size_t));
  });
  missing = ranks_.from_first(std::move(missing));
  missing_.resize(missing.size() / sizeof(std::size_t));
  std::copy(missing.begin(), missing.end(), reinterpret_cast<char*>(missing_.data()));
  ranks_.agree([&] {
    if (!lock_) lock_ = std::make_unique<Lock>(folder_ / lock_name);
    lock_->take(ranks_.rank());
  });
}

Campaign::~Campaign() = default;

std::size_t Campaign::kept_cases() const {
  std::size_t missing = 0;
  for (const std::size_t number : missing_) missing += plan_.cases_of(number);
  return plan_.count - missing;
}

std::vector<fs::path> Campaign::journals() const {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(folder_)) {
    const auto name = entry.path().filename().string();
    if (name == lock_name || name.starts_with('.')) continue; // NFS hides removed files so
    if (!name.starts_with(journal_name)) throw Error(entry.path().string() + ": is no checkpoint of microslip");
    paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

void Campaign::find_missing() {
  std::vector<bool> is_kept(plan_.chunks());
  for (const auto& path : journals())
    for (const KeptChunk& chunk : find_chunks(path, plan_)) is_kept[chunk.number] = true;
  for (std::size_t number = 0; number < is_kept.size(); ++number)
    if (!is_kept[number]) missing_.push_back(number);
}

Campaign::Writer& Campaign::writer() {
  if (!writer_)
    writer_ = std::make_unique<Writer>(folder_ / (std::string(journal_name) + std::to_string(ranks_.rank())), plan_);
  return *writer_;
}

bool Campaign::run(const CampaignOptions& options, const std::function<RowWorker()>& make_worker) {
  ranks_.begin();
  bool complete = true;
  const auto work = [&] {
    try {
      complete = compute_missing(options, make_worker);
      if (writer_) writer_->sync();
      writer_.reset();
    } catch (...) {
      ranks_.end();
      throw;
    }
  };
  try {
    ranks_.agree(work, options.progress);
  } catch (const Stopped&) {
    return false;
  }
  return complete;
}

bool Campaign::compute_missing(const CampaignOptions& options, const std::function<RowWorker()>& make_worker) {
  if (missing_.empty()) return true;
  Writer& journal = writer();
  RareLook look;
  const Progress progress = [&](double) {
    if (!look.is_due()) return true;
    const std::size_t taken = ranks_.taken(); // of many ranks this is what moves the others' questions on
    if (taken >= Ranks::none) return false;
    const double left = static_cast<double>(missing_.size() - std::min(taken, missing_.size()));
    return !options.progress || options.progress(1 - left / static_cast<double>(plan_.chunks()));
  };
  const BatchOptions batch = {
      .threads = options.threads, .progress = progress, .take = [this] { return ranks_.take(); }};
  const auto report = run_batch(missing_.size(), batch, [&]() -> BatchWorker {
    return [&, worker = make_worker()](std::size_t k, std::size_t, const Progress& of_chunk) {
      CampaignRows rows;
      if (compute_chunk(plan_, missing_[k], worker, of_chunk, rows)) journal.add(rows);
    };
  });
  return report.complete;
}

void Campaign::keep(const CampaignRows& rows) {
  writer().add(rows);
}

void Campaign::read(const std::function<void(const CampaignRows&)>& visit) const {
  constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();
  struct ChunkPosition {
    std::size_t journal = nowhere, offset = 0;
  };
  std::vector<ChunkPosition> positions(plan_.chunks());
  std::vector<std::unique_ptr<JournalReader>> readers;
  for (const auto& path : journals()) {
    for (const auto& [number, offset] : find_chunks(path, plan_)) positions[number] = {readers.size(), offset};
    readers.push_back(std::make_unique<JournalReader>(path, plan_));
  }
  for (const auto& [journal, offset] : positions) {
    if (journal == nowhere) throw Error(folder_.string() + ": not all cases are computed");
    visit(readers[journal]->at(offset));
  }
}

void Campaign::remove() {
  writer_.reset();
  std::error_code ignored; // what is left here is read and removed by the next run
  for (const auto& path : journals()) fs::remove(path, ignored);
  fs::remove(folder_ / lock_name, ignored);
  lock_.reset();
  fs::remove(folder_, ignored);
}

bool compute_chunk(const CampaignPlan& plan, std::size_t number, const RowWorker& worker, const Progress& progress,
                   CampaignRows& rows) {
  const std::size_t first = plan.first_of(number), cases = plan.cases_of(number);
  rows = {.number = number, .values = std::vector<double>(cases * plan.width), .failed = {}};
  for (std::size_t i = 0; i < cases; ++i) {
    const auto part = static_cast<double>(i) / static_cast<double>(cases);
    if (progress && !progress(part)) return false;
    const std::span row(rows.values.data() + i * plan.width, plan.width);
    std::string reason;
    try {
      reason = worker(first + i, row, progress);
    } catch (const Error& error) {
      std::fill(row.begin(), row.end(), std::numeric_limits<double>::quiet_NaN());
      reason = error.what();
    } catch (const Stopped&) {
      return false;
    }
    if (!reason.empty()) rows.failed.push_back({first + i, std::move(reason)});
  }
  return !progress || progress(1);
}

} // namespace microslip::campaign
