// Without MPI.

#include "campaign/launcher.hpp"
#include "campaign/ranks.hpp"
#include "microslip/error.hpp"

namespace microslip::campaign {

std::unique_ptr<Ranks> launched_ranks() {
  if (has_launcher())
    throw Error(
        "this microslip was built without MPI; start it without mpirun, on threads, or build it where Open MPI is");
  return std::make_unique<Ranks>();
}

} // namespace microslip::campaign
