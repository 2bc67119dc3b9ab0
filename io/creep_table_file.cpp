#include "io/creep_table_file.hpp"

#include "io/output_file.hpp"
#include "io/program_files.hpp"
#include "io/system_calls.hpp"
#include "microslip/error.hpp"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace microslip::io {
namespace {

namespace fs = std::filesystem;

/// A file that is open while its contents are found.
class OpenFile {
public:
  explicit OpenFile(const fs::path& path) : path_(path), descriptor_(system_calls::open(path, O_RDONLY)) {
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
  std::shared_ptr<const void> contents(std::size_t size) const {
    auto bytes = system_calls::contents(descriptor_, size);
    if (!bytes) fail(errno);
    return bytes;
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
  const auto mapped = file.contents(size);
  try {
    return decode({static_cast<const std::byte*>(mapped.get()), size}, mapped);
  } catch (const Error& error) {
    throw Error(path.string() + ": " + error.what());
  }
}

fs::path shipped_creep_table() {
  const fs::path name = "hertz.creep", in_share = "share/microslip/python/microslip";
  const fs::path folder = library_folder();
  std::error_code error;
  // Beside the Python module; of a library in lib, in lib/x86_64-linux-gnu.
  for (const fs::path& file :
       {folder / name, folder.parent_path() / in_share / name, folder.parent_path().parent_path() / in_share / name})
    if (fs::exists(file, error)) return file;
  return python_folder() / "microslip" / name;
}

CreepTableSource creep_table_source(const fs::path& path) {
  const fs::path shipped = shipped_creep_table();
  std::error_code ignored;
  if (path != shipped && !fs::equivalent(path, shipped, ignored)) return read_creep_table(path);
  static const CreepTableSource source = read_creep_table(shipped);
  return source;
}

fs::path creep_table_or_shipped(const fs::path& asked) {
  return asked.empty() ? shipped_creep_table() : asked;
}

void write_creep_table(const CreepTableNodes& nodes, const fs::path& path) {
  OutputFile file(path);
  write_creep_table(nodes, file);
}

void write_creep_table(const CreepTableNodes& nodes, OutputFile& file) {
  const auto bytes = encode(nodes);
  file.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()}); // NOLINT: bytes are bytes
  file.commit();
}

} // namespace microslip::io
