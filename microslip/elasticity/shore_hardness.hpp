#pragma once

namespace microslip {

/// Range of Shore A hardness, 20 to 90, in which a modulus follows from it. Below 20 the indenter sinks in by more than
/// 2 mm, two and a half times the diameter of its tip, far beyond a small indentation; above 90 a change of one, which
/// two readings of the same rubber differ by, changes the modulus by more than a tenth. ASTM D2240 advises against
/// readings outside it, too.
inline constexpr double softest_shore_a = 20, hardest_shore_a = 90;

/// Young's modulus E [Pa] of rubber of the Shore A hardness S by Gent's relation (1958),
/// E = 0.0981 (56 + 7.62336 S)/(0.137505 (254 - 2.54 S)) MPa: S is read from a spring of 0.549 N + 0.0748 N S that
/// presses a frustum of a cone of 1.03 mm mean diameter 0.0254 mm (100 - S) into an incompressible half-space. It is an
/// estimate: another relation in use, log10(E/MPa) = 0.0235 S - 0.6403 (Ruess), gives as much at S = 30 and 1.9 times
/// as much at 80; where it matters, measure E. Throws Error unless S is in [20, 90].
double young_modulus_of_shore_a(double hardness);

/// Inverse of young_modulus_of_shore_a: the Shore A hardness of a Young's modulus [Pa]. Throws Error for one whose
/// hardness is not in [20, 90], from 0.732 to 20.84 MPa.
double shore_a_of_young_modulus(double young_modulus);

} // namespace microslip
