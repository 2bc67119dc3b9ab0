#include "microslip/simplified/row_solver.hpp"

#include "microslip/contact/conclude.hpp"
#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"
#include "microslip/numerics/dual.hpp"
#include "microslip/simplified/ellipse_grid.hpp"
#include "microslip/simplified/kernel/field_recorder.hpp"
#include "microslip/simplified/kernel/patch_march.hpp"
#include "microslip/simplified/kernel/row_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace microslip {

using namespace detail;

namespace {

/// Derivatives to the creepages; and to the load as well, which is needed only where friction depends on the slip
/// velocity.
using Gradient = Dual<double, creepage_partials>;
using FullGradient = Dual<double, row_partials>;

/// Rows of one call of a kernel: enough to keep its vectors full, few enough to stay in the first-level cache.
constexpr int rows_per_block = 320;

template <class Real> Drive<Real> drive_of(const Creepage& c, double normal_force) {
  if constexpr (std::is_same_v<Real, double>)
    return {c.longitudinal, c.lateral, c.spin, normal_force};
  else {
    const Real load = numbers_of<Real> > 4 ? Real::variable(normal_force, numbers_of<Real> - 2) : Real(normal_force);
    return {Real::variable(c.longitudinal, 0), Real::variable(c.lateral, 1), Real::variable(c.spin, 2), load};
  }
}

bool is_coulomb(const FrictionLaw& law) {
  return law.kind() == FrictionLaw::Kind::coulomb;
}

/// Peak of the bound over mu Fn: (F13) or (F11) at the centre.
double peak_factor(TractionBound shape, double a, double b) {
  return (shape == TractionBound::parabolic ? 2.0 : 1.5) / (std::numbers::pi * a * b);
}

void finish(std::span<const RowSums, 1> totals, double slip_area, double area, const EllipticContact&,
            ContactForces& result) {
  result = forces_of(totals[0], slip_area, area);
}
template <std::size_t N>
void finish(std::span<const RowSums, N> totals, double slip_area, double area, const EllipticContact& contact,
            ContactDerivatives& result) {
  result.forces = forces_of(totals[0], slip_area, area);
  for (std::size_t k = 1; k < N; ++k) {
    result.jacobian[0][k - 1] = totals[k].fx;
    result.jacobian[1][k - 1] = totals[k].fy;
    result.jacobian[2][k - 1] = totals[k].mz;
  }
  if (N == 1 + row_partials) return;
  // With Coulomb friction the forces are homogeneous of degree one in creepages and load: Euler's theorem.
  const Creepage& c = contact.creepage;
  const double forces[] = {totals[0].fx, totals[0].fy, totals[0].mz};
  for (int n = 0; n < 3; ++n) {
    double* row = result.jacobian[n];
    row[3] = (forces[n] - c.longitudinal * row[0] - c.lateral * row[1] - c.spin * row[2]) / contact.normal_force;
  }
}

Status& status_of(ContactForces& result) {
  return result.status;
}
Status& status_of(ContactDerivatives& result) {
  return result.forces.status;
}

} // namespace

struct RowSolver::Workspace {
  MarchingScheme scheme;
  SimplifiedOptions options;
  MarchingKernels kernels;
  EllipseGrid grid;
  double travel;
  int block;            ///< contacts marched together
  double cell_per_half; ///< length of a cell over half the row's
  double weight;        ///< what a cell counts for in the forces, over its area: makes the discrete normal force exact
  RowArrays rows;
  std::vector<char> fits_single; ///< of the contacts of a block

  Workspace(MarchingScheme marching_scheme, const SimplifiedOptions& o)
      : scheme(marching_scheme), options(o), kernels(marching_kernels(marching_scheme, o.instruction_set)),
        grid(o.mx, o.my, o.bound), travel(travel_of(o.direction)), block(std::max(1, rows_per_block / o.my)),
        cell_per_half(2.0 / o.mx), weight(1 / (peak_factor(o.bound, 1, 1) * grid.bound_integral)),
        rows(block * o.my, o.mx), fits_single(static_cast<std::size_t>(block)) {}

  RowGeometry row(const EllipticContact& contact, int j) const {
    const double half = contact.a * grid.half_length[j];
    return {contact.b * grid.y[j], -travel * half, half * cell_per_half};
  }

  /// Rigid slip and peak of the bound for the rows of a contact, from `first_row` of the arrays on, in a unit of
  /// tractions [Pa]. Returns the size of the rigid slip of a cell in that unit, an upper bound of it.
  template <class Real> double prepare(const EllipticContact& contact, int first_row, double unit = 1) {
    const auto drive = drive_of<Real>(contact.creepage, contact.normal_force);
    const auto l = flexibilities(options.flexibility, options.slope_reduction, contact, drive, options.creepage_table);
    const Real along = drive.xi / l.longitudinal, across = drive.eta / l.lateral, turn = drive.phi / l.spin;
    for (int k = 0; k < numbers_of<Real>; ++k) {
      const EffectiveSlip w = {number(along, k) / unit, number(across, k) / unit, number(turn, k) / unit};
      for (int j = 0; j < options.my; ++j) put_row(rows, first_row + j, k, w, row(contact, j), travel);
    }
    const double peak = peak_of(contact) / unit;
    for (int j = 0; j < options.my; ++j) rows.bound_scale[first_row + j] = peak * grid.row_bound[j];
    const double largest =
        std::abs(value_of(along)) + std::abs(value_of(across)) + std::abs(value_of(turn)) * (contact.a + contact.b);
    return largest * contact.a * cell_per_half / unit;
  }

  template <class Real, class Result>
  void collect(const EllipticContact& contact, int first_row, Result& result, double unit = 1) const {
    std::array<RowSums, numbers_of<Real>> totals;
    const double width = 2 * contact.b / options.my, scale = weight * width * unit;
    for (int k = 0; k < numbers_of<Real>; ++k) {
      RowSums sum;
      for (int j = 0; j < options.my; ++j) sum.add_row(rows, first_row + j, k, row(contact, j), travel);
      totals[k] = {sum.fx * scale, sum.fy * scale, sum.mz * scale};
    }
    double sliding = 0;
    for (int j = 0; j < options.my; ++j) sliding += rows.slip_cells[first_row + j] * grid.half_length[j];
    const double area = std::numbers::pi * contact.a * contact.b;
    // The cells' areas do not add up to the ellipse's either.
    const double slip_area = sliding * cell_per_half * contact.a * width * (std::numbers::pi / grid.area);
    finish(std::span<const RowSums, numbers_of<Real>>(totals), slip_area, area, contact, result);
  }

  /// Contacts with Coulomb friction, at most `block` of them.
  template <class Real, class Result>
  void solve_block(MarchingKernel kernel, std::span<const EllipticContact> contacts, std::span<Result> results) {
    const int n = static_cast<int>(contacts.size());
    for (int c = 0; c < n; ++c) prepare<Real>(contacts[c], c * options.my);
    march_profiles(kernel, n);
    for (int c = 0; c < n; ++c) collect<Real>(contacts[c], c * options.my, results[c]);
  }

  /// Solves in single precision, in the unit of the bound's peak. Contacts that slide so fast that their tractions
  /// are lost beside the rigid slip are solved in double precision.
  void solve_in_single(std::span<const EllipticContact> contacts, std::span<ContactForces> results) {
    constexpr double fastest = 50; // rigid slip of a cell: 6e-8 of it are lost
    const int n = static_cast<int>(contacts.size());
    const auto unit_of = [&](const EllipticContact& contact) { return peak_of(contact) > 0 ? peak_of(contact) : 1; };
    for (int c = 0; c < n; ++c)
      fits_single[c] = prepare<double>(contacts[c], c * options.my, unit_of(contacts[c])) <= fastest;
    march_profiles(kernels.forces_in_single, n);
    for (int c = 0; c < n; ++c)
      if (fits_single[c]) collect<double>(contacts[c], c * options.my, results[c], unit_of(contacts[c]));
    for (int c = 0; c < n; ++c)
      if (!fits_single[c]) solve_block<double>(kernels.forces, contacts.subspan(c, 1), results.subspan(c, 1));
  }

  double peak_of(const EllipticContact& contact) const {
    return contact.normal_force * contact.friction.peak_coefficient() *
           peak_factor(options.bound, contact.a, contact.b);
  }

  void march_profiles(MarchingKernel kernel, int contacts) {
    MarchingRows all = rows.view(0, contacts * options.my, options.mx);
    all.profile_centre = grid.profile_centre.data();
    all.profile_middle = grid.profile_middle.data();
    all.profile_slope = grid.profile_slope;
    kernel(all);
  }

  /// Traction bound of one vector of rows, point by point, with friction at each point's slip velocity.
  template <class Real> void fill_tables(const EllipticContact& contact, int first_row) {
    const auto drive = drive_of<Real>(contact.creepage, contact.normal_force);
    const Real load = drive.normal_force * (1 / contact.normal_force); // 1, with its derivative
    const double peak = contact.friction.peak_coefficient();
    const int width = kernels.width, point = numbers_of<Real> * width;
    for (int lane = 0; lane < width; ++lane) {
      const int j = std::min(first_row + lane, options.my - 1); // lanes beyond the last row repeat it
      const RowGeometry at = row(contact, j);
      const auto bound = [&](double profile, double position) -> Real {
        const double largest_bound = rows.bound_scale[j] * profile;
        if (is_coulomb(contact.friction) || !(peak > 0)) return load * largest_bound;
        const double x = at.leading + travel * position * at.cell;
        return load * friction_coefficient(contact.friction, drive, contact.rolling_speed, x, at.y) *
               (largest_bound / peak);
      };
      put(bound(grid.profile_slope, 0), &rows.table_slope[lane], width);
      for (int i = 0; i <= options.mx; ++i)
        put(bound(grid.profile_centre[i], i == 0 ? 0 : i - 0.5), &rows.table_centre[i * point + lane], width);
      for (int i = 0; i < options.mx; ++i)
        put(bound(grid.profile_middle[i], i == 0 ? 0.25 : i), &rows.table_middle[i * point + lane], width);
    }
  }

  template <class Real, class Result>
  void solve_with_table(MarchingKernel kernel, const EllipticContact& contact, Result& result) {
    prepare<Real>(contact, 0);
    for (int first = 0; first < options.my; first += kernels.width) {
      fill_tables<Real>(contact, first);
      kernel(rows.view(first, kernels.width, options.mx));
    }
    collect<Real>(contact, 0, result);
  }

  /// Walks through many contacts: blocks of those with Coulomb friction, one by one the others.
  template <class Result, class Block, class One>
  void walk(std::span<const EllipticContact> contacts, std::span<Result> results, Block solve_many, One solve_one) {
    const auto fits = [](const EllipticContact& c) { return is_valid_simplified(c) && is_coulomb(c.friction); };
    for (std::size_t i = 0; i < contacts.size();) {
      std::size_t n = 0;
      while (n < static_cast<std::size_t>(block) && i + n < contacts.size() && fits(contacts[i + n])) ++n;
      if (n > 0)
        solve_many(contacts.subspan(i, n), results.subspan(i, n));
      else if (is_valid_simplified(contacts[i]))
        solve_one(contacts[i], results[i]);
      else
        status_of(results[i]) = Status::invalid_input;
      i += std::max<std::size_t>(n, 1);
    }
    for (Result& result : results) conclude(result);
  }

  void solve(std::span<const EllipticContact> contacts, std::span<ContactForces> results) {
    walk(
        contacts, results,
        [&](auto c, auto r) {
          if (options.precision == Precision::single)
            solve_in_single(c, r);
          else
            solve_block<double>(kernels.forces, c, r);
        },
        [&](auto& c, auto& r) { solve_with_table<double>(kernels.forces_with_table, c, r); });
  }
  void differentiate(std::span<const EllipticContact> contacts, std::span<ContactDerivatives> results) {
    walk(
        contacts, results, [&](auto c, auto r) { solve_block<Gradient>(kernels.derivatives, c, r); },
        [&](auto& c, auto& r) { solve_with_table<FullGradient>(kernels.derivatives_with_table, c, r); });
  }

  ContactSolution fields(const EllipticContact& contact) {
    ContactSolution out;
    out.elements = Elements(ElementGrid::across_ellipse(contact.a, contact.b, options.mx, options.my, 0));
    out.fields = SurfaceFields(out.elements.size());
    out.creepage = contact.creepage;
    FieldRecorder recorder(options.mx, kernels.width);
    const Flexibilities l =
        flexibilities(options.flexibility, options.slope_reduction, contact, options.creepage_table);
    prepare<double>(contact, 0);
    for (int first = 0; first < options.my; first += kernels.width) {
      fill_tables<double>(contact, first);
      MarchingRows view = rows.view(first, kernels.width, options.mx);
      recorder.attach(view);
      kernels.fields_with_table(view);
      for (int j = first; j < std::min(first + kernels.width, options.my); ++j) {
        const RowGeometry at = row(contact, j);
        recorder.copy_row(out, j, j - first, at, travel, l);
        recorder.copy_bound(out, j, j - first, travel, rows.table_centre);
        std::fill_n(&out.elements.area[out.elements.index(0, j)], options.mx,
                    weight * at.cell * (2 * contact.b / options.my));
      }
    }
    ContactForces forces;
    collect<double>(contact, 0, forces);
    set_totals(out, forces, contact.rolling_speed);
    out.totals.frictional_power = contact.rolling_speed * work_on_rigid_slip(out, l);
    return out;
  }
};

RowSolver::RowSolver(MarchingScheme scheme, const SimplifiedOptions& options) {
  require_count("mx", options.mx, 1, most_cells);
  require_count("my", options.my, 1, most_cells);
  require_between("slope_reduction.initial", options.slope_reduction.initial, "-", 1e-6, 1);
  require_between("slope_reduction.at_infinity", options.slope_reduction.at_infinity, "-", 0, 1);
  require_between("slope_reduction.decay", options.slope_reduction.decay, "-", 0, 1e6);
  if (!is_available(options.instruction_set)) throw Error("instruction_set: this processor does not have it");
  workspace_ = std::make_unique<Workspace>(scheme, options);
}
RowSolver::RowSolver(const RowSolver& other) : workspace_(std::make_unique<Workspace>(*other.workspace_)) {}
RowSolver::RowSolver(RowSolver&&) noexcept = default;
RowSolver& RowSolver::operator=(RowSolver other) noexcept {
  std::swap(workspace_, other.workspace_);
  return *this;
}
RowSolver::~RowSolver() = default;

const SimplifiedOptions& RowSolver::options() const {
  return workspace_->options;
}
MarchingScheme RowSolver::scheme() const {
  return workspace_->scheme;
}

ContactForces RowSolver::solve(const EllipticContact& contact) noexcept {
  ContactForces forces;
  workspace_->solve({&contact, 1}, {&forces, 1});
  return forces;
}
void RowSolver::solve(std::span<const EllipticContact> contacts, std::span<ContactForces> forces) noexcept {
  workspace_->solve(contacts, forces);
}
ContactDerivatives RowSolver::differentiate(const EllipticContact& contact) noexcept {
  ContactDerivatives derivatives;
  workspace_->differentiate({&contact, 1}, {&derivatives, 1});
  return derivatives;
}
void RowSolver::differentiate(std::span<const EllipticContact> contacts,
                              std::span<ContactDerivatives> derivatives) noexcept {
  workspace_->differentiate(contacts, derivatives);
}

ContactSolution RowSolver::fields(const EllipticContact& contact) {
  try {
    check_simplified(contact);
  } catch (const Error& refusal) {
    return solution_without_result(Status::invalid_input, refusal.what());
  }
  ContactSolution out = workspace_->fields(contact);
  conclude(out, 0); // nothing is iterated
  return out;
}
ContactSolution RowSolver::fields(const PatchRows& patch, const PatchMotion& motion) {
  return march_patch(workspace_->kernels, workspace_->travel, patch, motion);
}

} // namespace microslip
