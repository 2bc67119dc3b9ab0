#pragma once

#include <filesystem>
#include <fstream>
#include <mutex>
#include <set>
#include <string>

namespace microslip::libcontact {

/// The log file that the interface defines. Each message is written once; any thread may write.
class Log {
public:
  /// Begins a file; the messages so far count as not written. False if it cannot be written: then nothing is.
  bool open(const std::filesystem::path& file);
  void write_once(const std::string& message) noexcept;
  void close();

private:
  std::mutex mutex_;
  std::ofstream file_;
  std::set<std::string> written_;
};

} // namespace microslip::libcontact
