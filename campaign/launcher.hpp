#pragma once

#include <array>
#include <cstdlib>

namespace microslip::campaign {

/// Returns whether this process is one of several that Open MPI's mpirun, another one's, or Slurm with PMI has started.
inline bool has_launcher() {
  constexpr std::array marks = {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"};
  for (const char* mark : marks)
    if (std::getenv(mark) != nullptr) return true;
  return false;
}

} // namespace microslip::campaign
