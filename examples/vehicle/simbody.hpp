#pragma once

#include <concepts>

/// Simbody's headers are of C++11: from C++20 on, a == b of two of its indices is ambiguous, as it may be turned round.
/// A better match decides, which must stand before them.
namespace SimTK {

template <class Index>
requires requires(Index& index) {
  index.invalidate();
  { index.isValid() } -> std::same_as<bool>;
  static_cast<int>(index);
}
bool operator==(const Index& a, const Index& b) {
  return static_cast<int>(a) == static_cast<int>(b);
}

} // namespace SimTK

#include <Simbody.h>
