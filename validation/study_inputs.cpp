#include "validation/study_inputs.hpp"

#include <algorithm>
#include <system_error>

namespace microslip::validation {

namespace fs = std::filesystem;

std::vector<fs::path> study_inputs(const fs::path& other_cases) {
  const fs::path data = MICROSLIP_REFERENCE_DATA;
  std::vector<fs::path> files;
  for (const fs::path& folder : {data, data / ".." / "contact-cases", other_cases}) {
    std::error_code missing;
    for (const auto& entry : fs::recursive_directory_iterator(folder, missing))
      if (entry.is_regular_file()) files.push_back(entry.path().lexically_normal());
  }
  std::ranges::sort(files);
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

} // namespace microslip::validation
