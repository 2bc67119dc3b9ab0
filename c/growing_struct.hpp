#pragma once

#include "c/guarded_call.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <type_traits>

namespace microslip::c {

/// Structs that begin with the size that the caller knows them by. A caller with an older header knows fewer fields,
/// one with a newer header more; zero stands for the behaviour of a library that does not know a field.
template <class Struct>
constexpr bool is_growing_struct = std::is_trivially_copyable_v<Struct>&& std::is_standard_layout_v<Struct>&&
                                       offsetof(Struct, struct_size) == 0;

/// Largest plausible size; a larger one was never set [bytes].
constexpr std::size_t largest_struct = 4096;

/// Throws Refusal unless `size` covers `oldest` bytes, which is what the first version of the struct had.
inline void require_struct_size(std::string_view name, std::size_t size, std::size_t oldest) {
  if (size >= oldest && size <= largest_struct) return;
  throw Refusal(MICROSLIP_WRONG_SIZE, std::string(name) + ".struct_size = " + std::to_string(size) +
                                          " [bytes]: must be sizeof the struct; was it initialised?");
}

/// The caller's struct as this library knows it: fields that the caller does not know are zero. Throws Refusal if
/// fields that this library does not know are not zero.
template <class Struct>
Struct read_growing(std::string_view name, const Struct* given, std::size_t oldest = sizeof(Struct)) {
  static_assert(is_growing_struct<Struct>);
  const std::size_t size = require_pointer(name, given)->struct_size;
  require_struct_size(name, size, oldest);
  const auto* bytes = reinterpret_cast<const unsigned char*>(given);
  const bool known = std::all_of(bytes + std::min(size, sizeof(Struct)), bytes + size, [](auto b) { return b == 0; });
  if (!known)
    throw Refusal(MICROSLIP_INVALID_OPTION,
                  std::string(name) + " has fields that version " + microslip_version() + " does not know");
  Struct value{};
  std::memcpy(&value, bytes, std::min(size, sizeof(Struct)));
  return value;
}

/// Copies as many bytes of `value` as a struct of `size` bytes has, clears the rest of it, and sets its size.
template <class Struct>
void write_growing(std::string_view name, Struct value, Struct* target, std::size_t size,
                   std::size_t oldest = sizeof(Struct)) {
  static_assert(is_growing_struct<Struct>);
  require_pointer(name, target);
  require_struct_size(name, size, oldest);
  value.struct_size = size;
  auto* bytes = reinterpret_cast<unsigned char*>(target);
  const std::size_t shared = std::min(size, sizeof(Struct));
  std::memcpy(bytes, &value, shared);
  std::memset(bytes + shared, 0, size - shared);
}

} // namespace microslip::c
