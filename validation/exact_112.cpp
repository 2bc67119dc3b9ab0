#include "validation/studies.hpp"

#include "validation/error_statistics.hpp"
#include "validation/exact_cases.hpp"
#include "validation/reference_112.hpp"
#include "validation/report.hpp"

#include <string>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

using Results = std::vector<RelativeForces>;

Results solve(const std::vector<EllipticContact>& contacts, int n, const StudyOptions& options) {
  const auto cases = solve_exactly(contacts, {.n = n}, options);
  Results results;
  for (std::size_t i = 0; i < cases.size(); ++i) results.push_back(relative(cases[i].forces, contacts[i]));
  return results;
}

/// Judged by the rms that is allowed; 0: shown only.
void report_differences(Report& report, const Results& mine, const Results& theirs, double rms_allowed) {
  const std::pair<const char*, double RelativeForces::*> components[] = {
      {"Fx", &RelativeForces::fx}, {"Fy", &RelativeForces::fy}, {"Mz", &RelativeForces::mz}};
  for (const auto& [name, component] : components) {
    auto e = differences(mine, theirs, component);
    const ErrorStatistics s = statistics(e);
    const std::string row = fmt::format("{}  95 % {:.1e}  largest {:.1e}  rms", name, s.p95, s.largest);
    const std::string rms = fmt::format("{:.1e}", s.rms);
    if (rms_allowed > 0)
      report.figure(row, rms, fmt::format("<= {:.0e}", rms_allowed), s.rms <= rms_allowed);
    else
      report.remark(row, rms, "", "");
  }
}

} // namespace

bool run_exact_112(const StudyOptions& options, std::ostream& out) {
  Report report(out, options.figures);
  const auto reference = read_reference_112();
  if (reference.empty()) {
    report.line(reference_112_skipped);
    return true;
  }
  std::vector<EllipticContact> contacts;
  Results theirs_coarse, theirs_limit;
  for (const Reference112& r : reference) {
    contacts.push_back(r.contact);
    theirs_coarse.push_back(r.coarse);
    theirs_limit.push_back(r.limit);
  }

  StudyOptions part = options;
  const auto on = [&](int n, double from, double to) {
    part.progress = part_of(options.progress, from, to);
    return solve(contacts, n, part);
  };
  const Results n15 = on(15, 0, 0.05), n31 = on(31, 0.05, 0.2), n63 = on(63, 0.2, 1);
  if (n15.empty() || n31.empty() || n63.empty()) return false;
  Results cheap, fine;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    cheap.push_back(limit(n15[i], 15, n31[i], 31));
    fine.push_back(limit(n31[i], 31, n63[i], 63));
  }
  report.line(fmt::format("{} cases; forces over mu Fn, moments over mu Fn sqrt(a b)", contacts.size()));
  report.heading("31 x 31 elements, CONTACT on the same grid");
  report_differences(report, n31, theirs_coarse, 1e-6);
  report.heading("Extrapolated from 31 and 63 elements, CONTACT's extrapolation of the same");
  report_differences(report, fine, theirs_limit, 2e-6);
  report.heading("31 x 31 elements as they are, CONTACT extrapolated: the discretisation error");
  report_differences(report, n31, theirs_limit, 0);
  report.heading("Extrapolated from 15 and 31 elements, CONTACT extrapolated from 31 and 63");
  report_differences(report, cheap, theirs_limit, 0.002);
  return report.all_as_stated();
}

} // namespace microslip::validation
