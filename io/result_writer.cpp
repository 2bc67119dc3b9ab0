#include "io/result_writer.hpp"

#include "microslip/version.hpp"

#include <chrono>
#include <ctime>

namespace microslip::io {
namespace {

std::string now() {
  const auto time = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm parts{};
#ifdef _WIN32
  gmtime_s(&parts, &time);
#else
  gmtime_r(&time, &parts);
#endif
  char text[32];
  const auto length = std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return {text, length};
}

} // namespace

std::vector<std::pair<std::string, std::string>> provenance_attributes(const Provenance& provenance) {
  const BuildInfo build = build_info();
  return {{"format", std::to_string(result_format)},
          {"kind", provenance.kind},
          {"title", provenance.title},
          {"version", std::string(build.version)},
          {"commit", std::string(build.commit)},
          {"compiler", std::string(build.compiler)},
          {"build_type", std::string(build.build_type)},
          {"created", now()},
          {"command_line", provenance.command_line},
          {"case_file", provenance.case_file},
          {"case_text", provenance.case_text}};
}

} // namespace microslip::io
