#include "io/system_calls.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace microslip::io::system_calls {

int open(const std::filesystem::path& path, int flags) {
  return ::open(path.c_str(), flags | O_CLOEXEC, 0666);
}

int duplicate(int descriptor) {
  return ::fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
}

int flush(int descriptor) {
  return ::fsync(descriptor);
}

int replace(const std::filesystem::path& from, const std::filesystem::path& to) {
  return std::rename(from.c_str(), to.c_str());
}

int access_folder(const std::filesystem::path& folder) {
  return ::access(folder.c_str(), W_OK | X_OK);
}

std::shared_ptr<const void> contents(int descriptor, std::size_t size) {
  void* const at = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, descriptor, 0);
  if (at == MAP_FAILED) return nullptr; // NOLINT: the system's macro
  return {at, [size](const void* mapped) { ::munmap(const_cast<void*>(mapped), size); }};
}

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

bool is_dead(long process) {
  return ::kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH;
}

} // namespace microslip::io::system_calls
