#include "microslip/table/making/creep_table_maker.hpp"

#include "microslip/batch/batch.hpp"
#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"
#include "microslip/rolling/accurate_contact.hpp"
#include "microslip/rolling/solver.hpp"
#include "microslip/table/creep_coordinates.hpp"
#include "microslip/table/creep_force_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace microslip {
namespace {

/// The contact that stands for all loads, moduli, sizes and coefficients of friction.
constexpr double shear_modulus = 1, normal_force = 1, friction = 0.01, capacity = friction * normal_force;

using Node = std::array<double, creep_channels>;

EllipticContact contact_of(double a_over_b, double poisson_ratio) {
  EllipticContact contact;
  contact.a = std::sqrt(a_over_b);
  contact.b = 1 / contact.a;
  contact.shear_modulus = shear_modulus;
  contact.poisson_ratio = poisson_ratio;
  contact.normal_force = normal_force;
  contact.friction = FrictionLaw::coulomb(friction);
  return contact;
}

/// The creepages with (X, Y, Z) of length 1 in a direction.
Creepage creepage_of(double a_over_b, double poisson_ratio, double elevation, double azimuth) {
  const creep_coordinates::LinearTheory linear(creepage_coefficients(a_over_b, poisson_ratio, CreepageTable::computed),
                                               creep_coordinates::spin_scale(a_over_b));
  const double g = shear_modulus / capacity;
  const auto [x, y, z] = creep_coordinates::direction(a_over_b, elevation, azimuth);
  return {.longitudinal = x / (g * linear.x), .lateral = y / (g * linear.y), .spin = z / (g * linear.z)};
}

/// The contact of a node.
EllipticContact contact_at(const CreepTableAxes& axes, std::size_t material, int ratio, int level, int elevation,
                           int azimuth) {
  const double nu = axes.poisson_ratios[material], a_over_b = axes.ratio(ratio);
  const double t = axes.level(level);
  const double r =
      t < 1 ? creep_coordinates::half_way * t / (1 - t) : 1; // at the last level the direction alone counts
  const Creepage unit = creepage_of(a_over_b, nu, axes.elevation(elevation), axes.azimuth(azimuth));
  EllipticContact contact = contact_of(a_over_b, nu);
  contact.creepage = {unit.longitudinal * r, unit.lateral * r, unit.spin * r};
  return contact;
}

/// Forces of full sliding under the elliptic pressure: tractions against the rigid slip everywhere.
Node full_sliding(const EllipticContact& contact) {
  constexpr int rings = 160, sectors = 256;
  Node sum = {};
  for (int i = 0; i < rings; ++i) {
    // Rings with equal shares of the load: within the radius r it is 1 - (1 - r^2)^(3/2).
    const double radius = std::sqrt(1 - std::pow((i + 0.5) / rings, 2.0 / 3));
    for (int k = 0; k < sectors; ++k) {
      const double angle = 2 * std::numbers::pi * (k + 0.5) / sectors;
      const double x = contact.a * radius * std::cos(angle), y = contact.b * radius * std::sin(angle);
      const double slip_x = contact.creepage.longitudinal - contact.creepage.spin * y;
      const double slip_y = contact.creepage.lateral + contact.creepage.spin * x;
      const double slip = std::sqrt(slip_x * slip_x + slip_y * slip_y);
      if (!(slip > 0)) continue;
      sum[0] -= slip_x / slip;
      sum[1] -= slip_y / slip;
      sum[2] -= (x * slip_y - y * slip_x) / slip;
    }
  }
  for (double& number : sum) number /= rings * sectors;
  return sum;
}

Node node_of(const ContactForces& forces, const EllipticContact& contact) {
  return {forces.fx / capacity, forces.fy / capacity, forces.mz / (capacity * std::sqrt(contact.a * contact.b)),
          forces.adhesion_area / (std::numbers::pi * contact.a * contact.b)};
}

/// Squares and extremes of the estimated errors of some nodes.
struct Errors {
  std::array<double, 3> squares = {}, worst = {};
  long nodes = 0, solved = 0, not_converged = 0;

  void add(std::size_t channel, double error) {
    squares[channel] += error * error;
    worst[channel] = std::max(worst[channel], error);
  }
};

CreepTableOrigin origin_of(const std::vector<Errors>& errors, int elements) {
  CreepTableOrigin origin = {.elements = elements};
  long nodes = 0;
  for (const Errors& e : errors) {
    nodes += e.nodes;
    origin.solved += e.solved;
    origin.not_converged += e.not_converged;
    for (std::size_t c = 0; c < 3; ++c) {
      origin.error_rms[c] += e.squares[c];
      origin.error_worst[c] = std::max(origin.error_worst[c], e.worst[c]);
    }
  }
  for (double& square : origin.error_rms) square = std::sqrt(square / static_cast<double>(nodes));
  return origin;
}

/// Numbers of all nodes of a table, by their positions on the axes.
class Numbers {
public:
  explicit Numbers(const CreepTableAxes& axes) : axes_(axes), numbers_(axes.blocks() * axes.nodes() * creep_channels) {}

  const CreepTableAxes& axes() const { return axes_; }
  const std::vector<double>& all() const { return numbers_; }
  double* at(std::size_t material, int ratio, int level, int elevation, int azimuth) {
    std::size_t index = material;
    for (const auto& [count, i] : {std::pair(axes_.ratios, ratio), std::pair(axes_.levels, level),
                                   std::pair(axes_.elevations, elevation), std::pair(axes_.azimuths, azimuth)})
      index = index * std::size_t(count) + std::size_t(i);
    return &numbers_[index * creep_channels];
  }

private:
  CreepTableAxes axes_;
  std::vector<double> numbers_;
};

/// Beyond this estimated error of Fx, Fy or Mz a node is solved on a third grid.
constexpr double doubtful = 0.002;

/// Solves nodes of one a/b and nu.
class BlockMaker {
public:
  BlockMaker(int elements, Numbers& numbers)
      : axes_(numbers.axes()), numbers_(numbers), coarse_(grid(elements / 2)), fine_(grid(elements)),
        finest_(grid(2 * elements)) {}

  void make(std::size_t material, int ratio, Errors& errors, const Progress& progress) {
    const int pole = axes_.elevations - 1;
    for (int i = 0; i <= pole; ++i)
      for (int j = 0; j < axes_.azimuths; ++j) {
        if (!progress((i + static_cast<double>(j) / axes_.azimuths) / axes_.elevations)) return;
        if (i < pole || j == 0)
          make_direction(material, ratio, i, j, errors);
        else
          for (int level = 0; level < axes_.levels; ++level)
            std::copy_n(numbers_.at(material, ratio, level, i, 0), creep_channels,
                        numbers_.at(material, ratio, level, i, j));
      }
  }

private:
  static Method grid(int elements) { return {.mx = elements, .my = elements}; }

  void make_direction(std::size_t material, int ratio, int elevation, int azimuth, Errors& errors) {
    for (int level = 0; level < axes_.levels; ++level) {
      const EllipticContact contact = contact_at(axes_, material, ratio, level, elevation, azimuth);
      const Node node = level + 1 == axes_.levels ? full_sliding(contact) : limit(contact, errors);
      std::copy(node.begin(), node.end(), numbers_.at(material, ratio, level, elevation, azimuth));
    }
  }

  Node limit(const EllipticContact& contact, Errors& errors) {
    const Node coarse = solve(coarse_, contact, errors);
    Node fine = solve(fine_, contact, errors), node = limit(coarse, fine);
    if (error_of(node, fine) > doubtful) {
      const Node finest = solve(finest_, contact, errors);
      node = limit(fine, finest);
      fine = finest;
    }
    for (std::size_t c = 0; c < 3; ++c) errors.add(c, std::abs(node[c] - fine[c]));
    ++errors.nodes;
    node[3] = std::clamp(node[3], 0.0, 1.0);
    return node;
  }
  static Node solve(Solver& solver, const EllipticContact& contact, Errors& errors) {
    const ContactForces forces = solver.solve(rolling_problem(contact)).forces();
    ++errors.solved;
    errors.not_converged += forces.status != Status::ok;
    return node_of(forces, contact);
  }
  static Node limit(const Node& coarse, const Node& fine) {
    Node node;
    for (std::size_t c = 0; c < creep_channels; ++c) node[c] = limit_of_second_order(coarse[c], fine[c]);
    return node;
  }
  static double error_of(const Node& node, const Node& fine) {
    double error = 0;
    for (std::size_t c = 0; c < 3; ++c) error = std::max(error, std::abs(node[c] - fine[c]));
    return error;
  }

  const CreepTableAxes& axes_;
  Numbers& numbers_;
  Solver coarse_, fine_, finest_;
};

void check(const CreepTableMaking& making) {
  check(making.axes);
  require_count("elements", making.elements, fewest_table_elements, most_table_elements);
  if (making.elements % 2 != 0) throw Error("elements", making.elements, "-", "even");
}

} // namespace

CreepTableNodes make_creep_table(const CreepTableMaking& making) {
  check(making);
  const CreepTableAxes& axes = making.axes;
  Numbers numbers(axes);
  struct Block {
    std::size_t material;
    int ratio;
  };
  std::vector<Block> blocks;
  for (std::size_t m = 0; m < axes.poisson_ratios.size(); ++m)
    for (int ratio = 0; ratio < axes.ratios; ++ratio) blocks.push_back({m, ratio});
  std::vector<Errors> errors(blocks.size());
  const auto report =
      run_batch(blocks.size(), {.threads = making.threads, .progress = making.progress}, [&]() -> BatchWorker {
        return [&, own = std::make_shared<BlockMaker>(making.elements, numbers)](std::size_t i, std::size_t,
                                                                                 const Progress& progress) {
          own->make(blocks[i].material, blocks[i].ratio, errors[i], progress);
        };
      });
  if (!report.complete) throw Stopped();
  return quantised(axes, origin_of(errors, making.elements), numbers.all());
}

} // namespace microslip
