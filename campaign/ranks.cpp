#include "campaign/ranks.hpp"

#include "microslip/error.hpp"

namespace microslip::campaign {

void Ranks::agree(const std::function<void()>& work, const Progress& progress) {
  std::string error;
  try {
    work();
  } catch (const Error& failure) {
    error = failure.what();
  }
  error = common_error(std::move(error), progress);
  if (!error.empty()) throw Error(error);
}

} // namespace microslip::campaign
