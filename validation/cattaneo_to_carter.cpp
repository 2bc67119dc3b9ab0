#include "validation/studies.hpp"

#include "microslip/error.hpp"
#include "microslip/rolling/accurate_contact.hpp"
#include "validation/hertzian_solve.hpp"
#include "validation/marching.hpp"
#include "validation/report.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr CombinedMaterial material = {1e6, 0.28, 0};
constexpr double normal_force = 0.4705, friction = 0.4013, force_share = 0.657;
constexpr GapCurvatures gap = {2.963, 2.963};
/// That of CONTACT's example: 28 elements across, their centres on both axes.
constexpr ElementGrid grid{34, 33, -4e-3, -4e-3, 0.25e-3, 0.25e-3};
constexpr int last_case = 57; ///< the first is the shift, then the contact rolls an element in each
constexpr double tolerance = 1e-8;

TangentialInput input_of(ContactMotion motion) {
  TangentialInput input;
  input.motion = motion;
  input.force_x = -force_share * friction * normal_force;
  input.tolerance = tolerance;
  return input;
}

struct Published {
  double creepage; ///< of the first case the shift [mm]
  double energy;   ///< [J], with that of the normal tractions
  double power;    ///< [W] at 1 m/s; of the first case the work [J]
  int adhesion, slip;
};

double normal_energy(const HertzianSolve& contact) {
  const NormalSolution& n = contact.normal();
  double sum = 0;
  for (std::size_t k = 0; k < n.pressure.size(); ++k) sum += n.pressure[k] * n.displacement[k];
  return 0.5 * sum * contact.grid().element_area();
}

/// Met if the four digits printed are those computed.
void figure(Report& report, const std::string& name, double computed, double published) {
  report.figure(name, fmt::format("{:.4e}", computed), fmt::format("{:.3e}", published),
                std::abs(computed / published - 1) <= 5e-4);
}

void report_case(Report& report, int number, const ContactSolution& s, double energy, const Published& published) {
  report.heading(fmt::format("Case {}: computed, CONTACT", number));
  const int adhesion = count(s, CellState::adhesion), slip = count(s, CellState::slip);
  if (number == 1)
    figure(report, "shift [mm]", s.creepage.longitudinal * 1e3, published.creepage);
  else
    figure(report, "creepage", s.creepage.longitudinal, published.creepage);
  report.count("elements in adhesion", adhesion, published.adhesion);
  report.count("elements in slip", slip, published.slip);
  figure(report, "elastic energy [J]", s.totals.elastic_energy + energy, published.energy);
  figure(report, number == 1 ? "frictional work [J]" : "frictional power at 1 m/s [W]", s.totals.frictional_power,
         published.power);
}

/// Steady rolling on the same grid, `refined` times finer, solved directly.
double steady_creepage(int refined, const std::optional<LeadingEdge>& edge) {
  ElementGrid fine{grid.mx * refined, grid.my * refined, 0, 0, grid.dx / refined, grid.dy / refined};
  fine.x0 = grid.x0 - (grid.dx - fine.dx) / 2;
  fine.y0 = grid.y0 - (grid.dy - fine.dy) / 2;
  TangentialInput input = input_of(ContactMotion::steady);
  input.leading_edge = edge;
  return HertzianSolve(material, fine, gap, normal_force).solve(friction, input).creepage.longitudinal;
}

/// Steady rolling at second order, on n x n elements across.
double second_order_creepage(int n) {
  const HertzContact hertz = hertz_from_load(gap, material, normal_force);
  EllipticContact contact;
  contact.a = hertz.a;
  contact.b = hertz.b;
  contact.shear_modulus = material.shear_modulus;
  contact.poisson_ratio = material.poisson_ratio;
  contact.normal_force = hertz.normal_force;
  contact.friction = FrictionLaw::coulomb(friction);
  const RollingProblem problem = rolling_problem(contact, {.force_x = -force_share * friction * normal_force});
  const ContactSolution s = Solver({.mx = n, .my = n, .tolerance = tolerance}).solve(problem);
  if (s.report.status != Status::ok) throw Error("steady rolling at second order: not converged");
  return s.creepage.longitudinal;
}

void report_edge(Report& report) {
  report.heading("Steady creepage on 28, 56, 112 elements across, and its limit from the last two");
  for (const bool corrected : {false, true}) {
    std::optional<LeadingEdge> edge;
    if (corrected) edge = LeadingEdge{};
    const double coarse = steady_creepage(1, edge), fine = steady_creepage(2, edge), finest = steady_creepage(4, edge);
    report.line(
        fmt::format("{}  {:.4e}  {:.4e}  {:.4e}  {:.4e}",
                    corrected ? "with the leading edge's correction   " : "without the leading edge's correction",
                    coarse, fine, finest, limit(fine, 2, finest, 4)));
  }
  const double coarse = second_order_creepage(28), fine = second_order_creepage(56),
               finest = second_order_creepage(112);
  report.line(fmt::format("second order                           {:.4e}  {:.4e}  {:.4e}  {:.4e}", coarse, fine, finest,
                          limit_of_second_order(fine, finest)));
}

} // namespace

bool run_cattaneo_to_carter(const StudyOptions& options, std::ostream& out) {
  HertzianSolve contact(material, grid, gap, normal_force);
  const double energy = normal_energy(contact);
  Report report(out, options.figures);
  report.line(
      "a = 3.5 mm, Fx = -0.657 mu Fn, G = 1 N/mm2, nu = 0.28, mu = 0.4013; dq = dx = 0.25 mm, 28 elements across");

  ContactSolution s = contact.solve(friction, input_of(ContactMotion::shift));
  report_case(report, 1, s, energy, {1.774e-2, 1.470e-5, 1.261e-7, 305, 316});
  const VectorField shifted = s.fields.traction;
  for (int k = 2; k <= last_case; ++k) {
    TangentialInput input = input_of(ContactMotion::transient);
    const VectorField before = std::move(s.fields.traction);
    input.previous = input.start = &before;
    s = contact.solve(friction, input);
    if (k == 2) report_case(report, 2, s, energy, {1.824e-3, 1.472e-5, 1.188e-4, 422, 199});
    if (options.progress && !options.progress(0.7 * k / last_case)) return false;
  }
  report_case(report, last_case, s, energy, {3.101e-3, 1.483e-5, 3.459e-4, 346, 275});

  report.heading("Steady rolling");
  const double rolled = s.creepage.longitudinal;
  const double direct = contact.solve(friction, input_of(ContactMotion::steady)).creepage.longitudinal;
  TangentialInput marching = input_of(ContactMotion::transient);
  marching.previous = &shifted;
  const auto marched = march_to_steady(contact.tangential(), grid, contact.bound(friction), marching);
  const double arrived = marched.last.creepage.longitudinal;
  report.figure("creepage of case 57, solved directly", fmt::format("{:.5e}", rolled), fmt::format("{:.5e}", direct),
                std::abs(rolled / direct - 1) <= 1e-4);
  report.figure(fmt::format("marched {} steps until it stays, solved directly", marched.steps),
                fmt::format("{:.6e}", arrived), fmt::format("{:.6e}", direct),
                marched.last.report.status == Status::ok && std::abs(arrived / direct - 1) <= 1e-5);
  if (options.progress && !options.progress(0.8)) return false;
  report_edge(report);
  return report.all_as_stated();
}

} // namespace microslip::validation
