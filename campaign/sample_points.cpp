#include "campaign/sample_points.hpp"

#include "campaign/hash.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include <boost/random/sobol.hpp>

namespace microslip::campaign {
namespace {

constexpr std::size_t digits = 31; ///< binary ones of a point's number

/// SplitMix64 (Steele, Lea and Flood 2014): numbers by their index, without a state.
std::uint64_t scrambled(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

/// In [0, 1).
double fraction(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

std::uint64_t random_bits(std::uint64_t stream, std::size_t point) {
  return scrambled(stream + point * 0x9e3779b97f4a7c15);
}

/// Where `place` goes in a random order of 0 to count - 1: four rounds of Feistel's network on numbers of as many
/// binary digits as count - 1 has, or one more, and again until the result is one of them.
std::size_t shuffled(std::size_t place, std::size_t count, std::uint64_t stream) {
  const int half = std::max(1, (static_cast<int>(std::bit_width(count - 1)) + 1) / 2);
  const std::uint64_t mask = (std::uint64_t{1} << half) - 1;
  do {
    std::uint64_t high = place >> half, low = place & mask;
    for (std::uint64_t round = 0; round < 4; ++round)
      high = std::exchange(low, high ^ (scrambled(low ^ scrambled(stream + round)) & mask));
    place = high << half | low;
  } while (place >= count);
  return place;
}

} // namespace

SamplePoints::SamplePoints(PointSet set, std::size_t count, std::uint64_t seed, std::span<const std::string> names)
    : set_(set), count_(count) {
  for (const std::string& name : names) streams_.push_back(scrambled(hash_of(name) ^ scrambled(seed)));
  if (set_ == PointSet::sobol) make_directions();
}

/// The engine goes through the sequence by Gray's code, from point 1 on: 2^(d+1) - 1 is the direction number of digit
/// d.
void SamplePoints::make_directions() {
  boost::random::sobol engine(streams_.size());
  directions_.resize(digits * streams_.size());
  for (std::size_t d = 0; d < digits; ++d) {
    engine.seed((std::uint64_t{1} << (d + 1)) - 2);
    for (std::size_t k = 0; k < streams_.size(); ++k) directions_[k * digits + d] = engine();
  }
}

std::uint64_t SamplePoints::sobol_digits(std::size_t point, std::size_t k) const {
  std::uint64_t bits = scrambled(streams_[k]);
  for (std::size_t d = 0; point >> d != 0; ++d)
    if (point >> d & 1) bits ^= directions_[k * digits + d];
  return bits;
}

double SamplePoints::at(std::size_t point, std::size_t k) const {
  if (set_ == PointSet::sobol) return fraction(sobol_digits(point, k));
  const double random = fraction(random_bits(streams_[k], point));
  if (set_ == PointSet::random) return random;
  const double part =
      (static_cast<double>(shuffled(point, count_, streams_[k])) + random) / static_cast<double>(count_);
  return std::min(part, 1 - 0x1p-53);
}

} // namespace microslip::campaign
