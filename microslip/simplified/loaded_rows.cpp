#include "microslip/simplified/loaded_rows.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"
#include "microslip/simplified/flexibility.hpp"
#include "microslip/simplified/kernel/row_motion.hpp"
#include "microslip/simplified/row_solver.hpp"

#include <algorithm>
#include <cmath>
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

/// Where a patch's load is, as moments of it, and how the contact moves there.
struct LoadMoments {
  double load = 0, capacity = 0;
  Vec2 centre, semi_axes;
  Creepage creepage; ///< at the centre

  /// Of rows of whose loads the patch has these shares.
  LoadMoments(std::span<const LoadedRow> rows, std::span<const double> share) {
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const LoadedRow& row = rows[k];
      const double part = share[k] * row.load;
      load += part, capacity += part * row.friction;
      centre.x += part * row.centre, centre.y += part * row.y;
      const Creepage& w = row.creepage;
      creepage.longitudinal += part * w.longitudinal;
      creepage.lateral += part * (w.lateral + w.spin * row.centre);
      creepage.spin += part * w.spin;
    }
    if (!(load > 0)) return;
    for (double* mean : {&centre.x, &centre.y, &creepage.longitudinal, &creepage.lateral, &creepage.spin})
      *mean /= load;
    double xx = 0, yy = 0;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const LoadedRow& row = rows[k];
      const double x = row.centre - centre.x, y = row.y - centre.y, l = row.half_length;
      xx += share[k] * row.load * (x * x + l * l / 4);
      yy += share[k] * row.load * (y * y + row.width * row.width / 12);
    }
    semi_axes = {std::sqrt(5 * xx / load), std::sqrt(5 * yy / load)};
  }
};

/// The shares of all rows' loads in the patch that a loaded row belongs to.
void find_shares(std::span<const LoadedRow> rows, std::size_t row, std::span<double> share) {
  constexpr double united = 2;
  const auto density = [&](std::size_t k) { return rows[k].load / rows[k].width; };
  const double own = density(row);
  const auto share_of = [&](std::size_t k, double least) {
    const double lesser = std::min(own, density(k));
    return lesser > 0 ? std::min(1.0, united * least / lesser) : 0.0;
  };
  std::fill(share.begin(), share.end(), 0.0);
  share[row] = 1;
  double least = own;
  for (std::size_t k = row + 1; k < rows.size() && rows[k].joined && least > 0; ++k) {
    least = std::min(least, density(k));
    share[k] = share_of(k, least);
  }
  least = own;
  for (std::size_t k = row; k-- > 0 && rows[k + 1].joined && least > 0;) {
    least = std::min(least, density(k));
    share[k] = share_of(k, least);
  }
}

} // namespace

struct LoadedRowSolver::Workspace {
  int cells, most_rows;
  double travel;
  MarchingKernels kernels = marching_kernels(MarchingScheme::fastsim2, best_instruction_set());
  RowProfile profile;
  RowArrays arrays;
  std::vector<double> share, share_before;

  Workspace(int n, int rows, RollingDirection direction)
      : cells(n), most_rows(rows), travel(travel_of(direction)), profile(n), arrays(rows, n),
        share(static_cast<std::size_t>(rows)), share_before(static_cast<std::size_t>(rows)) {}

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

  void solve(double shear_modulus, double poisson_ratio, std::span<const LoadedRow> rows, std::span<RowForces> forces) {
    std::fill(forces.begin(), forces.end(), RowForces{});
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
        motion = patch->of(row.creepage);
      }
      put_row(arrays, static_cast<int>(j), 0, motion, geometry(row), travel);
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
