#include "validation/exact_112.hpp"

#include "microslip/error.hpp"
#include "validation/error_statistics.hpp"
#include "validation/exact_cases.hpp"
#include "validation/relative_forces.hpp"
#include "validation/report.hpp"
#include "validation/test_set.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr const char* reference_file = MICROSLIP_REFERENCE_DATA "/exact_theory_112.csv";

struct ReferenceCase {
  int number;                   ///< of the 3,220, from 1
  double xi, eta, phi;          ///< phi in 1/mm
  RelativeForces coarse, limit; ///< on 31 x 31 elements, and extrapolated from that and 63 x 63
};

/// A line of numbers; Error if there are not `count`.
std::vector<double> numbers(const std::string& line, std::size_t count) {
  std::vector<double> values;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) {
    std::istringstream text(cell);
    double value = 0;
    if (!(text >> value)) throw Error(std::string(reference_file) + ": '" + cell + "' is not a number");
    values.push_back(value);
  }
  if (values.size() != count) throw Error(std::string(reference_file) + ": a line has not the columns expected");
  return values;
}

std::vector<ReferenceCase> read_reference() {
  std::vector<ReferenceCase> cases;
  std::ifstream in(reference_file);
  bool head = true;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    if (head) { // the names of the columns
      head = false;
      continue;
    }
    const auto v = numbers(line, 21);
    cases.push_back({static_cast<int>(v[0]), v[5], v[6], v[7], {v[11], v[12], v[13]}, {v[17], v[18], v[19]}});
  }
  return cases;
}

/// The cases of our test set with those numbers, after a check that they are the same.
std::vector<EllipticContact> contacts_of(const std::vector<ReferenceCase>& reference) {
  const auto all = test_set_contacts();
  std::vector<EllipticContact> contacts;
  for (const ReferenceCase& r : reference) {
    const auto index = static_cast<std::size_t>(r.number - 1);
    if (index >= all.size()) throw Error(fmt::format("{}: there is no case {}", reference_file, r.number));
    const Creepage& c = all[index].creepage;
    const double scale = std::abs(r.xi) + std::abs(r.eta) + 1e-6;
    const bool same = std::abs(c.longitudinal - r.xi) <= 1e-5 * scale && std::abs(c.lateral - r.eta) <= 1e-5 * scale &&
                      std::abs(c.spin * 1e-3 - r.phi) <= 1e-5 * (r.phi + 1e-9);
    if (!same) throw Error(fmt::format("{}: case {} has other creepages", reference_file, r.number));
    contacts.push_back(all[index]);
  }
  return contacts;
}

using Results = std::vector<RelativeForces>;

Results solve(const std::vector<EllipticContact>& contacts, int n, const StudyOptions& options) {
  const auto cases = solve_exactly(contacts, n, Start::fastsim2, options);
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
  Report report(out);
  if (!std::filesystem::exists(reference_file)) {
    report.line("SKIPPED: the file exact_theory_112.csv is not in the folder MICROSLIP_REFERENCE_DATA of the build");
    return true;
  }
  const auto reference = read_reference();
  const auto contacts = contacts_of(reference);
  Results theirs_coarse, theirs_limit;
  for (const ReferenceCase& r : reference) theirs_coarse.push_back(r.coarse), theirs_limit.push_back(r.limit);

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
  return report.all_met();
}

} // namespace microslip::validation
