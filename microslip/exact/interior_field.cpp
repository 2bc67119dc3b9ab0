#include "microslip/exact/interior_field.hpp"

#include "microslip/elasticity/bilinear_interior_influence.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/memory_need.hpp"

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
constexpr double memory_for_point = 700;

ElementGrid with_margin(ElementGrid grid, int margin) {
  require_count("margin", margin, 0, 10000);
  grid.mx += 2 * margin;
  grid.x0 -= margin * grid.dx;
  if (!grid.line) {
    grid.my += 2 * margin;
    grid.y0 -= margin * grid.dy;
  }
  const auto points = static_cast<double>(grid.count());
  if (points * memory_for_point > physical_memory())
    throw Error("points of a plane", points, "-", "no more than this machine has memory for, 700 bytes each");
  return grid;
}

/// Values of a grid in the midst of a larger one.
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
                             const SurfaceTractions& tractions)
    : material_(material), body_(body), grid_(grid) {
  check(grid);
  if (!(material.shear_modulus > 0))
    throw Error("shear_modulus", material.shear_modulus, "Pa", "positive, or infinite for a rigid body");
  require_between("poisson_ratio", material.poisson_ratio, "-", 0, 0.5);
  px_ = copy_of("px", tractions.px, grid.count());
  py_ = copy_of("py", tractions.py, grid.count());
  pn_ = copy_of("pn", tractions.pn, grid.count());
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * grid.mx + i;
      if (px_[k] != 0 || py_[k] != 0 || pn_[k] != 0) loaded_.push_back({grid.x(i), grid.y(j), px_[k], py_[k], pn_[k]});
    }
}

InteriorInfluence InteriorField::influence(double x, double y, double depth) const {
  const double far = grid_.mx * grid_.dx;
  if (grid_.shape == ElementShape::bilinear)
    return grid_.line ? bilinear_line_interior_influence(material_, body_, grid_.dx, x, depth, far)
                      : bilinear_interior_influence(material_, body_, grid_.dx, grid_.dy, x, y, depth);
  if (grid_.line) return line_interior_influence(material_, body_, grid_.dx, x, depth, far);
  return interior_influence(material_, body_, grid_.dx, grid_.dy, x, y, depth);
}

InteriorState InteriorField::at(const InteriorPoint& point) const {
  require_finite("x", point.x, "m");
  require_finite("y", point.y, "m");
  require_depth(point.depth);
  InteriorState sum;
  for (const LoadedElement& e : loaded_) {
    const InteriorInfluence a = influence(point.x - e.x, point.y - e.y, point.depth);
    if (e.px != 0) add(sum, e.px, a.px);
    if (e.py != 0) add(sum, e.py, a.py);
    if (e.pn != 0) add(sum, e.pn, a.pn);
  }
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
    : field_(std::move(field)), grid_(with_margin(field_.grid(), margin)), transform_(grid_.mx, grid_.my, 3) {
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

std::vector<double> InteriorLayers::kernel(int load, int component,
                                           const std::vector<InteriorInfluence>& quadrant) const {
  const bool odd_x = odd_load[load].x != odd_component[component].x;
  const bool odd_y = odd_load[load].y != odd_component[component].y;
  const int width = 2 * grid_.mx - 1;
  std::vector<double> table(static_cast<std::size_t>(width) * (2 * grid_.my - 1));
  for (int j = 1 - grid_.my; j < grid_.my; ++j) {
    double* row = table.data() + static_cast<std::size_t>(j + grid_.my - 1) * width + (grid_.mx - 1);
    const InteriorInfluence* from = quadrant.data() + static_cast<std::size_t>(std::abs(j)) * grid_.mx;
    const double sign = odd_y && j < 0 ? -1 : 1;
    for (int i = 0; i < grid_.mx; ++i) {
      const double value = sign * component_of(from[i].*loads[load], component);
      row[-i] = odd_x ? -value : value;
      row[i] = value;
    }
  }
  return table;
}

std::vector<InteriorState> InteriorLayers::at_depth(double depth) {
  require_depth(depth);
  std::vector<InteriorState> states(grid_.count());
  if (loads_.empty()) return states;
  std::vector<InteriorInfluence> quadrant(grid_.count());
#pragma omp parallel for if (grid_.count() > 1000)
  for (int j = 0; j < grid_.my; ++j)
    for (int i = 0; i < grid_.mx; ++i)
      quadrant[static_cast<std::size_t>(j) * grid_.mx + i] = field_.influence(i * grid_.dx, j * grid_.dy, depth);

  std::vector<double> values(grid_.count());
  std::vector<ToeplitzTransform::Spectrum> spectra(loads_.size());
  std::vector<const ToeplitzTransform::Spectrum*> pointers;
  for (const auto& spectrum : spectra) pointers.push_back(&spectrum);
  for (int component = 0; component < components; ++component) {
    for (std::size_t l = 0; l < loads_.size(); ++l)
      spectra[l] = transform_.kernel_spectrum(kernel(loads_[l], component, quadrant));
    transform_.apply(pointers, std::array{std::span<double>(values)});
    for (std::size_t k = 0; k < states.size(); ++k) component_of(states[k], component) = values[k];
  }
  return states;
}

} // namespace microslip
