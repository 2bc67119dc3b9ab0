#pragma once

#include "microslip/simplified/row_solver.hpp"

#include <span>

namespace microslip {

/// Forces of many contacts by copies of `solver` on `threads` threads, to the last bit the same for every number of
/// them. Throws Error unless `threads` is in [1, most_threads] and there are as many forces as contacts.
void solve_parallel(const RowSolver& solver, std::span<const EllipticContact> contacts, std::span<ContactForces> forces,
                    int threads);

} // namespace microslip
