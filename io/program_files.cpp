#include "io/program_files.hpp"

#include <system_error>

#ifdef _WIN32
#include <windows.h>
#else
#include <dlfcn.h>
#endif

namespace microslip::io {

namespace fs = std::filesystem;

fs::path program_file() {
#ifdef _WIN32
  wchar_t name[MAX_PATH];
  const DWORD length = GetModuleFileNameW(nullptr, name, MAX_PATH);
  return length < MAX_PATH ? fs::path(name, name + length) : fs::path();
#else
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error);
#endif
}

fs::path library_folder() {
#ifdef _WIN32
  return program_file().parent_path(); // there is no Python module
#else
  Dl_info here = {};
  const bool is_known =
      ::dladdr(reinterpret_cast<const void*>(&library_folder), &here) != 0; // NOLINT: as dladdr wants it
  return is_known && here.dli_fname != nullptr ? fs::path(here.dli_fname).parent_path() : fs::path();
#endif
}

fs::path python_folder() {
  const fs::path above = program_file().parent_path().parent_path();
  std::error_code error;
  return fs::exists(above / "__init__.py", error) ? above.parent_path() : above / "share/microslip/python";
}

fs::path explorer_page() {
  return program_file().parent_path().parent_path() / "share/microslip/explorer/index.html";
}

} // namespace microslip::io
