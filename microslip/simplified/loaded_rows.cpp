#include "microslip/simplified/loaded_rows.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"
#include "microslip/simplified/flexibility.hpp"
#include "microslip/simplified/kernel/field_recorder.hpp"
#include "microslip/simplified/load_moments.hpp"
#include "microslip/simplified/row_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

namespace microslip {

using namespace detail;

namespace {

/// The bound's course along a row, of mean 1/2 over the row's length, in the kernels' points: the mean of a
/// semi-ellipse and a parabola with the integral 1 over half a row.
struct RowProfile {
  std::vector<double> centre, middle;

  explicit RowProfile(int cells) {
    const auto at = [cells](double position) {
      const double t = 1 - 2 * position / cells, rest = 1 - t * t;
      return std::sqrt(rest) / std::numbers::pi + 0.375 * rest;
    };
    centre.push_back(0);
    double sum = 0;
    for (int i = 1; i <= cells; ++i) {
      middle.push_back(at(i == 1 ? 0.25 : i - 1));
      centre.push_back(at(i - 0.5));
      sum += centre.back();
    }
    const double scale = cells / (2 * sum); // makes the discrete integral that of the load
    for (double& g : centre) g *= scale;
    for (double& g : middle) g *= scale;
  }
};

} // namespace

struct LoadedRowSolver::Workspace {
  int cells, most_rows;
  double travel;
  MarchingKernels kernels = marching_kernels(MarchingScheme::fastsim2, best_instruction_set());
  RowProfile profile;
  RowArrays arrays;
  std::vector<double> share, share_before;
  std::vector<Flexibilities> row_flexibility;

  Workspace(int n, int rows, RollingDirection direction)
      : cells(n), most_rows(rows), travel(travel_of(direction)), profile(n), arrays(rows, n),
        share(static_cast<std::size_t>(rows)), share_before(static_cast<std::size_t>(rows)),
        row_flexibility(static_cast<std::size_t>(rows)) {}

  RowGeometry geometry(const LoadedRow& row) const {
    return {0, row.centre - travel * row.half_length, 2 * row.half_length / cells};
  }

  /// The springs' motion in the rows of a patch: what a row moves with the contact's centre, and beyond that.
  struct Springs {
    Creepage centre;
    Flexibilities l;

    EffectiveSlip of(const Creepage& w) const {
      return {centre.longitudinal / l.longitudinal + (w.longitudinal - centre.longitudinal) / l.spin,
              centre.lateral / l.lateral + (w.lateral - centre.lateral) / l.spin, w.spin / l.spin};
    }
  };
  static Springs springs(double shear_modulus, double poisson_ratio, const LoadMoments& moments) {
    const EllipticContact ellipse{.a = moments.semi_axes.x,
                                  .b = moments.semi_axes.y,
                                  .shear_modulus = shear_modulus,
                                  .poisson_ratio = poisson_ratio,
                                  .normal_force = moments.load,
                                  .friction = FrictionLaw::coulomb(moments.capacity / moments.load),
                                  .creepage = moments.creepage};
    return {moments.creepage, flexibilities(FlexibilityModel::blended, {}, ellipse)};
  }

  /// Rigid slip, bound and flexibilities of all rows. False if nothing is loaded.
  bool prepare(double shear_modulus, double poisson_ratio, std::span<const LoadedRow> rows) {
    const std::span<double> shares(share.data(), rows.size()), shares_before(share_before.data(), rows.size());
    std::optional<Springs> patch;
    for (std::size_t j = 0; j < rows.size(); ++j) {
      const LoadedRow& row = rows[j];
      EffectiveSlip motion{};
      if (row.load * row.friction > 0) {
        find_shares(rows, j, shares);
        // Rows of one hump have the same shares.
        if (!patch || !std::equal(shares.begin(), shares.end(), shares_before.begin()))
          patch = springs(shear_modulus, poisson_ratio, LoadMoments(rows, shares));
        std::copy(shares.begin(), shares.end(), shares_before.begin());
        motion = patch->of(row.creepage), row_flexibility[j] = patch->l;
      }
      put_row(arrays, static_cast<int>(j), 0, motion, geometry(row), travel);
      arrays.bound_scale[j] = row.friction * row.load / (row.width * row.half_length);
    }
    return patch.has_value();
  }

  /// Forces of the rows from what the kernel left.
  void collect(std::span<const LoadedRow> rows, std::span<RowForces> forces) const {
    for (std::size_t j = 0; j < rows.size(); ++j) {
      const RowGeometry at = geometry(rows[j]);
      RowSums sums;
      sums.add_row(arrays, static_cast<int>(j), 0, at, travel);
      const double width = rows[j].width;
      forces[j] = {sums.fx * width, sums.fy * width, sums.mz * width, arrays.slip_cells[j] * at.cell * width};
    }
  }

  void solve(double shear_modulus, double poisson_ratio, std::span<const LoadedRow> rows, std::span<RowForces> forces) {
    std::fill(forces.begin(), forces.end(), RowForces{});
    if (!prepare(shear_modulus, poisson_ratio, rows)) return;
    MarchingRows all = arrays.view(0, static_cast<int>(rows.size()), cells);
    all.profile_centre = profile.centre.data();
    all.profile_middle = profile.middle.data();
    all.profile_slope = std::numeric_limits<double>::infinity();
    kernels.forces(all);
    collect(rows, forces);
  }

  /// The bounds of one vector of rows from `first` on, as tables.
  void put_bounds(std::size_t first, std::size_t count) {
    const int width = kernels.width;
    for (int lane = 0; lane < width; ++lane) {
      const double scale = arrays.bound_scale[std::min(first + static_cast<std::size_t>(lane), count - 1)];
      arrays.table_slope[lane] = scale > 0 ? std::numeric_limits<double>::infinity() : 0;
      for (int i = 0; i <= cells; ++i) arrays.table_centre[i * width + lane] = scale * profile.centre[i];
      for (int i = 0; i < cells; ++i) arrays.table_middle[i * width + lane] = scale * profile.middle[i];
    }
  }

  ContactSolution solve_with_fields(double shear_modulus, double poisson_ratio, std::span<const LoadedRow> rows,
                                    double speed) {
    ContactSolution out;
    out.elements = elements_of(rows);
    out.fields = SurfaceFields(out.elements.size());
    out.fields.pressure.resize(out.elements.size());
    std::vector<RowForces> forces(rows.size());
    if (!prepare(shear_modulus, poisson_ratio, rows)) return out;
    FieldRecorder recorder(cells, kernels.width);
    for (std::size_t first = 0; first < rows.size(); first += kernels.width) {
      put_bounds(first, rows.size());
      MarchingRows view = arrays.view(static_cast<int>(first), kernels.width, cells);
      recorder.attach(view);
      kernels.fields_with_table(view);
      for (std::size_t j = first; j < std::min(first + kernels.width, rows.size()); ++j) {
        const int row = static_cast<int>(j), lane = static_cast<int>(j - first);
        RowGeometry place = geometry(rows[j]);
        place.y = rows[j].y;
        recorder.copy_row(out, row, lane, place, travel, row_flexibility[j]);
        recorder.copy_bound(out, row, lane, travel, arrays.table_centre);
      }
    }
    collect(rows, forces);
    add_totals(rows, forces, speed, out);
    return out;
  }

  Elements elements_of(std::span<const LoadedRow> rows) const {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const LoadedRow& row : rows)
      low = std::min(low, row.centre - row.half_length), high = std::max(high, row.centre + row.half_length);
    const double dx = (high - low) / cells;
    Elements elements(
        ElementGrid{cells, static_cast<int>(rows.size()), low + dx / 2, rows.front().y, dx, rows.front().width});
    for (int j = 0; j < elements.my(); ++j)
      for (int i = 0; i < cells; ++i) {
        const LoadedRow& row = rows[j];
        const std::size_t k = elements.index(i, j);
        elements.width[k] = 2 * row.half_length / cells;
        elements.area[k] = elements.width[k] * row.width;
        elements.x[k] = row.centre - row.half_length + (i + 0.5) * elements.width[k];
      }
    return elements;
  }

  /// Pressures, the slip's scale, states, and the totals.
  void add_totals(std::span<const LoadedRow> rows, std::span<const RowForces> forces, double speed,
                  ContactSolution& out) const {
    SurfaceFields& f = out.fields;
    ContactForces sum;
    double area = 0, work = 0, work_by_creepage = 0; // for V = 1
    for (std::size_t j = 0; j < rows.size(); ++j) {
      const LoadedRow& row = rows[j];
      const std::size_t first = j * cells;
      if (!(row.load > 0)) {
        std::fill_n(&f.state[first], cells, CellState::exterior);
        continue;
      }
      for (int i = 0; i < cells; ++i) {
        const std::size_t k = first + i;
        const double part = half_disk(2 * (i + 1.0) / cells - 1) - half_disk(2.0 * i / cells - 1);
        f.pressure[k] = row.load * part / out.elements.area[k];
        work -= (f.traction.x[k] * f.slip.x[k] + f.traction.y[k] * f.slip.y[k]) * out.elements.area[k];
      }
      const Creepage& w = row.creepage;
      work_by_creepage -= w.longitudinal * forces[j].fx + w.lateral * forces[j].fy + w.spin * forces[j].mz;
      sum.fx += forces[j].fx, sum.fy += forces[j].fy, sum.mz += forces[j].mz - row.y * forces[j].fx;
      sum.slip_area += forces[j].slip_area, area += 2 * row.half_length * row.width;
    }
    const double scale = work > 0 ? std::max(work_by_creepage / work, 0.0) : 0;
    for (auto* slip : {&f.slip.x, &f.slip.y})
      for (double& s : *slip) s *= scale;
    sum.adhesion_area = area - sum.slip_area;
    set_totals(out, sum, speed);
    out.totals.power_by_creepage = speed * work_by_creepage;
  }

  /// The share of a semi-ellipse's integral that lies below t, from -1 to 1.
  static double half_disk(double t) {
    t = std::clamp(t, -1.0, 1.0);
    return 0.5 + (t * std::sqrt(1 - t * t) + std::asin(t)) / std::numbers::pi;
  }
};

LoadedRowSolver::LoadedRowSolver(int cells, int most_rows, RollingDirection direction) {
  require_count("cells", cells, 1, most_cells);
  require_count("most_rows", most_rows, 1, most_cells);
  workspace_ = std::make_unique<Workspace>(cells, most_rows, direction);
}
LoadedRowSolver::LoadedRowSolver(LoadedRowSolver&&) noexcept = default;
LoadedRowSolver& LoadedRowSolver::operator=(LoadedRowSolver&&) noexcept = default;
LoadedRowSolver::~LoadedRowSolver() = default;

void LoadedRowSolver::solve(double shear_modulus, double poisson_ratio, std::span<const LoadedRow> rows,
                            std::span<RowForces> forces) noexcept {
  workspace_->solve(shear_modulus, poisson_ratio, rows.first(std::min<std::size_t>(rows.size(), workspace_->most_rows)),
                    forces);
}

ContactSolution LoadedRowSolver::solve_with_fields(double shear_modulus, double poisson_ratio,
                                                   std::span<const LoadedRow> rows, double rolling_speed) {
  if (rows.empty() || rows.size() > static_cast<std::size_t>(workspace_->most_rows))
    throw Error("rows", static_cast<double>(rows.size()), "-", "at least 1 and at most those of the solver");
  return workspace_->solve_with_fields(shear_modulus, poisson_ratio, rows, rolling_speed);
}

} // namespace microslip
