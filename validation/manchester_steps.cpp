#include "validation/manchester_steps.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr double agreed = 0.005; // of mu Fn

double larger_component(const Vec2& from, const Vec2& to) {
  return std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
}

} // namespace

std::array<double, 4> ManchesterForces::changes() const {
  const std::array forces = {contact, planes, surface, table, fastsim2};
  std::array<double, 4> out{};
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = larger_component(forces[k], forces[k + 1]) / capacity;
  return out;
}

double ManchesterForces::difference() const {
  return larger_component(contact, fastsim2) / capacity;
}

void report_steps(Report& report, const std::vector<ManchesterForces>& all) {
  report.heading("A-2.2, states where fastsim2 differs from CONTACT by more than 0.005 mu Fn: what each rule changes");
  report.line("            differs  elements, gap,  planes or  normal problem  FASTSIM2  most by");
  report.line("                            patches   surfaces         by rows");
  std::size_t others = 0;
  for (const ManchesterForces& one : all) {
    if (one.difference() <= agreed) continue;
    ++others;
    const auto changes = one.changes();
    const auto most = std::max_element(changes.begin(), changes.end()) - changes.begin();
    report.line(fmt::format("{:10} {:8.4f} {:15.4f} {:10.4f} {:15.4f} {:9.4f}  {}", one.name, one.difference(),
                            changes[0], changes[1], changes[2], changes[3],
                            ManchesterForces::steps[std::size_t(most)]));
  }
  const auto within = [&](std::size_t step) {
    return std::count_if(all.begin(), all.end(),
                         [&](const ManchesterForces& f) { return f.changes()[step] <= agreed; });
  };
  report.remark("states beyond 0.005", fmt::format("{} of {}", others, all.size()), "-", "each with its rules above");
  for (std::size_t k = 0; k < ManchesterForces::steps.size(); ++k)
    report.remark(ManchesterForces::steps[k], fmt::format("{} of {}", within(k), all.size()), "-",
                  "changed by at most 0.005");
}

} // namespace microslip::validation
