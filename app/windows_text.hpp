#pragma once

#include <string>
#include <string_view>

namespace microslip::app {

/// Between the texts of this program, which are UTF-8, and those of Windows.
std::wstring wide(std::string_view text);
std::string utf8(std::wstring_view text);

} // namespace microslip::app
