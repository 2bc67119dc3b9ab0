#include "microslip/interior/interior_field.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/elasticity/bilinear_interior_influence.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/halfspace/memory_need.hpp"
#include "microslip/exact/halfspace/retarded_influence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace microslip {
namespace {

// Loads and components by number, in the order of these tables.
constexpr std::array loads = {&InteriorInfluence::px, &InteriorInfluence::py, &InteriorInfluence::pn};
constexpr int components = 9;

template <class State> auto& component_of(State& s, int component) {
  auto& t = s.stress;
  const std::array all = {&s.ux, &s.uy, &s.uz, &t.xx, &t.yy, &t.zz, &t.xy, &t.xz, &t.yz};
  return *all[component];
}

/// Whether a load or a component changes its sign when x (y) does.
struct Odd {
  bool x, y;
};
constexpr std::array<Odd, 3> odd_load = {{{true, false}, {false, true}, {false, false}}};
constexpr std::array<Odd, components> odd_component = {{{true, false},
                                                        {false, true},
                                                        {false, false},
                                                        {false, false},
                                                        {false, false},
                                                        {false, false},
                                                        {true, true},
                                                        {true, false},
                                                        {false, true}}};

void add(InteriorState& sum, double p, const InteriorState& s) {
  sum.ux += p * s.ux;
  sum.uy += p * s.uy;
  sum.uz += p * s.uz;
  sum.stress.xx += p * s.stress.xx;
  sum.stress.yy += p * s.stress.yy;
  sum.stress.zz += p * s.stress.zz;
  sum.stress.xy += p * s.stress.xy;
  sum.stress.xz += p * s.stress.xz;
  sum.stress.yz += p * s.stress.yz;
}

double require_depth(double depth) {
  if (require_finite("depth", depth, "m") < 0) throw Error("depth", depth, "m", "at least 0");
  return depth;
}

std::vector<double> copy_of(const char* name, std::span<const double> p, std::size_t count) {
  if (p.empty()) return std::vector<double>(count);
  if (p.size() != count)
    throw Error(std::string("size of ") + name, double(p.size()), "-", "the number of elements, or 0");
  for (const double value : p) require_finite(name, value, "Pa");
  return {p.begin(), p.end()};
}

/// What InteriorLayers needs for a point, at most [bytes].
constexpr double memory_for_point = 700, memory_for_retarded_point = 1200;

ElementGrid with_margin(const InteriorField& field, int margin) {
  ElementGrid grid = field.grid();
  require_count("margin", margin, 0, most_cells);
  grid.mx += 2 * margin;
  grid.x0 -= margin * grid.dx;
  if (!grid.line) {
    grid.my += 2 * margin;
    grid.y0 -= margin * grid.dy;
  }
  const auto points = static_cast<double>(grid.count());
  const double bytes = field.has_retardation() ? memory_for_retarded_point : memory_for_point;
  if (points * bytes > physical_memory())
    throw Error("points of a plane", points, "-",
                "no more than this machine has memory for, " + std::to_string(std::lround(bytes)) + " bytes each");
  return grid;
}

/// Values of a grid in the middle of a larger one.
std::vector<double> embedded(const std::vector<double>& values, const ElementGrid& inner, const ElementGrid& outer) {
  const int columns = (outer.mx - inner.mx) / 2, rows = (outer.my - inner.my) / 2;
  std::vector<double> out(outer.count());
  for (int j = 0; j < inner.my; ++j)
    std::copy_n(values.begin() + std::ptrdiff_t(j) * inner.mx, inner.mx,
                out.begin() + std::ptrdiff_t(j + rows) * outer.mx + columns);
  return out;
}

bool any(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double v) { return v != 0; });
}

} // namespace

InteriorField::InteriorField(const Material& material, Body body, const ElementGrid& grid,
                             const SurfaceTractions& tractions, const Retardation& retardation)
    : material_(material), delay_(retardation), body_(body), grid_(grid) {
  check(grid);
  if (!(material.shear_modulus > 0))
    throw Error("shear_modulus", material.shear_modulus, "Pa", "positive, or infinite for a rigid body");
  require_between("poisson_ratio", material.poisson_ratio, "-", 0, 0.5);
  px_ = copy_of("px", tractions.px, grid.count());
  py_ = copy_of("py", tractions.py, grid.count());
  pn_ = copy_of("pn", tractions.pn, grid.count());
  require_between("retardation.ratio", retardation.ratio, "-", 0, 1e6);
  require_finite("retardation.distance", retardation.distance, "m");
  for (int j = 0; j < grid.my; ++j) {
    const std::size_t begin = loaded_.size();
    for (int i = 0; i < grid.mx; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * grid.mx + i;
      if (px_[k] != 0 || py_[k] != 0 || pn_[k] != 0) loaded_.push_back({i, j, px_[k], py_[k], pn_[k]});
    }
    if (loaded_.size() > begin) loaded_rows_.push_back({begin, loaded_.size()});
  }
  if (!grid.line || !has_retardation()) return;
  // As in the contact problem: on the average 0 where the elastic displacements are.
  const double far = grid.mx * grid.dx;
  const InteriorInfluence behind = retarded_influence(-far, 1, 0, 0)[0], ahead = retarded_influence(far, 1, 0, 0)[0];
  retarded_far_away_.px.ux = (behind.px.ux + ahead.px.ux) / 2;
  retarded_far_away_.py.uy = (behind.py.uy + ahead.py.uy) / 2;
  retarded_far_away_.pn.uz = (behind.pn.uz + ahead.pn.uz) / 2;
}

InteriorInfluence InteriorField::influence(double x, double y, double depth) const {
  const double far = grid_.mx * grid_.dx;
  if (grid_.shape == ElementShape::bilinear)
    return grid_.line ? bilinear_line_interior_influence(material_, body_, grid_.dx, x, depth, far)
                      : bilinear_interior_influence(material_, body_, grid_.dx, grid_.dy, x, y, depth);
  if (grid_.line) return line_interior_influence(material_, body_, grid_.dx, x, depth, far);
  return interior_influence(material_, body_, grid_.dx, grid_.dy, x, y, depth);
}

std::vector<InteriorInfluence> InteriorField::retarded_influence(double x_first, int count, double y,
                                                                 double depth) const {
  std::vector<InteriorInfluence> row = retarded_row<InteriorInfluence>(
      delay_, [&](double x) { return influence(x, y, depth); }, grid_.dx, x_first, count);
  for (InteriorInfluence& a : row) {
    a.px.ux -= retarded_far_away_.px.ux;
    a.py.uy -= retarded_far_away_.py.uy;
    a.pn.uz -= retarded_far_away_.pn.uz;
  }
  return row;
}

/// Row by row, as the history of an element's displacement is that of the next one as well.
void InteriorField::add_late(const InteriorPoint& point, InteriorState& sum) const {
  for (const auto& [begin, end] : loaded_rows_) {
    const int first = loaded_[begin].i, last = loaded_[end - 1].i, row = loaded_[begin].j;
    const auto retarded =
        retarded_influence(point.x - grid_.x(last), last - first + 1, point.y - grid_.y(row), point.depth);
    for (std::size_t k = begin; k < end; ++k) {
      const InteriorInfluence& a = retarded[static_cast<std::size_t>(last - loaded_[k].i)];
      add(sum, loaded_[k].px, a.px);
      add(sum, loaded_[k].py, a.py);
      add(sum, loaded_[k].pn, a.pn);
    }
  }
}

InteriorState InteriorField::at(const InteriorPoint& point) const {
  require_finite("x", point.x, "m");
  require_finite("y", point.y, "m");
  require_depth(point.depth);
  InteriorState sum;
  for (const LoadedElement& e : loaded_) {
    const InteriorInfluence a = influence(point.x - grid_.x(e.i), point.y - grid_.y(e.j), point.depth);
    if (e.px != 0) add(sum, e.px, a.px);
    if (e.py != 0) add(sum, e.py, a.py);
    if (e.pn != 0) add(sum, e.pn, a.pn);
  }
  if (has_retardation()) add_late(point, sum);
  return sum;
}

std::vector<InteriorState> InteriorField::at(std::span<const InteriorPoint> points) const {
  for (const InteriorPoint& p : points) { // exceptions must not leave a parallel loop
    require_finite("x", p.x, "m");
    require_finite("y", p.y, "m");
    require_depth(p.depth);
  }
  std::vector<InteriorState> states(points.size());
  const auto count = static_cast<std::ptrdiff_t>(points.size());
#pragma omp parallel for schedule(static, 16) if (count * std::ptrdiff_t(loaded_.size()) > 100000)
  for (std::ptrdiff_t k = 0; k < count; ++k) states[k] = at(points[k]);
  return states;
}

InteriorLayers::InteriorLayers(InteriorField field, int margin)
    : field_(std::move(field)), grid_(with_margin(field_, margin)), transform_(grid_.mx, grid_.my, 3) {
  const std::array all = {&field_.px(), &field_.py(), &field_.pn()};
  std::vector<std::vector<double>> padded;
  for (int load = 0; load < 3; ++load)
    if (any(*all[load])) {
      loads_.push_back(load);
      padded.push_back(embedded(*all[load], field_.grid(), grid_));
    }
  const std::vector<std::span<const double>> spans(padded.begin(), padded.end());
  transform_.load(spans);
}

InteriorLayers::Influences InteriorLayers::influences(double depth) const {
  const int width = 2 * grid_.mx - 1;
  Influences found;
  found.quadrant.resize(grid_.count());
  if (field_.has_retardation()) found.retarded.resize(static_cast<std::size_t>(width) * grid_.my);
#pragma omp parallel for schedule(dynamic) if (grid_.count() > 1000 || field_.has_retardation())
  for (int j = 0; j < grid_.my; ++j) {
    const double y = j * grid_.dy;
    for (int i = 0; i < grid_.mx; ++i)
      found.quadrant[static_cast<std::size_t>(j) * grid_.mx + i] = field_.influence(i * grid_.dx, y, depth);
    if (!field_.has_retardation()) continue;
    const auto row = field_.retarded_influence((1 - grid_.mx) * grid_.dx, width, y, depth);
    std::copy(row.begin(), row.end(), found.retarded.begin() + std::ptrdiff_t(j) * width);
  }
  return found;
}

std::vector<double> InteriorLayers::kernel(int load, int component, const Influences& influences) const {
  const bool odd_x = odd_load[load].x != odd_component[component].x;
  const bool odd_y = odd_load[load].y != odd_component[component].y;
  const int width = 2 * grid_.mx - 1;
  std::vector<double> table(static_cast<std::size_t>(width) * (2 * grid_.my - 1));
  for (int j = 1 - grid_.my; j < grid_.my; ++j) {
    double* row = table.data() + static_cast<std::size_t>(j + grid_.my - 1) * width;
    const auto from = static_cast<std::size_t>(std::abs(j));
    const double sign = odd_y && j < 0 ? -1 : 1;
    const auto value = [&](const InteriorInfluence& a) { return sign * component_of(a.*loads[load], component); };
    for (int i = 0; i < grid_.mx; ++i) {
      const double here = value(influences.quadrant[from * grid_.mx + i]);
      row[grid_.mx - 1 - i] = odd_x ? -here : here;
      row[grid_.mx - 1 + i] = here;
    }
    if (influences.retarded.empty()) continue;
    for (int i = 0; i < width; ++i) row[i] += value(influences.retarded[from * width + i]);
  }
  return table;
}

std::vector<InteriorState> InteriorLayers::at_depth(double depth) {
  require_depth(depth);
  std::vector<InteriorState> states(grid_.count());
  if (loads_.empty()) return states;
  const Influences found = influences(depth);

  std::vector<double> values(grid_.count());
  std::vector<ToeplitzTransform::Spectrum> spectra(loads_.size());
  std::vector<const ToeplitzTransform::Spectrum*> pointers;
  for (const auto& spectrum : spectra) pointers.push_back(&spectrum);
  for (int component = 0; component < components; ++component) {
    for (std::size_t l = 0; l < loads_.size(); ++l)
      spectra[l] = transform_.kernel_spectrum(kernel(loads_[l], component, found));
    transform_.apply(pointers, std::array{std::span<double>(values)});
    for (std::size_t k = 0; k < states.size(); ++k) component_of(states[k], component) = values[k];
  }
  return states;
}

} // namespace microslip
