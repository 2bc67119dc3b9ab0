#include "io/output_file.hpp"

#include "microslip/error.hpp"

#include <cerrno>
#include <charconv>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace microslip {
namespace {

constexpr mode_t permissions = 0666; // the user's mask takes its part away

std::filesystem::path follow_links(const std::filesystem::path& path) {
  std::error_code error;
  const auto target = std::filesystem::canonical(path, error);
  return error ? path : target;
}

/// The descriptor that a name such as /dev/stdout stands for, or -1. To open the name again would lose the place where
/// others write.
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

std::filesystem::path temporary_name(const std::filesystem::path& target, int attempt) {
  std::string name = ".";
  name.append(target.filename().string()).append(".").append(std::to_string(::getpid()));
  if (attempt > 0) name.append("-").append(std::to_string(attempt));
  return target.parent_path() / name.append(".tmp");
}

} // namespace

OutputFile::OutputFile(const std::filesystem::path& path) : path_(path), target_(follow_links(path)) {
  const int named = named_descriptor(path.string());
  if (named >= 0 || is_special(path)) {
    descriptor_ = named >= 0 ? ::fcntl(named, F_DUPFD_CLOEXEC, 0) : ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail(errno);
    return;
  }
  // A name may be taken by the remains of a killed program that had the same process number.
  for (int attempt = 0; descriptor_ < 0; ++attempt) {
    temporary_ = temporary_name(target_, attempt);
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, permissions);
    if (descriptor_ < 0 && (errno != EEXIST || attempt == 100)) fail(errno);
  }
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void OutputFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const auto count = ::write(descriptor_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(errno);
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

void OutputFile::commit() {
  // Some file systems report a full disk only here.
  if (!temporary_.empty() && ::fsync(descriptor_) != 0) fail(errno);
  const int descriptor = descriptor_;
  descriptor_ = -1;
  if (::close(descriptor) != 0) fail(errno);
  if (temporary_.empty()) return;
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  temporary_.clear();
}

void OutputFile::fail(int error_number) const {
  throw Error(path_.string() + ": cannot be written: " + std::generic_category().message(error_number));
}

void create_folder(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (!error && !std::filesystem::is_directory(path, error)) error = std::make_error_code(std::errc::not_a_directory);
  if (error) throw Error(path.string() + ": cannot be made a folder: " + error.message());
}

} // namespace microslip
