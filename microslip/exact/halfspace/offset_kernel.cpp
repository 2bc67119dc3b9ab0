#include "microslip/exact/halfspace/offset_kernel.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/elasticity/bilinear_influence.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/halfspace/retarded_influence.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace microslip {
namespace {

/// Distance at which an endless strip's displacement is 0 [m].
double far_of(const ElementGrid& grid) {
  return grid.mx * grid.dx;
}

/// The influence of an element of the grid, constant or bilinear.
Influence influence_at(const CombinedMaterial& material, const ElementGrid& grid, double x, double y) {
  if (grid.shape == ElementShape::constant) return element_influence(material, grid, grid.dx, x, y);
  return grid.line ? bilinear_line_influence(material, grid.dx, x, far_of(grid))
                   : bilinear_influence(material, grid.dx, grid.dy, x, y);
}

/// 1 for a point within an element of length `side`, half on its edge; `x` is its distance from the centre.
double share_within(double x, double side) {
  constexpr double rounding = 1e-9;
  const double distance = 2 * std::abs(x) / side;
  return distance < 1 - rounding ? 1 : distance < 1 + rounding ? 0.5 : 0;
}

/// A layer is sheared where the traction is: on the element itself, and half on its edges.
void add_layer(double flexibility, double dx, double first, std::vector<Influence>& row) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    const double share = share_within(first + static_cast<double>(i) * dx, dx);
    row[i].xx += share * flexibility;
    row[i].yy += share * flexibility;
  }
}

/// Displacements of a line contact are known up to a constant: the one that makes the mean of the retarded ones 0 at
/// the two points where the elastic ones are.
Influence far_away(const Retardation& retardation, const RowInfluence<Influence>& influence, const ElementGrid& grid) {
  const double far = far_of(grid);
  const Influence a = retarded_row(retardation, influence, grid.dx, -far, 1)[0];
  const Influence b = retarded_row(retardation, influence, grid.dx, far, 1)[0];
  return {(a.xx + b.xx) / 2, 0, (a.yy + b.yy) / 2, (a.zz + b.zz) / 2, 0, 0};
}

/// The influence at a point's mirror images.
Influence mirrored_along_x(const Influence& a) {
  return {a.xx, -a.xy, a.yy, a.zz, -a.xz, a.yz};
}
Influence mirrored_along_y(const Influence& a) {
  return {a.xx, -a.xy, a.yy, a.zz, a.xz, -a.yz};
}

/// The elastic influence on the points of a row at the distance y, `shift` further along x, at all offsets from 1 - mx
/// on: where points are those of elements each is computed on one side only.
std::vector<Influence> elastic_row(const CombinedMaterial& material, const ElementGrid& grid, double shift, double y) {
  const double columns = shift / grid.dx;
  std::vector<Influence> row, side;
  row.reserve(2 * static_cast<std::size_t>(grid.mx) - 1);
  if (columns != std::round(columns) || std::abs(columns) > grid.mx) {
    for (int i = 1 - grid.mx; i < grid.mx; ++i) row.push_back(influence_at(material, grid, i * grid.dx + shift, y));
    return row;
  }
  const auto further = static_cast<int>(columns);
  for (int i = 0; i < grid.mx + std::abs(further); ++i) side.push_back(influence_at(material, grid, i * grid.dx, y));
  for (int i = 1 - grid.mx + further; i < grid.mx + further; ++i)
    row.push_back(i < 0 ? mirrored_along_x(side[static_cast<std::size_t>(-i)]) : side[static_cast<std::size_t>(i)]);
  return row;
}

/// The influence of an element on the points of row j, `shift` further, at all offsets from 1 - mx on.
std::vector<Influence> influence_row(const Bodies& bodies, const ElementGrid& grid, Vec2 shift, int j) {
  const double y = j * grid.dy + shift.y, first = (1 - grid.mx) * grid.dx + shift.x;
  const int count = 2 * grid.mx - 1;
  std::vector<Influence> row = elastic_row(bodies.material, grid, shift.x, y);
  for (const RetardedPart& part : bodies.retarded) {
    const RowInfluence<Influence> influence = [&](double x) { return influence_at(part.material, grid, x, y); };
    const std::vector<Influence> retarded = retarded_row(part.retardation, influence, grid.dx, first, count);
    const Influence far = grid.line ? far_away(part.retardation, influence, grid) : Influence{};
    for (std::size_t i = 0; i < retarded.size(); ++i) {
      row[i].xx += retarded[i].xx - far.xx, row[i].xy += retarded[i].xy, row[i].yy += retarded[i].yy - far.yy;
      row[i].xz += retarded[i].xz, row[i].yz += retarded[i].yz, row[i].zz += retarded[i].zz - far.zz;
    }
  }
  const double sheared = grid.line ? 1 : share_within(y, grid.dy);
  if (sheared > 0 && bodies.layer.flexibility > 0) add_layer(sheared * bodies.layer.flexibility, grid.dx, first, row);
  return row;
}

/// Contribution of a particle's displacement to its slip, (E14): (u(x + shift) - u(x + before))/length, or without the
/// second term.
struct SlipRate {
  Vec2 shift = {};
  double length = 1;
  std::optional<Vec2> before = {};
};

/// Calls at(i, j, slip, here) for all offsets of a grid: what the influence makes of slip, and the influence itself.
template <class At>
void for_offsets(const Bodies& bodies, const ElementGrid& grid, const SlipRate& rate, const Progress& progress, At at) {
  const bool mirrors = rate.shift.y == 0 && (!rate.before || rate.before->y == 0); // row -j is the image of row j
  for (int j = mirrors ? 0 : 1 - grid.my; j < grid.my; ++j) {
    go_on(progress, 0);
    const std::vector<Influence> now = influence_row(bodies, grid, rate.shift, j);
    const std::vector<Influence> before =
        rate.before ? influence_row(bodies, grid, *rate.before, j) : std::vector<Influence>(now.size());
    for (int i = 1 - grid.mx; i < grid.mx; ++i) {
      const auto k = static_cast<std::size_t>(i + grid.mx - 1);
      const auto of = [&](double Influence::*part) { return (now[k].*part - before[k].*part) / rate.length; };
      const Influence slip = {of(&Influence::xx), of(&Influence::xy), of(&Influence::yy),
                              of(&Influence::zz), of(&Influence::xz), of(&Influence::yz)};
      at(i, j, slip, now[k]);
      if (mirrors && j > 0) at(i, -j, mirrored_along_y(slip), mirrored_along_y(now[k]));
    }
  }
}

TangentialKernel tangential_kernel(const Bodies& bodies, const ElementGrid& grid, const SlipRate& rate,
                                   const Progress& progress) {
  check(grid);
  const OffsetTable empty(grid);
  TangentialKernel kernel{empty, empty, empty};
  for_offsets(bodies, grid, rate, progress, [&](int i, int j, const Influence& slip, const Influence&) {
    kernel.xx.at(i, j) = slip.xx;
    kernel.xy.at(i, j) = slip.xy;
    kernel.yy.at(i, j) = slip.yy;
  });
  return kernel;
}

CoupledKernel coupled_kernel(const Bodies& bodies, const ElementGrid& grid, const SlipRate& rate,
                             const Progress& progress) {
  check(grid);
  const OffsetTable empty(grid);
  const bool is_displacement = !rate.before && rate.shift.x == 0 && rate.shift.y == 0;
  CoupledKernel kernel{{empty, empty, empty}, {}, empty, empty, empty, empty, empty, is_displacement};
  if (is_displacement && bodies.are_elastic()) kernel.symmetric_over = rate.length;
  for_offsets(bodies, grid, rate, progress, [&](int i, int j, const Influence& slip, const Influence& here) {
    kernel.slip.xx.at(i, j) = slip.xx;
    kernel.slip.xy.at(i, j) = slip.xy;
    kernel.slip.yy.at(i, j) = slip.yy;
    kernel.xz.at(i, j) = slip.xz;
    kernel.yz.at(i, j) = slip.yz;
    kernel.zx.at(i, j) = -here.xz;
    kernel.zy.at(i, j) = -here.yz;
    kernel.zz.at(i, j) = here.zz;
  });
  return kernel;
}

InclinedKernel inclined_kernel(const Bodies& bodies, const ElementGrid& grid, const SlipRate& rate,
                               const Progress& progress) {
  check(grid);
  const OffsetTable empty(grid);
  const std::array<OffsetTable, 9> tables = {empty, empty, empty, empty, empty, empty, empty, empty, empty};
  InclinedKernel kernel{tables, tables};
  const auto set = [](std::array<OffsetTable, 9>& of, int i, int j, const Influence& a) {
    const double values[] = {a.xx, a.xy, a.xz, a.xy, a.yy, a.yz, -a.xz, -a.yz, a.zz};
    for (std::size_t k = 0; k < of.size(); ++k) of[k].at(i, j) = values[k];
  };
  for_offsets(bodies, grid, rate, progress, [&](int i, int j, const Influence& slip, const Influence& here) {
    set(kernel.slip, i, j, slip);
    set(kernel.displacement, i, j, here);
  });
  return kernel;
}

/// Columns or rows to a position [m] that is a whole number of elements ashift.
int whole_elements(const char* field, double distance, double size) {
  constexpr double rounding = 1e-6;
  const double count = std::round(distance / size);
  if (!(std::abs(distance / size - count) <= rounding && std::abs(count) <= most_cells))
    throw Error(field, distance, "m", "a whole number of elements with influence coefficients from a table");
  return static_cast<int>(count);
}

/// The influence on the element i columns and j rows further, also one column beyond a table that ends with the grid:
/// there along a straight line.
FullInfluence influence_in(const InfluenceTable& table, int i, int j) {
  if (std::abs(i) != table.mx() || table.mx() < 2) return table.find(i, j);
  const int inwards = i > 0 ? -1 : 1;
  const FullInfluence last = table.find(i + inwards, j), before = table.find(i + 2 * inwards, j);
  const auto along = [&](double FullInfluence::*part) { return 2 * last.*part - before.*part; };
  using A = FullInfluence;
  return {along(&A::xx), along(&A::xy), along(&A::xz), along(&A::yx), along(&A::yy),
          along(&A::yz), along(&A::zx), along(&A::zy), along(&A::zz)};
}

CoupledKernel table_kernel(const InfluenceTable& table, const ElementGrid& grid, const SlipRate& rate) {
  check(grid);
  const OffsetTable empty(grid);
  const auto columns = [&](Vec2 shift) { return whole_elements("step along x", shift.x, grid.dx); };
  const auto rows = [&](Vec2 shift) { return whole_elements("step along y", shift.y, grid.dy); };
  const Vec2 before = rate.before.value_or(Vec2{});
  const int i_now = columns(rate.shift), j_now = rows(rate.shift), i_before = columns(before), j_before = rows(before);
  CoupledKernel kernel{
      {empty, empty, empty}, empty, empty, empty, empty, empty, empty, !rate.before && i_now == 0 && j_now == 0};
  for (int j = 1 - grid.my; j < grid.my; ++j)
    for (int i = 1 - grid.mx; i < grid.mx; ++i) {
      const FullInfluence here = influence_in(table, i, j), now = influence_in(table, i + i_now, j + j_now);
      const FullInfluence past = rate.before ? influence_in(table, i + i_before, j + j_before) : FullInfluence{};
      const auto slip = [&](double FullInfluence::*part) { return (now.*part - past.*part) / rate.length; };
      kernel.slip.xx.at(i, j) = slip(&FullInfluence::xx);
      kernel.slip.xy.at(i, j) = slip(&FullInfluence::xy);
      kernel.slip.yy.at(i, j) = slip(&FullInfluence::yy);
      kernel.yx->at(i, j) = slip(&FullInfluence::yx);
      kernel.xz.at(i, j) = slip(&FullInfluence::xz);
      kernel.yz.at(i, j) = slip(&FullInfluence::yz);
      kernel.zx.at(i, j) = here.zx;
      kernel.zy.at(i, j) = here.zy;
      kernel.zz.at(i, j) = here.zz;
    }
  return kernel;
}

SlipRate difference_over(Vec2 step) {
  return {.shift = {}, .length = std::hypot(step.x, step.y), .before = step};
}

} // namespace

Influence element_influence(const CombinedMaterial& material, const ElementGrid& grid, double width, double x,
                            double y) {
  return grid.line ? line_influence(material, width, x, far_of(grid)) : influence(material, width, grid.dy, x, y);
}

OffsetTable normal_kernel(const CombinedMaterial& material, const ElementGrid& grid) {
  check(grid);
  OffsetTable zz(grid);
  for (int j = 1 - grid.my; j < grid.my; ++j)
    for (int i = 1 - grid.mx; i < grid.mx; ++i) zz.at(i, j) = normal_coefficient(material, grid, i, j);
  return zz;
}

double normal_coefficient(const CombinedMaterial& material, const ElementGrid& grid, int i, int j) {
  return influence_at(material, grid, i * grid.dx, j * grid.dy).zz;
}

void NormalRows::find(int j, std::span<double> entries) {
  const std::size_t count = entries.size();
  if (grid_.shape != ElementShape::constant) {
    for (std::size_t i = 0; i < count; ++i) entries[i] = normal_coefficient(material_, grid_, static_cast<int>(i), j);
    return;
  }
  if (!strips_) strips_ = half_strips(grid_, -0.5, count + 1);
  const HalfStrips::Row row = strips_->at(j);
  const double f = grid_.dx / (std::numbers::pi * material_.contact_modulus());
  for (std::size_t i = 0; i < count; ++i) entries[i] = f * (row.xx[i + 1] - row.xx[i] + row.yy[i + 1] - row.yy[i]);
}

HalfStrips half_strips(const ElementGrid& grid, std::vector<double> x) {
  return grid.line ? HalfStrips::endless(std::move(x), grid.mx) : HalfStrips(std::move(x), grid.dy / grid.dx);
}

HalfStrips half_strips(const ElementGrid& grid, double first, std::size_t count) {
  std::vector<double> x(count);
  for (std::size_t k = 0; k < count; ++k) x[k] = first + static_cast<double>(k);
  return half_strips(grid, std::move(x));
}

TangentialKernel TangentialKernel::displacement(const Bodies& bodies, const ElementGrid& grid, Vec2 shift,
                                                double length, const Progress& progress) {
  return tangential_kernel(bodies, grid, {.shift = shift, .length = length}, progress);
}
TangentialKernel TangentialKernel::difference(const Bodies& bodies, const ElementGrid& grid, Vec2 step,
                                              const Progress& progress) {
  return tangential_kernel(bodies, grid, difference_over(step), progress);
}

DisplacementQuadrant displacement_quadrant(const Bodies& bodies, const ElementGrid& grid, int columns,
                                           const Progress& progress) {
  check(grid);
  DisplacementQuadrant quadrant;
  for (auto* part : {&quadrant.xx, &quadrant.xy, &quadrant.yy})
    part->reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(grid.my));
  for (int j = 0; j < grid.my; ++j) {
    go_on(progress, 0);
    for (int i = 0; i < columns; ++i) {
      const Influence a = influence_at(bodies.material, grid, i * grid.dx, j * grid.dy);
      quadrant.xx.push_back(a.xx);
      quadrant.xy.push_back(a.xy);
      quadrant.yy.push_back(a.yy);
    }
  }
  quadrant.xx[0] += bodies.layer.flexibility; // sheared where the traction is
  quadrant.yy[0] += bodies.layer.flexibility;
  return quadrant;
}

double middle_eigenvalue(std::span<const double> quadrant, int mx) {
  double longest = 0, shortest = 0;
  for (std::size_t k = 0; k < quadrant.size(); ++k) {
    const std::size_t i = k % mx, j = k / mx;
    const double value = quadrant[k] * (i > 0 ? 2 : 1) * (j > 0 ? 2 : 1);
    longest += value;
    shortest += (i + j) % 2 == 0 ? value : -value;
  }
  return std::sqrt(std::max(longest, quadrant[0]) / 2 * std::max(shortest, 0.1 * quadrant[0]));
}

CoupledKernel CoupledKernel::displacement(const Bodies& bodies, const ElementGrid& grid, Vec2 shift, double length,
                                          const Progress& progress) {
  return coupled_kernel(bodies, grid, {.shift = shift, .length = length}, progress);
}
CoupledKernel CoupledKernel::difference(const Bodies& bodies, const ElementGrid& grid, Vec2 step,
                                        const Progress& progress) {
  return coupled_kernel(bodies, grid, difference_over(step), progress);
}

InclinedKernel InclinedKernel::displacements(const Bodies& bodies, const ElementGrid& grid, Vec2 shift, double length,
                                             const Progress& progress) {
  return inclined_kernel(bodies, grid, {.shift = shift, .length = length}, progress);
}
InclinedKernel InclinedKernel::difference(const Bodies& bodies, const ElementGrid& grid, Vec2 step,
                                          const Progress& progress) {
  return inclined_kernel(bodies, grid, difference_over(step), progress);
}

CoupledKernel CoupledKernel::displacement(const InfluenceTable& table, const ElementGrid& grid, Vec2 shift,
                                          double length) {
  return table_kernel(table, grid, {.shift = shift, .length = length});
}
CoupledKernel CoupledKernel::difference(const InfluenceTable& table, const ElementGrid& grid, Vec2 step) {
  return table_kernel(table, grid, difference_over(step));
}

} // namespace microslip
