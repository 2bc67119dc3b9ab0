#pragma once

#include <string>
#include <vector>

namespace microslip::app {

/// How a module of the Python package has ended.
struct PythonRun {
  int code = 0;                                        ///< as run_child returns it
  std::vector<std::string> output = {}, messages = {}; ///< lines of its output and errors

  /// Message of the module on its input, without its name; else empty.
  std::string said_of_input(const std::string& module) const;
};

/// Python: what the environment variable MICROSLIP_PYTHON names, or the one found at build time.
std::string python();

/// Runs `python -m MODULE` with the package where Python looks first. Throws Error if temporary files cannot be made,
/// Interrupted as run_child.
PythonRun run_python_module(const std::string& module, const std::vector<std::string>& arguments);

} // namespace microslip::app
