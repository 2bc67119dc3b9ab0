#include "validation/contact_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <set>

namespace microslip::validation {
namespace {

/// Inputs, and counts of iterations, which are those of other methods.
const std::set<std::string> not_compared = {"CHI", "DQ", "VELOC", "SPINXO", "SPINYO", "INORM", "ITANG"};

double size_of(const PrintedNumbers& numbers, std::initializer_list<const char*> names) {
  double square = 0;
  for (const char* name : names)
    if (const auto found = numbers.find(name); found != numbers.end()) square += std::pow(found->second.value, 2);
  return std::sqrt(square);
}

/// What a difference of a quantity is relative to, by what CONTACT printed beside it.
double scale_of(const std::string& name, const PrintedNumbers& beside) {
  const double value = size_of(beside, {name.c_str()});
  const auto is = [&](std::initializer_list<const char*> names) {
    return std::ranges::any_of(names, [&](const char* one) { return name == one; });
  };
  constexpr double least = 1e-4; // of the normal force: tangential forces that vanish by symmetry have no scale
  const double normal = size_of(beside, {"FN", "BAR_FN"});
  const double tangential = std::max(size_of(beside, {"FX", "FY", "FS", "BAR_FX", "BAR_FS"}), least * normal);
  if (is({"FX", "FY", "FS", "BAR_FX", "BAR_FS"})) return tangential;
  if (is({"MN", "MZ"})) return std::max(value, tangential); // [N mm]
  if (name.ends_with("(TR)") && name.starts_with("F")) return size_of(beside, {"FX(TR)", "FY(TR)", "FZ(TR)"});
  if (name.ends_with("(WS)") && name.starts_with("F")) return size_of(beside, {"FX(WS)", "FY(WS)", "FZ(WS)"});
  if (is({"Z_WS", "YCP(R)", "ZCP(R)", "XCP(W)", "YCP(W)", "ZCP(W)", "XCP(TR)", "YCP(TR)", "ZCP(TR)"})) return 1; // [mm]
  if (is({"DELTCP(TR)"})) return 0.1;
  if (is({"NPOT", "NCON", "NADH", "NSLIP", "NPLAST"})) return std::max(1.0, size_of(beside, {"NCON"}));
  if (is({"CKSI", "CETA"})) return size_of(beside, {"CKSI", "CETA"});
  if (name.ends_with("/FN")) return 1;
  return value;
}

Difference difference_of(const std::string& name, const PrintedNumber& ours, const PrintedNumber& theirs,
                         double scale) {
  const double apart = std::abs(ours.value - theirs.value), unit = std::max(ours.rounding, theirs.rounding);
  constexpr double rounding = 1.001; // of decimals as binary numbers
  Difference d{.name = name, .ours = ours, .theirs = theirs};
  d.relative = apart > theirs.rounding ? (apart - theirs.rounding) / scale : 0;
  d.agreement = apart <= theirs.rounding * rounding ? Agreement::equal
                : apart <= 2 * unit * rounding      ? Agreement::last_digit
                : d.relative < 1e-3                 ? Agreement::within_0_1_pc
                : d.relative < 1e-2                 ? Agreement::within_1_pc
                                                    : Agreement::off;
  return d;
}

void add(CaseComparison& sum, const PrintedNumbers& ours, const PrintedNumbers& theirs, std::size_t patch) {
  for (const auto& [name, number] : theirs) {
    if (not_compared.contains(name)) continue;
    const auto found = ours.find(name);
    if (found == ours.end()) {
      sum.missing.push_back(name);
      continue;
    }
    Difference d = difference_of(name, found->second, number, scale_of(name, theirs));
    d.patch = patch;
    d.load = size_of(theirs, {"FN", "BAR_FN", "FZ(TR)"});
    ++sum.counts[static_cast<std::size_t>(d.agreement)];
    if (d.agreement != Agreement::equal) sum.differences.push_back(std::move(d));
  }
}

} // namespace

CaseComparison compare(const PrintedCase& ours, const PrintedCase& theirs) {
  CaseComparison result{.our_patches = ours.patches.size(), .their_patches = theirs.patches.size()};
  add(result, ours.totals, theirs.totals, 0);
  if (result.our_patches != result.their_patches) return result;
  for (std::size_t k = 0; k < theirs.patches.size(); ++k) add(result, ours.patches[k], theirs.patches[k], k + 1);
  return result;
}

} // namespace microslip::validation
