#include "microslip/interior/interior_field.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/elasticity/bilinear_interior_influence.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/halfspace/memory_need.hpp"
#include "microslip/exact/halfspace/retarded_influence.hpp"
#include "microslip/numerics/threads.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace microslip {
namespace {

// Loads and components by number, in the order of these tables.
constexpr std::array loads = {&InteriorInfluence::px, &InteriorInfluence::py, &InteriorInfluence::pn};
constexpr int components = 9;

template <class State> auto& component_of(State& s, int component) {
  auto& t = s.stress;
  const std::array all = {&s.ux, &s.uy, &s.uz, &t.xx, &t.yy, &t.zz, &t.xy, &t.xz, &t.yz};
  return *all[component];
}

// How they change their signs with x and y.
constexpr std::array<Parity, 3> load_parity = {{{true, false}, {false, true}, {false, false}}};
constexpr std::array<Parity, components> component_parity = {{{true, false},
                                                              {false, true},
                                                              {false, false},
                                                              {false, false},
                                                              {false, false},
                                                              {false, false},
                                                              {true, true},
                                                              {true, false},
                                                              {false, true}}};
constexpr int displacements = 3; // which come first

constexpr int at_once = 64;                     // elements between two calls of progress
constexpr std::size_t work_of_threads = 100000; // points times elements that are worth several threads

/// Parity of the influence of a load on a component: odd where only one of them is.
Parity influence_parity(int load, int component) {
  const Parity a = load_parity[load], b = component_parity[component];
  return {a.odd_x != b.odd_x, a.odd_y != b.odd_y};
}

double require_depth(double depth) {
  if (require_finite("depth", depth, "m") < 0) throw Error("depth", depth, "m", "at least 0");
  return depth;
}

std::vector<double> copy_of(const char* name, std::span<const double> p, std::size_t count) {
  if (p.empty()) return std::vector<double>(count);
  if (p.size() != count)
    throw Error(std::string("size of ") + name, double(p.size()), "-", "the number of elements, or 0");
  for (const double value : p) require_finite(name, value, "Pa");
  return {p.begin(), p.end()};
}

/// Memory of InteriorLayers for a point, at most [bytes], and for the kernels of several depths.
constexpr double memory_for_point = 900, memory_for_retarded_point = 1600;
constexpr std::size_t most_kept = std::size_t(256) << 20;

ElementGrid with_margin(const InteriorField& field, int margin) {
  ElementGrid grid = field.grid();
  require_count("margin", margin, 0, most_cells);
  grid.mx += 2 * margin;
  grid.x0 -= margin * grid.dx;
  if (!grid.line) {
    grid.my += 2 * margin;
    grid.y0 -= margin * grid.dy;
  }
  const auto points = static_cast<double>(grid.count());
  const double bytes = field.has_retardation() ? memory_for_retarded_point : memory_for_point;
  if (points * bytes > physical_memory())
    throw Error("points of a plane", points, "-",
                "no more than this machine has memory for, " + std::to_string(std::lround(bytes)) + " bytes each");
  return grid;
}

/// Values of a grid in the middle of a larger one.
std::vector<double> embedded(const std::vector<double>& values, const ElementGrid& inner, const ElementGrid& outer) {
  const int columns = (outer.mx - inner.mx) / 2, rows = (outer.my - inner.my) / 2;
  std::vector<double> out(outer.count());
  for (int j = 0; j < inner.my; ++j)
    std::copy_n(values.begin() + std::ptrdiff_t(j) * inner.mx, inner.mx,
                out.begin() + std::ptrdiff_t(j + rows) * outer.mx + columns);
  return out;
}

bool any(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double v) { return v != 0; });
}

} // namespace

InteriorField::InteriorField(const Material& material, Body body, const ElementGrid& grid,
                             const SurfaceTractions& tractions, const Retardation& retardation)
    : material_(material), delay_(retardation), body_(body), grid_(grid) {
  check(grid);
  if (!(material.shear_modulus > 0))
    throw Error("shear_modulus", material.shear_modulus, "Pa", "positive, or infinite for a rigid body");
  require_between("poisson_ratio", material.poisson_ratio, "-", 0, 0.5);
  require_between("retardation.ratio", retardation.ratio, "-", 0, 1e6);
  require_finite("retardation.distance", retardation.distance, "m");
  set_tractions(tractions);
  if (!grid.line || !has_retardation()) return;
  // As in the contact problem: on the average 0 where the elastic displacements are.
  const double far = grid.mx * grid.dx;
  const InteriorInfluence behind = retarded_influence(-far, 1, 0, 0)[0], ahead = retarded_influence(far, 1, 0, 0)[0];
  retarded_far_away_.px.ux = (behind.px.ux + ahead.px.ux) / 2;
  retarded_far_away_.py.uy = (behind.py.uy + ahead.py.uy) / 2;
  retarded_far_away_.pn.uz = (behind.pn.uz + ahead.pn.uz) / 2;
}

InteriorField::InteriorField(const LayeredBody& body, Body number, const ElementGrid& grid,
                             const SurfaceTractions& tractions, double speed)
    : layers_(std::make_shared<LayeredElements>(body, number, grid, speed)), material_(body.top().instantaneous),
      body_(number), grid_(grid) {
  set_tractions(tractions);
}

void InteriorField::set_tractions(const SurfaceTractions& tractions) {
  px_ = copy_of("px", tractions.px, grid_.count());
  py_ = copy_of("py", tractions.py, grid_.count());
  pn_ = copy_of("pn", tractions.pn, grid_.count());
  loaded_.clear();
  loaded_rows_.clear();
  for (int j = 0; j < grid_.my; ++j) {
    const std::size_t begin = loaded_.size();
    for (int i = 0; i < grid_.mx; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * grid_.mx + i;
      if (px_[k] != 0 || py_[k] != 0 || pn_[k] != 0) loaded_.push_back({i, j, px_[k], py_[k], pn_[k]});
    }
    if (loaded_.size() > begin) loaded_rows_.push_back({begin, loaded_.size()});
  }
}

InteriorInfluence InteriorField::half_space_influence(double x, double y, double depth) const {
  const double far = grid_.mx * grid_.dx;
  if (grid_.shape == ElementShape::bilinear)
    return grid_.line ? bilinear_line_interior_influence(material_, body_, grid_.dx, x, depth, far)
                      : bilinear_interior_influence(material_, body_, grid_.dx, grid_.dy, x, y, depth);
  if (grid_.line) return line_interior_influence(material_, body_, grid_.dx, x, depth, far);
  return interior_influence(material_, body_, grid_.dx, grid_.dy, x, y, depth);
}

std::vector<InteriorInfluence> InteriorField::influence(double x_first, int count, double y, double depth,
                                                        const Progress& progress) const {
  if (layers_ && layers_->is_elastic()) return layers_->row(x_first, count, y, depth);
  std::vector<InteriorInfluence> row(count);
  for (int i = 0; i < count && !layers_; ++i) {
    if (i % at_once == 0) go_on(progress, 0);
    row[i] = half_space_influence(x_first + i * grid_.dx, y, depth);
  }
  return row;
}

std::vector<InteriorInfluence> InteriorField::retarded_influence(double x_first, int count, double y,
                                                                 double depth) const {
  if (layers_) return layers_->row(x_first, count, y, depth);
  std::vector<InteriorInfluence> row = retarded_row<InteriorInfluence>(
      delay_, [&](double x) { return half_space_influence(x, y, depth); }, grid_.dx, x_first, count);
  for (InteriorInfluence& a : row) {
    a.px.ux -= retarded_far_away_.px.ux;
    a.py.uy -= retarded_far_away_.py.uy;
    a.pn.uz -= retarded_far_away_.pn.uz;
  }
  return row;
}

int InteriorField::retarded_components() const {
  if (layers_) return layers_->is_elastic() ? 0 : components;
  return delay_.ratio > 0 ? displacements : 0;
}

/// Adds what is retarded, and of layers all, row by row, as the history of an element's displacement is that of the
/// next one as well.
void InteriorField::add_rows(const InteriorPoint& point, const Progress& progress, InteriorState& sum) const {
  for (const auto& [begin, end] : loaded_rows_) {
    go_on(progress, 0);
    const int first = loaded_[begin].i, last = loaded_[end - 1].i;
    const double y = point.y - grid_.y(loaded_[begin].j);
    const auto influences = retarded_influence(point.x - grid_.x(last), last - first + 1, y, point.depth);
    for (std::size_t k = begin; k < end; ++k) {
      const InteriorInfluence& a = influences[static_cast<std::size_t>(last - loaded_[k].i)];
      add(sum, loaded_[k].px, a.px);
      add(sum, loaded_[k].py, a.py);
      add(sum, loaded_[k].pn, a.pn);
    }
  }
}

InteriorState InteriorField::at(const InteriorPoint& point, const Progress& progress) const {
  require_finite("x", point.x, "m");
  require_finite("y", point.y, "m");
  require_depth(point.depth);
  InteriorState sum;
  if (layers_) {
    add_rows(point, progress, sum);
    return sum;
  }
  for (std::size_t k = 0; k < loaded_.size(); ++k) {
    if (k % at_once == 0) go_on(progress, 0);
    const LoadedElement& e = loaded_[k];
    const InteriorInfluence a = half_space_influence(point.x - grid_.x(e.i), point.y - grid_.y(e.j), point.depth);
    if (e.px != 0) add(sum, e.px, a.px);
    if (e.py != 0) add(sum, e.py, a.py);
    if (e.pn != 0) add(sum, e.pn, a.pn);
  }
  if (has_retardation()) add_rows(point, progress, sum);
  return sum;
}

std::vector<InteriorState> InteriorField::at(std::span<const InteriorPoint> points, const Progress& progress) const {
  constexpr std::size_t together = 16;
  for (const InteriorPoint& p : points) { // the first bad one is named
    require_finite("x", p.x, "m");
    require_finite("y", p.y, "m");
    require_depth(p.depth);
  }
  std::vector<InteriorState> states(points.size());
  const auto blocks = static_cast<int>((points.size() + together - 1) / together);
  distribute(blocks, threads_for(points.size() * loaded_.size(), work_of_threads), progress,
             [&](int block, int, const Progress& on) {
               const std::size_t first = block * together, last = std::min(first + together, points.size());
               for (std::size_t k = first; k < last; ++k) states[k] = at(points[k], on);
             });
  return states;
}

InteriorLayers::InteriorLayers(InteriorField field, int margin, const Progress& progress)
    : field_(std::move(field)), grid_(with_margin(field_, margin)), transform_(grid_.mx, grid_.my) {
  load(progress);
}

void InteriorLayers::set_tractions(const SurfaceTractions& tractions, const Progress& progress) {
  field_.set_tractions(tractions);
  load(progress);
}

void InteriorLayers::load(const Progress& progress) {
  const std::array all = {&field_.px(), &field_.py(), &field_.pn()};
  std::vector<std::vector<double>> padded;
  loads_.clear();
  for (int load = 0; load < static_cast<int>(all.size()); ++load)
    if (any(*all[load])) {
      loads_.push_back(load);
      padded.push_back(embedded(*all[load], field_.grid(), grid_));
    }
  const std::vector<std::span<const double>> spans(padded.begin(), padded.end());
  transform_.load(spans, progress);
}

InteriorLayers::Influences InteriorLayers::influences(double depth, const Progress& progress) const {
  const int width = 2 * grid_.mx - 1;
  Influences found;
  found.quadrant.resize(grid_.count());
  if (field_.has_retardation()) found.retarded.resize(static_cast<std::size_t>(width) * grid_.my);
  const int threads = field_.has_retardation() ? omp_get_max_threads() : threads_for(grid_.count(), 1000);
  distribute(grid_.my, threads, progress, [&](int j, int, const Progress& on) {
    const double y = j * grid_.dy;
    const auto elastic = field_.influence(0, grid_.mx, y, depth, on);
    std::copy(elastic.begin(), elastic.end(), found.quadrant.begin() + std::ptrdiff_t(j) * grid_.mx);
    if (!field_.has_retardation()) return;
    const auto row = field_.retarded_influence((1 - grid_.mx) * grid_.dx, width, y, depth);
    std::copy(row.begin(), row.end(), found.retarded.begin() + std::ptrdiff_t(j) * width);
  });
  return found;
}

/// A retarded influence is neither even nor odd in x: the part with the elastic one's parity is added to that, the
/// other one is a separate kernel.
InteriorLayers::LoadKernels InteriorLayers::find_kernels(int load, const Influences& influences,
                                                         const Progress& progress) {
  LoadKernels kernels;
  const int middle = grid_.mx - 1, width = 2 * grid_.mx - 1;
  for (int component = 0; component < components; ++component) {
    const auto value = [&](const InteriorInfluence& a) { return component_of(a.*loads[load], component); };
    const Parity parity = influence_parity(load, component);
    const bool retarded = component < field_.retarded_components() && !influences.retarded.empty();
    // Half of what is retarded at offsets i and -i of a row, the latter with a sign.
    const auto half = [&](int j, int i, double sign) {
      const InteriorInfluence* row = &influences.retarded[static_cast<std::size_t>(j) * width + middle];
      return (value(row[i]) + sign * value(row[-i])) / 2;
    };
    const double sign = parity.odd_x ? -1 : 1;
    kernels.push_back(transform_.spectrum(
        parity,
        [&](int j, std::span<double> entries) {
          for (int i = 0; i < grid_.mx; ++i) {
            entries[i] = value(influences.quadrant[static_cast<std::size_t>(j) * grid_.mx + i]);
            if (retarded) entries[i] += half(j, i, sign);
          }
        },
        progress));
    if (!retarded) continue;
    kernels.push_back(transform_.spectrum(
        {!parity.odd_x, parity.odd_y},
        [&](int j, std::span<double> entries) {
          for (int i = 0; i < grid_.mx; ++i) entries[i] = half(j, i, -sign);
        },
        progress));
  }
  return kernels;
}

/// Kernels of a depth, at least those of the loads that are not zero.
const InteriorLayers::Kernels& InteriorLayers::kernels(double depth, const Progress& progress) {
  Kernels& kernels = kept_[depth];
  const bool complete = std::all_of(loads_.begin(), loads_.end(), [&](int load) { return !kernels[load].empty(); });
  if (complete) return kernels;
  const Influences found = influences(depth, progress);
  for (const int load : loads_)
    if (kernels[load].empty()) kernels[load] = find_kernels(load, found, progress);
  return kernels;
}

/// Forgets what was kept of a depth if it is too much together with the rest.
void InteriorLayers::limit_memory(double depth) {
  std::size_t bytes = 0;
  for (const auto& [_, kernels] : kept_)
    for (const LoadKernels& of_load : kernels)
      for (const auto& spectrum : of_load) bytes += spectrum.size() * sizeof(double);
  if (bytes > most_kept) kept_.erase(depth);
}

std::vector<InteriorState> InteriorLayers::at_depth(double depth, const Progress& progress) {
  std::vector<int> columns(grid_.mx), rows(grid_.my);
  std::iota(columns.begin(), columns.end(), 0);
  std::iota(rows.begin(), rows.end(), 0);
  return at_depth(depth, columns, rows, progress);
}

std::vector<InteriorState> InteriorLayers::at_depth(double depth, std::span<const int> columns,
                                                    std::span<const int> rows, const Progress& progress) {
  require_depth(depth);
  std::vector<InteriorState> states(columns.size() * rows.size());
  if (loads_.empty()) return states;
  const Kernels& of_depth = kernels(depth, progress);

  std::vector<double> values(rows.size() * grid_.mx);
  std::array<std::size_t, loads.size()> next{}; // kernel of each load
  for (int component = 0; component < components; ++component) {
    std::vector<ParityToeplitz::Term> terms;
    for (std::size_t in = 0; in < loads_.size(); ++in) {
      const int load = loads_[in];
      Parity parity = influence_parity(load, component);
      terms.push_back({in, &of_depth[load][next[in]++], parity});
      if (component >= field_.retarded_components()) continue;
      parity.odd_x = !parity.odd_x;
      terms.push_back({in, &of_depth[load][next[in]++], parity});
    }
    transform_.apply(terms, rows, values, progress);
    for (std::size_t r = 0, k = 0; r < rows.size(); ++r)
      for (const int column : columns) component_of(states[k++], component) = values[r * grid_.mx + column];
  }
  limit_memory(depth);
  return states;
}

} // namespace microslip
