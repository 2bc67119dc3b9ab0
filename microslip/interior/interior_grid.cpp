#include "microslip/interior/interior_grid.hpp"

#include "microslip/error.hpp"

#include <cmath>
#include <optional>

namespace microslip {
namespace {

/// From so many points in a plane on transforms cost less than sums.
constexpr std::size_t many = 32;

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

using States = std::vector<InteriorState>;

/// The planes z of one body.
class BodyStates {
public:
  BodyStates(const InteriorBody& of, Body body, const ElementGrid& elements, const SurfaceTractions& tractions,
             const InteriorGrid& points)
      : points_(points), field_(of.material, body, elements, tractions, of.retardation),
        columns_(centres(points.x, elements.x0, elements.dx, elements.mx)),
        rows_(centres(points.y, elements.y0, elements.dy, elements.my)) {
    if (columns_ && rows_ && points.x.size() * points.y.size() >= many) layers_.emplace(field_);
  }

  States at_depth(double depth) { return layers_ ? from_layer(depth) : from_sums(depth); }

private:
  States from_layer(double depth) {
    const States all = layers_->at_depth(depth);
    States chosen;
    for (const int j : *rows_)
      for (const int i : *columns_) chosen.push_back(all[static_cast<std::size_t>(j) * layers_->grid().mx + i]);
    return chosen;
  }

  States from_sums(double depth) const {
    std::vector<InteriorPoint> plane;
    for (const double y : points_.y)
      for (const double x : points_.x) plane.push_back({x, y, depth});
    return field_.at(plane);
  }

  const InteriorGrid& points_;
  InteriorField field_;
  std::optional<std::vector<int>> columns_, rows_;
  std::optional<InteriorLayers> layers_;
};

/// A measure of stress, and what counts as extreme.
struct Measure {
  const char* name;
  double (*value)(const Stress& stress);
  double (*size)(double value);
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

constexpr Measure measures[] = {
    {"sigma_hyd", hydrostatic, magnitude},
    {"von_mises", von_mises, largest},
    {"tresca", tresca, largest},
    {"sigma_1", [](const Stress& s) { return principal_stresses(s)[0]; }, largest},
    {"sigma_3", [](const Stress& s) { return principal_stresses(s)[2]; }, smallest},
    {"sigma_xx", [](const Stress& s) { return s.xx; }, magnitude},
    {"sigma_yy", [](const Stress& s) { return s.yy; }, magnitude},
    {"sigma_zz", [](const Stress& s) { return s.zz; }, magnitude},
};

} // namespace

std::vector<InteriorState> interior_states(const InteriorBody& body1, const InteriorBody& body2,
                                           const ElementGrid& elements, const SurfaceTractions& tractions,
                                           const InteriorGrid& points) {
  std::optional<BodyStates> first, second;
  States all;
  for (const double z : points.z) {
    auto& body = z < 0 ? second : first;
    if (!body) body.emplace(z < 0 ? body2 : body1, z < 0 ? Body::second : Body::first, elements, tractions, points);
    const States plane = body->at_depth(std::abs(z));
    all.insert(all.end(), plane.begin(), plane.end());
  }
  return all;
}

std::vector<InteriorState> interior_states(const InteriorBody& body1, const InteriorBody& body2,
                                           const ContactSolution& solution, const InteriorGrid& points) {
  const Elements& e = solution.elements;
  const SurfaceFields& f = solution.fields;
  if (f.pressure.size() != e.size()) throw Error("solution: has no pressures; stresses need one of the exact theory");
  std::vector<double> px(f.traction.x), py(f.traction.y), pn(f.pressure);
  for (std::size_t k = 0; k < e.size(); ++k) {
    const double share = e.area[k] / e.grid.element_area();
    px[k] *= share;
    py[k] *= share;
    pn[k] *= share;
  }
  if (e.size() == 0) return {};
  return interior_states(body1, body2, e.grid, {px, py, pn}, points);
}

std::vector<InteriorExtreme> interior_extremes(const std::vector<InteriorState>& states) {
  std::vector<InteriorExtreme> extremes;
  if (states.empty()) return extremes;
  for (const Measure& measure : measures) {
    InteriorExtreme found{measure.name, measure.value(states[0].stress), 0};
    for (std::size_t k = 1; k < states.size(); ++k) {
      const double value = measure.value(states[k].stress);
      if (measure.size(value) > measure.size(found.value)) found = {measure.name, value, k};
    }
    extremes.push_back(found);
  }
  return extremes;
}

} // namespace microslip
