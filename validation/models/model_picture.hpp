#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace microslip::validation {

/// One error of several models: for each the numbers of some series.
struct ModelPanel {
  std::string title; ///< what the error is of, and over what
  std::vector<std::string> series;
  struct Row {
    std::string name;
    std::vector<double> values; ///< of each series, > 0; NaN where there is none
  };
  std::vector<Row> rows;
};

/// Writes them for the pictures of the kind `models`. Throws Error if the file cannot be written.
void write_model_panels(const std::filesystem::path& file, const std::string& title, const std::string& command_line,
                        const std::vector<ModelPanel>& panels);

} // namespace microslip::validation
