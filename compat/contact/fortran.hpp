#pragma once

#include <initializer_list>
#include <string>

namespace microslip::contact_program {

// Numbers as CONTACT writes them.

/// Fortran's Gw.d: `digits` significant ones, with four blanks behind instead of an exponent from 0.1 up to
/// 10^digits; 0.1234E-05 beyond that.
std::string general(double value, int width, int digits);
/// The same for several numbers, one after the other.
std::string general(std::initializer_list<double> values, int width, int digits);

/// `fixed` significant digits without an exponent if all digits before the point fit, and from 0.1 on;
/// else `scientific` ones with it: 1.234E-05.
std::string significant(double value, int width = 12, int fixed = 4, int scientific = 4);
std::string significant(std::initializer_list<double> values);

/// `decimals` of them behind the point.
std::string decimal(double value, int width, int decimals);

/// 0 for what is smaller than `least`.
double without_noise(double value, double least);

} // namespace microslip::contact_program
