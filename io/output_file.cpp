#include "io/output_file.hpp"

#include "io/system_calls.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <climits>
#include <cstring>
#include <mutex>
#include <optional>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace microslip::io {
namespace {

/// Target of links, also if it does not exist yet. With links that lead to one another, one of them.
std::filesystem::path follow_links(std::filesystem::path path) {
  constexpr int most_links = 40; // as Linux has it
  std::error_code error;
  for (int k = 0; k < most_links && std::filesystem::is_symlink(path, error); ++k)
    path = path.parent_path() / std::filesystem::read_symlink(path, error);
  return path;
}

/// The descriptor that a name such as /dev/stdout stands for, or -1. To open the name again would lose the position
/// where others write.
int named_descriptor(const std::string& name) {
  constexpr std::string_view numbered = "/dev/fd/";
  if (name == "/dev/stdout") return STDOUT_FILENO;
  if (name == "/dev/stderr") return STDERR_FILENO;
  int number = -1;
  if (name.starts_with(numbered)) std::from_chars(name.data() + numbered.size(), name.data() + name.size(), number);
  return number;
}

bool is_special(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
}

/// The names of temporary files, where a signal handler finds them: memory that is never moved nor given back.
struct TemporaryName {
  std::atomic<bool> is_taken = false, is_there = false;
  std::array<char, PATH_MAX> name;
};
std::array<TemporaryName, 8> temporary_names; // a command writes two files at a time
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may not wait");

/// Registers a temporary file. With more at a time than the list can hold, or a longer name, a signal handler leaves it
/// to the next run.
void register_temporary(const std::string& name) {
  if (name.size() >= PATH_MAX) return;
  for (auto& slot : temporary_names) {
    if (slot.is_taken.exchange(true)) continue;
    std::memcpy(slot.name.data(), name.c_str(), name.size() + 1);
    slot.is_there = true;
    return;
  }
}

void forget_temporary(const std::string& name) {
  for (auto& slot : temporary_names) {
    if (!slot.is_there || name != slot.name.data()) continue;
    slot.is_there = false;
    slot.is_taken = false;
  }
}

/// Text before the process number in the names of this computer's temporary files.
std::string temporary_mark() {
  return std::string(".microslip.").append(system_calls::host_name()).append(".");
}

/// The process that made a temporary file, or 0 if it is none or another computer's.
long process_of(const std::string& name, const std::string& mark) {
  long process = 0;
  const auto at = name.rfind(mark);
  if (at != std::string::npos && name.starts_with('.') && name.ends_with(".tmp"))
    std::from_chars(name.data() + at + mark.size(), name.data() + name.size(), process);
  return process;
}

/// Removes what killed processes have left in a folder; once, as a command may write thousands of files there.
void remove_remains(const std::filesystem::path& folder) {
  static std::mutex busy;
  static std::optional<std::filesystem::path> last;
  const std::scoped_lock lock(busy);
  if (folder == last) return;
  last = folder;
  const auto mark = temporary_mark();
  std::error_code error, ignored;
  const auto searched = folder.empty() ? std::filesystem::path(".") : folder;
  for (std::filesystem::directory_iterator entry(searched, error), end; !error && entry != end;
       entry.increment(error)) {
    const long process = process_of(entry->path().filename().string(), mark);
    if (process > 0 && system_calls::is_dead(process)) std::filesystem::remove(entry->path(), ignored);
  }
}

std::filesystem::path temporary_name(const std::filesystem::path& target, int attempt) {
  std::string name = ".";
  name.append(target.filename().string()).append(temporary_mark()).append(std::to_string(::getpid()));
  if (attempt > 0) name.append("-").append(std::to_string(attempt));
  return target.parent_path() / name.append(".tmp");
}

} // namespace

OutputFile::OutputFile(const std::filesystem::path& path) : path_(path), target_(follow_links(path)) {
  const int named = named_descriptor(path.string());
  if (named >= 0 || is_special(path)) {
    descriptor_ = named >= 0 ? system_calls::duplicate(named) : system_calls::open(path, O_WRONLY);
    if (descriptor_ < 0) fail(errno);
    return;
  }
  std::error_code ignored;
  if (std::filesystem::is_symlink(target_, ignored)) fail(ELOOP);
  remove_remains(target_.parent_path());
  open_temporary();
}

/// A name may be taken by another OutputFile of this process, or by the remains of one with the same number.
void OutputFile::open_temporary() {
  for (int attempt = 0; descriptor_ < 0; ++attempt) {
    temporary_ = temporary_name(target_, attempt);
    descriptor_ = system_calls::open(temporary_, O_WRONLY | O_CREAT | O_EXCL);
    if (descriptor_ < 0 && (errno != EEXIST || attempt == 100)) fail(errno);
  }
  register_temporary(temporary_.string());
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (temporary_.empty()) return;
  std::error_code ignored;
  std::filesystem::remove(temporary_, ignored);
  forget_temporary(temporary_.string());
}

void OutputFile::write(std::string_view bytes) {
  constexpr std::size_t most_bytes = 1 << 30; // of one call on Windows
  while (!bytes.empty()) {
    const auto count = ::write(descriptor_, bytes.data(), static_cast<unsigned>(std::min(bytes.size(), most_bytes)));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(errno);
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

void OutputFile::commit() {
  // Some file systems report a full disk only here.
  if (!temporary_.empty() && system_calls::flush(descriptor_) != 0) fail(errno);
  const int descriptor = descriptor_;
  descriptor_ = -1;
  if (::close(descriptor) != 0) fail(errno);
  if (temporary_.empty()) return;
  if (system_calls::replace(temporary_, target_) != 0) fail(errno);
  forget_temporary(temporary_.string());
  temporary_.clear();
}

void OutputFile::fail(int error_number) const {
  const std::string leads_to = target_ == path_ ? "" : ", a link to " + target_.string();
  throw Error(path_.string() + leads_to + ": cannot be written: " + std::generic_category().message(error_number));
}

void remove_temporary_files() noexcept {
  for (const auto& slot : temporary_names)
    if (slot.is_there) ::unlink(slot.name.data());
}

void require_other_file(const std::filesystem::path& output, const std::filesystem::path& input) {
  std::error_code ignored;
  if (std::filesystem::is_regular_file(output, ignored) && std::filesystem::equivalent(output, input, ignored))
    throw Error(output.string() + ": is the input, which the output would replace; name another file");
}

bool is_same_output(const std::filesystem::path& one, const std::filesystem::path& other) {
  for (const auto* path : {&one, &other})
    if (path->empty() || named_descriptor(path->string()) >= 0 || is_special(*path)) return false;
  const auto target = [](const std::filesystem::path& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(follow_links(path)));
  };
  try {
    return target(one) == target(other);
  } catch (const std::filesystem::filesystem_error&) {
    return false; // opening them says why
  }
}

void require_writable_folder(const std::filesystem::path& path) {
  std::filesystem::path there = path.empty() ? "." : path;
  std::error_code error;
  while (!std::filesystem::exists(there, error) && there.has_relative_path())
    there = there.has_parent_path() ? there.parent_path() : ".";
  error.clear();
  if (!std::filesystem::is_directory(there, error) && !error) error = std::make_error_code(std::errc::not_a_directory);
  if (!error && system_calls::access_folder(there) != 0) error = {errno, std::generic_category()};
  if (error) throw Error(path.string() + ": cannot be made a folder: " + error.message());
}

void require_writable_file(const std::filesystem::path& path) {
  // What is written directly is opened once only: a pipe's reader takes its closing for the end.
  if (std::error_code ignored; is_special(path) && !std::filesystem::is_directory(path, ignored)) return;
  if (named_descriptor(path.string()) < 0) const OutputFile tried(path);
}

void require_writable_file_in(const std::filesystem::path& folder, const std::filesystem::path& name) {
  require_writable_folder(folder);
  if (std::error_code ignored; folder.empty() || std::filesystem::exists(folder, ignored))
    require_writable_file(folder / name);
}

void create_folder(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (!error && !std::filesystem::is_directory(path, error)) error = std::make_error_code(std::errc::not_a_directory);
  if (error) throw Error(path.string() + ": cannot be made a folder: " + error.message());
}

} // namespace microslip::io
