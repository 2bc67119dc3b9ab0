#include "microslip/simplified/load_moments.hpp"

#include <algorithm>
#include <cmath>

namespace microslip::detail {

LoadMoments::LoadMoments(std::span<const LoadedRow> rows, std::span<const double> share) {
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const LoadedRow& row = rows[k];
    const double part = share[k] * row.load;
    load += part, capacity += part * row.friction;
    centre.x += part * row.centre, centre.y += part * row.y;
    const Creepage& w = row.creepage;
    creepage.longitudinal += part * w.longitudinal;
    creepage.lateral += part * (w.lateral + w.spin * row.centre);
    creepage.spin += part * w.spin;
  }
  if (!(load > 0)) return;
  for (double* mean : {&centre.x, &centre.y, &creepage.longitudinal, &creepage.lateral, &creepage.spin}) *mean /= load;
  double xx = 0, yy = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const LoadedRow& row = rows[k];
    const double x = row.centre - centre.x, y = row.y - centre.y, l = row.half_length;
    xx += share[k] * row.load * (x * x + l * l / 4);
    yy += share[k] * row.load * (y * y + row.width * row.width / 12);
  }
  semi_axes = {std::sqrt(5 * xx / load), std::sqrt(5 * yy / load)};
}

void find_shares(std::span<const LoadedRow> rows, std::size_t row, std::span<double> share) {
  const auto density = [&](std::size_t k) { return rows[k].load / rows[k].width; };
  const double own = density(row);
  const auto share_of = [&](std::size_t k, double least) {
    const double lesser = std::min(own, density(k));
    return lesser > 0 ? std::min(1.0, united * least / lesser) : 0.0;
  };
  std::fill(share.begin(), share.end(), 0.0);
  share[row] = 1;
  double least = own;
  for (std::size_t k = row + 1; k < rows.size() && rows[k].joined && least > 0; ++k) {
    least = std::min(least, density(k));
    share[k] = share_of(k, least);
  }
  least = own;
  for (std::size_t k = row; k-- > 0 && rows[k + 1].joined && least > 0;) {
    least = std::min(least, density(k));
    share[k] = share_of(k, least);
  }
}

} // namespace microslip::detail
