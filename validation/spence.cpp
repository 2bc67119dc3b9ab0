#include "validation/studies.hpp"

#include "microslip/exact/classical/contact_sequence.hpp"
#include "validation/hertzian_solve.hpp"
#include "validation/report.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

const Bodies on_rigid = combine({0.5, 0}, {1e5, 0});
constexpr double friction = 0.2986, curvature = 0.004116, element = 0.2;
/// CONTACT's example has its grid that much off the middle.
constexpr double contact_shift = 1e-4;

struct Outcome {
  ContactStepSolution last;
  double adhesion; ///< its radius over the contact's
  double centre;   ///< pressure over Hertz's
  bool ok = true;
};

/// Load in `stages` steps such that the contact grows by an element in each: k elements across after stage k. `ok` is
/// false if a step fails.
Outcome compress(int stages, int stages_of_full_load, double dx, double shift, Coupling coupling,
                 const Progress& progress) {
  const int m = stages + 10;
  ContactStep step;
  step.grid = {m, m, -0.5 * (m - 1) * dx + shift, -0.5 * (m - 1) * dx + shift, dx, dx};
  step.bodies = on_rigid;
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < m; ++i)
      step.gap.push_back(curvature * (std::pow(step.grid.x(i), 2) + std::pow(step.grid.y(j), 2)));
  step.friction = {FrictionLaw::coulomb(friction)};
  step.force_x = step.force_y = 0;
  step.motion.motion = ContactMotion::shift;
  step.motion.tolerance = 1e-8;
  step.coupling = coupling;
  ContactSequence sequence;
  Outcome out{};
  for (int k = 1; k <= stages; ++k) {
    step.load = {NormalLoad::Given::force, std::pow(static_cast<double>(k) / stages_of_full_load, 3)};
    out.last = sequence.solve(step);
    out.ok = out.ok && out.last.report.status == Status::ok;
    step.start = StepStart::previous;
    if (progress && !progress(static_cast<double>(k) / stages)) break;
  }
  out.adhesion = std::sqrt(static_cast<double>(out.last.adhesion_elements) / out.last.contact_elements);
  const double hertz = hertz_from_load({curvature, curvature}, on_rigid.material, step.load.value).peak_pressure;
  out.centre = out.last.normal.peak_pressure / hertz;
  return out;
}

} // namespace

bool run_spence(const StudyOptions& options, std::ostream& out) {
  Report report(out, options.figures);
  report.line(
      fmt::format("nu = 0, G = 0.5 on a rigid plane, K = {:.4f}, mu = 0.2986, Fn = (k/45)^3 after stage k; one Newton "
                  "system in each stage",
                  on_rigid.material.dissimilarity));
  const Outcome whole = compress(35, 45, element, contact_shift, Coupling::newton, part_of(options.progress, 0, 0.1));
  report.heading("35 stages, elements of 0.2 mm: computed, CONTACT");
  const auto figure = [&](const char* name, double value, double published, double half_digit, const char* format) {
    report.figure(name, fmt::format(fmt::runtime(format), value), fmt::format(fmt::runtime(format), published),
                  whole.ok && std::abs(value - published) <= half_digit);
  };
  figure("approach [mm]", whole.last.normal.approach, 9.874e-2, 0.6e-5, "{:.5f}");
  figure("peak pressure [N/mm2]", whole.last.normal.peak_pressure, 2.392e-2, 0.6e-5, "{:.5f}");
  figure("elements in contact", whole.last.contact_elements, 921, 0, "{}");
  figure("in adhesion", whole.last.adhesion_elements, 225, 0, "{}");
  const Outcome in_turn =
      compress(35, 45, element, contact_shift, Coupling::alternating, part_of(options.progress, 0.1, 0.3));
  report.figure("approach by the alternating process: difference",
                fmt::format("{:.1e}", std::abs(in_turn.last.normal.approach - whole.last.normal.approach)), "<= 1e-7",
                in_turn.ok && std::abs(in_turn.last.normal.approach - whole.last.normal.approach) <= 1e-7);

  report.heading(
      "The same load in more and more stages and elements: stages, centre pressure over Hertz's, adhesion radius");
  constexpr std::array stages = {17, 35, 69};
  std::array<Outcome, stages.size()> series;
  for (std::size_t n = 0; n < stages.size(); ++n) {
    const double dx = element * 35 / stages[n];
    series[n] = compress(stages[n], stages[n] * 45 / 35, dx, 0, Coupling::newton,
                         part_of(options.progress, 0.3 + 0.2 * double(n), n == 2 ? 1 : 0.5 + 0.2 * double(n)));
    report.line(fmt::format("{:>4}  {:.4f}  {:.4f}{}", stages[n], series[n].centre, series[n].adhesion,
                            series[n].ok ? "" : "  a stage has failed"));
  }
  const double centre = limit(series[1].centre, stages[1], series[2].centre, stages[2]);
  const double adhesion = limit(series[1].adhesion, stages[1], series[2].adhesion, stages[2]);
  report.near("centre pressure over Hertz's, extrapolated", "{:.3f}", centre, "1.31", 0.01);
  report.near("adhesion radius over the contact's, extrapolated", "{:.3f}", adhesion, "0.5", 0.01);
  return report.all_as_stated();
}

} // namespace microslip::validation
