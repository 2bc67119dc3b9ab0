#include "microslip/exact/classical/classical_solution.hpp"

#include <utility>

namespace microslip {
namespace {

std::vector<double> scaled(std::vector<double> field, double factor) {
  for (double& value : field) value *= factor;
  return field;
}

} // namespace

ContactSolution contact_solution(const ElementGrid& grid, TangentialSolution tangential, const NormalSolution& normal,
                                 double load, ContactMotion motion, double speed) {
  ContactSolution out;
  out.motion = motion;
  out.elements = Elements(grid);
  SurfaceFields& f = out.fields;
  f.traction.x = std::move(tangential.tractions.px), f.traction.y = std::move(tangential.tractions.py);
  f.slip.x = std::move(tangential.sx), f.slip.y = std::move(tangential.sy);
  f.displacement.x = std::move(tangential.ux), f.displacement.y = std::move(tangential.uy);
  f.bound = std::move(tangential.bound);
  f.state = std::move(tangential.state);
  f.pressure = scaled(normal.pressure, load);
  f.gap = scaled(normal.gap, load);
  out.creepage = tangential.creepage;
  out.approach = normal.approach * load;
  out.totals = find_totals(out.elements, f, out.creepage, motion == ContactMotion::shift ? 1 : speed);
  out.report = {.status = tangential.forces.status,
                .residual = tangential.residual,
                .newton_steps = tangential.newton_steps,
                .products = tangential.products};
  return out;
}

} // namespace microslip
