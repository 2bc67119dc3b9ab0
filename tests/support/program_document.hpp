#pragma once

#include "io/json.hpp"
#include "tests/support/program_run.hpp"

#include <gtest/gtest.h>

namespace microslip {

/// The document that a command prints with --json.
inline io::Json program_document(const TemporaryFolder& folder, const std::string& command) {
  const Outcome outcome = run_program(folder, command + " --json");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  return io::Json::parse(outcome.output);
}

} // namespace microslip
