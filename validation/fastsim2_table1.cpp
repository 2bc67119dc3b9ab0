#include "validation/studies.hpp"

#include "io/output_file.hpp"
#include "io/result_file.hpp"
#include "microslip/batch/solve_parallel.hpp"
#include "validation/error_statistics.hpp"
#include "validation/exact_cases.hpp"
#include "validation/relative_forces.hpp"
#include "validation/report.hpp"
#include "validation/test_set.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr int coarse = 15, fine = 31; ///< elements across the ellipse
constexpr int cells = 640;

/// A row of the paper's Table 1; all zero: not in it.
struct Published {
  ErrorStatistics fx, fy;
};

struct Variant {
  std::string_view name, group;
  FlexibilityModel flexibility;
  TractionBound bound;
  Published published;
};

constexpr std::array variants = {
    Variant{"three flexibilities, parabolic bound",
            "three_parabolic",
            FlexibilityModel::three,
            TractionBound::parabolic,
            {{.026, .059, .026, 0}, {.051, .084, .039, 0}}},
    Variant{"three flexibilities, elliptic bound",
            "three_elliptic",
            FlexibilityModel::three,
            TractionBound::elliptic,
            {{.032, .067, .029, 0}, {.051, .085, .041, 0}}},
    Variant{"one flexibility, parabolic bound",
            "one_parabolic",
            FlexibilityModel::one,
            TractionBound::parabolic,
            {{.033, .119, .046, 0}, {.069, .130, .056, 0}}},
    Variant{"one flexibility, elliptic bound",
            "one_elliptic",
            FlexibilityModel::one,
            TractionBound::elliptic,
            {{.035, .104, .041, 0}, {.054, .109, .049, 0}}},
    Variant{"blended flexibilities, parabolic bound",
            "blended_parabolic",
            FlexibilityModel::blended,
            TractionBound::parabolic,
            {}},
    Variant{"blended flexibilities, elliptic bound",
            "blended_elliptic",
            FlexibilityModel::blended,
            TractionBound::elliptic,
            {}},
};

using Results = std::vector<RelativeForces>;

/// By exact theory.
struct Reference {
  Results coarse, fine, limit;
  std::vector<bool> slides_in_part;
  int failures = 0;
};

Reference solve_reference(const std::vector<EllipticContact>& contacts, const StudyOptions& options, double share) {
  Reference r;
  StudyOptions part = options;
  part.progress = part_of(options.progress, 0, 0.2 * share);
  const auto on_coarse = solve_exactly(contacts, {.n = coarse}, part);
  part.progress = part_of(options.progress, 0.2 * share, share);
  const auto on_fine = on_coarse.empty() ? on_coarse : solve_exactly(contacts, {.n = fine}, part);
  for (std::size_t i = 0; i < on_fine.size(); ++i) {
    const ContactForces &f = on_fine[i].forces, &c = on_coarse[i].forces;
    r.coarse.push_back(relative(c, contacts[i]));
    r.fine.push_back(relative(f, contacts[i]));
    r.limit.push_back(limit(r.coarse[i], coarse, r.fine[i], fine));
    r.slides_in_part.push_back(slides_in_part(f, contacts[i]));
    r.failures += (f.status != Status::ok) + (c.status != Status::ok);
  }
  return r;
}

Results solve_simplified(const std::vector<EllipticContact>& contacts, const Variant& variant, int threads) {
  SimplifiedOptions options;
  options.mx = options.my = cells;
  options.flexibility = variant.flexibility;
  options.bound = variant.bound;
  std::vector<ContactForces> forces(contacts.size());
  solve_parallel(RowSolver(MarchingScheme::fastsim2, options), contacts, forces, threads);
  Results results;
  for (std::size_t i = 0; i < contacts.size(); ++i) results.push_back(relative(forces[i], contacts[i]));
  return results;
}

struct Errors {
  std::vector<double> fx, fy; ///< sorted
  ErrorStatistics of_fx, of_fy;
};

Errors errors_of(const Results& results, const Results& reference, const std::vector<bool>* only = nullptr) {
  Errors e{differences(results, reference, &RelativeForces::fx, only),
           differences(results, reference, &RelativeForces::fy, only),
           {},
           {}};
  e.of_fx = statistics(e.fx);
  e.of_fy = statistics(e.fy);
  return e;
}

std::string row(std::string_view name, const Errors& e) {
  return fmt::format("{:<40} Fx {:.4f} {:.4f} {:.4f}   Fy {:.4f} {:.4f} {:.4f}", name, e.of_fx.p80, e.of_fx.p95,
                     e.of_fx.rms, e.of_fy.p80, e.of_fy.p95, e.of_fy.rms);
}

void report_published(Report& report, const Variant& variant, const Errors& errors) {
  const auto component = [&](std::string_view name, const ErrorStatistics& computed, const ErrorStatistics& published) {
    const auto one = [&](std::string_view what, double mine, double theirs) {
      report.near(fmt::format("  {}  {}", name, what), "{:.4f}", mine, "{:.3f}", theirs, 0.003);
    };
    one("80 %", computed.p80, published.p80);
    one("95 %", computed.p95, published.p95);
    one("rms", computed.rms, published.rms);
  };
  report.line(variant.name);
  component("Fx", errors.of_fx, variant.published.fx);
  component("Fy", errors.of_fy, variant.published.fy);
}

void write_statistics(io::ResultFile& file, const std::string& path, const ErrorStatistics& s,
                      const std::string& force) {
  file.scalar(path + "p80_" + force, s.p80, "-", "80 % of the errors in " + force + " are at most this");
  file.scalar(path + "p95_" + force, s.p95, "-", "95 % of the errors in " + force + " are at most this");
  file.scalar(path + "rms_" + force, s.rms, "-", "root mean square error in " + force);
}

void write(const StudyOptions& options, const std::array<Errors, variants.size()>& errors,
           const std::array<Errors, variants.size()>& partial) {
  io::create_folder(options.output);
  io::ResultFile file(options.output / "fastsim2_table1.h5",
                      {.kind = "fastsim2-table1",
                       .title = "FASTSIM2 against exact theory on the 3,220 cases",
                       .command_line = "microslip validate fastsim2-table1"});
  for (std::size_t k = 0; k < variants.size(); ++k) {
    const Variant& v = variants[k];
    const std::string path = std::string(v.group) + "/";
    file.array(path + "error_fx", errors[k].fx, "-", "errors in fx, sorted");
    file.array(path + "error_fy", errors[k].fy, "-", "errors in fy, sorted");
    write_statistics(file, path, errors[k].of_fx, "fx");
    write_statistics(file, path, errors[k].of_fy, "fy");
    write_statistics(file, path + "partial_slip/", partial[k].of_fx, "fx");
    write_statistics(file, path + "partial_slip/", partial[k].of_fy, "fy");
    if (!(v.published.fx.rms > 0)) continue;
    write_statistics(file, "published/" + path, v.published.fx, "fx");
    write_statistics(file, "published/" + path, v.published.fy, "fy");
  }
  file.commit();
}

} // namespace

bool run_fastsim2_table1(const StudyOptions& options, std::ostream& out) {
  io::require_writable_folder(options.output);
  const std::vector<EllipticContact> contacts = test_set_contacts();
  const double exact_share = 0.4;
  const Reference exact = solve_reference(contacts, options, exact_share);
  if (exact.fine.empty()) return false;
  std::array<Results, variants.size()> simplified;
  for (std::size_t k = 0; k < variants.size(); ++k) {
    simplified[k] = solve_simplified(contacts, variants[k], options.threads);
    const double done = double(k + 1) / double(variants.size());
    if (options.progress && !options.progress(exact_share + (1 - exact_share) * done)) return false;
  }

  std::array<Errors, variants.size()> errors, partial;
  for (std::size_t k = 0; k < variants.size(); ++k) {
    errors[k] = errors_of(simplified[k], exact.limit);
    partial[k] = errors_of(simplified[k], exact.limit, &exact.slides_in_part);
  }
  Report report(out, options.figures);
  report.line(fmt::format("{} cases; errors over mu Fn of FASTSIM2 on {} x {} cells", contacts.size(), cells, cells));
  report.count("cases of exact theory that do not converge", exact.failures, 0);
  report.heading(fmt::format("Against exact theory, extrapolated from {} and {} elements across: computed, published "
                             "(met within 0.003)",
                             coarse, fine));
  for (std::size_t k = 0; k < variants.size(); ++k)
    if (variants[k].published.fx.rms > 0) report_published(report, variants[k], errors[k]);
  report.heading("The same and what is not in the paper: 80 %, 95 %, rms");
  for (std::size_t k = 0; k < variants.size(); ++k) report.line(row(variants[k].name, errors[k]));
  report.heading(fmt::format("Against exact theory on {} x {} elements as they are", fine, fine));
  for (std::size_t k = 0; k < variants.size(); ++k)
    report.line(row(variants[k].name, errors_of(simplified[k], exact.fine)));
  report.heading(fmt::format("Only the {} cases with adhesion and creepage, against the extrapolated forces",
                             std::count(exact.slides_in_part.begin(), exact.slides_in_part.end(), true)));
  for (std::size_t k = 0; k < variants.size(); ++k) report.line(row(variants[k].name, partial[k]));
  report.line(row(fmt::format("exact theory on {} x {} elements", fine, fine),
                  errors_of(exact.fine, exact.limit, &exact.slides_in_part)));

  write(options, errors, partial);
  return report.all_as_stated();
}

} // namespace microslip::validation
