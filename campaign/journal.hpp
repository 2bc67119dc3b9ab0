#pragma once

#include "campaign/rows.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace microslip::campaign {

/// Results of one process of a campaign: a file to which chunks are added one by one, each with its checksum,
/// by one write to the system. It begins with what tells campaigns apart and the byte order. A process that is killed
/// leaves all chunks that it has added, and at most one cut off at the end.
class Journal {
public:
  /// Creates the file, or goes on at the end of one that find_chunks has read. Throws Error with the path and the
  /// system's reason.
  Journal(std::filesystem::path path, const CampaignPlan& plan);
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;
  ~Journal();

  /// Throws Error with the path and the system's reason, e.g. of a full disk; the file then is as before.
  void add(const CampaignRows& rows);
  /// Waits until the disk has what was added: a crash of the machine loses nothing of it.
  void sync();

private:
  void write(const std::string& bytes);
  [[noreturn]] void fail(int error_number) const;

  std::filesystem::path path_;
  CampaignPlan plan_;
  int descriptor_ = -1;
  std::size_t size_ = 0;
};

/// Position of a chunk in a journal.
struct KeptChunk {
  std::size_t number = 0; ///< of the chunk
  std::size_t offset = 0; ///< [bytes]
};

/// The chunks of a journal, in the order in which they were added. A chunk that is cut off at the end, as by the death
/// of its process, is taken away from the file; nobody may be writing to it. Throws Error with the path for a file that
/// is no journal, or of another campaign, version or byte order, or has damaged chunks, with the position of the first.
std::vector<KeptChunk> find_chunks(const std::filesystem::path& path, const CampaignPlan& plan);

/// Reads chunks of one journal, from any position.
class JournalReader {
public:
  /// Throws Error with the path and the system's reason.
  JournalReader(std::filesystem::path path, const CampaignPlan& plan);
  JournalReader(const JournalReader&) = delete;
  JournalReader& operator=(const JournalReader&) = delete;
  ~JournalReader();

  /// Throws Error if the chunk there is damaged.
  CampaignRows at(std::size_t offset) const;

private:
  friend std::vector<KeptChunk> find_chunks(const std::filesystem::path& path, const CampaignPlan& plan);

  /// Bytes of the file from `offset` on, fewer than `count` at its end.
  std::string bytes_at(std::size_t offset, std::size_t count) const;
  [[noreturn]] void fail(const std::string& what) const;

  std::filesystem::path path_;
  CampaignPlan plan_;
  int descriptor_ = -1;
};

} // namespace microslip::campaign
