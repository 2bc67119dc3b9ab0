#include "microslip/interior/layered_elements.hpp"

#include "microslip/elasticity/interior_kernels.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/halfspace/cell_quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace microslip {
namespace {

constexpr double on_surface = 1e-6;   // of an element
constexpr std::size_t most_kept = 64; // depths

/// Sums of kernels along lines across a cell, by Gauss's rule.
class PointLines {
public:
  explicit PointLines(const InteriorPointKernels& kernels) : kernels_(kernels), point_(kernels.parts()) {}

  using Value = InteriorInfluence;
  static constexpr bool exact_across = false;
  std::size_t parts() const { return point_.size(); }
  double smooth_distance() const { return kernels_.smooth_distance(); }
  void find(double x, const Cell& cell, const GaussLegendre& rule, std::vector<Value>& line) {
    std::fill(line.begin(), line.end(), Value{});
    for (std::size_t k = 0; k < rule.count(); ++k) {
      const double y = rule.node(k, cell.y, cell.y + cell.height), weight = rule.weight(k, 0, cell.height);
      kernels_.evaluate(std::hypot(x, y), point_);
      for (std::size_t m = 0; m < line.size(); ++m) add(line[m], weight, point_[m].at(x, y));
    }
  }

private:
  const InteriorPointKernels& kernels_;
  std::vector<InteriorPointState> point_;
};

/// Kernels of endless strips.
class StripLines {
public:
  explicit StripLines(const InteriorLineKernels& kernels) : kernels_(kernels), line_(kernels.parts()) {}

  using Value = InteriorInfluence;
  static constexpr bool exact_across = true;
  std::size_t parts() const { return line_.size(); }
  double smooth_distance() const { return kernels_.smooth_distance(); }
  void find(double x, const Cell&, const GaussLegendre&, std::vector<Value>& line) {
    kernels_.evaluate(std::abs(x), line_);
    for (std::size_t m = 0; m < line.size(); ++m) line[m] = line_[m].at(x);
  }

private:
  const InteriorLineKernels& kernels_;
  std::vector<InteriorLineState> line_;
};

/// The state of the mirrored tractions, at the mirrored point: what is odd in x.
InteriorState mirrored_in_x(const InteriorState& s) {
  return {-s.ux, s.uy, s.uz, {s.stress.xx, s.stress.yy, s.stress.zz, -s.stress.xy, -s.stress.xz, s.stress.yz}};
}
InteriorInfluence mirrored_in_x(const InteriorInfluence& a) {
  InteriorInfluence mirrored = {{}, mirrored_in_x(a.py), mirrored_in_x(a.pn)};
  add(mirrored.px, -1, mirrored_in_x(a.px));
  return mirrored;
}

std::vector<double> memory_lengths(const LayeredBody& body, double speed) {
  const CreepBasis basis(body);
  std::vector<double> lengths(basis.times().begin(), basis.times().end());
  for (double& length : lengths) length *= std::abs(speed);
  return lengths;
}

} // namespace

struct LayeredElements::Kernels {
  std::optional<InteriorPointKernels> point;
  std::optional<InteriorLineKernels> line;
};

LayeredElements::LayeredElements(const LayeredBody& body, Body number, const ElementGrid& grid, double speed)
    : body_(body), number_(number), grid_(grid), speed_(speed) {
  check("body", body);
  if (grid.shape != ElementShape::constant) throw Error("layers: states inside need constant elements");
  require_finite("speed", speed, "m/s");
  if (speed == 0 && !body.is_elastic()) throw Error("speed", 0, "m/s", "not zero for viscoelastic bodies");
  lengths_ = memory_lengths(body, speed);
}

std::shared_ptr<const LayeredElements::Kernels> LayeredElements::kernels(double depth, double reach) const {
  const double length = std::hypot(grid_.mx * grid_.dx, grid_.line ? 0 : grid_.my * grid_.dy);
  const int doublings = std::max(1, static_cast<int>(std::ceil(std::log2(reach / length))));
  const std::lock_guard lock(guard_);
  const std::pair key(depth, doublings);
  if (const auto found = known_.find(key); found != known_.end()) return found->second;
  const double rounded_reach = length * std::exp2(doublings);
  const InteriorSpectrum spectrum(body_, depth);
  auto kernels = std::make_shared<Kernels>();
  if (grid_.line)
    kernels->line.emplace(spectrum, rounded_reach, grid_.mx * grid_.dx);
  else
    kernels->point.emplace(spectrum, rounded_reach);
  if (known_.size() >= most_kept) known_.clear();
  return known_[key] = kernels;
}

/// Of rolling along +x, in body 1.
std::vector<InteriorInfluence> LayeredElements::rolled_row(double x_first, int count, double y, double depth) const {
  const double dx = grid_.dx, dy = grid_.dy;
  const LayerDepth at = layer_at(body_, depth);
  std::vector<InteriorInfluence> row(count);
  if (at.layer == 0)
    for (int i = 0; i < count; ++i) {
      const Material& top = body_.top().instantaneous;
      const double x = x_first + i * dx;
      row[i] = grid_.line ? line_interior_influence(top, Body::first, dx, x, depth, grid_.mx * dx)
                          : interior_influence(top, Body::first, dx, dy, x, y, depth);
    }
  if (body_.layers.empty() && body_.is_elastic()) return row;
  const std::vector<Cell> beyond = columns_beyond(x_first + (count - 0.5) * dx, dx, lengths_);
  const double last = beyond.empty() ? x_first + (count - 0.5) * dx : beyond.back().x + beyond.back().width;
  const double reach = std::hypot(std::max(std::abs(x_first) + dx, std::abs(last)), grid_.line ? 0 : std::abs(y) + dy);
  const double smooth_depth = is_elastic() ? depth : std::max(depth, on_surface * std::min(dx, dy));
  const auto there = kernels(smooth_depth, reach);
  const auto found = [&](int i, const InteriorInfluence& a) { add(row[i], 1, a); };
  if (there->line)
    RolledRows(StripLines(*there->line), lengths_, beyond).find(x_first, count, y, dx, dy, found);
  else
    RolledRows(PointLines(*there->point), lengths_, beyond).find(x_first, count, y, dx, dy, found);
  return row;
}

std::vector<InteriorInfluence> LayeredElements::row(double x_first, int count, double y, double depth) const {
  const bool mirrored = speed_ < 0 && !is_elastic();
  std::vector<InteriorInfluence> row =
      rolled_row(mirrored ? -(x_first + (count - 1) * grid_.dx) : x_first, count, y, depth);
  if (mirrored) {
    std::reverse(row.begin(), row.end());
    for (InteriorInfluence& a : row) a = mirrored_in_x(a);
  }
  if (number_ == Body::second)
    for (InteriorInfluence& a : row) a = of_body_2(a);
  return row;
}

} // namespace microslip
