#include "microslip/interior/interior_grid.hpp"

#include "microslip/error.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace microslip {
namespace {

/// Points in a plane from which on transforms cost less than sums.
constexpr std::size_t several = 8;

/// The numbers of the elements whose centres these coordinates are; none if one is not.
std::optional<std::vector<int>> centres(const std::vector<double>& coordinates, double first, double size, int count) {
  std::vector<int> indices;
  for (const double at : coordinates) {
    const double index = std::round((at - first) / size);
    if (!(index >= 0 && index < count) || std::abs(first + index * size - at) > 1e-9 * size) return {};
    indices.push_back(static_cast<int>(index));
  }
  return indices;
}

std::vector<InteriorPoint> plane_of(const InteriorGrid& points, double depth) {
  std::vector<InteriorPoint> plane;
  for (const double y : points.y)
    for (const double x : points.x) plane.push_back({x, y, depth});
  return plane;
}

InteriorField field_of(const InteriorBody& body, Body number, const ElementGrid& elements,
                       const SurfaceTractions& tractions) {
  if (body.layered) return {*body.layered, number, elements, tractions, body.speed};
  return {body.material, number, elements, tractions, body.retardation};
}

/// A measure of stress, what counts as extreme, and, where the measure costs more than it, a bound of that.
struct Measure {
  const char* name;
  double (*value)(const Stress& stress);
  double (*size)(double value);
  double (*bound)(const Stress& stress, double von_mises) = nullptr;
};

double magnitude(double value) {
  return std::abs(value);
}
double largest(double value) {
  return value;
}
double smallest(double value) {
  return -value;
}

/// Allowance for rounding in what follows.
constexpr double slack = 1e-12;

// Principal stresses differ from the mean of all three by at most 2/3 of von Mises' stress, and from one another by at
// most 2/sqrt(3) of it: they are 2/3 cos(t), 2/3 cos(t + 2 pi/3), 2/3 cos(t + 4 pi/3) of it.
double bound_of_difference(const Stress&, double von_mises) {
  return 2 / std::numbers::sqrt3 * von_mises * (1 + slack);
}
double bound_of_tension(const Stress& s, double von_mises) {
  return hydrostatic(s) + 2.0 / 3 * von_mises + slack * (std::abs(hydrostatic(s)) + von_mises);
}
double bound_of_compression(const Stress& s, double von_mises) {
  return -hydrostatic(s) + 2.0 / 3 * von_mises + slack * (std::abs(hydrostatic(s)) + von_mises);
}

constexpr Measure measures[] = {
    {"sigma_hyd", hydrostatic, magnitude},
    {"von_mises", von_mises, largest},
    {"tresca", tresca, largest, bound_of_difference},
    {"sigma_1", [](const Stress& s) { return principal_stresses(s)[0]; }, largest, bound_of_tension},
    {"sigma_3", [](const Stress& s) { return principal_stresses(s)[2]; }, smallest, bound_of_compression},
    {"sigma_xx", [](const Stress& s) { return s.xx; }, magnitude},
    {"sigma_yy", [](const Stress& s) { return s.yy; }, magnitude},
    {"sigma_zz", [](const Stress& s) { return s.zz; }, magnitude},
};

/// Returns whether all elements lie on their columns of the grid, those at an edge a little beside their centres.
bool follow_columns(const Elements& e) {
  for (std::size_t k = 0; k < e.size(); ++k)
    if (std::abs(e.x[k] - e.grid.x(static_cast<int>(k % e.mx()))) > e.grid.dx / 2 * (1 + 1e-9)) return false;
  return true;
}

/// Tractions of the grid's elements that have the forces of these ones. Where rows are divided along their lengths,
/// an element's force is shared out by overlap.
std::vector<double> on_grid(const Elements& e, const std::vector<double>& traction) {
  std::vector<double> regular(e.size());
  const double whole = e.grid.element_area();
  if (follow_columns(e)) {
    for (std::size_t k = 0; k < e.size(); ++k) regular[k] = traction[k] * e.area[k] / whole;
    return regular;
  }
  const double left = e.grid.x0 - e.grid.dx / 2;
  for (int j = 0; j < e.my(); ++j)
    for (int i = 0; i < e.mx(); ++i) {
      const std::size_t k = e.index(i, j);
      const double begin = (e.x[k] - e.width[k] / 2 - left) / e.grid.dx, end = begin + e.width[k] / e.grid.dx;
      const double force = traction[k] * e.area[k] / whole;
      for (int column = std::max(static_cast<int>(begin), 0); column < std::min(end, double(e.mx())); ++column) {
        const double overlap = std::min(end, column + 1.0) - std::max(begin, double(column));
        regular[e.index(column, j)] += force * overlap / (end - begin);
      }
    }
  return regular;
}

} // namespace

InteriorLayers& InteriorSequence::layers_of(const InteriorBody& body, Body number, const ElementGrid& elements,
                                            const SurfaceTractions& tractions, const Progress& progress) {
  auto& known = bodies_[number == Body::first ? 0 : 1];
  if (known && known->body == body && known->layers.grid() == elements)
    known->layers.set_tractions(tractions, progress);
  else
    known.emplace(OfBody{body, InteriorLayers(field_of(body, number, elements, tractions), 0, progress)});
  return known->layers;
}

std::vector<InteriorState> InteriorSequence::states(const InteriorBody& body1, const InteriorBody& body2,
                                                    const ElementGrid& elements, const SurfaceTractions& tractions,
                                                    const InteriorGrid& points, const Progress& progress) {
  const auto columns = centres(points.x, elements.x0, elements.dx, elements.mx);
  const auto rows = centres(points.y, elements.y0, elements.dy, elements.my);
  const bool transforms = columns && rows && points.x.size() * points.y.size() >= several;
  std::array<InteriorLayers*, 2> layers{};
  std::array<std::optional<InteriorField>, 2> fields;
  std::vector<InteriorState> all;
  for (std::size_t k = 0; k < points.z.size(); ++k) {
    const double z = points.z[k], planes = static_cast<double>(points.z.size());
    const Progress of_plane =
        essential_part(progress, static_cast<double>(k) / planes, (static_cast<double>(k) + 1) / planes);
    go_on(of_plane, 0);
    const std::size_t n = z < 0 ? 1 : 0;
    const InteriorBody& body = z < 0 ? body2 : body1;
    const Body number = z < 0 ? Body::second : Body::first;
    std::vector<InteriorState> plane;
    if (transforms) {
      if (layers[n] == nullptr) layers[n] = &layers_of(body, number, elements, tractions, of_plane);
      plane = layers[n]->at_depth(std::abs(z), *columns, *rows, of_plane);
    } else {
      if (!fields[n]) fields[n].emplace(field_of(body, number, elements, tractions));
      plane = fields[n]->at(plane_of(points, std::abs(z)), of_plane);
    }
    all.insert(all.end(), plane.begin(), plane.end());
  }
  return all;
}

std::vector<InteriorState> interior_states(const InteriorBody& body1, const InteriorBody& body2,
                                           const ElementGrid& elements, const SurfaceTractions& tractions,
                                           const InteriorGrid& points, const Progress& progress) {
  return InteriorSequence().states(body1, body2, elements, tractions, points, progress);
}

std::vector<InteriorState> interior_states(const InteriorBody& body1, const InteriorBody& body2,
                                           const ContactSolution& solution, const InteriorGrid& points,
                                           const Progress& progress) {
  const Elements& e = solution.elements;
  const SurfaceFields& f = solution.fields;
  if (f.pressure.size() != e.size()) throw Error("solution: has no pressures; stresses need one of the exact theory");
  if (e.size() == 0) return {};
  const auto px = on_grid(e, f.traction.x), py = on_grid(e, f.traction.y), pn = on_grid(e, f.pressure);
  return interior_states(body1, body2, e.grid, {px, py, pn}, points, progress);
}

std::vector<InteriorExtreme> interior_extremes(const std::vector<InteriorState>& states) {
  std::vector<InteriorExtreme> extremes;
  if (states.empty()) return extremes;
  for (const Measure& measure : measures) extremes.push_back({measure.name, measure.value(states[0].stress), 0});
  for (std::size_t k = 1; k < states.size(); ++k) {
    const Stress& stress = states[k].stress;
    const double equivalent = von_mises(stress);
    for (std::size_t m = 0; m < extremes.size(); ++m) {
      const Measure& measure = measures[m];
      const double extreme = measure.size(extremes[m].value);
      if (measure.bound != nullptr && measure.bound(stress, equivalent) <= extreme) continue;
      const double value = measure.value(stress);
      if (measure.size(value) > extreme) extremes[m] = {measure.name, value, k};
    }
  }
  return extremes;
}

} // namespace microslip
