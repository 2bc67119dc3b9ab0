#pragma once

#include "compat/libcontact/include/contact_addon.h"

#include <cmath>
#include <span>
#include <string>
#include <vector>

namespace microslip::libcontact {

// Arguments of calls. Each throws Refusal, with the argument's name, for a null pointer, a length below 0 and numbers
// that are not finite.

/// Target of a pointer.
template <class Value> Value& given(const char* name, Value* pointer);
int integer(const char* name, const int* value);
double real(const char* name, const double* value);

/// An array and its length; a null pointer may stand for none.
std::span<const int> integers(const char* name, const int* count, const int* values);
std::span<const double> reals(const char* name, const int* count, const double* values);
/// Destination of results.
template <class Value> std::span<Value> room(const char* name, const int* count, Value* values);
/// Letters, without blanks at the end, or up to a zero.
std::string text(const char* name, const char* letters, const int* length);

/// The nearest integer to a number that stands for one, if it is in a range.
int as_integer(const char* name, double value, int least, int most);
/// Refuses a number of values other than those from `least` to `most`.
void require_count(const char* name, std::size_t count, std::size_t least, std::size_t most);
/// Writes as many values as fit; the rest of the array stays.
template <class Value> void fill(std::span<Value> room, const std::vector<Value>& values) {
  for (std::size_t k = 0; k < room.size() && k < values.size(); ++k) room[k] = values[k];
}

} // namespace microslip::libcontact
