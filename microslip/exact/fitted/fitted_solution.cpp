#include "microslip/exact/fitted/fitted_solution.hpp"

namespace microslip {

ElementGrid mirrored(ElementGrid grid) {
  grid.x0 = -grid.x(grid.mx - 1);
  return grid;
}

std::vector<double> mirrored(const ElementGrid& grid, const std::vector<double>& field) {
  std::vector<double> image(field.size());
  for (std::size_t k = 0; k < field.size(); ++k) image[k + grid.mx - 1 - 2 * (k % grid.mx)] = field[k];
  return image;
}

ContactSolution contact_solution(const FittedContact& fitted, const SecondOrderSolution& found,
                                 const FittedLoad& load) {
  const bool forward = load.direction == RollingDirection::forward;
  const double side = forward ? 1 : -1; // components along x, and spin, change their sign in the mirror
  const ElementGrid& grid = fitted.grid;
  const FrictionSolution& friction = found.friction;
  ContactSolution out;
  Elements& e = out.elements = Elements(forward ? grid : mirrored(grid));
  SurfaceFields& f = out.fields = SurfaceFields(e.size());
  f.displacement = VectorField(e.size());
  f.pressure.resize(e.size());
  for (std::size_t k = 0; k < fitted.elements.size(); ++k) {
    const FittedElement& element = fitted.elements[k];
    const std::size_t cell = forward ? element.cell : element.cell + grid.mx - 1 - 2 * (element.cell % grid.mx);
    e.x[cell] = side * element.centre();
    e.width[cell] = element.width();
    e.area[cell] = element.width() * grid.dy;
    f.bound[cell] = load.bound[k];
    f.pressure[cell] = fitted.load_share[k] * load.normal_force;
    f.traction.x[cell] = side * friction.traction.x[k], f.traction.y[cell] = friction.traction.y[k];
    f.slip.x[cell] = side * friction.slip.x[k], f.slip.y[cell] = friction.slip.y[k];
    f.displacement.x[cell] = side * found.displacement.x[k], f.displacement.y[cell] = found.displacement.y[k];
    f.state[cell] = friction.sliding[k] ? CellState::slip : CellState::adhesion;
  }
  out.creepage = {side * found.creepage.longitudinal, found.creepage.lateral, side * found.creepage.spin};
  out.approach = load.approach;
  out.totals = find_totals(e, f, out.creepage, load.rolling_speed);
  out.totals.frictional_power = load.rolling_speed * found.frictional_work;
  out.report = friction.report;
  return out;
}

} // namespace microslip
