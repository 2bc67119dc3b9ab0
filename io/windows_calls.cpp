#include "io/system_calls.hpp"

#include <algorithm>
#include <cerrno>
#include <cstddef>

#include <fcntl.h>
#include <io.h>
#include <sys/stat.h>
#include <windows.h>

namespace microslip::io::system_calls {

int open(const std::filesystem::path& path, int flags) {
  return ::_wopen(path.c_str(), flags | _O_BINARY | _O_NOINHERIT, _S_IREAD | _S_IWRITE);
}

int duplicate(int descriptor) {
  return ::_dup(descriptor);
}

int flush(int descriptor) {
  return ::_commit(descriptor);
}

int replace(const std::filesystem::path& from, const std::filesystem::path& to) {
  if (::MoveFileExW(from.c_str(), to.c_str(), MOVEFILE_REPLACE_EXISTING)) return 0;
  errno = ::GetLastError() == ERROR_ACCESS_DENIED ? EACCES : EIO;
  return -1;
}

int access_folder(const std::filesystem::path& folder) {
  return ::_waccess(folder.c_str(), 2); // may be written
}

std::shared_ptr<const void> contents(int descriptor, std::size_t size) {
  const std::shared_ptr<std::byte[]> bytes(new std::byte[size]);
  for (std::size_t done = 0; done < size;) {
    const auto wanted = static_cast<unsigned>(std::min<std::size_t>(size - done, 1 << 30));
    const int count = ::_read(descriptor, bytes.get() + done, wanted);
    if (count <= 0) return nullptr;
    done += static_cast<std::size_t>(count);
  }
  return bytes;
}

std::string host_name() {
  char name[MAX_COMPUTERNAME_LENGTH + 1];
  DWORD length = sizeof name;
  return ::GetComputerNameA(name, &length) ? std::string(name, length) : "";
}

bool is_dead(long process) {
  const HANDLE handle = ::OpenProcess(PROCESS_QUERY_LIMITED_INFORMATION, FALSE, static_cast<DWORD>(process));
  if (handle == nullptr) return ::GetLastError() == ERROR_INVALID_PARAMETER;
  DWORD code = STILL_ACTIVE;
  const bool is_known = ::GetExitCodeProcess(handle, &code);
  ::CloseHandle(handle);
  return is_known && code != STILL_ACTIVE;
}

} // namespace microslip::io::system_calls
