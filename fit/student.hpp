#pragma once

namespace microslip::fit {

/// Two-sided quantile of Student's distribution: t with P(|T| <= t) = `probability` in (0, 1) for `freedom` >= 1
/// degrees of freedom, by bisection of the finite sums that the probability is (Abramowitz & Stegun, 26.7.3 and
/// 26.7.4), to 1e-12. The quantile of F with 1 and `freedom` degrees of freedom is its square.
double student_quantile(double probability, int freedom);

} // namespace microslip::fit
