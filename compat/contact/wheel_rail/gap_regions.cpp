#include "compat/contact/wheel_rail/gap_regions.hpp"

#include "compat/contact/wheel_rail/search_thresholds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace microslip::contact_program {
namespace {

/// The interval of overlap around a point, with a point on either side where there is none.
struct Interval {
  std::size_t first, last;
  bool holds(std::size_t k) const { return k >= first && k <= last; }
};

Interval overlap_around(const std::vector<double>& gap, std::size_t k) {
  Interval i{k, k};
  while (i.first > 0 && gap[i.first - 1] < 0) --i.first;
  while (i.last + 1 < gap.size() && gap[i.last + 1] < 0) ++i.last;
  if (i.first > 0) --i.first;
  if (i.last + 1 < gap.size()) ++i.last;
  return i;
}

/// The integral over x of the square of the overlap c - a x^2, c = -gap.
double weight_of(double overlap, double curvature) {
  const double half = std::sqrt(overlap / curvature);
  const double sum = 2 * overlap * overlap * half - 4.0 / 3 * overlap * curvature * half * half * half +
                     2.0 / 5 * curvature * curvature * std::pow(half, 5);
  return std::max(SearchThresholds::least_weight, sum);
}

/// Where the straight line between two points is zero, as a fraction of the distance; nothing if that is not between
/// them.
double crossing(double outside, double inside) {
  const double change = inside - outside;
  return outside * inside <= -1e-18 && std::abs(change) >= 1e-12 ? -outside / change : 0;
}

GapRegion region_of(const GapLine& g, const Interval& i, double curvature) {
  GapRegion r;
  r.x0 = std::numeric_limits<double>::infinity(); // also of wheels that are deflected far along the track
  r.x1 = -r.x0;
  for (std::size_t k = i.first; k <= i.last; ++k) {
    if (g.gap[k] > 0) continue;
    const double half = std::sqrt(-g.gap[k] / curvature), weight = weight_of(-g.gap[k], curvature);
    r.x += weight * g.x[k];
    r.y += weight * g.y[k];
    r.angle += weight * g.angle[k];
    r.weight += weight;
    r.x0 = std::min(r.x0, g.x[k] - half);
    r.x1 = std::max(r.x1, g.x[k] + half);
  }
  r.x /= r.weight;
  r.y /= r.weight;
  r.angle /= r.weight;
  const auto end = [&](std::size_t outside, std::size_t inside, double& y, double& z) {
    const double share = crossing(g.gap[outside], g.gap[inside]);
    y = g.y[outside] + share * (g.y[inside] - g.y[outside]);
    z = g.z_rail[outside] + share * (g.z_rail[inside] - g.z_rail[outside]);
  };
  end(i.first, std::min(i.first + 1, i.last), r.y0, r.z0);
  end(i.last, std::max(i.last, i.first + 1) - 1, r.y1, r.z1);
  if (i.first == 0) r.y0 = std::min(r.y0, 2 * r.y - g.y[i.last]);
  if (i.last + 1 == g.size()) r.y1 = std::max(r.y1, g.y[i.first]);
  return r;
}

} // namespace

LeastGap least_gap(const GapLine& g) {
  const auto at = static_cast<std::size_t>(std::min_element(g.gap.begin(), g.gap.end()) - g.gap.begin());
  LeastGap least{g.gap[at], g.angle[at], g.z_wheel[at], 0};
  if (g.size() < 3) return least;
  const std::size_t k = std::clamp<std::size_t>(at, 1, g.size() - 2);
  const std::size_t n = std::min({std::size_t{3}, k, g.size() - 1 - k});
  const double step = g.y[k + n] - g.y[k];
  least.curvature = (g.z_rail[k + n] + g.z_rail[k - n] - 2 * g.z_rail[k]) / (2 * step * step);
  return least;
}

std::vector<std::pair<int, int>> local_minima(const std::vector<double>& gap, int nx, double depth) {
  const int ny = static_cast<int>(gap.size()) / nx;
  const auto at = [nx](int i, int j) { return static_cast<std::size_t>(j) * nx + i; };
  std::vector<std::pair<int, int>> found;
  std::vector<char> on_plateau(gap.size(), 0);
  for (int i = 0; i < nx; ++i)
    for (int j = 0; j < ny; ++j) {
      const double here = gap[at(i, j)];
      bool is_minimum = here < depth && here < no_gap;
      const auto compare = [&](int other_i, int other_j, bool before) {
        if (!is_minimum || other_i < 0 || other_i >= nx || other_j < 0 || other_j >= ny) return;
        const double other = gap[at(other_i, other_j)];
        if (on_plateau[at(other_i, other_j)] && std::abs(other - here) < SearchThresholds::plateau) {
          on_plateau[at(i, j)] = 1;
          is_minimum = false;
        } else if (before ? other <= here : other < here) {
          is_minimum = false;
        }
      };
      compare(i, j - 1, true);
      compare(i, j + 1, false);
      compare(i - 1, j, true);
      compare(i + 1, j, false);
      if (!is_minimum) continue;
      found.emplace_back(i, j);
      on_plateau[at(i, j)] = 1;
    }
  std::stable_sort(found.begin(), found.end(), [&](const auto& a, const auto& b) {
    return gap[at(a.first, a.second)] < gap[at(b.first, b.second)];
  });
  return found;
}

std::vector<std::pair<int, int>> near_misses(const std::vector<double>& gap, int nx, double depth, double farthest) {
  std::vector<std::pair<int, int>> found;
  for (const auto& [i, j] : local_minima(gap, nx, depth + farthest))
    if (gap[static_cast<std::size_t>(j) * nx + i] >= depth && found.size() < SearchThresholds::most_near_misses)
      found.emplace_back(i, j);
  return found;
}

std::vector<NearMiss> near_misses(const GapLine& line, double farthest) {
  std::vector<NearMiss> found;
  for (const auto& [i, j] : near_misses(line.gap, 1, 0, farthest)) {
    const auto k = static_cast<std::size_t>(j);
    found.push_back({line.x[k], line.y[k], line.gap[k]});
  }
  return found;
}

std::vector<GapRegion> find_regions(const GapLine& line, double curvature) {
  std::vector<Interval> taken;
  std::vector<GapRegion> regions;
  for (const auto& [i, j] : local_minima(line.gap, 1, 0)) {
    const auto k = static_cast<std::size_t>(j);
    if (std::any_of(taken.begin(), taken.end(), [k](const Interval& known) { return known.holds(k); })) continue;
    taken.push_back(overlap_around(line.gap, k));
    regions.push_back(region_of(line, taken.back(), curvature));
  }
  return regions;
}

} // namespace microslip::contact_program
