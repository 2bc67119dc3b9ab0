#include "microslip/exact/halfspace/inclination_correction.hpp"

namespace microslip {
namespace {

CoupledOperator displacement(const CombinedMaterial& material, const ElementGrid& grid,
                             const RowInclination& inclination) {
  ElementResponse response;
  response.inclination = inclination;
  return CoupledOperator::displacement(Bodies(material), grid, {}, 1, {}, response);
}

InclinationCorrection::Fields product(CoupledOperator& op, const InclinationCorrection::Fields& p) {
  InclinationCorrection::Fields u;
  for (auto& field : u) field.resize(p[0].size());
  op.apply({p[0], p[1], p[2]}, std::array{std::span(u[0]), std::span(u[1]), std::span(u[2])});
  return u;
}

} // namespace

InclinationCorrection::InclinationCorrection(const CombinedMaterial& material, const ElementGrid& grid,
                                             const RowInclination& inclination)
    : inclined_(displacement(material, grid, inclination)), plane_(displacement(material, grid, {})) {}

InclinationCorrection::Fields InclinationCorrection::find(const Fields& tractions) {
  Fields added = product(inclined_, tractions);
  const Fields plane = product(plane_, tractions);
  for (std::size_t i = 0; i < added.size(); ++i)
    for (std::size_t k = 0; k < added[i].size(); ++k) added[i][k] -= plane[i][k];
  return added;
}

} // namespace microslip
