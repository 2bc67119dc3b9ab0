#include "app/child_process.hpp"

#include <cerrno>
#include <string_view>

#include <io.h>
#include <windows.h>

namespace microslip {
namespace {

/// As the C library of a child takes its command line apart: quotes and the strokes before them are escaped.
std::string quoted(std::string_view argument) {
  std::string text = "\"";
  std::size_t strokes = 0;
  for (const char c : argument) {
    if (c == '"') text.append(strokes + 1, '\\');
    strokes = c == '\\' ? strokes + 1 : 0;
    text += c;
  }
  return text.append(strokes, '\\').append("\"");
}

HANDLE inherited(std::FILE* file) {
  const auto handle = reinterpret_cast<HANDLE>(::_get_osfhandle(::_fileno(file)));
  ::SetHandleInformation(handle, HANDLE_FLAG_INHERIT, HANDLE_FLAG_INHERIT);
  return handle;
}

} // namespace

std::vector<std::string> environment_variables() {
  std::vector<std::string> variables;
  char* const all = ::GetEnvironmentStringsA();
  for (const char* variable = all; *variable != '\0'; variable += variables.back().size() + 1)
    variables.emplace_back(variable);
  ::FreeEnvironmentStringsA(all);
  return variables;
}

int run_child(std::vector<std::string> arguments, std::vector<std::string> environment, std::FILE* output,
              std::FILE* errors) {
  std::string line, variables;
  for (const auto& argument : arguments) line.append(line.empty() ? "" : " ").append(quoted(argument));
  for (const auto& variable : environment) variables.append(variable).push_back('\0');
  STARTUPINFOA start{};
  start.cb = sizeof start;
  start.dwFlags = STARTF_USESTDHANDLES;
  start.hStdOutput = inherited(output);
  start.hStdError = inherited(errors);
  PROCESS_INFORMATION child{};
  if (!::CreateProcessA(nullptr, line.data(), nullptr, nullptr, TRUE, 0, variables.data(), nullptr, &start, &child))
    return ::GetLastError() == ERROR_FILE_NOT_FOUND ? -ENOENT : -EACCES;
  ::WaitForSingleObject(child.hProcess, INFINITE);
  DWORD code = 0;
  ::GetExitCodeProcess(child.hProcess, &code);
  ::CloseHandle(child.hThread);
  ::CloseHandle(child.hProcess);
  return static_cast<int>(code);
}

} // namespace microslip
