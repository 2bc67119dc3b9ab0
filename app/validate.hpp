#pragma once

#include "app/command.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace microslip::app {

struct ValidateArguments {
  std::vector<std::string> names; ///< of the studies; none: all
  bool list = false;
  std::filesystem::path output = "results";
  std::optional<std::filesystem::path> report; ///< folder
  std::string purpose = {};                    ///< of the report
  std::filesystem::path cases = {};            ///< folder of CONTACT's input files
  int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  bool thorough = false, no_pictures = false, json = false;
};

/// Adds `microslip validate`, whose exit code is what `run` returns.
void add_validate_command(Command& program, int& exit_code, int (*run)(const ValidateArguments& arguments));

/// Goes on as microslip-validate, the program beside this one that has the studies and the vehicle, with the arguments
/// of this one. Throws Error if it is not there.
int go_on_as_studies();
int run_studies_program(const ValidateArguments& arguments);

} // namespace microslip::app
