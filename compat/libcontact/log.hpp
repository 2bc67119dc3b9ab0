#pragma once

#include <exception>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <set>
#include <string>
#include <type_traits>

namespace microslip::libcontact {

/// The log file that the interface defines, which has the results that flags ask for as well. Each message is written
/// once; any thread may write.
class Log {
public:
  /// Begins a file; the messages so far count as not written. False if it cannot be written: then nothing is.
  bool open(const std::filesystem::path& file);
  void write_once(const std::string& message) noexcept;
  /// The same of a message that is made now; without memory for it nothing is written.
  template <class Make> void write_once(Make make) noexcept requires std::is_invocable_r_v<std::string, Make> {
    try {
      write_once(make());
    } catch (const std::exception&) {
    }
  }
  /// Writes results. False if that is impossible.
  bool write(const std::string& results);
  void close();

private:
  std::mutex mutex_;
  std::ofstream file_;
  std::set<std::string> written_;
};

} // namespace microslip::libcontact
