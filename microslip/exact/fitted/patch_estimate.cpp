#include "microslip/exact/fitted/patch_estimate.hpp"

#include "microslip/simplified/grid_fastsim.hpp"
#include "microslip/simplified/prescribed_forces.hpp"

#include <array>
#include <numbers>
#include <vector>

namespace microslip {
namespace {

/// FASTSIM on the cells of a fitted contact; the bound replaces the pressure, and friction is 1.
class FastsimOnCells {
public:
  FastsimOnCells(const CombinedMaterial& material, const FittedContact& contact, std::span<const double> bound,
                 const RowVariation& rows)
      : material_(material), contact_(contact), fastsim_(contact.grid, on_cells(contact, bound)) {
    double moment_x = 0, moment_y = 0;
    for (std::size_t k = 0; k < bound.size(); ++k) {
      const FittedElement& e = contact.elements[k];
      const double load = bound[k] * e.width() * contact.grid.dy;
      capacity_ += load;
      moment_x += load * e.centre();
      moment_y += load * contact.grid.y(e.row);
    }
    centre_ = {moment_x / capacity_, moment_y / capacity_};
    if (rows.creepage) find_extra_slip(rows);
  }

  double area() const { return fastsim_.contact_area(); }

  ContactSolution solve(Creepage creepage) const {
    creepage.longitudinal -= creepage.spin * centre_.y; // at the centre
    creepage.lateral += creepage.spin * centre_.x;
    const auto [a, b] = fastsim_.equivalent_axes();
    const EllipticContact ellipse{.a = a,
                                  .b = b,
                                  .shear_modulus = material_.shear_modulus,
                                  .poisson_ratio = material_.poisson_ratio,
                                  .normal_force = capacity_,
                                  .friction = FrictionLaw::coulomb(1),
                                  .creepage = creepage};
    return fastsim_.solve(flexibilities(FlexibilityModel::blended, {}, ellipse), std::array{1.0},
                          {.creepage = creepage, .spin_centre = centre_, .extra_x = extra_.x, .extra_y = extra_.y});
  }

private:
  static std::vector<double> on_cells(const FittedContact& contact, std::span<const double> bound) {
    std::vector<double> cells(contact.grid.count());
    for (std::size_t k = 0; k < bound.size(); ++k) cells[contact.elements[k].cell] = bound[k];
    return cells;
  }

  void find_extra_slip(const RowVariation& rows) {
    const ElementGrid& grid = contact_.grid;
    extra_ = VectorField(grid.count());
    for (int j = 0; j < grid.my; ++j) {
      const Creepage w = rows.creepage_at(grid.y(j));
      for (int i = 0; i < grid.mx; ++i) {
        const std::size_t k = static_cast<std::size_t>(j) * grid.mx + i;
        extra_.x[k] = w.longitudinal, extra_.y[k] = w.lateral + w.spin * grid.x(i);
      }
    }
  }

  const CombinedMaterial& material_;
  const FittedContact& contact_;
  VectorField extra_{}; ///< of the rows, at the cells; empty: none
  GridFastsim fastsim_;
  double capacity_ = 0;
  Vec2 centre_{};
};

} // namespace

RollingEstimate estimate_by_fastsim(const CombinedMaterial& material, const FittedContact& contact, double capacity,
                                    const SecondOrderInput& input) {
  const std::vector<double> bound = friction_bound(contact, capacity, input.variation);
  const double stiffness =
      material.shear_modulus * FastsimOnCells(material, contact, bound, {}).area() / std::numbers::pi;
  return {.tractions =
              [material, rows = input.variation](const FittedContact& fitted, std::span<const double> fitted_bound,
                                                 const Creepage& creepage) {
                const VectorField p =
                    FastsimOnCells(material, fitted, fitted_bound, rows).solve(creepage).fields.traction;
                VectorField tractions;
                for (const FittedElement& e : fitted.elements) {
                  tractions.x.push_back(p.x[e.cell]);
                  tractions.y.push_back(p.y[e.cell]);
                }
                return tractions;
              },
          .creepage = [=, &contact, force_x = input.force_x, force_y = input.force_y, given = input.creepage,
                       rows = input.variation]() -> std::optional<Creepage> {
            constexpr double tolerance = 1e-4;
            const FastsimOnCells fastsim(material, contact, bound, rows);
            const FoundCreepage found =
                find_creepage([&](const Creepage& w) { return fastsim.solve(w).forces(); }, {force_x, force_y}, given,
                              capacity, capacity / stiffness, tolerance);
            if (found.status != Status::ok) return {};
            return found.creepage;
          },
          .stiffness = stiffness};
}

} // namespace microslip
