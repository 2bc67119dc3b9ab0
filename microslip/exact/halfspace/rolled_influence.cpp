#include "microslip/exact/halfspace/rolled_influence.hpp"

#include "microslip/error.hpp"
#include "microslip/numerics/gauss_legendre.hpp"
#include "microslip/numerics/threads.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

namespace microslip {
namespace {

constexpr double forgotten = 40; // exp(-40) is below rounding

/// Gauss's rules for cells by how large they are: errors of 1e-9. Weights that fade are exact for polynomials of half
/// the degree only, and need more nodes.
const GaussLegendre& rule_for(double size_over_scale, bool fading) {
  static const std::array<GaussLegendre, 3> even{GaussLegendre(6), GaussLegendre(4), GaussLegendre(3)};
  static const std::array<GaussLegendre, 3> with_fading{GaussLegendre(9), GaussLegendre(6), GaussLegendre(4)};
  return (fading ? with_fading : even)[size_over_scale > 0.33 ? 0 : size_over_scale > 0.1 ? 1 : 2];
}

/// Weights that integrate polynomials times exp(-x/l) over [0, width], through the nodes of a rule.
std::vector<double> fading_weights(const GaussLegendre& rule, double width, double length) {
  static const GaussLegendre fine(24);
  const double end = std::min(width, forgotten * length);
  std::vector<double> weights(rule.count());
  for (std::size_t k = 0; k < fine.count(); ++k) {
    const double x = fine.node(k, 0, end), weight = fine.weight(k, 0, end) * std::exp(-x / length);
    for (std::size_t g = 0; g < rule.count(); ++g) {
      double basis = 1;
      for (std::size_t o = 0; o < rule.count(); ++o)
        if (o != g) basis *= (x - rule.node(o, 0, width)) / (rule.node(g, 0, width) - rule.node(o, 0, width));
      weights[g] += weight * basis;
    }
  }
  return weights;
}

/// A rectangle over which kernels are integrated [m].
struct Cell {
  double x, y, width, height; ///< x, y: of its corner towards minus infinity

  double distance() const {
    const auto outside = [](double low, double size) { return std::max({low, -low - size, 0.0}); };
    return std::hypot(outside(x, width), outside(y, height));
  }
};

/// Integrals over a cell of each part's kernel, and of that times exp(-(x' - x)/l), x the cell's begin.
struct CellIntegrals {
  std::vector<Influence> whole, fading;

  explicit CellIntegrals(std::size_t parts) : whole(parts), fading(parts) {}
};

/// The influence of a point force at a point whose direction from it has the cosine c and the sine s.
Influence directed(const PointKernel& a, double c, double s) {
  const double along = a.difference * (c * c - s * s);
  return {a.sum + along, a.difference * 2 * c * s, a.sum - along, a.normal, a.coupling * c, a.coupling * s};
}

/// Integrals of what layers add along lines across a cell: Gauss's rule, too. An object for each thread, as of
/// HalfSpaceLines.
class LayerLines {
public:
  explicit LayerLines(const LayeredKernels& kernels) : kernels_(kernels), point_(kernels.parts()) {}

  static constexpr bool exact_across = false;
  std::size_t parts() const { return point_.size(); }
  /// Distance from the origin below which kernels are smooth [m].
  double smooth_distance() const { return 2 * kernels_.thickness(); }
  void find(double x, const Cell& cell, const GaussLegendre& rule, std::vector<Influence>& line) {
    std::fill(line.begin(), line.end(), Influence{});
    for (std::size_t k = 0; k < rule.count(); ++k) {
      const double y = rule.node(k, cell.y, cell.y + cell.height), r = std::hypot(x, y);
      kernels_.evaluate(r, point_);
      const double c = r > 0 ? x / r : 1, s = r > 0 ? y / r : 0, weight = rule.weight(k, 0, cell.height);
      for (std::size_t m = 0; m < line.size(); ++m) add(line[m], weight, directed(point_[m], c, s));
    }
  }

private:
  const LayeredKernels& kernels_;
  std::vector<PointKernel> point_;
};

/// Kernels of what layers add below endless strips.
class LayerStrips {
public:
  LayerStrips(const LayeredLineKernels& kernels, double far) : kernels_(kernels), far_(far), line_(kernels.parts()) {}

  static constexpr bool exact_across = true;
  std::size_t parts() const { return line_.size(); }
  double smooth_distance() const { return 2 * kernels_.thickness(); }
  void find(double x, const Cell&, const GaussLegendre&, std::vector<Influence>& line) {
    kernels_.evaluate(std::abs(x), far_, line_);
    for (std::size_t m = 0; m < line.size(); ++m) {
      const auto& [normal, along, across, coupling] = line_[m];
      line[m] = {along, 0, across, normal, x < 0 ? -coupling : coupling, 0};
    }
  }

private:
  const LayeredLineKernels& kernels_;
  double far_;
  std::vector<LineKernel> line_;
};

/// Integrals of the retarded half-spaces' kernels along lines across a cell, in closed form: with t = y/r of its ends,
/// of x^2/r^3, x y/r^3, y^2/r^3, x/r^2 and y/r^2 they are [t], -[x/r], [asinh(y/|x|) - t], [atan(y/x)] and [ln r]. In
/// asinh(y/|x|) = sign(y) (ln(|y| + r) - ln|x|) the last term cancels but where y changes its sign, which keeps it
/// finite at x = 0 elsewhere. Of endless lines they are (E10), (E11): of x^2/r^3 and y^2/r^3 in effect 0 and -2
/// ln|x/far|.
class HalfSpaceLines {
public:
  HalfSpaceLines(std::span<const HalfSpaceCreep> creep, const ElementSides& sides)
      : creep_(creep), far_(sides.far), smooth_distance_(1e-12 * sides.dx) {}

  static constexpr bool exact_across = true;
  std::size_t parts() const { return creep_.size() + 1; }
  double smooth_distance() const { return smooth_distance_; }
  void find(double x, const Cell& cell, const GaussLegendre&, std::vector<Influence>& line) {
    constexpr CombinedMaterial incompressible = {1, 0.5, 0}, without_ratio = {1, 0, 0.5}; // of G = 1/2 on a rigid body
    const KernelIntegrals sum = far_ ? endless(x) : across(x, cell);
    const Influence a = influence_of(incompressible, sum), both = influence_of(without_ratio, sum);
    line[0] = {};
    for (std::size_t m = 1; m < line.size(); ++m) {
      line[m] = {};
      add(line[m], creep_[m - 1].a - creep_[m - 1].b, a);
      add(line[m], creep_[m - 1].b, both);
    }
  }

private:
  KernelIntegrals endless(double x) const {
    return {.yy = -2 * std::log(std::abs(x) / *far_), .x = std::copysign(std::numbers::pi, x)};
  }
  static KernelIntegrals across(double x, const Cell& cell) {
    KernelIntegrals sum;
    add_end(1, x, cell.y + cell.height, sum);
    add_end(-1, x, cell.y, sum);
    if (cell.y < 0 && cell.y + cell.height > 0) sum.yy -= 2 * std::log(std::abs(x));
    return sum;
  }
  static void add_end(double sign, double x, double y, KernelIntegrals& sum) {
    const double r = std::hypot(x, y), t = y / r, side = y < 0 ? -1 : 1;
    sum.xx += sign * t, sum.xy -= sign * x / r, sum.yy += sign * (side * std::log(std::abs(y) + r) - t);
    sum.x += sign * std::atan(y / x), sum.y += sign * std::log(r);
  }

  std::span<const HalfSpaceCreep> creep_;
  std::optional<double> far_;
  double smooth_distance_;
};

/// Integrates kernels over cells.
template <class Lines> class CellQuadrature {
public:
  CellQuadrature(Lines lines, std::vector<double> lengths)
      : lines_(std::move(lines)), lengths_(std::move(lengths)), line_(lines_.parts()) {}

  void integrate(const Cell& cell, CellIntegrals& out) {
    std::fill(out.whole.begin(), out.whole.end(), Influence{});
    std::fill(out.fading.begin(), out.fading.end(), Influence{});
    add_cell(cell, cell.x, out);
  }

private:
  void add_cell(const Cell& cell, double begin, CellIntegrals& out) {
    const double scale = std::hypot(lines_.smooth_distance(), cell.distance()), largest = 0.7 * scale;
    const double height = Lines::exact_across ? 0 : cell.height;
    if (cell.width > largest && cell.width >= height) {
      const double half = cell.width / 2;
      add_cell({cell.x, cell.y, half, cell.height}, begin, out);
      add_cell({cell.x + half, cell.y, half, cell.height}, begin, out);
    } else if (height > largest) {
      const double half = cell.height / 2;
      add_cell({cell.x, cell.y, cell.width, half}, begin, out);
      add_cell({cell.x, cell.y + half, cell.width, half}, begin, out);
    } else {
      add_points(cell, rule_for(std::max(cell.width, height) / scale, !lengths_.empty()), begin, out);
    }
  }

  void add_points(const Cell& cell, const GaussLegendre& rule, double begin, CellIntegrals& out) {
    const std::vector<std::vector<double>>& fading = fading_of(rule, cell.width);
    for (std::size_t g = 0; g < rule.count(); ++g) {
      lines_.find(rule.node(g, cell.x, cell.x + cell.width), cell, rule, line_);
      for (std::size_t m = 0; m < line_.size(); ++m) {
        add(out.whole[m], rule.weight(g, 0, cell.width), line_[m]);
        if (m == 0) continue;
        const double faded = cell.x > begin ? std::exp((begin - cell.x) / lengths_[m - 1]) : 1;
        add(out.fading[m], faded * fading[m - 1][g], line_[m]);
      }
    }
  }

  const std::vector<std::vector<double>>& fading_of(const GaussLegendre& rule, double width) {
    const auto [found, is_new] = fading_.try_emplace({width, rule.count()});
    if (is_new)
      for (const double length : lengths_) found->second.push_back(fading_weights(rule, width, length));
    return found->second;
  }

  Lines lines_;
  std::vector<double> lengths_; ///< V T of the retarded parts [m]
  /// Weights of each length and node, by width and number of nodes.
  std::map<std::pair<double, std::size_t>, std::vector<std::vector<double>>> fading_;
  std::vector<Influence> line_;
};

/// Columns beyond the elements, from nearest to farthest, as far as the longest memory reaches: each is half as wide as
/// it is far from the middle.
std::vector<Cell> columns_beyond(double begin, double dx, const std::vector<double>& lengths) {
  std::vector<Cell> columns;
  if (lengths.empty()) return columns;
  const double end = begin + forgotten * *std::max_element(lengths.begin(), lengths.end());
  for (double x = begin; x < end; x += columns.back().width) columns.push_back({x, 0, std::max(dx, x / 2), 0});
  return columns;
}

/// Rows of elements, whose sums S run from the far end towards minus x. An object for each thread.
template <class Lines> class RolledRows {
public:
  RolledRows(const Lines& lines, const std::vector<double>& lengths)
      : lengths_(lengths), quadrature_(lines, lengths), integrals_(lines.parts()), sums_(lines.parts()) {}

  void add_to(const ElementSides& sides, const std::vector<Cell>& beyond, int j, InfluenceRows& rows) {
    const double y = (j - 0.5) * sides.dy;
    std::fill(sums_.begin(), sums_.end(), Influence{});
    for (auto cell = beyond.rbegin(); cell != beyond.rend(); ++cell) {
      quadrature_.integrate({cell->x, y, cell->width, sides.dy}, integrals_);
      continue_sums(cell->width);
    }
    const bool symmetric = lengths_.empty();
    for (int i = rows.columns() - 1; i >= (symmetric ? 0 : 1 - rows.columns()); --i) {
      quadrature_.integrate({(i - 0.5) * sides.dx, y, sides.dx, sides.dy}, integrals_);
      const Influence u = displacement(sides.dx);
      add(rows.at(i, j), 1, u);
      if (symmetric && i > 0) add(rows.at(-i, j), 1, mirrored_in_x(u));
      continue_sums(sides.dx);
    }
  }

private:
  Influence displacement(double dx) const {
    Influence sum = integrals_.whole[0];
    for (std::size_t m = 1; m < sums_.size(); ++m) {
      add(sum, 1, integrals_.whole[m]);
      add(sum, -1, integrals_.fading[m]);
      add(sum, -std::expm1(-dx / lengths_[m - 1]), sums_[m]);
    }
    return sum;
  }
  void continue_sums(double width) {
    for (std::size_t m = 1; m < sums_.size(); ++m) {
      Influence next = integrals_.fading[m];
      add(next, std::exp(-width / lengths_[m - 1]), sums_[m]);
      sums_[m] = next;
    }
  }

  std::vector<double> lengths_;
  CellQuadrature<Lines> quadrature_;
  CellIntegrals integrals_;
  std::vector<Influence> sums_; ///< S
};

template <class Lines>
void add_rows(const Lines& lines, const std::vector<double>& lengths, const std::vector<Cell>& beyond,
              const ElementSides& sides, const Progress& progress, InfluenceRows& rows) {
  const int threads = threads_for(static_cast<std::size_t>(rows.rows()) * static_cast<std::size_t>(rows.columns()), 64);
  std::vector<RolledRows<Lines>> of_thread(static_cast<std::size_t>(threads), {lines, lengths});
  distribute(rows.rows(), threads, progress, [&](int j, int thread, const Progress&) {
    of_thread[static_cast<std::size_t>(thread)].add_to(sides, beyond, j, rows);
  });
}

double end_of(const InfluenceRows& rows, const ElementSides& sides) {
  return (rows.columns() - 0.5) * sides.dx;
}

double surface_thickness(const LayeredBody& body) {
  if (body.layers.empty()) throw Error("layers: none");
  return body.layers.front().thickness;
}

} // namespace

Influence mirrored_in_x(const Influence& a) {
  return {a.xx, -a.xy, a.yy, a.zz, -a.xz, a.yz};
}

RolledLayers::RolledLayers(const LayeredBody& body) : RolledLayers(LayeredSpectrum(body), surface_thickness(body)) {}

RolledLayers::RolledLayers(const LayeredSpectrum& spectrum, double thickness)
    : points_(spectrum, thickness), lines_(spectrum, thickness) {}

void RolledLayers::add(double speed, const ElementSides& sides, const Progress& progress, InfluenceRows& rows) {
  std::vector<double> lengths(points_.times().begin(), points_.times().end());
  for (double& length : lengths) length *= speed;
  const std::vector<Cell> beyond = columns_beyond(end_of(rows, sides), sides.dx, lengths);
  const double end = beyond.empty() ? end_of(rows, sides) : beyond.back().x + beyond.back().width;
  if (sides.far) {
    lines_.extend(end);
    add_rows(LayerStrips(lines_, *sides.far), lengths, beyond, sides, progress, rows);
  } else {
    points_.extend(std::hypot(end, (rows.rows() - 0.5) * sides.dy));
    add_rows(LayerLines(points_), lengths, beyond, sides, progress, rows);
  }
}

void add_creep(std::span<const HalfSpaceCreep> creep, double speed, const ElementSides& sides, const Progress& progress,
               InfluenceRows& rows) {
  std::vector<double> lengths;
  for (const HalfSpaceCreep& part : creep) lengths.push_back(speed * part.time);
  const std::vector<Cell> beyond = columns_beyond(end_of(rows, sides), sides.dx, lengths);
  add_rows(HalfSpaceLines(creep, sides), lengths, beyond, sides, progress, rows);
}

} // namespace microslip
