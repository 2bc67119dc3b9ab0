#include "microslip/contact/limits.hpp"
#include "microslip/description/input_lines.hpp"

namespace microslip::description {
namespace {

constexpr Bounds nodes = between(fewest_axis_nodes, most_axis_nodes);
constexpr double poisson_ratios[] = {0, 0.28, 0.5};
constexpr double axis_ratios[] = {smallest_axis_ratio, largest_axis_ratio};

std::vector<Input> all_inputs() {
  return {
      numbers("poisson_ratio", "-", between(0, 0.5), poisson_ratios, "Poisson's ratios"),
      numbers("axis_ratio", "-", between(smallest_axis_ratio, largest_axis_ratio), axis_ratios,
              "least and largest ratio a/b of the ellipses' semi-axes, along over across the rolling"),
      whole("ratios", nodes, 19, "nodes of a/b"),
      whole("levels", nodes, 30, "nodes from no slip to full sliding"),
      whole("elevations", nodes, 29, "nodes from no spin to nothing but spin"),
      whole("azimuths", nodes, 21, "nodes of the direction of the creepage"),
      whole("elements", between(fewest_table_elements, most_table_elements), 24,
            "elements across the ellipse, even; half of them for the extrapolation"),
  };
}

} // namespace

const InputTable& creep_table_inputs() {
  static const InputTable table(all_inputs(), {});
  return table;
}

} // namespace microslip::description
