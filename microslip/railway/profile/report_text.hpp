#pragma once

#include "microslip/railway/profile/profile.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace microslip {

/// Five digits, in every locale.
std::string digits(double value);
/// Lengths as reports show them, in mm: `0.1 mm`, `(-43.7, 12) mm`.
std::string in_mm(double length);
std::string in_mm(const ProfilePoint& point);
/// `4.1 um`, two digits.
std::string in_um(double length);
/// `12 %`, two digits.
std::string in_percent(double part);
/// `1 point`, `3 points`.
std::string counted(std::size_t n, std::string_view noun);

} // namespace microslip
