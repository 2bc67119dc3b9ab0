#include "io/creep_table_file.hpp"

#include "io/output_file.hpp"
#include "microslip/error.hpp"

#include <cerrno>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace microslip {
namespace {

namespace fs = std::filesystem;

/// A file that is open while it is mapped.
class OpenFile {
public:
  explicit OpenFile(const fs::path& path) : path_(path), descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (descriptor_ < 0) fail(errno);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() { ::close(descriptor_); }

  std::size_t size() const {
    struct stat status = {};
    if (::fstat(descriptor_, &status) != 0) fail(errno);
    if (!S_ISREG(status.st_mode)) throw Error(path_.string() + ": is no file");
    return static_cast<std::size_t>(status.st_size);
  }
  std::shared_ptr<const void> map(std::size_t size) const {
    void* const at = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, descriptor_, 0);
    if (at == MAP_FAILED) fail(errno); // NOLINT: the system's macro
    return {at, [size](const void* mapped) { ::munmap(const_cast<void*>(mapped), size); }};
  }

private:
  [[noreturn]] void fail(int error) const {
    throw Error(path_.string() + ": cannot be read: " + std::generic_category().message(error));
  }

  fs::path path_;
  int descriptor_;
};

} // namespace

CreepTableNodes read_creep_table(const fs::path& path) {
  const OpenFile file(path);
  const std::size_t size = file.size();
  if (size == 0) throw Error(path.string() + ": is empty, no creep-force table");
  const auto mapped = file.map(size);
  try {
    return decode({static_cast<const std::byte*>(mapped.get()), size}, mapped);
  } catch (const Error& error) {
    throw Error(path.string() + ": " + error.what());
  }
}

fs::path shipped_creep_table() {
  std::error_code error;
  const auto program = fs::read_symlink("/proc/self/exe", error);
  return program.parent_path().parent_path() / "share/microslip/python/microslip/hertz.creep";
}

void write_creep_table(const CreepTableNodes& nodes, const fs::path& path) {
  const auto bytes = encode(nodes);
  OutputFile file(path);
  file.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()}); // NOLINT: bytes are bytes
  file.commit();
}

} // namespace microslip
