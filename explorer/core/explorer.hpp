#pragma once

#include "explorer/core/kept_files.hpp"
#include "explorer/core/nips.hpp"
#include "explorer/core/request.hpp"
#include "explorer/core/wheel_models.hpp"
#include "io/creep_tables.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace microslip::explorer {

/// What the page of the explorer asks: text in, text out, both JSON. docs/explorer.md describes the calls.
///
/// Keeps files, models of wheels on rails, solvers of nips and creep-force tables from one call to the next.
class Explorer {
public:
  /// Files of requests are written to this folder, which has to be there; empty: the current one.
  explicit Explorer(const std::filesystem::path& folder = {});

  /// `{"result": ..., "time": seconds}`, or `{"error": {"message": ...}}` with the words of the reader that refuses.
  /// Throws nothing.
  std::string answer(std::string_view request);

private:
  io::Json call(const Request& request);
  io::Json solve(const Request& request);
  io::Json inputs(const Request& request);
  io::Json radii(const Request& request);
  io::Json creep_curve(const Request& request);
  io::Json transient(const Request& request);
  io::Json nip(const Request& request);
  io::Json nip_curve(const Request& request);
  io::Json profile(const Request& request);
  io::Json conicity(const Request& request);
  io::Json description(const Request& request);
  io::Json version(const Request& request);

  void take_files(const Request& request);

  KeptFiles files_;
  std::string case_name_; ///< of cases in messages, and where the paths of their profiles start
  io::CreepTables tables_;
  WheelModels models_;
  Nips nips_;
};

} // namespace microslip::explorer
