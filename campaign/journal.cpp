#include "campaign/journal.hpp"

#include "campaign/hash.hpp"
#include "microslip/error.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <system_error>
#include <type_traits>

#include <fcntl.h>
#include <unistd.h>

namespace microslip::campaign {
namespace {

constexpr std::array<char, 8> magic = {'m', 's', 'l', 'i', 'p', 'j', 'n', 'l'};
constexpr std::uint32_t format = 1; ///< raised by any change of what follows
constexpr std::uint32_t byte_order = 0x01020304;
constexpr std::uint32_t chunk_mark = 0x4b4e4843; // CHNK

constexpr const char* no_checkpoint = "is no checkpoint of microslip";

template <class Struct> std::string_view bytes_of(const Struct& object) {
  static_assert(std::has_unique_object_representations_v<Struct>, "no byte without a meaning");
  return {reinterpret_cast<const char*>(&object), sizeof object};
}

/// A struct whose last member is a hash of the ones before.
template <class Struct> std::uint64_t check_of(const Struct& object) {
  return hash_of(bytes_of(object).substr(0, sizeof object - sizeof object.check));
}

/// Head of a journal.
struct FileHead {
  std::array<char, 8> magic = campaign::magic;
  std::uint32_t format = campaign::format, byte_order = campaign::byte_order;
  std::uint64_t identity, count, width, chunk;
  std::uint64_t check = 0;
};

/// Head of a chunk, before its rows, the reasons of its failed cases and a hash of both.
struct ChunkHead {
  std::uint32_t mark = chunk_mark, reasons; ///< bytes of these
  std::uint64_t number;
  std::uint64_t check = 0;
};

/// Head of each reason.
struct ReasonHead {
  std::uint64_t index, length;
};

template <class Struct> Struct checked(Struct object) {
  object.check = check_of(object);
  return object;
}

FileHead head_of(const CampaignPlan& plan) {
  return checked(
      FileHead{.identity = plan.identity, .count = plan.count, .width = plan.width, .chunk = plan.chunk, .check = 0});
}

std::string to_bytes(const CampaignRows& rows) {
  std::string reasons;
  for (const auto& [index, reason] : rows.failed) {
    reasons.append(bytes_of(ReasonHead{index, reason.size()}));
    reasons.append(reason);
  }
  const auto head = checked(ChunkHead{.reasons = static_cast<std::uint32_t>(reasons.size()), .number = rows.number});
  std::string bytes(bytes_of(head));
  bytes.append(reinterpret_cast<const char*>(rows.values.data()), rows.values.size() * sizeof(double));
  bytes.append(reasons);
  const std::uint64_t check = hash_of(std::string_view(bytes).substr(sizeof head));
  return bytes.append(bytes_of(check));
}

template <class Struct> Struct struct_at(std::string_view bytes) {
  Struct object;
  std::memcpy(&object, bytes.data(), sizeof object);
  return object;
}

/// The reasons as to_bytes has written them; none if they are damaged.
std::optional<std::vector<FailedCase>> failed_cases(std::string_view bytes) {
  std::vector<FailedCase> failed;
  while (!bytes.empty()) {
    if (bytes.size() < sizeof(ReasonHead)) return std::nullopt;
    const auto [index, length] = struct_at<ReasonHead>(bytes);
    bytes.remove_prefix(sizeof(ReasonHead));
    if (length > bytes.size()) return std::nullopt;
    failed.push_back({index, std::string(bytes.substr(0, length))});
    bytes.remove_prefix(length);
  }
  return failed;
}

std::size_t row_bytes(const CampaignPlan& plan, std::size_t number) {
  return plan.cases_of(number) * plan.width * sizeof(double);
}

/// All of a chunk but its head.
std::size_t body_bytes(const CampaignPlan& plan, const ChunkHead& head) {
  return row_bytes(plan, head.number) + head.reasons + sizeof(std::uint64_t);
}

bool is_right(const CampaignPlan& plan, const ChunkHead& head) {
  return head.mark == chunk_mark && head.check == check_of(head) && head.number < plan.chunks();
}

bool is_right(std::string_view body) {
  const auto content = body.substr(0, body.size() - sizeof(std::uint64_t));
  return hash_of(content) == struct_at<std::uint64_t>(body.substr(content.size()));
}

std::string reason_of(int error_number) {
  return std::generic_category().message(error_number);
}

/// Fault of the beginning of a journal; empty: none.
std::string fault_of(const FileHead& head, const CampaignPlan& plan) {
  if (head.magic != magic) return no_checkpoint;
  if (head.byte_order != byte_order) return "was written on a machine with another byte order";
  if (head.format != format)
    return "has format " + std::to_string(head.format) +
           " of checkpoints; this version of microslip reads and writes " + std::to_string(format);
  if (head.check != check_of(head))
    return "is damaged at its beginning; without this file its chunks are computed anew";
  if (head.check != head_of(plan).check)
    return "belongs to another campaign, or to this one before it was changed; remove the checkpoint to begin anew";
  return "";
}

} // namespace

Journal::Journal(std::filesystem::path path, const CampaignPlan& plan) : path_(std::move(path)), plan_(plan) {
  descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail(errno);
  const auto end = ::lseek(descriptor_, 0, SEEK_END);
  if (end < 0) fail(errno);
  size_ = static_cast<std::size_t>(end);
  if (size_ == 0) write(std::string(bytes_of(head_of(plan))));
}

Journal::~Journal() {
  ::close(descriptor_);
}

void Journal::add(const CampaignRows& rows) {
  write(to_bytes(rows));
}

void Journal::sync() {
  if (::fdatasync(descriptor_) != 0) fail(errno);
}

/// Writes bytes; what cannot be written to its end is removed again.
void Journal::write(const std::string& bytes) {
  std::size_t written = 0;
  while (written < bytes.size()) {
    const auto count = ::write(descriptor_, bytes.data() + written, bytes.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      const int error_number = errno;
      if (written > 0 && ::ftruncate(descriptor_, static_cast<off_t>(size_)) != 0) fail(errno);
      fail(error_number);
    }
    written += static_cast<std::size_t>(count);
  }
  size_ += written;
}

void Journal::fail(int error_number) const {
  throw Error(path_.string() + ": cannot be written: " + reason_of(error_number));
}

JournalReader::JournalReader(std::filesystem::path path, const CampaignPlan& plan)
    : path_(std::move(path)), plan_(plan), descriptor_(::open(path_.c_str(), O_RDONLY | O_CLOEXEC)) {
  if (descriptor_ < 0) fail("cannot be read: " + reason_of(errno));
}

JournalReader::~JournalReader() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

CampaignRows JournalReader::at(std::size_t offset) const {
  const auto wrong = [&] {
    fail("the chunk at byte " + std::to_string(offset) + " is damaged; without this file its chunks are computed anew");
  };
  const std::string start = bytes_at(offset, sizeof(ChunkHead));
  if (start.size() < sizeof(ChunkHead)) wrong();
  const auto head = struct_at<ChunkHead>(start);
  if (!is_right(plan_, head)) wrong();
  const std::string body = bytes_at(offset + sizeof head, body_bytes(plan_, head));
  if (body.size() < body_bytes(plan_, head) || !is_right(body)) wrong();
  const std::size_t of_rows = row_bytes(plan_, head.number);
  CampaignRows rows{.number = head.number, .values = std::vector<double>(of_rows / sizeof(double)), .failed = {}};
  std::memcpy(rows.values.data(), body.data(), of_rows);
  auto failed = failed_cases(std::string_view(body).substr(of_rows, head.reasons));
  if (!failed) wrong();
  rows.failed = std::move(*failed);
  return rows;
}

std::string JournalReader::bytes_at(std::size_t offset, std::size_t count) const {
  std::string bytes(count, '\0');
  std::size_t done = 0;
  while (done < count) {
    const auto n = ::pread(descriptor_, bytes.data() + done, count - done, static_cast<off_t>(offset + done));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail("cannot be read: " + reason_of(errno));
    if (n == 0) break;
    done += static_cast<std::size_t>(n);
  }
  bytes.resize(done);
  return bytes;
}

void JournalReader::fail(const std::string& what) const {
  throw Error(path_.string() + ": " + what);
}

std::vector<KeptChunk> find_chunks(const std::filesystem::path& path, const CampaignPlan& plan) {
  const JournalReader reader(path, plan);
  const auto cut = [&](std::size_t size) {
    if (::truncate(path.c_str(), static_cast<off_t>(size)) != 0) reader.fail("cannot be written: " + reason_of(errno));
  };
  const std::string start = reader.bytes_at(0, sizeof(FileHead));
  if (start.size() < sizeof(FileHead)) { // of a process that was killed at its first write
    const FileHead whole = head_of(plan);
    if (!bytes_of(whole).starts_with(start)) reader.fail(no_checkpoint);
    cut(0);
    return {};
  }
  if (const auto fault = fault_of(struct_at<FileHead>(start), plan); !fault.empty()) reader.fail(fault);
  std::vector<KeptChunk> chunks;
  const std::size_t size = std::filesystem::file_size(path);
  for (std::size_t offset = sizeof(FileHead); offset < size;) {
    const std::string head_bytes = reader.bytes_at(offset, sizeof(ChunkHead));
    const bool has_head = head_bytes.size() == sizeof(ChunkHead);
    const auto head = has_head ? struct_at<ChunkHead>(head_bytes) : ChunkHead{};
    const bool is_whole = has_head && (!is_right(plan, head) || size - offset - sizeof head >= body_bytes(plan, head));
    if (!is_whole) {
      cut(offset);
      break;
    }
    chunks.push_back({reader.at(offset).number, offset});
    offset += sizeof head + body_bytes(plan, head);
  }
  return chunks;
}

} // namespace microslip::campaign
