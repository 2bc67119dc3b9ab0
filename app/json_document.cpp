#include "app/json_document.hpp"

#include "app/command_line.hpp"
#include "io/result_writer.hpp"
#include "microslip/version.hpp"

#include <cstdio>

#include <fmt/format.h>

namespace microslip::app {

void add_json_flag(Command& command, bool& json) {
  command.add_flag("--json", json, "print one JSON document instead of the text");
}

io::Json json_document(const std::string& kind) {
  const auto build = build_info();
  return {{"format", std::to_string(io::result_format)},
          {"kind", kind},
          {"version", build.version},
          {"commit", build.commit},
          {"compiler", build.compiler},
          {"build_type", build.build_type},
          {"command_line", command_line()}};
}

void print_json(const io::Json& document) {
  fmt::print("{}", io::json_text(document));
  std::fflush(stdout);
}

} // namespace microslip::app
