#pragma once

#include "microslip/contact/contact_solution.hpp"
#include "microslip/exact/classical/tangential_problem.hpp"
#include "microslip/exact/normal/normal_problem.hpp"

namespace microslip {

/// What a normal and a tangential problem on one grid have found together. Pressure, gap and approach are those of
/// `normal` times `load`, for a normal problem that was solved for 1 N; `speed` is V [m/s], 1 for a shift.
ContactSolution contact_solution(const ElementGrid& grid, TangentialSolution tangential, const NormalSolution& normal,
                                 double load, ContactMotion motion, double speed);

} // namespace microslip
