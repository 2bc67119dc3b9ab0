#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace microslip {

/// Asks the system to give the pages of some memory all at once, where it can do so (Linux). One by one, as they are
/// first written to, megabytes of them cost more than filling them, on virtual machines ten times as much. Contents
/// stay as they are.
void populate(void* memory, std::size_t bytes) noexcept;

/// Allocator of large arrays that are filled as soon as they are allocated.
template <class Value> struct PopulatingAllocator : std::allocator<Value> {
  template <class Other> struct rebind { using other = PopulatingAllocator<Other>; };
  Value* allocate(std::size_t count) {
    Value* const memory = std::allocator<Value>::allocate(count);
    populate(memory, count * sizeof(Value));
    return memory;
  }
};

template <class Value> using PopulatedVector = std::vector<Value, PopulatingAllocator<Value>>;

} // namespace microslip
