#include "microslip/interior/layered_interior.hpp"

#include "microslip/elasticity/interior_response.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace microslip {
namespace {

constexpr double below_interface = 1 + 1e-9;
constexpr int most_margin = 100;    // elements
constexpr double no_tension = 1e-6; // of the largest normal stress

/// Tractions of elements of their own grid.
struct Load {
  ElementGrid grid;
  std::array<std::vector<double>, 3> p; ///< px, py, pn; empty ones are zero

  SurfaceTractions tractions() const { return {p[0], p[1], p[2]}; }
};

int joined_count(int elements, int n) {
  return (elements + n - 1) / n;
}

/// The means of n by n elements each; strips are joined along x.
Load joined(const ElementGrid& grid, const SurfaceTractions& tractions, int n) {
  Load load{grid, {}};
  const int rows = grid.line ? 1 : n;
  load.grid.mx = joined_count(grid.mx, n), load.grid.dx *= n, load.grid.x0 += (n - 1) * grid.dx / 2;
  if (!grid.line) load.grid.my = joined_count(grid.my, n), load.grid.dy *= n, load.grid.y0 += (n - 1) * grid.dy / 2;
  const std::array all = {tractions.px, tractions.py, tractions.pn};
  for (std::size_t part = 0; part < all.size(); ++part) {
    if (all[part].empty()) continue;
    load.p[part].resize(load.grid.count());
    for (int j = 0; j < grid.my; ++j)
      for (int i = 0; i < grid.mx; ++i)
        load.p[part][static_cast<std::size_t>(j / rows) * load.grid.mx + i / n] +=
            all[part][static_cast<std::size_t>(j) * grid.mx + i] / (n * rows);
  }
  return load;
}

/// Half the width of the loaded part, the smaller one of an area; half an element's without load.
double half_width(const ElementGrid& grid, const SurfaceTractions& tractions) {
  int first_x = grid.mx, last_x = 0, first_y = grid.my, last_y = 0;
  for (const auto& p : {tractions.px, tractions.py, tractions.pn})
    for (std::size_t k = 0; k < p.size(); ++k)
      if (p[k] != 0) {
        const int i = static_cast<int>(k % grid.mx), j = static_cast<int>(k / grid.mx);
        first_x = std::min(first_x, i), last_x = std::max(last_x, i);
        first_y = std::min(first_y, j), last_y = std::max(last_y, j);
      }
  const double along = 0.5 * std::max(last_x - first_x + 1, 1) * grid.dx,
               across = 0.5 * std::max(last_y - first_y + 1, 1) * grid.dy;
  return grid.line ? along : std::min(along, across);
}

struct PlanePeak {
  double value = -std::numeric_limits<double>::infinity();
  InteriorPoint place;
};

/// The summit of the parabola through values at -1, 0, 1 of which that at 0 is the largest: where it is, and how much
/// higher.
std::pair<double, double> summit(double left, double middle, double right) {
  const double bend = left - 2 * middle + right;
  if (!(bend < 0) || left > middle || right > middle) return {0, 0};
  const double at = (left - right) / (2 * bend);
  return {at, -bend * at * at / 2};
}

/// The largest value of a measure in a plane, between points by parabolas along x and y.
template <class Measure>
PlanePeak largest_of(const std::vector<InteriorState>& states, const ElementGrid& grid, double depth,
                     const Measure& measure) {
  std::vector<double> values(states.size());
  std::transform(states.begin(), states.end(), values.begin(),
                 [&](const InteriorState& state) { return measure(state.stress); });
  const auto k = static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
  const int i = static_cast<int>(k % grid.mx), j = static_cast<int>(k / grid.mx);
  PlanePeak peak{values[k], {grid.x(i), grid.y(j), depth}};
  const auto refine = [&](bool has_neighbours, std::size_t step, double size, double& place) {
    if (!has_neighbours) return;
    const auto [at, higher] = summit(values[k - step], values[k], values[k + step]);
    place += at * size, peak.value += higher;
  };
  refine(i > 0 && i + 1 < grid.mx, 1, grid.dx, peak.place.x);
  refine(j > 0 && j + 1 < grid.my, grid.mx, grid.dy, peak.place.y);
  return peak;
}

/// Planes of one layer, with elements joined as its depth allows.
class LayerPlanes {
public:
  /// `top`: the least depth of the planes, which reach as far beyond the elements as `reach`.
  LayerPlanes(const LayeredBody& body, Body number, double speed, const ElementGrid& grid,
              const SurfaceTractions& tractions, double top, double reach, const Progress& progress)
      : whole_(body, number, grid, tractions, speed), joined_(joined_in(grid, top)),
        layers_(planes(body, number, speed, joined(grid, tractions, joined_), reach, progress)) {}

  template <class Measure> PlanePeak largest(double depth, const Measure& measure, const Progress& progress) {
    return largest_of(layers_.at_depth(depth, progress), layers_.grid(), depth, measure);
  }

  /// The value at the place of a peak by all elements, where they were joined.
  template <class Measure> PlanePeak by_all(PlanePeak peak, const Measure& measure, const Progress& progress) const {
    if (joined_ > 1) peak.value = measure(whole_.at(peak.place, progress).stress);
    return peak;
  }

  /// Both of an interface, from the same states.
  InterfacePeak interface(Body body, int layer, double depth, const Progress& progress) {
    const auto shear_of = [](const Stress& s) { return std::hypot(s.xz, s.yz); };
    const auto tension_of = [](const Stress& s) { return s.zz; };
    const auto size_of = [](const Stress& s) { return std::abs(s.zz); };
    const std::vector<InteriorState> states = layers_.at_depth(depth, progress);
    const auto peak_of = [&](const auto& measure) { return largest_of(states, layers_.grid(), depth, measure); };
    const PlanePeak shear = by_all(peak_of(shear_of), shear_of, progress),
                    tension = by_all(peak_of(tension_of), tension_of, progress);
    const bool pulls = tension.value > no_tension * peak_of(size_of).value;
    return {body, layer, shear.value, shear.place, pulls ? tension.value : 0, tension.place};
  }

private:
  static double smaller_side(const ElementGrid& grid) { return grid.line ? grid.dx : std::min(grid.dx, grid.dy); }
  static int joined_in(const ElementGrid& grid, double top) {
    constexpr double elements_in_depth = 12;
    return std::max(1, static_cast<int>(std::min(top / elements_in_depth / smaller_side(grid), double(grid.mx))));
  }
  static InteriorLayers planes(const LayeredBody& body, Body number, double speed, const Load& load, double reach,
                               const Progress& progress) {
    const int margin = static_cast<int>(std::min(std::ceil(reach / smaller_side(load.grid)), double(most_margin)));
    return InteriorLayers(InteriorField(body, number, load.grid, load.tractions(), speed), margin, progress);
  }

  InteriorField whole_;
  int joined_; ///< elements along each side
  InteriorLayers layers_;
};

/// Depths of a layer between its top and bottom, or of a substrate: as far down as half the load's width and its top
/// tell that there is more than they, and the bottom.
std::vector<double> depths_of(double top, double bottom, double half_width) {
  const double end = 2.5 * top + 1.5 * half_width;
  std::vector<double> depths;
  double z = top;
  while (z < std::min(bottom, end)) {
    depths.push_back(z);
    z += std::max(half_width / 8, z / 3);
  }
  if (bottom < std::numeric_limits<double>::infinity()) {
    if (depths.size() == 1) depths.push_back((top + bottom) / 2);
    depths.push_back(bottom);
  }
  return depths;
}

/// The largest value over depths, by planes put between them where it is.
class DepthSearch {
public:
  void add(const PlanePeak& peak) {
    const auto after = std::find_if(peaks_.begin(), peaks_.end(),
                                    [&](const PlanePeak& other) { return other.place.depth > peak.place.depth; });
    peaks_.insert(after, peak);
  }
  const PlanePeak& best() const { return peaks_[best_index()]; }

  /// The next depth to look at: the summit of the parabola through the three planes about the best one; none if it is
  /// nearer than `closest` to that or lies beyond them.
  std::optional<double> next(double closest) const {
    if (peaks_.size() < 3) return std::nullopt;
    const std::size_t middle = std::clamp<std::size_t>(best_index(), 1, peaks_.size() - 2);
    const PlanePeak &above = peaks_[middle - 1], &here = peaks_[middle], &below = peaks_[middle + 1];
    const double up = here.place.depth - above.place.depth, down = below.place.depth - here.place.depth;
    const double left = (here.value - above.value) / up, right = (below.value - here.value) / down;
    if (!(right < left)) return std::nullopt;
    const double move = (left * down + right * up) / (2 * (left - right)), depth = here.place.depth + move;
    const bool is_between = move > -up && move < down;
    if (!is_between || std::abs(depth - best().place.depth) < closest) return std::nullopt;
    return depth;
  }

private:
  std::size_t best_index() const {
    const auto best = std::max_element(peaks_.begin(), peaks_.end(),
                                       [](const PlanePeak& a, const PlanePeak& b) { return a.value < b.value; });
    return static_cast<std::size_t>(best - peaks_.begin());
  }

  std::vector<PlanePeak> peaks_; ///< by depth
};

/// The largest von Mises stress between two depths.
PlanePeak largest_in_layer(LayerPlanes& planes, double top, double bottom, double half_width,
                           const Progress& progress) {
  constexpr int most_more = 5;
  const std::vector<double> depths = depths_of(top, bottom, half_width);
  const auto plane = [&](double depth) { return planes.largest(depth, von_mises, progress); };
  DepthSearch search;
  for (const double depth : depths) search.add(plane(depth));
  for (int more = 0; more < most_more; ++more) {
    const auto depth = search.next(0.03 * std::max(half_width / 8, search.best().place.depth / 3));
    if (!depth) break;
    search.add(plane(*depth));
  }
  return planes.by_all(search.best(), von_mises, progress);
}

void add_peaks(const LayeredBody& body, Body number, double speed, const ElementGrid& grid,
               const SurfaceTractions& tractions, const Progress& progress, LayeredPeaks& peaks) {
  const auto bottoms = bottoms_of(body);
  const double width = half_width(grid, tractions);
  const int layers = static_cast<int>(body.layers.size());
  double top = 0;
  for (int n = 0; n <= layers; ++n) {
    if (n == layers && body.substrate.is_rigid()) break;
    const Progress on = essential_part(progress, double(n) / (layers + 1), double(n + 1) / (layers + 1));
    const double bottom = n < layers ? bottoms[n] : std::numeric_limits<double>::infinity();
    LayerPlanes planes(body, number, speed, grid, tractions, top, top, on);
    const PlanePeak peak = largest_in_layer(planes, top * below_interface, bottom, width, on);
    peaks.layers.push_back({number, n, peak.value, peak.place});
    top = bottom;
  }
  for (int n = 0; n < layers; ++n)
    peaks.interfaces.push_back(
        LayerPlanes(body, number, speed, grid, tractions, bottoms[n], 3 * bottoms[n] + width, progress)
            .interface(number, n, bottoms[n], progress));
}

} // namespace

LayeredPeaks layered_peaks(const LayeredBodies& bodies, const ElementGrid& elements, const SurfaceTractions& tractions,
                           const Progress& progress) {
  LayeredPeaks peaks;
  add_peaks(bodies.body1, Body::first, bodies.speed, elements, tractions, part(progress, 0, 0.5), peaks);
  add_peaks(bodies.body2, Body::second, bodies.speed, elements, tractions, part(progress, 0.5, 1), peaks);
  return peaks;
}

LayeredPeaks layered_peaks(const LayeredBodies& bodies, const ContactSolution& solution, const Progress& progress) {
  const SurfaceFields& f = solution.fields;
  if (f.pressure.size() != solution.elements.size() || f.pressure.empty())
    throw Error("solution: has no pressures; stresses need one of the exact theory");
  return layered_peaks(bodies, solution.elements.grid, {f.traction.x, f.traction.y, f.pressure}, progress);
}

} // namespace microslip
