#include "microslip/exact/halfspace/inclination_correction.hpp"

namespace microslip {

InclinationCorrection::InclinationCorrection(const CombinedMaterial& material, const ElementGrid& grid,
                                             const RowInclination& inclination)
    : product_(InclinedKernel::displacements(Bodies(material), grid, {}, 1, {}), grid, inclination) {}

InclinationCorrection::Fields InclinationCorrection::find(const Fields& tractions) {
  Fields added, plane;
  for (Fields* fields : {&added, &plane})
    for (auto& field : *fields) field.resize(tractions[0].size());
  const auto spans = [](Fields& f) { return std::array{std::span(f[0]), std::span(f[1]), std::span(f[2])}; };
  const InclinedProduct::Fields given = {tractions[0], tractions[1], tractions[2]};
  product_.apply(given, spans(added));
  product_.apply_plane(given, spans(plane));
  for (std::size_t i = 0; i < added.size(); ++i)
    for (std::size_t k = 0; k < added[i].size(); ++k) added[i][k] -= plane[i][k];
  return added;
}

} // namespace microslip
