#include "microslip/table/creep_force_table.hpp"

#include "microslip/contact/conclude.hpp"
#include "microslip/error.hpp"
#include "microslip/numerics/kernel/dispatch.hpp"
#include "microslip/numerics/vector_log.hpp"
#include "microslip/table/creep_spline.hpp"
#include "microslip/table/kernel/creep_look_up.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>
#include <type_traits>
#include <utility>
#include <vector>

namespace microslip {
namespace detail {

MICROSLIP_DECLARE_KERNEL(CreepKernels creep_kernels())

namespace {

/// Linear theory of one Poisson's ratio by a/b: a spline, finer than that of the forces.
class LinearSpline {
public:
  LinearSpline(const CreepTableAxes& axes, double poisson_ratio) : last_(finer * (axes.ratios - 1)) {
    const int n = last_ + 1;
    const SplineFilter filter = SplineFilter::not_a_knot(n);
    coefficients_.resize(filter.coefficients() * numbers);
    for (int i = 0; i < n; ++i) {
      const double a_over_b =
          axes.least_ratio * std::pow(axes.largest_ratio / axes.least_ratio, static_cast<double>(i) / last_);
      const auto c = creepage_coefficients(a_over_b, poisson_ratio, CreepageTable::computed);
      const double row[] = {c.c11, c.c22, c.c23, c.c33};
      std::copy_n(row, numbers, &coefficients_[(std::size_t(i) + filter.first_value()) * numbers]);
    }
    filter.apply(coefficients_.data(), numbers, {numbers});
  }

  /// Coefficients at a position among the table's nodes of a/b.
  CreepageCoefficients at(double position) const {
    const int nearest = std::min(static_cast<int>(std::lround(position * finer)), last_);
    const auto weights = quadratic_weights(position * finer - nearest).value;
    const double* from = &coefficients_[std::size_t(nearest) * numbers];
    double c[numbers] = {};
    for (std::size_t n = 0; n < weights.size(); ++n)
      for (std::size_t k = 0; k < numbers; ++k) c[k] += weights[n] * from[n * numbers + k];
    return {c[0], c[1], c[2], c[3]};
  }

private:
  static constexpr int finer = 16;
  static constexpr std::size_t numbers = 4;
  int last_;
  std::vector<double> coefficients_;
};

/// Lagrange's weight of number `k` of some Poisson's ratios at another one.
double lagrange_weight(std::span<const double> poisson_ratios, std::size_t k, double nu) {
  double weight = 1;
  for (std::size_t m = 0; m < poisson_ratios.size(); ++m)
    if (m != k) weight *= (nu - poisson_ratios[m]) / (poisson_ratios[k] - poisson_ratios[m]);
  return weight;
}

/// Data of a table for one Poisson's ratio.
struct Material {
  double poisson_ratio;
  CreepSpline coefficients;
  LinearSpline linear;
};
using Materials = std::vector<std::shared_ptr<const Material>>;

/// Makes the data of some Poisson's ratios.
Materials make_materials(const CreepTableNodes& nodes, std::span<const double> poisson_ratios) {
  const auto& known = nodes.axes.poisson_ratios;
  std::vector<std::vector<double>> weights;
  for (const double nu : poisson_ratios) {
    auto& of_one = weights.emplace_back(known.size());
    for (std::size_t m = 0; m < known.size(); ++m) of_one[m] = lagrange_weight(known, m, nu);
  }
  auto splines = creep_splines(nodes, weights);
  Materials made;
  for (std::size_t i = 0; i < splines.size(); ++i)
    made.push_back(std::make_shared<const Material>(
        Material{poisson_ratios[i], std::move(splines[i]), LinearSpline(nodes.axes, poisson_ratios[i])}));
  return made;
}

/// Data of a contact that are not in its block.
struct Contact {
  Status status;
  double area, mu, mu_slope, slip; ///< mu_slope: d mu/d slip, of creepage
  double force[3], creepage[3];    ///< units of the forces, and what (X, Y, Z) take of the creepages
};

/// Contacts that are looked up together, and what a loop along them turns into a block.
template <int size> struct Batch {
  using Numbers = double[size];
  CreepBlock<size> block;
  Contact contacts[size];
  Numbers ratio, arm;               ///< a/b and c of the ellipse whose forces are read
  Numbers c, g, c11, c22, c23, c33; ///< of the contact itself; g = G c^2/(mu Fn)
  Numbers eta_over_xi;              ///< C22/C11 of the ellipse whose forces are read
};

} // namespace
} // namespace detail

using namespace detail;

struct CreepTableSource::Data {
  const CreepTableNodes nodes;
  std::mutex mutex;
  Materials own;                                        ///< of the nodes' Poisson's ratios, as far as they are made
  std::vector<std::weak_ptr<const Material>> of_others; ///< that are in use

  explicit Data(CreepTableNodes of_table) : nodes(std::move(of_table)) {}

  Materials materials(std::span<const double> poisson_ratios) {
    const std::scoped_lock lock(mutex);
    Materials all; // held from here on: other threads may let go of theirs at any time
    std::vector<double> missing;
    for (const double nu : poisson_ratios)
      if (!all.emplace_back(find(nu))) missing.push_back(nu);
    const Materials made = make_materials(nodes, missing);
    const auto& known = nodes.axes.poisson_ratios;
    for (const auto& one : made)
      if (std::find(known.begin(), known.end(), one->poisson_ratio) != known.end())
        own.push_back(one);
      else
        of_others.push_back(one);
    auto next = made.begin();
    for (auto& one : all)
      if (!one) one = *next++;
    return all;
  }

private:
  std::shared_ptr<const Material> find(double poisson_ratio) {
    for (const auto& made : own)
      if (made->poisson_ratio == poisson_ratio) return made;
    std::erase_if(of_others, [](const auto& other) { return other.expired(); });
    for (const auto& other : of_others)
      if (auto made = other.lock(); made && made->poisson_ratio == poisson_ratio) return made;
    return nullptr;
  }
};

CreepTableSource::CreepTableSource(CreepTableNodes nodes) : data_(std::make_shared<Data>(std::move(nodes))) {}

struct CreepForceTable::Data {
  CreepTableAxes axes;
  double side; ///< 1, rolling backward -1: then all is seen in a mirror
  Materials materials;
  CreepGrid grid;
  CreepKernels kernels;
  double log_least, per_log_step;

  Data(const CreepTableAxes& all_axes, RollingDirection direction, InstructionSet instruction_set)
      : axes(all_axes), side(direction == RollingDirection::forward ? 1 : -1),
        kernels(MICROSLIP_CALL_KERNEL(instruction_set, creep_kernels())), log_least(std::log(axes.least_ratio)),
        per_log_step((axes.ratios - 1) / std::log(axes.largest_ratio / axes.least_ratio)) {
    if (!is_available(instruction_set)) throw Error("instruction_set is not available on this processor");
    const CreepSplineSize size(axes);
    grid = {.ratios = axes.ratios,
            .levels = axes.levels,
            .elevations = axes.elevations,
            .azimuths = axes.azimuths,
            .ratio_stride = 0,
            .level_stride = 0,
            .elevation_stride = std::ptrdiff_t{size.azimuths} * creep_channels,
            .azimuth_step = axes.azimuth_step(),
            .azimuth_scale = TrigonometricSpline(axes.azimuth_step()).scale};
    grid.level_stride = grid.elevation_stride * size.elevations;
    grid.ratio_stride = grid.level_stride * size.levels;
  }

  template <class Result> void solve(std::span<const EllipticContact> contacts, std::span<Result> results) const {
    Batch<creep_batch> batch;
    for (std::size_t i = 0; i < contacts.size(); i += creep_batch) {
      const std::size_t count = std::min(contacts.size() - i, std::size_t{creep_batch});
      solve(contacts.subspan(i, count), results.subspan(i, count), batch, kernels.batch);
    }
  }
  template <class Result> Result solve(const EllipticContact& contact) const {
    Batch<1> batch;
    Result result;
    solve({&contact, 1}, std::span<Result>(&result, 1), batch, kernels.single);
    return result;
  }

private:
  template <class Result, int size>
  void solve(std::span<const EllipticContact> contacts, std::span<Result> results, Batch<size>& batch,
             const CreepLookUp<size>& look_up) const;
  template <int size> void read(const EllipticContact& contact, Batch<size>& batch, int i) const;
  template <int size> void find_linear_theory(const EllipticContact& contact, Batch<size>& batch, int i) const;
  template <int size> void scale(Batch<size>& batch) const;
  template <int size> void write(const Batch<size>& batch, int i, ContactForces& forces) const;
  template <int size>
  void write(const EllipticContact& contact, const Batch<size>& batch, int i, ContactDerivatives& result) const;
};

template <class Result, int size>
void CreepForceTable::Data::solve(std::span<const EllipticContact> contacts, std::span<Result> results,
                                  Batch<size>& batch, const CreepLookUp<size>& look_up) const {
  constexpr bool gradient = std::is_same_v<Result, ContactDerivatives>;
  CreepBlock<size>& block = batch.block;
  block.count = static_cast<int>(contacts.size());
  block.materials = static_cast<int>(materials.size());
  for (std::size_t m = 0; m < materials.size(); ++m) block.coefficients[m] = materials[m]->coefficients.data();
  // What is missing at the end of a batch is the last contact once more.
  for (int i = 0; i < size; ++i) read(contacts[std::size_t(std::min(i, block.count - 1))], batch, i);
  for (int i = 0; i < size; ++i) block.ratio[i] = (vector_log(batch.ratio[i]) - log_least) * per_log_step;
  for (int i = 0; i < size; ++i) find_linear_theory(contacts[std::size_t(std::min(i, block.count - 1))], batch, i);
  scale(batch);
  (gradient ? look_up.derivatives : look_up.forces)(grid, block);
  for (int i = 0; i < block.count; ++i) {
    Result& result = results[std::size_t(i)];
    if constexpr (gradient)
      write(contacts[std::size_t(i)], batch, i, result);
    else
      write(batch, i, result);
    conclude(result);
  }
}

/// A contact's size, load and creepages. One that has no forces, or cannot have any, is looked up without creepage.
template <int size> void CreepForceTable::Data::read(const EllipticContact& contact, Batch<size>& batch, int i) const {
  Contact& own = batch.contacts[i];
  const Creepage& creepage = contact.creepage;
  own.status = is_valid_simplified(contact) ? Status::ok : Status::invalid_input;
  own.area = std::numbers::pi * contact.a * contact.b;
  own.slip = own.mu_slope = 0;
  own.mu = contact.friction.kinetic_coefficient();
  if (contact.friction.kind() != FrictionLaw::Kind::coulomb) {
    own.slip = std::sqrt(creepage.longitudinal * creepage.longitudinal + creepage.lateral * creepage.lateral);
    const auto mu = contact.friction.coefficient(Dual<double, 1>::variable(own.slip * contact.rolling_speed, 0));
    own.mu = mu.value;
    own.mu_slope = mu.partial[0] * contact.rolling_speed;
  }
  const double capacity = own.mu * contact.normal_force;
  CreepBlock<size>& block = batch.block;
  if (own.status != Status::ok || !(capacity > 0)) {
    batch.ratio[i] = batch.arm[i] = batch.c[i] = batch.g[i] = 1;
    block.x[i] = block.y[i] = block.z[i] = 0;
    own.force[0] = own.force[1] = own.force[2] = 0;
    return;
  }
  // Beyond the range forces are those of an ellipse with the longer semi-axis.
  const double ratio = contact.a / contact.b;
  batch.c[i] = std::sqrt(contact.a * contact.b);
  batch.ratio[i] = std::clamp(ratio, axes.least_ratio, axes.largest_ratio);
  batch.arm[i] = ratio > axes.largest_ratio ? contact.a / std::sqrt(axes.largest_ratio)
                 : ratio < axes.least_ratio ? contact.b * std::sqrt(axes.least_ratio)
                                            : batch.c[i];
  if (batch.ratio[i] != ratio) own.status = Status::out_of_range;
  batch.g[i] = contact.shear_modulus * contact.a * contact.b / capacity;
  block.x[i] = side * creepage.longitudinal, block.y[i] = creepage.lateral, block.z[i] = side * creepage.spin;
  own.force[0] = own.force[1] = capacity;
  own.force[2] = capacity * batch.arm[i];
}

/// Coefficients of linear theory, and the shares of the materials.
template <int size>
void CreepForceTable::Data::find_linear_theory(const EllipticContact& contact, Batch<size>& batch, int i) const {
  CreepBlock<size>& block = batch.block;
  Contact& own = batch.contacts[i];
  const double nu = contact.poisson_ratio;
  const Material* known = nullptr;
  for (std::size_t m = 0; m < materials.size(); ++m) {
    block.weight[m][i] = materials[m]->poisson_ratio == nu;
    if (materials[m]->poisson_ratio == nu) known = materials[m].get();
  }
  CreepageCoefficients c;
  if (known != nullptr && own.status == Status::ok) {
    c = known->linear.at(block.ratio[i]);
    batch.eta_over_xi[i] = c.c22 / c.c11;
  } else if (own.status == Status::invalid_input) {
    c = materials.front()->linear.at(block.ratio[i]);
    batch.eta_over_xi[i] = 1;
  } else {
    const double read_nu = std::clamp(nu, materials.front()->poisson_ratio, materials.back()->poisson_ratio);
    if (read_nu != nu) own.status = Status::out_of_range;
    for (std::size_t m = 0; m < materials.size(); ++m)
      block.weight[m][i] = lagrange_weight(axes.poisson_ratios, m, read_nu);
    c = creepage_coefficients(contact.a / contact.b, nu, CreepageTable::computed);
    const auto there =
        own.status == Status::ok ? c : creepage_coefficients(batch.ratio[i], read_nu, CreepageTable::computed);
    batch.eta_over_xi[i] = there.c22 / there.c11;
  }
  batch.c11[i] = c.c11, batch.c22[i] = c.c22, batch.c23[i] = c.c23, batch.c33[i] = c.c33;
}

/// Scales creepages to X, Y, Z.
template <int size> void CreepForceTable::Data::scale(Batch<size>& batch) const {
  CreepBlock<size>& block = batch.block;
  double by[3][size];
  for (int i = 0; i < size; ++i) {
    const double g = batch.g[i], c = batch.c[i], arm = batch.arm[i];
    const double xi = g * batch.c11[i], eta = xi * batch.eta_over_xi[i],
                 phi = xi * creep_coordinates::spin_scale(batch.ratio[i]) * arm;
    block.stretch[i] = creep_coordinates::stretch(batch.ratio[i]);
    block.y_y[i] = g * batch.c22[i] / eta;
    block.y_z[i] = g * batch.c23[i] * c / phi;
    block.m_y[i] = -g * batch.c23[i] * c / (eta * arm);
    block.m_z[i] = g * batch.c33[i] * c * c / (phi * arm);
    block.x[i] *= xi, block.y[i] *= eta, block.z[i] *= phi;
    by[0][i] = xi, by[1][i] = eta, by[2][i] = phi;
  }
  for (int i = 0; i < size; ++i) {
    for (int n = 0; n < 3; ++n) batch.contacts[i].creepage[n] = by[n][i];
    const double square = block.x[i] * block.x[i] + block.y[i] * block.y[i] + block.z[i] * block.z[i];
    if (!std::isfinite(square)) {
      batch.contacts[i].status = Status::invalid_input;
      block.x[i] = block.y[i] = block.z[i] = 0;
    }
  }
}

template <int size> void CreepForceTable::Data::write(const Batch<size>& batch, int i, ContactForces& forces) const {
  const Contact& own = batch.contacts[i];
  const CreepBlock<size>& block = batch.block;
  const double adhesion = own.force[0] > 0 ? own.area * block.adhesion[i] : 0;
  forces = {.fx = own.force[0] * block.force[0][i] * side,
            .fy = own.force[1] * block.force[1][i],
            .mz = own.force[2] * block.force[2][i] * side,
            .adhesion_area = adhesion,
            .slip_area = own.area - adhesion,
            .status = own.status};
}

template <int size>
void CreepForceTable::Data::write(const EllipticContact& contact, const Batch<size>& batch, int i,
                                  ContactDerivatives& result) const {
  const Contact& own = batch.contacts[i];
  const CreepBlock<size>& block = batch.block;
  write(batch, i, result.forces);
  const double position[] = {block.x[i], block.y[i], block.z[i]}, own_side[] = {side, 1, side};
  for (int n = 0; n < 3; ++n) {
    double by_capacity = block.force[n][i]; // of F at given creepages, over what F is a multiple of
    for (int k = 0; k < 3; ++k) {
      by_capacity -= position[k] * block.derivative[n][k][i];
      result.jacobian[n][k] = own.force[n] * block.derivative[n][k][i] * own.creepage[k] * own_side[n] * own_side[k];
    }
    by_capacity *= own.force[n] * own_side[n];
    result.jacobian[n][3] = by_capacity / contact.normal_force;
    if (own.mu_slope != 0 && own.slip > 0) {
      const double by_slip = by_capacity / own.mu * own.mu_slope / own.slip;
      result.jacobian[n][0] += by_slip * contact.creepage.longitudinal;
      result.jacobian[n][1] += by_slip * contact.creepage.lateral;
    }
  }
}

CreepForceTable::CreepForceTable(const CreepTableSource& source, RollingDirection direction,
                                 InstructionSet instruction_set) {
  const CreepTableAxes& axes = source.data_->nodes.axes;
  auto data = std::make_shared<Data>(axes, direction, instruction_set);
  data->materials = source.data_->materials(axes.poisson_ratios);
  data_ = std::move(data);
}

CreepForceTable::CreepForceTable(const CreepTableSource& source, double poisson_ratio, RollingDirection direction,
                                 InstructionSet instruction_set) {
  CreepTableAxes axes = source.data_->nodes.axes;
  require_between("poisson_ratio", poisson_ratio, "-", axes.poisson_ratios.front(), axes.poisson_ratios.back());
  axes.poisson_ratios = {poisson_ratio};
  auto data = std::make_shared<Data>(axes, direction, instruction_set);
  data->materials = source.data_->materials(axes.poisson_ratios);
  data_ = std::move(data);
}

const CreepTableAxes& CreepForceTable::axes() const {
  return data_->axes;
}

RollingDirection CreepForceTable::direction() const {
  return data_->side > 0 ? RollingDirection::forward : RollingDirection::backward;
}

ContactForces CreepForceTable::solve(const EllipticContact& contact) const noexcept {
  return data_->solve<ContactForces>(contact);
}

void CreepForceTable::solve(std::span<const EllipticContact> contacts, std::span<ContactForces> forces) const noexcept {
  data_->solve(contacts, forces);
}

ContactDerivatives CreepForceTable::differentiate(const EllipticContact& contact) const noexcept {
  return data_->solve<ContactDerivatives>(contact);
}

void CreepForceTable::differentiate(std::span<const EllipticContact> contacts,
                                    std::span<ContactDerivatives> derivatives) const noexcept {
  data_->solve(contacts, derivatives);
}

} // namespace microslip
