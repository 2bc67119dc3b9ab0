#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace microslip::campaign {

/// How the points of a sample fill the cube [0, 1)^n, in the order of their words in files.
enum class PointSet {
  random,          ///< independent of each other
  latin_hypercube, ///< of each coordinate one in each of `count` equal parts (McKay, Beckman and Conover 1979)
  sobol            ///< Sobol's sequence with Joe and Kuo's numbers (2008), shifted at random digit by digit
};

/// Points in [0, 1)^n whose coordinates have names; each is known from its number alone, on every machine alike.
/// Coordinates depend on seed and name, of Sobol's sequence on their place, too.
class SamplePoints {
public:
  /// At most 2^31 points and 1,000 coordinates.
  SamplePoints(PointSet set, std::size_t count, std::uint64_t seed, std::span<const std::string> names);

  /// Coordinate `k` of a point. Cost: some nanoseconds.
  double at(std::size_t point, std::size_t k) const;

private:
  void make_directions();
  std::uint64_t sobol_digits(std::size_t point, std::size_t k) const;

  PointSet set_;
  std::size_t count_;
  std::vector<std::uint64_t> streams_;    ///< of random numbers, one for each coordinate
  std::vector<std::uint64_t> directions_; ///< Sobol's direction numbers, one for each binary digit of a coordinate
};

} // namespace microslip::campaign
