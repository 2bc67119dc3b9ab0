#include "app/child_process.hpp"
#include "app/interrupt.hpp"
#include "app/windows_text.hpp"

#include <cerrno>
#include <cstdint>
#include <string_view>
#include <utility>

#include <io.h>
#include <windows.h>

#include <shellapi.h>

namespace microslip::app {
namespace {

/// Word as a child's C library parses its command line: quotes and the backslashes before them are escaped.
std::string command_line_word(std::string_view argument) {
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

/// Starts a program that its command line names, or `file`, with its output and errors there, and waits. As run_child.
int run(const wchar_t* file, std::wstring line, wchar_t* environment, std::FILE* output, std::FILE* errors) {
  STARTUPINFOW start{};
  start.cb = sizeof start;
  start.dwFlags = STARTF_USESTDHANDLES;
  start.hStdOutput = inherited(output);
  start.hStdError = inherited(errors);
  PROCESS_INFORMATION child{};
  constexpr DWORD how = CREATE_UNICODE_ENVIRONMENT;
  if (!::CreateProcessW(file, line.data(), nullptr, nullptr, TRUE, how, environment, nullptr, &start, &child))
    return ::GetLastError() == ERROR_FILE_NOT_FOUND ? -ENOENT : -EACCES;
  ::WaitForSingleObject(child.hProcess, INFINITE);
  DWORD code = 0;
  ::GetExitCodeProcess(child.hProcess, &code);
  ::CloseHandle(child.hThread);
  ::CloseHandle(child.hProcess);
  InterruptGuard::throw_if_interrupted();
  return static_cast<int>(code);
}

} // namespace

std::vector<std::string> environment_variables() {
  std::vector<std::string> variables;
  wchar_t* const all = ::GetEnvironmentStringsW();
  for (std::wstring_view variable = all; !variable.empty(); variable = variable.data() + variable.size() + 1)
    variables.push_back(utf8(variable));
  ::FreeEnvironmentStringsW(all);
  return variables;
}

int run_child(std::vector<std::string> arguments, std::vector<std::string> environment, std::FILE* output,
              std::FILE* errors) {
  std::wstring line, variables;
  for (const auto& argument : arguments)
    line.append(line.empty() ? L"" : L" ").append(wide(command_line_word(argument)));
  for (const auto& variable : environment) variables.append(wide(variable)).push_back(L'\0');
  return run(nullptr, std::move(line), variables.data(), output, errors);
}

int go_on_as(const std::filesystem::path& program) {
  return run(program.c_str(), ::GetCommandLineW(), nullptr, stdout, stderr);
}

void end_child() noexcept {} // the console tells it as well

bool open_in_browser(const std::string& address) {
  const auto code = ::ShellExecuteW(nullptr, L"open", wide(address).c_str(), nullptr, nullptr, SW_SHOWNORMAL);
  return reinterpret_cast<std::intptr_t>(code) > 32; // as the call says that it worked
}

} // namespace microslip::app
