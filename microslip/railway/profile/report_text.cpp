#include "microslip/railway/profile/report_text.hpp"

#include "microslip/decimal.hpp"

namespace microslip {

std::string digits(double value) {
  return rounded_text(value, 5);
}

std::string in_mm(double length) {
  return digits(length * 1e3) + " mm";
}

std::string in_mm(const ProfilePoint& point) {
  return "(" + digits(point.y * 1e3) + ", " + digits(point.z * 1e3) + ") mm";
}

std::string in_um(double length) {
  return rounded_text(length * 1e6, 2) + " um";
}

std::string in_percent(double part) {
  return rounded_text(part * 1e2, 2) + " %";
}

std::string counted(std::size_t n, std::string_view noun) {
  return std::to_string(n) + " " + std::string(noun) + (n == 1 ? "" : "s");
}

} // namespace microslip
