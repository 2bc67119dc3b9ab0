#pragma once

#include "microslip/contact/elliptic_contact.hpp"

#include <optional>

namespace microslip {

/// The creepages with which FASTSIM2 has the given forces [N], those of the contact where none is given. The
/// dissimilarity counts as zero. Nothing if it finds none, as close to full sliding. Cost: some tens of microseconds.
std::optional<Creepage> creepage_from_fastsim2(const EllipticContact& contact, std::optional<double> force_x,
                                               std::optional<double> force_y);

} // namespace microslip
