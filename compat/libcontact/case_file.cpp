#include "compat/libcontact/case_file.hpp"

#include "compat/contact/input_text.hpp"
#include "compat/libcontact/include/contact_addon.h"
#include "compat/libcontact/refusal.hpp"

namespace microslip::libcontact {

void CaseFile::set_path(const std::filesystem::path& path) {
  const std::lock_guard lock(mutex_);
  path_ = path;
}

void CaseFile::add(const std::string& text) {
  const std::lock_guard lock(mutex_);
  if (!file_.is_open()) file_ = std::ofstream(path_);
  file_ << text << std::flush;
  if (!file_) throw Refusal(CNTC_err_other, path_.string() + ": cannot be written");
}

void CaseFile::close() {
  const std::lock_guard lock(mutex_);
  if (file_.is_open()) file_ << contact_program::input_end();
  file_ = {};
}

} // namespace microslip::libcontact
