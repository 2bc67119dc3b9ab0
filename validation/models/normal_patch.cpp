#include "validation/models/normal_patch.hpp"

#include "microslip/numerics/elliptic.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace microslip::validation {
namespace {

using std::numbers::pi;

/// The integral of sqrt(l^2 - x^2)/sqrt(x^2 + y^2) over x from -l to l: 2 l^2 D/sqrt(l^2 + y^2), D the elliptic
/// integral of the complementary modulus y/sqrt(l^2 + y^2). The mean over the row through y = 0 is that at
/// y = w/(2 e), for w << l, since there it is linear in ln y.
double pressing(const Strip& strip) {
  const double l = strip.half_length;
  const double y = std::max(std::abs(strip.y), strip.width / (2 * std::numbers::e));
  const double r = std::hypot(l, y);
  return 2 * l * l * complete_elliptic_integrals(y / r).D / r;
}

} // namespace

double Strip::peak() const {
  return half_length > 0 ? 2 * load / (pi * half_length * width) : 0;
}

double NormalPatch::force() const {
  return std::accumulate(strips.begin(), strips.end(), 0.0, [](double sum, const Strip& s) { return sum + s.load; });
}

double NormalPatch::area() const {
  double sum = 0;
  for (const Strip& s : strips) sum += 2 * s.half_length * s.width;
  return sum;
}

double NormalPatch::peak() const {
  double most = 0;
  for (const Strip& s : strips) most = std::max(most, s.peak());
  return most;
}

double NormalPatch::length() const {
  double most = 0;
  for (const Strip& s : strips) most = std::max(most, 2 * s.half_length);
  return most;
}

double NormalPatch::width() const {
  std::vector<double> lengths;
  for (const Strip& s : strips) lengths.push_back(s.half_length);
  return strips.empty() ? 0 : width_of_rows(lengths, strips.front().width);
}

NormalPatch NormalPatch::with_rows(int most) const {
  const std::size_t each = (strips.size() + std::size_t(most) - 1) / std::size_t(most);
  NormalPatch out;
  for (std::size_t first = 0; first < strips.size(); first += each) {
    const double width = strips[first].width;
    Strip sum{.y = strips[first].y + 0.5 * double(each - 1) * width, .width = double(each) * width};
    double squares = 0;
    for (std::size_t k = first; k < std::min(first + each, strips.size()); ++k)
      sum.load += strips[k].load, squares += strips[k].half_length * strips[k].half_length;
    sum.half_length = std::sqrt(squares / double(each));
    out.strips.push_back(sum);
  }
  return out;
}

double width_of_rows(const std::vector<double>& half_lengths, double width) {
  const std::size_t n = half_lengths.size();
  if (n < 2) return double(n) * width;
  const auto beyond = [&](std::size_t outer, std::size_t inner) { // of the outer row's middle
    const double last = half_lengths[outer] * half_lengths[outer];
    const double rise = half_lengths[inner] * half_lengths[inner] - last;
    return rise > 0 ? std::min(1.0, last / rise) : 1.0;
  };
  return width * (double(n - 1) + beyond(0, 1) + beyond(n - 1, n - 2));
}

NormalPatch in_rows(const HertzContact& hertz, double y) {
  constexpr int rows = 101;
  NormalPatch out;
  const double width = 2 * hertz.b / rows;
  for (int k = 0; k < rows; ++k) {
    const double from = 2.0 * k / rows - 1, to = 2.0 * (k + 1) / rows - 1, middle = (from + to) / 2;
    const double share = 0.75 * ((to - from) - (to * to * to - from * from * from) / 3); // of the load
    out.strips.push_back(
        {y + middle * hertz.b, width, hertz.a * std::sqrt(1 - middle * middle), share * hertz.normal_force});
  }
  return out;
}

NormalPatch pressed_at_point(std::vector<Strip> strips, const CombinedMaterial& material, double approach) {
  double sunk = 0; // for c = pi E*
  for (const Strip& s : strips)
    if (s.half_length > 0) sunk += pressing(s) * s.width;
  if (!(sunk > 0)) return {};
  const double c = pi * material.contact_modulus() * approach / sunk;
  for (Strip& s : strips) s.load = c * pi / 2 * s.half_length * s.half_length * s.width;
  return {std::move(strips)};
}

} // namespace microslip::validation
