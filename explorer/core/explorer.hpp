#pragma once

#include "explorer/core/kept_files.hpp"
#include "explorer/core/request.hpp"
#include "explorer/core/wheel_models.hpp"
#include "io/creep_tables.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace microslip {

/// What the page of the explorer asks: text in, text out, both JSON. docs/explorer.md describes the calls.
///
/// Keeps files, models of wheels on rails and creep-force tables from one call to the next.
class Explorer {
public:
  /// Files of requests are written to this folder, which has to be there; empty: the current one.
  explicit Explorer(const std::filesystem::path& folder = {});

  /// `{"result": ..., "time": seconds}`, or `{"error": {"message": ...}}` with the words of the reader that refuses.
  /// Throws nothing.
  std::string answer(std::string_view request);

private:
  Json call(const Request& request);
  Json solve(const Request& request);
  Json inputs(const Request& request);
  Json radii(const Request& request);
  Json creep_curve(const Request& request);
  Json transient(const Request& request);
  Json profile(const Request& request);
  Json conicity(const Request& request);
  Json version(const Request& request);

  void take_files(const Request& request);

  KeptFiles files_;
  std::string case_name_; ///< of cases in messages, and where the paths of their profiles start
  CreepTables tables_;
  WheelModels models_;
};

} // namespace microslip
