#include "microslip/exact/halfspace/rolled_influence.hpp"

#include "microslip/error.hpp"
#include "microslip/exact/halfspace/cell_quadrature.hpp"
#include "microslip/exact/halfspace/hat_quadrature.hpp"
#include "microslip/numerics/gauss_legendre.hpp"
#include "microslip/numerics/threads.hpp"

#include <array>
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

/// Where a point lies between the centres next to it, at multiples of the distance: in [0, 1].
double place_between_centres(double x, double distance) {
  return x / distance - std::floor(x / distance);
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

/// The same with the weights of bilinear elements whose centres are at multiples of the sides.
class LayerHats {
public:
  LayerHats(const LayeredKernels& kernels, const ElementSides& sides)
      : kernels_(kernels), sides_(sides), point_(kernels.parts()), low_(point_.size()), high_(point_.size()) {}

  using Value = CornerInfluence;
  static constexpr bool exact_across = false;
  std::size_t parts() const { return point_.size(); }
  double smooth_distance() const { return 2 * kernels_.thickness(); }
  void find(double x, const Cell& cell, const GaussLegendre& rule, std::vector<CornerInfluence>& line) {
    std::fill(low_.begin(), low_.end(), Influence{});
    std::fill(high_.begin(), high_.end(), Influence{});
    for (std::size_t k = 0; k < rule.count(); ++k) {
      const double y = rule.node(k, cell.y, cell.y + cell.height), r = std::hypot(x, y);
      kernels_.evaluate(r, point_);
      const double weight = rule.weight(k, 0, cell.height), rise = place_between_centres(y, sides_.dy);
      for (std::size_t m = 0; m < line.size(); ++m) {
        const Influence a = directed(point_[m], x / r, y / r);
        add(low_[m], weight * (1 - rise), a);
        add(high_[m], weight * rise, a);
      }
    }
    const double rise = place_between_centres(x, sides_.dx);
    for (std::size_t m = 0; m < line.size(); ++m) line[m] = shared_out(low_[m], high_[m], rise);
  }

private:
  const LayeredKernels& kernels_;
  ElementSides sides_;
  std::vector<PointKernel> point_;
  std::vector<Influence> low_, high_; ///< with the weights of elements below and above
};

/// Kernels of what layers add below endless strips.
class LayerStrips {
public:
  LayerStrips(const LayeredLineKernels& kernels, double far) : kernels_(kernels), far_(far), line_(kernels.parts()) {}

  using Value = Influence;
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

/// Integrals of a half-space's kernels along lines across a cell, in closed form: with t = y/r of its ends, of x^2/r^3,
/// x y/r^3, y^2/r^3, x/r^2 and y/r^2 they are [t], -[x/r], [asinh(y/|x|) - t], [atan(y/x)] and [ln r]. In asinh(y/|x|)
/// = sign(y) (ln(|y| + r) - ln|x|) the last term cancels but where y changes its sign, which keeps it finite at x = 0
/// elsewhere.
KernelIntegrals integrals_across(double x, const Cell& cell) {
  KernelIntegrals sum;
  const auto add_end = [&](double sign, double y) {
    const double r = std::hypot(x, y), t = y / r, side = y < 0 ? -1 : 1;
    sum.xx += sign * t, sum.xy -= sign * x / r, sum.yy += sign * (side * std::log(std::abs(y) + r) - t);
    sum.x += sign * std::atan(y / x), sum.y += sign * std::log(r);
  };
  add_end(1, cell.y + cell.height);
  add_end(-1, cell.y);
  if (cell.y < 0 && cell.y + cell.height >= 0) sum.yy -= 2 * std::log(std::abs(x));
  return sum;
}

/// Those of y times the kernels: -[x^2/r], [x (asinh(y/|x|) - t)], [r + x^2/r], [x ln r] and [y - x atan(y/x)].
KernelIntegrals moments_across(double x, const Cell& cell) {
  KernelIntegrals sum;
  const auto add_end = [&](double sign, double y) {
    const double r = std::hypot(x, y), bent = x * x / r;
    sum.xx -= sign * bent, sum.xy += sign * x * (std::asinh(y / std::abs(x)) - y / r), sum.yy += sign * (r + bent);
    sum.x += sign * x * std::log(r), sum.y += sign * (y - x * std::atan(y / x));
  };
  add_end(1, cell.y + cell.height);
  add_end(-1, cell.y);
  return sum;
}

/// What kernels integrate to in a retarded part of a half-space.
Influence creep_influence(const HalfSpaceCreep& part, const KernelIntegrals& integrals) {
  constexpr CombinedMaterial incompressible = {1, 0.5, 0}, without_ratio = {1, 0, 0.5}; // of G = 1/2 on a rigid body
  Influence sum{};
  add(sum, part.a - part.b, influence_of(incompressible, integrals));
  add(sum, part.b, influence_of(without_ratio, integrals));
  return sum;
}

/// Integrals of the retarded half-spaces' kernels along lines across a cell. Of endless lines they are (E10), (E11): of
/// x^2/r^3 and y^2/r^3 in effect 0 and -2 ln|x/far|.
class HalfSpaceLines {
public:
  HalfSpaceLines(std::span<const HalfSpaceCreep> creep, const ElementSides& sides)
      : creep_(creep), far_(sides.far), smooth_distance_(nearest * sides.dx) {}

  using Value = Influence;
  static constexpr bool exact_across = true;
  static constexpr double nearest = 1e-12; ///< of the elements' length
  std::size_t parts() const { return creep_.size() + 1; }
  double smooth_distance() const { return smooth_distance_; }
  void find(double x, const Cell& cell, const GaussLegendre&, std::vector<Influence>& line) {
    const KernelIntegrals sum = far_ ? endless(x) : integrals_across(x, cell);
    line[0] = {};
    for (std::size_t m = 1; m < line.size(); ++m) line[m] = creep_influence(creep_[m - 1], sum);
  }

private:
  KernelIntegrals endless(double x) const {
    return {.yy = -2 * std::log(std::abs(x) / *far_), .x = std::copysign(std::numbers::pi, x)};
  }

  std::span<const HalfSpaceCreep> creep_;
  std::optional<double> far_;
  double smooth_distance_;
};

/// The same with the weights of bilinear elements whose centres are at multiples of the sides.
class HalfSpaceHats {
public:
  HalfSpaceHats(std::span<const HalfSpaceCreep> creep, const ElementSides& sides) : creep_(creep), dx_(sides.dx) {}

  using Value = CornerInfluence;
  static constexpr bool exact_across = true;
  std::size_t parts() const { return creep_.size() + 1; }
  double smooth_distance() const { return HalfSpaceLines::nearest * dx_; }
  void find(double x, const Cell& cell, const GaussLegendre&, std::vector<CornerInfluence>& line) {
    const KernelIntegrals sum = integrals_across(x, cell), moment = moments_across(x, cell);
    line[0] = {};
    for (std::size_t m = 1; m < line.size(); ++m) {
      Influence low = creep_influence(creep_[m - 1], sum), high{};
      add(high, 1 / cell.height, creep_influence(creep_[m - 1], moment));
      add(high, -cell.y / cell.height, low);
      add(low, -1, high);
      line[m] = shared_out(low, high, place_between_centres(x, dx_));
    }
  }

private:
  std::span<const HalfSpaceCreep> creep_;
  double dx_;
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

/// Adds the influence of bilinear elements likewise, from the cells between their centres.
template <class Hats>
void add_hats(const Hats& hats, const std::vector<double>& lengths, const std::vector<Cell>& beyond,
              const ElementSides& sides, const Progress& progress, InfluenceRows& rows) {
  const bool symmetric = lengths.empty();
  const int columns = rows.columns(), first = symmetric ? 0 : 1 - columns;
  const int threads = threads_for(static_cast<std::size_t>(rows.rows()) * static_cast<std::size_t>(columns), 64);
  std::vector<RolledHats<Hats>> of_thread(static_cast<std::size_t>(threads), {hats, lengths, beyond});
  std::array<InfluenceRows, 2> sums{InfluenceRows(columns, rows.rows()), {columns, rows.rows()}}; // of cells on a side
  distribute(rows.rows() + 1, threads, progress, [&](int row, int thread, const Progress&) {
    const auto add_at = [&](int i, const CornerInfluence& u) {
      for (int b = 0; b < 2; ++b)
        for (int a = 0; a < 2; ++a) {
          const int to = i + a, j = row - 1 + b;
          if (to >= first && to < columns && j >= 0 && j < rows.rows()) add(sums[b].at(to, j), 1, u.at[a + 2 * b]);
        }
    };
    of_thread[static_cast<std::size_t>(thread)].find(first - 1, columns - 1, (row - 1) * sides.dy, sides.dx, sides.dy,
                                                     add_at);
  });
  for (int j = 0; j < rows.rows(); ++j)
    for (int i = first; i < columns; ++i)
      for (const InfluenceRows& sum : sums) {
        add(rows.at(i, j), 1, sum.at(i, j));
        if (symmetric && i > 0) add(rows.at(-i, j), 1, mirrored_in_x(sum.at(i, j)));
      }
}

/// How far the elements of an offset beyond the last one reach.
double reach_beyond(const ElementSides& sides) {
  return sides.shape == ElementShape::bilinear ? 1 : 0.5;
}
double end_of(const InfluenceRows& rows, const ElementSides& sides) {
  return (rows.columns() - 1 + reach_beyond(sides)) * sides.dx;
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
    return;
  }
  points_.extend(std::hypot(end, (rows.rows() - 1 + reach_beyond(sides)) * sides.dy));
  if (sides.shape == ElementShape::bilinear)
    add_hats(LayerHats(points_, sides), lengths, beyond, sides, progress, rows);
  else
    add_rows(LayerLines(points_), lengths, beyond, sides, progress, rows);
}

void add_creep(std::span<const HalfSpaceCreep> creep, double speed, const ElementSides& sides, const Progress& progress,
               InfluenceRows& rows) {
  std::vector<double> lengths;
  for (const HalfSpaceCreep& part : creep) lengths.push_back(speed * part.time);
  const std::vector<Cell> beyond = columns_beyond(end_of(rows, sides), sides.dx, lengths);
  if (sides.shape == ElementShape::bilinear)
    add_hats(HalfSpaceHats(creep, sides), lengths, beyond, sides, progress, rows);
  else
    add_rows(HalfSpaceLines(creep, sides), lengths, beyond, sides, progress, rows);
}

} // namespace microslip
