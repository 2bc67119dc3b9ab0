#include "microslip/exact/halfspace/rolled_influence.hpp"

#include "microslip/elasticity/layered_line_kernels.hpp"
#include "microslip/exact/halfspace/cell_quadrature.hpp"
#include "microslip/numerics/threads.hpp"

#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

namespace microslip {
namespace {

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

  using Value = Influence;
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
  explicit LayerStrips(const LayeredLineKernels& kernels) : kernels_(kernels), line_(kernels.parts()) {}

  using Value = Influence;
  static constexpr bool exact_across = true;
  std::size_t parts() const { return line_.size(); }
  double smooth_distance() const { return 2 * kernels_.thickness(); }
  void find(double x, const Cell&, const GaussLegendre&, std::vector<Influence>& line) {
    kernels_.evaluate(std::abs(x), line_);
    for (std::size_t m = 0; m < line.size(); ++m) {
      const auto& [normal, along, across, coupling] = line_[m];
      line[m] = {along, 0, across, normal, x < 0 ? -coupling : coupling, 0};
    }
  }

private:
  const LayeredLineKernels& kernels_;
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

  using Value = Influence;
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

/// Adds the influence of rows of elements; half of each row of symmetric ones.
template <class Lines>
void add_rows(const Lines& lines, const std::vector<double>& lengths, const std::vector<Cell>& beyond,
              const ElementSides& sides, const Progress& progress, InfluenceRows& rows) {
  const bool symmetric = lengths.empty();
  const int first = symmetric ? 0 : 1 - rows.columns();
  const int threads = threads_for(static_cast<std::size_t>(rows.rows()) * static_cast<std::size_t>(rows.columns()), 64);
  std::vector<RolledRows<Lines>> of_thread(static_cast<std::size_t>(threads), {lines, lengths, beyond});
  distribute(rows.rows(), threads, progress, [&](int j, int thread, const Progress&) {
    const auto add_at = [&](int n, const Influence& u) {
      const int i = first + n;
      add(rows.at(i, j), 1, u);
      if (symmetric && i > 0) add(rows.at(-i, j), 1, mirrored_in_x(u));
    };
    of_thread[static_cast<std::size_t>(thread)].find(first * sides.dx, rows.columns() - first, j * sides.dy, sides.dx,
                                                     sides.dy, add_at);
  });
}

double end_of(const InfluenceRows& rows, const ElementSides& sides) {
  return (rows.columns() - 0.5) * sides.dx;
}

} // namespace

Influence mirrored_in_x(const Influence& a) {
  return {a.xx, -a.xy, a.yy, a.zz, -a.xz, a.yz};
}

void add_layers(const LayeredBody& body, double speed, const ElementSides& sides, const Progress& progress,
                InfluenceRows& rows) {
  const LayeredSpectrum spectrum(body);
  std::vector<double> lengths(spectrum.times().begin(), spectrum.times().end());
  for (double& length : lengths) length *= speed;
  const std::vector<Cell> beyond = columns_beyond(end_of(rows, sides), sides.dx, lengths);
  const double end = beyond.empty() ? end_of(rows, sides) : beyond.back().x + beyond.back().width;
  const double thickness = body.layers.front().thickness;
  if (sides.far) {
    const LayeredLineKernels kernels(spectrum, thickness, end, *sides.far);
    add_rows(LayerStrips(kernels), lengths, beyond, sides, progress, rows);
  } else {
    const LayeredKernels kernels(spectrum, thickness, std::hypot(end, (rows.rows() - 0.5) * sides.dy));
    add_rows(LayerLines(kernels), lengths, beyond, sides, progress, rows);
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
