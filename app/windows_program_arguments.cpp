#include "app/program_arguments.hpp"
#include "app/windows_text.hpp"
#include "microslip/error.hpp"

#include <algorithm>

#include <windows.h>

#include <shellapi.h>

namespace microslip::app {

// What `main` is given is in the computer's code page, which lacks most letters. The compiler's library takes names of
// files byte by byte: those beyond ASCII would name other files.
std::vector<std::string> program_arguments(int, char**) {
  ::SetConsoleOutputCP(CP_UTF8);
  int count = 0;
  wchar_t** const all = ::CommandLineToArgvW(::GetCommandLineW(), &count);
  std::vector<std::string> arguments;
  for (int i = 1; i < count; ++i) arguments.push_back(utf8(all[i]));
  ::LocalFree(static_cast<void*>(all));
  for (const std::string& argument : arguments)
    if (std::any_of(argument.begin(), argument.end(), [](unsigned char byte) { return byte > 127; }))
      throw Error(argument +
                  ": arguments have letters of ASCII only on Windows; go to the folder of such a file first");
  return arguments;
}

} // namespace microslip::app
