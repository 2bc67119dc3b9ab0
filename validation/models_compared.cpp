#include "validation/studies.hpp"

#include "io/output_file.hpp"
#include "validation/clock.hpp"
#include "validation/error_statistics.hpp"
#include "validation/exact_cases.hpp"
#include "validation/models/model_picture.hpp"
#include "validation/models/tangential_models.hpp"
#include "validation/relative_forces.hpp"
#include "validation/report.hpp"
#include "validation/test_set.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr int finest = 48; // elements across, of the reference

using Results = std::vector<RelativeForces>;

/// The exact theory, extrapolated from two grids at second order, and which of the cases slide in part.
struct Reference {
  Results limit;
  std::vector<bool> slides_in_part;
  int failures = 0;
};

Reference solve_reference(const std::vector<EllipticContact>& contacts, const StudyOptions& options) {
  const auto on = [&](int elements, double begin, double end) {
    StudyOptions part = options;
    part.progress = part_of(options.progress, begin, end);
    return solve_exactly(contacts, {.n = elements, .discretisation = Discretisation::second_order}, part);
  };
  Reference out;
  const auto coarse = on(finest / 2, 0, 0.15);
  if (coarse.empty()) return out;
  const auto fine = on(finest, 0.15, 0.8);
  for (std::size_t k = 0; k < fine.size(); ++k) {
    const RelativeForces from = relative(coarse[k].forces, contacts[k]), to = relative(fine[k].forces, contacts[k]);
    out.limit.push_back(limit_of_second_order(from, to));
    out.slides_in_part.push_back(slides_in_part(fine[k].forces, contacts[k]));
    out.failures += (coarse[k].forces.status != Status::ok) + (fine[k].forces.status != Status::ok);
  }
  return out;
}

/// T-gamma over mu Fn times the sum of the creepages, spin over the contact's size c = sqrt(a b).
double relative_power(const RelativeForces& f, const EllipticContact& contact) {
  const double c = std::sqrt(contact.a * contact.b);
  const auto [xi, eta, phi] = contact.creepage;
  const double size = std::abs(xi) + std::abs(eta) + c * std::abs(phi);
  return size > 0 ? -(xi * f.fx + eta * f.fy + c * phi * f.mz) / size : 0;
}

/// How far a model is from the reference.
struct ModelErrors {
  ErrorStatistics fx, fy, mz, power, force_in_part;
  std::size_t worst = 0; ///< the case with the largest error of the force
  int unsolved = 0;      ///< contacts
  double seconds = 0;    ///< a contact
};

ModelErrors errors_of(const TangentialModel& model, const std::vector<EllipticContact>& contacts,
                      const Reference& reference) {
  Results results;
  ModelErrors out;
  const double begin = thread_time();
  for (const EllipticContact& contact : contacts) {
    const ContactForces forces = model.forces(contact);
    out.unsolved += !is_solved(forces.status);
    results.push_back(relative(forces, contact));
  }
  out.seconds = (thread_time() - begin) / double(contacts.size());
  const auto of = [&](double RelativeForces::*component) {
    std::vector<double> e = differences(results, reference.limit, component);
    return statistics(e);
  };
  out.fx = of(&RelativeForces::fx), out.fy = of(&RelativeForces::fy), out.mz = of(&RelativeForces::mz);
  std::vector<double> power, in_part;
  double worst = -1;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const RelativeForces &f = results[k], &r = reference.limit[k];
    power.push_back(std::abs(relative_power(f, contacts[k]) - relative_power(r, contacts[k])));
    const double error = std::hypot(f.fx - r.fx, f.fy - r.fy);
    if (reference.slides_in_part[k]) in_part.push_back(error);
    if (error > worst) worst = error, out.worst = k;
  }
  out.power = statistics(power);
  out.force_in_part = statistics(in_part);
  return out;
}

std::string place_of(const TestCase& test) {
  return fmt::format("a/b {:g}, spin {:g}, {:g} deg, {:g}", test.contact.a / test.contact.b, test.spin, test.angle,
                     test.magnitude);
}

void print_row(Report& report, const TangentialModel& model, const ModelErrors& e, const TestCase& worst) {
  const auto pair = [](const ErrorStatistics& s) {
    return fmt::format("{:7.4f} {:7.4f} {:6.3f}", s.rms, s.p99, s.largest);
  };
  const std::string moment = model.has_moment ? fmt::format("{:7.4f}", e.mz.rms) : fmt::format("{:>7}", "-");
  report.line(fmt::format("  {:<50} {}  {}  {} {:7.4f} {:7.4f}  {}", model.name, pair(e.fx), pair(e.fy), moment,
                          e.power.rms, e.force_in_part.rms, place_of(worst)));
}

const ModelErrors& of_model(std::string_view name, const std::vector<TangentialModel>& models,
                            const std::vector<ModelErrors>& errors) {
  const auto named = std::find_if(models.begin(), models.end(), [&](const auto& model) { return model.name == name; });
  return errors.at(static_cast<std::size_t>(named - models.begin()));
}

/// What the documentation claims of models, as bounds of rms errors over mu Fn.
struct Claim {
  std::string_view model, fx, fy;
};
constexpr Claim claims[] = {{"FASTSIM2, blended, 10 x 10", "<= 0.012", "<= 0.023"},
                            {"creep-force table", "<= 0.0005", "<= 0.0005"},
                            {"exact theory, second order, 24 x 24", "<= 0.001", "<= 0.001"}};

void judge(Report& report, const std::vector<TangentialModel>& models, const std::vector<ModelErrors>& errors) {
  report.heading("rms errors over mu Fn of all contacts");
  for (const Claim& claim : claims) {
    const ModelErrors& e = of_model(claim.model, models, errors);
    report.bounded(fmt::format("{}: Fx", claim.model), "{:.4f}", e.fx.rms, claim.fx);
    report.bounded(fmt::format("{}: Fy", claim.model), "{:.4f}", e.fy.rms, claim.fy);
  }
  int unsolved = 0;
  for (const ModelErrors& e : errors) unsolved += e.unsolved;
  report.count("contacts that a model leaves unsolved", unsolved, 0);
}

/// Times of contacts one after the other, over that of FASTSIM2 as it is used most.
void print_times(Report& report, const std::vector<TangentialModel>& models, const std::vector<ModelErrors>& errors) {
  const double of_unit = of_model("FASTSIM2, 3 flexibilities, 10 x 10", models, errors).seconds;
  report.heading("processor time of a contact over that of FASTSIM2 on 10 x 10");
  for (std::size_t k = 0; k < models.size(); ++k)
    report.line(fmt::format("  {:<50} {:8.2f}", models[k].name, errors[k].seconds / of_unit));
}

void write_picture(const StudyOptions& options, const std::vector<TangentialModel>& models,
                   const std::vector<ModelErrors>& errors) {
  std::vector<ModelPanel> panels;
  const auto add = [&](const char* title, ErrorStatistics ModelErrors::*of) {
    ModelPanel panel{.title = title, .series = {"rms", "99 %", "largest"}, .rows = {}};
    for (std::size_t k = 0; k < models.size(); ++k) {
      const ErrorStatistics& e = errors[k].*of;
      panel.rows.push_back({models[k].name, {e.rms, e.p99, e.largest}});
    }
    panels.push_back(std::move(panel));
  };
  add("$F_x$ over $\\mu F_n$", &ModelErrors::fx);
  add("$F_y$ over $\\mu F_n$", &ModelErrors::fy);
  io::create_folder(options.output);
  write_model_panels(options.output / "models.h5",
                     "Laws of creep forces on 3,220 ellipses: errors beside the exact theory",
                     "microslip validate models", panels);
}

} // namespace

bool run_models(const StudyOptions& options, std::ostream& out) {
  const std::vector<TestCase> cases = test_set();
  const std::vector<EllipticContact> contacts = test_set_contacts();
  Report report(out, options.figures);
  const Reference reference = solve_reference(contacts, options);
  if (reference.limit.size() != contacts.size()) return false;
  report.heading(fmt::format("creep forces of {} ellipses beside the exact theory, {} + {} elements", contacts.size(),
                             finest / 2, finest));
  report.count("reference solutions that do not converge", reference.failures, 0);
  report.line(
      "errors over mu Fn, mu Fn c of Mz, mu Fn (|xi| + |eta| + c |phi|) of T-gamma; 'in part': of the force, cases "
      "with adhesion and slip;");
  report.line("the worst force is at a/b, scaled spin, angle, scaled creepage");
  report.line(fmt::format("  {:<50} {:>7} {:>7} {:>6}  {:>7} {:>7} {:>6}  {:>7} {:>7} {:>7}  {}", "", "Fx rms", "99 %",
                          "worst", "Fy rms", "99 %", "worst", "Mz rms", "T-gamma", "in part", "worst at"));
  const std::vector<TangentialModel> models = tangential_models();
  std::vector<ModelErrors> errors;
  for (const TangentialModel& model : models) {
    errors.push_back(errors_of(model, contacts, reference));
    if (options.progress && !options.progress(0.8 + 0.2 * double(errors.size()) / double(models.size()))) return false;
  }
  for (std::size_t k = 0; k < models.size(); ++k) print_row(report, models[k], errors[k], cases[errors[k].worst]);
  judge(report, models, errors);
  print_times(report, models, errors);
  write_picture(options, models, errors);
  return report.all_as_stated();
}

} // namespace microslip::validation
