#include "cases/rolling_contact_result.hpp"
#include "cases/wheel_rail_result.hpp"
#include "io/result_file.hpp"

namespace microslip {
namespace {

template <class Input, class Result>
void write_file(const Input& input, const Result& result, const Provenance& provenance,
                const std::filesystem::path& path) {
  ResultFile file(path, provenance);
  write_result(input, result, file);
  file.commit();
}

} // namespace

void write_result(const RollingCase& input, const RollingContactResult& result, const Provenance& provenance,
                  const std::filesystem::path& path) {
  write_file(input, result, provenance, path);
}

void write_result(const WheelRailCase& input, const WheelRailResult& result, const Provenance& provenance,
                  const std::filesystem::path& path) {
  write_file(input, result, provenance, path);
}

void write_result(const WheelsetCase& input, const WheelsetResult& result, const Provenance& provenance,
                  const std::filesystem::path& path) {
  write_file(input, result, provenance, path);
}

} // namespace microslip
