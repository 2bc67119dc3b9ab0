#include "microslip/version.hpp"

#include "microslip_build.hpp"

namespace microslip {

BuildInfo build_info() {
  return {MICROSLIP_BUILD_VERSION, MICROSLIP_BUILD_COMMIT, MICROSLIP_BUILD_COMPILER, MICROSLIP_BUILD_TYPE};
}

} // namespace microslip
