#include "microslip/table/creep_table_axes.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"
#include "microslip/table/creep_coordinates.hpp"

#include <cmath>
#include <numbers>

namespace microslip {

double CreepTableAxes::ratio(int i) const {
  return least_ratio * std::pow(largest_ratio / least_ratio, static_cast<double>(i) / (ratios - 1));
}

double CreepTableAxes::elevation(int i) const {
  return creep_coordinates::elevation(static_cast<double>(i) / (elevations - 1));
}

double CreepTableAxes::azimuth_step() const {
  return std::numbers::pi / (azimuths - 1);
}

double CreepTableAxes::azimuth(int i) const {
  return i * azimuth_step() - std::numbers::pi / 2;
}

void check(const CreepTableAxes& axes) {
  require_between("least a/b", axes.least_ratio, "-", smallest_axis_ratio, largest_axis_ratio);
  require_between("largest a/b", axes.largest_ratio, "-", smallest_axis_ratio, largest_axis_ratio);
  if (!(axes.largest_ratio > axes.least_ratio))
    throw Error("largest a/b", axes.largest_ratio, "-", "above the least one");
  require_count("nodes of a/b", axes.ratios, fewest_axis_nodes, most_axis_nodes);
  require_count("nodes from no slip to full sliding", axes.levels, fewest_axis_nodes, most_axis_nodes);
  require_count("nodes from no spin to nothing but spin", axes.elevations, fewest_axis_nodes, most_axis_nodes);
  require_count("nodes of the direction of the creepage", axes.azimuths, fewest_axis_nodes, most_axis_nodes);
  require_count("Poisson's ratios", static_cast<int>(axes.poisson_ratios.size()), 1, 8);
  double before = -1;
  for (const double nu : axes.poisson_ratios) {
    require_between("poisson_ratio", nu, "-", 0, 0.5);
    if (!(nu > before)) throw Error("poisson_ratio", nu, "-", "above the one before");
    before = nu;
  }
  if (axes.blocks() * axes.nodes() > 20'000'000) throw Error("a creep-force table may have 20,000,000 nodes at most");
}

} // namespace microslip
