#include "compat/libcontact/arguments.hpp"

#include "compat/libcontact/refusal.hpp"

#include <cstring>

namespace microslip::libcontact {
namespace {

[[noreturn]] void refuse(const std::string& why) {
  throw Refusal(CNTC_err_other, why);
}

template <class Value> std::span<Value> array(const char* name, const int* count, Value* values) {
  const int length = integer((std::string("the length of ") + name).c_str(), count);
  if (length < 0) refuse(std::string("the length of ") + name + " = " + std::to_string(length) + ": must not be < 0");
  if (length > 0 && !values) refuse(std::string(name) + " is NULL");
  return {values, static_cast<std::size_t>(length)};
}

} // namespace

template <class Value> Value& given(const char* name, Value* pointer) {
  if (!pointer) refuse(std::string(name) + " is NULL");
  return *pointer;
}
template int& given(const char*, int*);
template double& given(const char*, double*);

int integer(const char* name, const int* value) {
  if (!value) refuse(std::string(name) + " is NULL");
  return *value;
}

double real(const char* name, const double* value) {
  if (!value) refuse(std::string(name) + " is NULL");
  if (!std::isfinite(*value)) refuse(std::string(name) + " is not finite");
  return *value;
}

std::span<const int> integers(const char* name, const int* count, const int* values) {
  return array(name, count, values);
}

std::span<const double> reals(const char* name, const int* count, const double* values) {
  const auto found = array(name, count, values);
  for (const double value : found)
    if (!std::isfinite(value)) refuse(std::string(name) + " has a number that is not finite");
  return found;
}

template <class Value> std::span<Value> room(const char* name, const int* count, Value* values) {
  return array(name, count, values);
}
template std::span<int> room(const char*, const int*, int*);
template std::span<double> room(const char*, const int*, double*);

std::string text(const char* name, const char* letters, const int* length) {
  constexpr int longest = 4096;
  const auto all = array(name, length, letters);
  if (all.size() > longest) refuse(std::string(name) + " has more than " + std::to_string(longest) + " letters");
  std::string found(all.begin(), all.end());
  found.resize(std::strlen(found.c_str()));
  found.erase(found.find_last_not_of(' ') + 1);
  return found;
}

int as_integer(const char* name, double value, int least, int most) {
  const double nearest = std::round(value);
  if (!(nearest >= least && nearest <= most))
    refuse(std::string(name) + " = " + std::to_string(value) + ": must be in " + std::to_string(least) + " to " +
           std::to_string(most));
  return static_cast<int>(nearest);
}

void require_count(const char* name, std::size_t count, std::size_t least, std::size_t most) {
  if (count >= least && count <= most) return;
  const std::string wanted =
      least == most ? std::to_string(least) : std::to_string(least) + " to " + std::to_string(most);
  refuse(std::string(name) + " has " + std::to_string(count) + " values: must be " + wanted);
}

} // namespace microslip::libcontact
