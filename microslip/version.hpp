#pragma once

#include <string_view>

namespace microslip {

/// Source of this build of the library: for results that can be traced.
struct BuildInfo {
  std::string_view version;    ///< e.g. "1.0.0"
  std::string_view commit;     ///< short hash, with "-dirty" if there were changes; "unknown" outside a repository
  std::string_view compiler;   ///< name and version
  std::string_view build_type; ///< e.g. "Release"
};

BuildInfo build_info();

} // namespace microslip
