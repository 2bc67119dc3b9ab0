#include "compat/contact/wheel_rail/patch_rules.hpp"

#include "compat/contact/wheel_rail/search_thresholds.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace microslip::contact_program {
namespace {

/// Between two intervals, whose ends may have any order.
double between(std::pair<double, double> a, std::pair<double, double> b) {
  const auto [a0, a1] = std::minmax({a.first, a.second});
  const auto [b0, b1] = std::minmax({b.first, b.second});
  return std::max({0.0, a0 - b1, b0 - a1});
}

/// Whether one lies behind the other along the track, at the same y.
bool overlap_across(const GapRegion& field, const GapRegion& gauge) {
  return field.y0 < gauge.y1;
}

/// Between the boxes of two regions, the first one nearer to the field.
double distance(const GapRegion& field, const GapRegion& gauge) {
  const double x = between({field.x0, field.x1}, {gauge.x0, gauge.x1});
  if (overlap_across(field, gauge)) return std::hypot(x, between({field.z0, field.z1}, {gauge.z0, gauge.z1}));
  return std::hypot(x, field.y0 - gauge.y1, field.z0 - gauge.z1);
}

bool may_join(const GapRegion& a, const GapRegion& b, double farthest, const PatchRules& rules) {
  return std::abs(a.angle - b.angle) <= rules.a_sep && distance(a, b) <= farthest;
}

GapRegion united(const GapRegion& a, const GapRegion& b) {
  GapRegion r = a;
  r.x0 = std::min(a.x0, b.x0);
  r.x1 = std::max(a.x1, b.x1);
  if (b.y0 < a.y0) r.y0 = b.y0, r.z0 = b.z0;
  if (b.y1 > a.y1) r.y1 = b.y1, r.z1 = b.z1;
  r.weight = a.weight + b.weight;
  const auto mean = [&](double of_a, double of_b) { return (of_a * a.weight + of_b * b.weight) / r.weight; };
  r.x = mean(a.x, b.x);
  r.y = mean(a.y, b.y);
  r.angle = mean(a.angle, b.angle);
  return r;
}

void combine(std::vector<GapRegion>& regions, const PatchRules& rules) {
  for (std::size_t k = 0; k + 1 < regions.size();) {
    if (!may_join(regions[k], regions[k + 1], rules.d_comb, rules)) {
      ++k;
      continue;
    }
    regions[k] = united(regions[k], regions[k + 1]);
    regions.erase(regions.begin() + static_cast<std::ptrdiff_t>(k) + 1);
  }
}

/// As a part of its own, from the last one of which a line along the track separates it; where there is no such line,
/// as one with it.
void add(PatchRegion& patch, const GapRegion& region) {
  patch.whole = united(patch.whole, region);
  GapRegion& last = patch.parts.back();
  if (overlap_across(last, region))
    last = united(last, region);
  else
    patch.parts.push_back(region);
}

void find_factors(PatchRegion& patch, const PatchRules& rules) {
  const std::size_t n = patch.parts.size();
  patch.factors.assign(n * n, 1);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const double left = std::max(0.0, rules.d_sep - distance(patch.parts[i], patch.parts[j]));
      const double share = std::min(1.0, left / std::max(1e-15, rules.d_sep - rules.d_comb));
      patch.factors[i * n + j] = patch.factors[j * n + i] = std::pow(share, SearchThresholds::blending);
    }
}

/// Turns the frames of patches that are nearly near enough to be joined.
void turn(std::vector<PatchRegion>& patches, const PatchRules& rules) {
  if (!(rules.d_turn > rules.d_sep)) return;
  const std::vector<PatchRegion> before = patches;
  for (std::size_t k = 0; k + 1 < patches.size(); ++k) {
    const GapRegion &a = before[k].whole, &b = before[k + 1].whole;
    const double apart = distance(a, b);
    if (std::abs(a.angle - b.angle) > rules.a_sep || apart < rules.d_sep || apart > rules.d_turn) continue;
    const double share = (rules.d_turn - apart) / (rules.d_turn - rules.d_sep), mean = united(a, b).angle;
    patches[k].whole.angle += share * (mean - a.angle);
    patches[k + 1].whole.angle += share * (mean - b.angle);
  }
}

} // namespace

std::vector<PatchRegion> make_patches(std::vector<GapRegion> regions, const PatchRules& rules) {
  std::stable_sort(regions.begin(), regions.end(), [](const auto& a, const auto& b) { return a.y > b.y; });
  combine(regions, rules);
  std::vector<PatchRegion> patches;
  for (const GapRegion& region : regions) {
    if (!patches.empty() && may_join(patches.back().whole, region, rules.d_sep, rules)) {
      add(patches.back(), region);
    } else {
      patches.push_back({region, {region}, {}});
    }
  }
  for (PatchRegion& patch : patches) find_factors(patch, rules);
  turn(patches, rules);
  return patches;
}

} // namespace microslip::contact_program
