#pragma once

#include <cstdint>
#include <string_view>

namespace microslip::campaign {

/// FNV-1a of 64 bits, continued from `start`: tells texts apart and finds damaged bytes; no defence against forgers.
constexpr std::uint64_t hash_of(std::string_view bytes, std::uint64_t start = 0xcbf29ce484222325) {
  std::uint64_t hash = start;
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
  return hash;
}

} // namespace microslip::campaign
