#pragma once

namespace microslip {

/// The state of an element of the potential contact.
enum class CellState : unsigned char { exterior = 0, adhesion = 1, slip = 2 };

} // namespace microslip
