#include "app/machine.hpp"

#include <fstream>
#include <thread>

#include <fmt/format.h>

#ifndef _WIN32
#include <sys/utsname.h>
#endif

namespace microslip::app {
namespace {

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name"))
      if (const auto at = line.find(": "); at != std::string::npos) return line.substr(at + 2);
  return "unknown processor";
}

std::string operating_system() {
#ifdef _WIN32
  return "Windows";
#else
  utsname name = {};
  if (uname(&name) != 0) return "unknown system";
  return fmt::format("{} {} {}", name.sysname, name.release, name.machine);
#endif
}

} // namespace

std::string machine() {
  return fmt::format("{}, {} threads, {}", processor(), std::thread::hardware_concurrency(), operating_system());
}

} // namespace microslip::app
