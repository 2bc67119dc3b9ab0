#include "microslip/simplified/loaded_rows.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"
#include "microslip/simplified/flexibility.hpp"
#include "microslip/simplified/kernel/row_motion.hpp"
#include "microslip/simplified/row_solver.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
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

/// Where the load is, as moments of it, and how the contact moves there.
struct LoadMoments {
  double load = 0, capacity = 0;
  Vec2 centre, semi_axes;
  Creepage creepage; ///< at the centre

  explicit LoadMoments(std::span<const LoadedRow> rows) {
    for (const LoadedRow& row : rows) {
      load += row.load, capacity += row.load * row.friction;
      centre.x += row.load * row.centre, centre.y += row.load * row.y;
      const Creepage& w = row.creepage;
      creepage.longitudinal += row.load * w.longitudinal;
      creepage.lateral += row.load * (w.lateral + w.spin * row.centre);
      creepage.spin += row.load * w.spin;
    }
    if (!(load > 0)) return;
    for (double* mean : {&centre.x, &centre.y, &creepage.longitudinal, &creepage.lateral, &creepage.spin})
      *mean /= load;
    double xx = 0, yy = 0;
    for (const LoadedRow& row : rows) {
      const double x = row.centre - centre.x, y = row.y - centre.y, l = row.half_length;
      xx += row.load * (x * x + l * l / 4);
      yy += row.load * (y * y + row.width * row.width / 12);
    }
    semi_axes = {std::sqrt(5 * xx / load), std::sqrt(5 * yy / load)};
  }
};

} // namespace

struct LoadedRowSolver::Workspace {
  int cells, most_rows;
  double travel;
  MarchingKernels kernels = marching_kernels(MarchingScheme::fastsim2, best_instruction_set());
  RowProfile profile;
  RowArrays arrays;

  Workspace(int n, int rows, RollingDirection direction)
      : cells(n), most_rows(rows), travel(travel_of(direction)), profile(n), arrays(rows, n) {}

  RowGeometry geometry(const LoadedRow& row) const {
    return {0, row.centre - travel * row.half_length, 2 * row.half_length / cells};
  }

  void solve(double shear_modulus, double poisson_ratio, std::span<const LoadedRow> rows, std::span<RowForces> forces) {
    std::fill(forces.begin(), forces.end(), RowForces{});
    const LoadMoments moments(rows);
    if (!(moments.capacity > 0)) return;
    const Creepage& c = moments.creepage;
    const EllipticContact ellipse{.a = moments.semi_axes.x,
                                  .b = moments.semi_axes.y,
                                  .shear_modulus = shear_modulus,
                                  .poisson_ratio = poisson_ratio,
                                  .normal_force = moments.load,
                                  .friction = FrictionLaw::coulomb(moments.capacity / moments.load),
                                  .creepage = c};
    const Flexibilities l = flexibilities(FlexibilityModel::blended, {}, ellipse);

    for (std::size_t j = 0; j < rows.size(); ++j) {
      const LoadedRow& row = rows[j];
      const Creepage& w = row.creepage;
      // At (x, 0) of the row: what it moves with the contact's centre, and beyond that.
      const double along = c.longitudinal / l.longitudinal + (w.longitudinal - c.longitudinal) / l.spin;
      const double across = c.lateral / l.lateral + (w.lateral - c.lateral) / l.spin;
      put_row(arrays, static_cast<int>(j), 0, {along, across, w.spin / l.spin}, geometry(row), travel);
      arrays.bound_scale[j] = row.friction * row.load / (row.width * row.half_length);
    }
    MarchingRows all = arrays.view(0, static_cast<int>(rows.size()), cells);
    all.profile_centre = profile.centre.data();
    all.profile_middle = profile.middle.data();
    all.profile_slope = std::numeric_limits<double>::infinity();
    kernels.forces(all);

    for (std::size_t j = 0; j < rows.size(); ++j) {
      const RowGeometry at = geometry(rows[j]);
      RowSums sums;
      sums.add_row(arrays, static_cast<int>(j), 0, at, travel);
      const double width = rows[j].width;
      forces[j] = {sums.fx * width, sums.fy * width, sums.mz * width, arrays.slip_cells[j] * at.cell * width};
    }
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

} // namespace microslip
