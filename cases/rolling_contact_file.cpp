#include "cases/rolling_contact_result.hpp"
#include "io/result_file.hpp"

namespace microslip {

void write_result(const RollingCase& input, const RollingContactResult& result, const Provenance& provenance,
                  const std::filesystem::path& path) {
  ResultFile file(path, provenance);
  write_result(input, result, file);
  file.commit();
}

} // namespace microslip
