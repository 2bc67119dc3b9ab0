#include "compat/contact/mat.hpp"

#include <cmath>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace microslip::contact_program {
namespace {

constexpr double per_m = 1e3, mega = 1e-6; ///< to mm, to N/mm2

std::string numbers(const std::vector<double>& values) {
  std::string line;
  for (const double value : values) fmt::format_to(std::back_inserter(line), " {:14.6g}", value);
  return line + "\n";
}

std::string head(const Case& c, const Outcome& outcome) {
  const ElementGrid& grid = outcome.step.grid;
  const MaterialData& m = *c.material;
  const bool rolls = c.digits.rolls();
  std::string text = "%    MX    MY  XL  YL  DX  DY  CHI  DQ  CONFIG  D  YNOM_WHL\n";
  text += numbers({double(grid.mx), double(grid.my), (grid.x0 - grid.dx / 2) * per_m, (grid.y0 - grid.dy / 2) * per_m,
                   grid.dx * per_m, grid.dy * per_m, rolls ? c.rolling->chi : 0,
                   rolls ? outcome.step.motion.step * per_m : 1, 0, 0, 0});
  text += "%    T     M   GG1  GG2  POISS1  POISS2\n";
  text += numbers(
      {double(number(c.digits.tang)), double(number(c.digits.mater)), m.shear1, m.shear2, m.poisson1, m.poisson2});
  text += "%    H     L   VELOC  FRICTION PARAMETERS\n";
  std::vector<double> friction = {double(number(c.digits.heat)), double(number(c.friction.law)),
                                  rolls ? c.rolling->veloc : 1};
  friction.insert(friction.end(), c.friction.sets[0].begin(), c.friction.sets[0].end());
  return text + numbers(friction);
}

double coefficient(const Outcome& outcome, std::size_t k) {
  const auto& friction = outcome.solution.friction;
  return outcome.step.frictionless || friction.empty() ? 0 : friction[k];
}

} // namespace

std::string mat_text(const Case& c, const Outcome& outcome) {
  const NormalSolution& n = outcome.solution.normal;
  const TangentialSolution& t = outcome.solution.tangential;
  const auto& temperature = outcome.temperature;
  const bool shifts = c.digits.tang == Tangential::shift;
  std::string text = head(c, outcome) + "%    I IGS  H  MU  PN  PX  PY  UN  UX  UY  " + (shifts ? "SHFT" : "SREL") +
                     (temperature ? "  TEMP1  TEMP2\n" : "\n");
  for (std::size_t k = 0; k < outcome.step.grid.count(); ++k) {
    const int state = element_state(outcome, k);
    if (c.digits.matfil == Stored::contact && state == 0) continue;
    fmt::format_to(std::back_inserter(text), "{:7} {:2}", k + 1, state);
    std::vector<double> line = {(outcome.step.gap[k] - n.approach) * per_m,
                                coefficient(outcome, k),
                                n.pressure[k] * mega,
                                t.tractions.px[k] * mega,
                                t.tractions.py[k] * mega,
                                n.displacement[k] * per_m,
                                t.ux[k] * per_m,
                                t.uy[k] * per_m,
                                std::hypot(t.sx[k], t.sy[k]) * (shifts ? per_m : 1)};
    if (temperature) line.insert(line.end(), {temperature->body1[k], temperature->body2[k]});
    text += numbers(line);
  }
  return text;
}

} // namespace microslip::contact_program
