#include "microslip/table/creep_table_nodes.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <type_traits>

namespace microslip {
namespace {

constexpr std::array<char, 8> magic = {'M', 'S', 'C', 'R', 'E', 'E', 'P', '\n'};
constexpr std::uint32_t byte_order = 0x01020304, version = 2;
constexpr std::size_t most_materials = 8;

/// The head of a file, of numbers of fixed size at fixed offsets.
struct Head {
  std::array<char, 8> magic;
  std::uint32_t byte_order, version;
  std::uint32_t materials, ratios, levels, elevations, azimuths, elements;
  std::int64_t solved, not_converged;
  double least_ratio, largest_ratio;
  std::array<double, most_materials> poisson_ratios;
  std::array<double, creep_channels> unit;
  std::array<double, 3> error_rms, error_worst;
  std::array<char, 280> reserved; ///< zero
  std::uint64_t data_checksum, head_checksum;
};
static_assert(sizeof(Head) == 512 && std::is_trivially_copyable_v<Head>);

/// FNV-1a, on eight bytes at a time: not against malice, but against broken files.
std::uint64_t checksum(std::span<const std::byte> bytes) {
  std::uint64_t sum = 0xcbf29ce484222325;
  const auto add = [&](std::uint64_t word) {
    sum = (sum ^ word) * 0x100000001b3;
    sum ^= sum >> 32;
  };
  std::size_t i = 0;
  for (; i + 8 <= bytes.size(); i += 8) {
    std::uint64_t word;
    std::memcpy(&word, &bytes[i], 8);
    add(word);
  }
  for (; i < bytes.size(); ++i) add(std::to_integer<std::uint64_t>(bytes[i]));
  return sum;
}

/// Checksum of all of the head before it.
std::uint64_t checksum(const Head& head) {
  return checksum(std::as_bytes(std::span(&head, 1)).first(sizeof head - sizeof head.head_checksum));
}

Head head_of(std::span<const std::byte> bytes) {
  Head head;
  if (bytes.size() < sizeof head)
    throw Error("is no creep-force table: it has " + std::to_string(bytes.size()) + " bytes");
  std::memcpy(&head, bytes.data(), sizeof head);
  if (head.magic != magic) throw Error("is no creep-force table");
  if (head.byte_order != byte_order)
    throw Error("was written with another byte order than this machine's: make it here, microslip table make");
  if (head.version != version)
    throw Error("is of version " + std::to_string(head.version) + "; this program reads version " +
                std::to_string(version) + ": make it again, microslip table make");
  if (head.head_checksum != checksum(head)) throw Error("is corrupted: the checksum of its head is wrong");
  return head;
}

CreepTableAxes axes_of(const Head& head) {
  if (head.materials > most_materials) throw Error("is corrupted: it has too many Poisson's ratios");
  CreepTableAxes axes = {.least_ratio = head.least_ratio,
                         .largest_ratio = head.largest_ratio,
                         .ratios = static_cast<int>(head.ratios),
                         .poisson_ratios = {head.poisson_ratios.begin(), head.poisson_ratios.begin() + head.materials},
                         .levels = static_cast<int>(head.levels),
                         .elevations = static_cast<int>(head.elevations),
                         .azimuths = static_cast<int>(head.azimuths)};
  check(axes);
  return axes;
}

} // namespace

CreepTableNodes quantised(const CreepTableAxes& axes, const CreepTableOrigin& origin, std::span<const double> numbers) {
  check(axes);
  const std::size_t size = axes.blocks() * axes.nodes() * creep_channels;
  if (numbers.size() != size)
    throw Error("a creep-force table with these axes has " + std::to_string(size) + " numbers");
  CreepTableNodes nodes = {.axes = axes, .origin = origin};
  for (std::size_t i = 0; i < size; ++i)
    nodes.unit[i % creep_channels] = std::max(nodes.unit[i % creep_channels], std::abs(numbers[i]) / 32000);
  auto values = std::make_shared<std::vector<std::int16_t>>(size);
  for (std::size_t i = 0; i < size; ++i) {
    const double unit = nodes.unit[i % creep_channels];
    (*values)[i] = unit > 0 ? static_cast<std::int16_t>(std::lround(numbers[i] / unit)) : std::int16_t{0};
  }
  nodes.values = *values;
  nodes.storage = values;
  return nodes;
}

std::vector<std::byte> encode(const CreepTableNodes& nodes) {
  check(nodes.axes);
  const auto data = std::as_bytes(nodes.values);
  Head head = {};
  head.magic = magic;
  head.byte_order = byte_order;
  head.version = version;
  head.materials = static_cast<std::uint32_t>(nodes.axes.poisson_ratios.size());
  head.ratios = static_cast<std::uint32_t>(nodes.axes.ratios);
  head.levels = static_cast<std::uint32_t>(nodes.axes.levels);
  head.elevations = static_cast<std::uint32_t>(nodes.axes.elevations);
  head.azimuths = static_cast<std::uint32_t>(nodes.axes.azimuths);
  head.elements = static_cast<std::uint32_t>(nodes.origin.elements);
  head.solved = nodes.origin.solved;
  head.not_converged = nodes.origin.not_converged;
  head.least_ratio = nodes.axes.least_ratio;
  head.largest_ratio = nodes.axes.largest_ratio;
  std::copy(nodes.axes.poisson_ratios.begin(), nodes.axes.poisson_ratios.end(), head.poisson_ratios.begin());
  head.unit = nodes.unit;
  head.error_rms = nodes.origin.error_rms;
  head.error_worst = nodes.origin.error_worst;
  head.data_checksum = checksum(data);
  head.head_checksum = checksum(head);
  std::vector<std::byte> bytes(sizeof head + data.size());
  std::memcpy(bytes.data(), &head, sizeof head);
  std::memcpy(bytes.data() + sizeof head, data.data(), data.size());
  return bytes;
}

CreepTableNodes decode(std::span<const std::byte> bytes, std::shared_ptr<const void> storage) {
  const Head head = head_of(bytes);
  const auto data = bytes.subspan(sizeof head);
  CreepTableNodes nodes = {.axes = axes_of(head),
                           .origin = {.elements = static_cast<int>(head.elements),
                                      .solved = static_cast<long>(head.solved),
                                      .not_converged = static_cast<long>(head.not_converged),
                                      .error_rms = head.error_rms,
                                      .error_worst = head.error_worst},
                           .unit = head.unit,
                           .storage = std::move(storage)};
  const std::size_t size = nodes.axes.blocks() * nodes.axes.nodes() * creep_channels;
  if (data.size() != size * sizeof(std::int16_t))
    throw Error("is cut short or too long: it has " + std::to_string(data.size()) + " bytes of numbers, not " +
                std::to_string(size * sizeof(std::int16_t)));
  if (checksum(data) != head.data_checksum) throw Error("is corrupted: the checksum of its numbers is wrong");
  nodes.values = {reinterpret_cast<const std::int16_t*>(data.data()), size}; // NOLINT: the head keeps them aligned
  return nodes;
}

} // namespace microslip
