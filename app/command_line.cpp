#include "app/command_line.hpp"

#include <fstream>

namespace microslip::app {
namespace {

std::string for_shell(const std::string& argument) {
  constexpr auto plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./=+,:@%";
  if (!argument.empty() && argument.find_first_not_of(plain) == std::string::npos) return argument;
  std::string quoted = "'";
  for (const char letter : argument) {
    if (letter == '\'') quoted += "'\\'";
    quoted += letter;
  }
  return quoted + "'";
}

} // namespace

std::string command_line() {
  std::ifstream arguments("/proc/self/cmdline", std::ios::binary);
  std::string line, argument;
  while (std::getline(arguments, argument, '\0')) {
    if (!line.empty()) line += ' ';
    line += for_shell(argument);
  }
  return line;
}

} // namespace microslip::app
