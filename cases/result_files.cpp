#include "cases/rolling_contact_result.hpp"
#include "cases/wheel_rail_result.hpp"
#include "io/result_file.hpp"

namespace microslip::cases {
namespace {

template <class Input, class Result>
void write_file(const Input& input, const Result& result, const io::Provenance& provenance,
                const std::filesystem::path& path) {
  io::ResultFile file(path, provenance);
  write_result(input, result, file);
  file.commit();
}

} // namespace

void write_result(const io::RollingCase& input, const RollingContactResult& result, const io::Provenance& provenance,
                  const std::filesystem::path& path) {
  write_file(input, result, provenance, path);
}

void write_result(const io::WheelRailCase& input, const WheelRailResult& result, const io::Provenance& provenance,
                  const std::filesystem::path& path) {
  write_file(input, result, provenance, path);
}

void write_result(const io::WheelsetCase& input, const WheelsetResult& result, const io::Provenance& provenance,
                  const std::filesystem::path& path) {
  write_file(input, result, provenance, path);
}

} // namespace microslip::cases
