#include "microslip/exact/halfspace/layered_influence.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/elasticity/bilinear_influence.hpp"
#include "microslip/elasticity/influence.hpp"
#include "microslip/error.hpp"

#include <cmath>
#include <cstdlib>
#include <optional>
#include <vector>

namespace microslip {
namespace {

/// 3 K + G as a modulus that relaxes.
PronySeries relaxation_of_3k_plus_g(const ViscoelasticMaterial& material) {
  const double m = shear_over_bulk_modulus(material.instantaneous);
  PronySeries series;
  for (const auto& [share, time] : *material.bulk_relaxation) series.push_back({share * 3 / (3 + m), time});
  for (const auto& [share, time] : material.shear_relaxation) series.push_back({share * m / (3 + m), time});
  return series;
}

/// The retarded parts of a half-space's influence. With a = 1/(2 G), b = 3/(2 (3 K + G)) it is (1 - nu)/G = a + b, nu/G
/// = a - b, (1 - 2 nu)/(2 G) = b; so a half-space with nu = 1/2 has a alone, one with nu = 0 both alike.
std::vector<HalfSpaceCreep> half_space_creep(const ViscoelasticMaterial& material) {
  const auto [modulus, nu] = material.instantaneous;
  const double a = 1 / (2 * modulus), b = (1 - 2 * nu) / (2 * modulus);
  std::vector<HalfSpaceCreep> parts;
  for (const auto& [ratio, time] : creep_of(material.shear_relaxation))
    parts.push_back({ratio * a, material.bulk_relaxation ? 0 : ratio * b, time});
  if (!material.bulk_relaxation || b == 0) return parts;
  for (const auto& [ratio, time] : creep_of(relaxation_of_3k_plus_g(material))) parts.push_back({0, ratio * b, time});
  return parts;
}

std::optional<RolledLayers> layers_of(const char* field, const LayeredBody& body) {
  check(field, body);
  return body.layers.empty() ? std::nullopt : std::optional<RolledLayers>(body);
}

/// Adds the influence of one body to that of two: `side` 1 for body 1, -1 for body 2, whose normal is the opposite one.
void add_body(const InfluenceRows& body, double side, InfluenceRows& sum) {
  for (int j = 0; j < sum.rows(); ++j)
    for (int i = 1 - sum.columns(); i < sum.columns(); ++i) {
      Influence a = body.at(i, j);
      a.xz *= side, a.yz *= side;
      add(sum.at(i, j), 1, a);
    }
}

void check(const ElementSides& sides, int columns, int rows) {
  require_positive("dx", sides.dx, "m");
  require_positive("dy", sides.dy, "m");
  require_count("columns", columns, 1, most_cells);
  require_count("rows", rows, 1, sides.far ? 1 : most_cells);
  if (!sides.far) return;
  require_positive("far", *sides.far, "m");
  if (sides.shape != ElementShape::constant) throw Error("layers: need constant elements in a line contact");
}

/// Influence on an element x, y away of half-spaces.
Influence half_space_influence(const CombinedMaterial& surfaces, const ElementSides& sides, double x, double y) {
  if (sides.far) return line_influence(surfaces, sides.dx, x, *sides.far);
  return sides.shape == ElementShape::bilinear ? bilinear_influence(surfaces, sides.dx, sides.dy, x, y)
                                               : influence(surfaces, sides.dx, sides.dy, x, y);
}

} // namespace

LayeredSurfaces::LayeredSurfaces(const LayeredBodies& bodies)
    : bodies_(bodies), layers1_(layers_of("body1", bodies.body1)), layers2_(layers_of("body2", bodies.body2)) {
  require_finite("speed", bodies.speed, "m/s");
  if (bodies.speed == 0 && !bodies.are_elastic()) throw Error("speed", 0, "m/s", "not zero for viscoelastic bodies");
  bodies.surfaces(); // are not both rigid
}

InfluenceRows LayeredSurfaces::find(const ElementSides& sides, int columns, int rows, const Progress& progress) {
  check(sides, columns, rows);
  const CombinedMaterial surfaces = bodies_.surfaces();
  InfluenceRows sum(columns, rows);
  for (int j = 0; j < rows; ++j)
    for (int i = 1 - columns; i < columns; ++i)
      sum.at(i, j) = half_space_influence(surfaces, sides, i * sides.dx, j * sides.dy);
  const double speed = std::abs(bodies_.speed);
  const auto add_creep_and_layers = [&](const LayeredBody& body, std::optional<RolledLayers>& layers, double side,
                                        const Progress& on) {
    InfluenceRows of_body(columns, rows);
    const std::vector<HalfSpaceCreep> creep = half_space_creep(body.top());
    if (!creep.empty()) add_creep(creep, speed, sides, part(on, 0, 0.3), of_body);
    if (layers) layers->add(speed, sides, part(on, 0.3, 1), of_body);
    add_body(of_body, side, sum);
  };
  add_creep_and_layers(bodies_.body1, layers1_, 1, part(progress, 0, 0.5));
  add_creep_and_layers(bodies_.body2, layers2_, -1, part(progress, 0.5, 1));
  return sum;
}

LayeredInfluence::LayeredInfluence(LayeredSurfaces& surfaces, const ElementSides& sides, int columns, int rows,
                                   const Progress& progress)
    : rows_(surfaces.find(sides, columns, rows, progress)), mirrored_(surfaces.bodies().speed < 0) {}

LayeredInfluence::LayeredInfluence(const LayeredBodies& bodies, const ElementSides& sides, int columns, int rows,
                                   const Progress& progress)
    : rows_(LayeredSurfaces(bodies).find(sides, columns, rows, progress)), mirrored_(bodies.speed < 0) {}

Influence LayeredInfluence::at(int i, int j) const {
  Influence a = mirrored_ ? mirrored_in_x(rows_.at(-i, std::abs(j))) : rows_.at(i, std::abs(j));
  if (j < 0) a.xy = -a.xy, a.yz = -a.yz;
  return a;
}

std::shared_ptr<const InfluenceTable> layered_table(const LayeredBodies& bodies, const ElementGrid& grid,
                                                    const Progress& progress) {
  LayeredSurfaces surfaces(bodies);
  return layered_table(surfaces, grid, {}, progress);
}

std::shared_ptr<const InfluenceTable> layered_table(LayeredSurfaces& surfaces, const ElementGrid& grid,
                                                    std::optional<double> far, const Progress& progress, int ahead) {
  check(grid);
  const int columns = grid.mx + ahead;
  if (!far) far = grid.mx * grid.dx;
  const ElementSides sides = {grid.dx, grid.dy, grid.line ? far : std::nullopt, grid.shape};
  const LayeredInfluence influence(surfaces, sides, columns, grid.my, progress);
  const bool symmetric = surfaces.bodies().are_elastic();
  auto table = std::make_shared<InfluenceTable>(columns, grid.my, grid.dx, grid.dy,
                                                InfluenceTable::Kind{symmetric, grid.line, grid.shape});
  for (int j = 1 - grid.my; j < grid.my; ++j)
    for (int i = symmetric ? 0 : 1 - columns; i < columns; ++i) {
      const Influence a = influence.at(i, j);
      table->at(i, j) = {a.xx, a.xy, a.xz, a.xy, a.yy, a.yz, -a.xz, -a.yz, a.zz};
    }
  return table;
}

} // namespace microslip
