#pragma once

#include <span>
#include <vector>

namespace microslip {

/// Curve of an unknown number of arcs through points with errors, by its distances n_i across a smooth curve beside it
/// at s_i: its curvature there is that of the other one and the second derivative of n. From one point to the next, h
/// further on, the curvature changes by a step of Student's distribution, with 0.3 degrees of freedom and the scale
/// sqrt(q h): by next to nothing in most, on arcs and lines, and by any amount in a few. Errors of the points are
/// normal. The variances Q of the steps are found by MacKay's fixed point of the marginal likelihood (D. J. C. MacKay,
/// Neural Computation 4 (1992) 415-447; M. E. Tipping, J. Machine Learning Research 1 (2001) 211-244), q from them; n
/// is then the mean given the measured distances d: with D the matrix that takes n to steps, V the variances of d, c
/// the steps of the curve beside it,
///
///   (D V D' + Q) g = D d + c,  n = d - V D' g,  steps Q g.
///
/// `s` [m] ascends, at least 4; `curvature` [1/m] of the curve beside; `measured` d [m]; `variances` V >= 0 [m^2], 0
/// for a point that stays. 100 rounds, each O(points), the first 60 with variances of errors that come down from 400
/// times V, so that steps that the data show clearly come first and chance makes none.
std::vector<double> distances_with_few_curvature_steps(std::span<const double> s, std::span<const double> curvature,
                                                       std::span<const double> measured,
                                                       std::span<const double> variances);

/// Factor by which errors have larger variances than V, by the residuals d - n of the curve that it makes probable, in
/// the median: steps explain the shape, errors the rest. Variances come down to V, or to that factor if it is more.
/// Arguments and cost as above.
double noise_factor_beside_few_curvature_steps(std::span<const double> s, std::span<const double> curvature,
                                               std::span<const double> measured, std::span<const double> variances);

} // namespace microslip
