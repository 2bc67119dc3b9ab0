#include "app/command_line.hpp"
#include "app/windows_text.hpp"

#include <windows.h>

namespace microslip::app {

std::string command_line() {
  return utf8(::GetCommandLineW());
}

} // namespace microslip::app
