#include "microslip/numerics/populating_allocator.hpp"

#if defined(__linux__)
#include <cstdint>

#include <sys/mman.h>
#include <unistd.h>
#endif

namespace microslip {

void populate([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) noexcept {
#if defined(MADV_POPULATE_WRITE) && !defined(__EMSCRIPTEN__)
  const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
  const auto begin = reinterpret_cast<std::uintptr_t>(memory); // NOLINT: an address
  const auto first = begin - begin % page;
  // Where an older system does not know it, or memory is short, pages come one by one.
  (void)::madvise(reinterpret_cast<void*>(first), begin + bytes - first, MADV_POPULATE_WRITE); // NOLINT: an address
#endif
}

} // namespace microslip
