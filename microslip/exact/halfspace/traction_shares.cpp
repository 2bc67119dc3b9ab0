#include "microslip/exact/halfspace/traction_shares.hpp"

#include <algorithm>

namespace microslip {
namespace {

Vec2 between(Vec2 a, Vec2 b, double t) {
  return {(1 - t) * a.x + t * b.x, (1 - t) * a.y + t * b.y};
}

} // namespace

TractionShares::TractionShares(const ElementGrid& grid, std::span<const double> bound, std::span<const double> px,
                               std::span<const double> py)
    : TractionShares(grid) {
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * grid.mx + i;
      if (bound[k] > 0) add(j, grid.x(i), bound[k], {px[k], py[k]});
    }
}

void TractionShares::add(int row, double x, double bound, Vec2 traction) {
  first_of_row_.resize(static_cast<std::size_t>(row) + 1, shares_.size());
  shares_.push_back({x, bound > 0 ? Vec2{traction.x / bound, traction.y / bound} : Vec2{}});
}

std::span<const TractionShares::Share> TractionShares::row(std::size_t j) const {
  const auto first = [&](std::size_t row) { return row < first_of_row_.size() ? first_of_row_[row] : shares_.size(); };
  return std::span(shares_).subspan(first(j), first(j + 1) - first(j));
}

Vec2 TractionShares::at(double x, double y) const {
  const auto in_row = [x](std::span<const Share> row) {
    const auto next = std::partition_point(row.begin(), row.end(), [x](const Share& s) { return s.x <= x; });
    if (next == row.begin()) return next->share;
    const auto before = next - 1;
    if (next == row.end()) return before->share;
    return between(before->share, next->share, (x - before->x) / (next->x - before->x));
  };
  const double position = std::clamp((y - grid_.y0) / grid_.dy, 0.0, grid_.my - 1.0);
  const int below = std::min(static_cast<int>(position), std::max(grid_.my - 2, 0));
  const auto low = row(below), high = row(std::min(below + 1, grid_.my - 1));
  if (low.empty() && high.empty()) return {};
  if (low.empty() || high.empty()) return in_row(low.empty() ? high : low);
  return between(in_row(low), in_row(high), position - below);
}

} // namespace microslip
