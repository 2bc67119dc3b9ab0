#include "compat/libcontact/log.hpp"

#include <exception>

namespace microslip::libcontact {
namespace {

/// So that neither the file nor memory grows without end where every message is a new one.
constexpr std::size_t most_messages = 1000;

} // namespace

bool Log::open(const std::filesystem::path& file) {
  const std::lock_guard lock(mutex_);
  written_.clear();
  file_ = std::ofstream(file);
  if (!file_) return false;
  file_ << "microslip " MICROSLIP_VERSION ", instead of CONTACT's library" << std::endl;
  return true;
}

void Log::write_once(const std::string& message) noexcept {
  try {
    const std::lock_guard lock(mutex_);
    if (!file_.is_open() || written_.size() > most_messages || !written_.insert(message).second) return;
    file_ << (written_.size() > most_messages ? "further messages are left out" : message) << std::endl;
  } catch (const std::exception&) { // a log that cannot be written is no reason to fail
  }
}

bool Log::write(const std::string& results) {
  const std::lock_guard lock(mutex_);
  file_ << results << std::flush;
  return file_.is_open() && file_.good();
}

void Log::close() {
  const std::lock_guard lock(mutex_);
  file_.close();
  written_.clear();
}

} // namespace microslip::libcontact
