#include "microslip/table/creep_force_table.hpp"

#include "microslip/error.hpp"
#include "microslip/numerics/kernel/dispatch.hpp"
#include "microslip/table/creep_spline.hpp"
#include "microslip/table/kernel/creep_sums.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace microslip {
namespace detail {

MICROSLIP_DECLARE_KERNEL(CreepSums creep_sums())

namespace {

using creep_coordinates::half_way;
using creep_coordinates::LinearTheory;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Below 1 by this the length of the force over mu Fn begins to bend, so that it stays below 1.
constexpr double bend = 3e-4;

/// Linear theory of one Poisson's ratio by a/b: a spline, finer than that of the forces.
class LinearSpline {
public:
  LinearSpline() = default;
  LinearSpline(const CreepTableAxes& axes, double poisson_ratio) : intervals_(finer * (axes.ratios - 1)) {
    const int n = intervals_ + 1;
    std::vector<double> values(std::size_t(n) * numbers);
    for (int i = 0; i < n; ++i) {
      const double a_over_b =
          axes.least_ratio * std::pow(axes.largest_ratio / axes.least_ratio, static_cast<double>(i) / intervals_);
      const auto c = creepage_coefficients(a_over_b, poisson_ratio, CreepageTable::computed);
      const double row[] = {c.c11, c.c22, c.c23, c.c33};
      for (std::size_t k = 0; k < numbers; ++k) values[std::size_t(i) * numbers + k] = row[k];
    }
    coefficients_.resize(std::size_t(n + 2) * numbers);
    const SplineFilter filter = SplineFilter::not_a_knot(n);
    for (std::size_t k = 0; k < numbers; ++k) filter.apply(&values[k], numbers, &coefficients_[k], numbers);
  }

  /// At a place between nodes of a/b, counted in intervals of the table.
  CreepageCoefficients at(double place) const {
    const double fine = place * finer;
    const int i = std::min(static_cast<int>(fine), intervals_ - 1);
    const auto weights = cubic_weights(fine - i).value;
    const double* from = &coefficients_[std::size_t(i) * numbers];
    double c[numbers] = {};
    for (std::size_t n = 0; n < 4; ++n)
      for (std::size_t k = 0; k < numbers; ++k) c[k] += weights[n] * from[n * numbers + k];
    return {c[0], c[1], c[2], c[3]};
  }

private:
  static constexpr int finer = 4;
  static constexpr std::size_t numbers = 4;
  int intervals_ = 0;
  std::vector<double> coefficients_;
};

/// A place on one axis of the table: the interval and the fraction of it.
struct Place {
  int interval;
  double fraction;

  Place(double position, int intervals)
      : interval(std::clamp(static_cast<int>(position), 0, intervals - 1)), fraction(position - interval) {}
};

/// The ellipse whose forces are read: that of the contact, or at the end of the table's range.
struct Shape {
  double a_over_b, arm; ///< and sqrt(a b) [m]
  bool in_range;
};

Shape shape_of(const CreepTableAxes& axes, double a, double b) {
  const double ratio = a / b;
  if (ratio > axes.largest_ratio) return {axes.largest_ratio, a / std::sqrt(axes.largest_ratio), false};
  if (ratio < axes.least_ratio) return {axes.least_ratio, b * std::sqrt(axes.least_ratio), false};
  return {ratio, std::sqrt(a * b), true};
}

/// X, Y, Z from xi, eta, phi, and linear theory's q from X, Y, Z.
struct Scale {
  double xi, eta, phi;
  double y_y = 1, y_z = 0, m_y = 0, m_z = 0;
};

struct Material {
  double poisson_ratio;
  std::vector<double> coefficients;
  LinearSpline linear;
};

} // namespace
} // namespace detail

using namespace detail;

struct CreepForceTable::Data {
  CreepTableAxes axes;
  double side; ///< 1, rolling backward -1: then all is seen in a mirror
  std::vector<Material> materials;
  CreepStrides strides;
  TrigonometricWeights azimuth_weights;
  CreepSums sums;
  double log_least, per_log_step;

  Data(const CreepTableNodes& nodes, RollingDirection direction)
      : axes(nodes.axes), side(direction == RollingDirection::forward ? 1 : -1), azimuth_weights(axes.azimuth_step()),
        sums(MICROSLIP_CALL_KERNEL(best_instruction_set(), creep_sums())), log_least(std::log(axes.least_ratio)),
        per_log_step((axes.ratios - 1) / std::log(axes.largest_ratio / axes.least_ratio)) {
    const CreepSplineSize size(axes);
    strides.elevation = std::ptrdiff_t{size.azimuths} * creep_channels;
    strides.level = strides.elevation * size.elevations;
    strides.ratio = strides.level * size.levels;
  }

  /// Lagrange's weight of a material at a Poisson's ratio.
  double weight(std::size_t material, double nu) const {
    double weight = 1;
    for (std::size_t k = 0; k < materials.size(); ++k)
      if (k != material)
        weight *= (nu - materials[k].poisson_ratio) / (materials[material].poisson_ratio - materials[k].poisson_ratio);
    return weight;
  }

  void add(const CreepTableNodes& nodes, std::size_t material) {
    const double nu = nodes.axes.poisson_ratios[material];
    materials.push_back({nu, CreepSpline(nodes, material).coefficients(), LinearSpline(nodes.axes, nu)});
  }
  /// The material between those of the nodes that this Poisson's ratio has.
  void add(const CreepTableNodes& nodes, double nu) {
    Data all(nodes, RollingDirection::forward);
    for (std::size_t m = 0; m < nodes.axes.poisson_ratios.size(); ++m)
      all.materials.push_back({nodes.axes.poisson_ratios[m], {}, {}});
    Material mixed = {nu, {}, LinearSpline(nodes.axes, nu)};
    for (std::size_t m = 0; m < all.materials.size(); ++m) {
      const double share = all.weight(m, nu);
      if (share == 0) continue;
      const CreepSpline spline(nodes, m);
      mixed.coefficients.resize(spline.coefficients().size());
      for (std::size_t k = 0; k < mixed.coefficients.size(); ++k)
        mixed.coefficients[k] += share * spline.coefficients()[k];
    }
    materials.push_back(std::move(mixed));
  }

  template <bool gradient> Status find(const EllipticContact& contact, ContactDerivatives& out) const noexcept;
  template <bool gradient>
  CreepSample read(const Place& ratio, const Place& level, const Place& elevation, const Place& azimuth,
                   double nu) const noexcept;
  Scale scale_of(const EllipticContact& contact, const Shape& shape, double capacity, const CreepageCoefficients& own,
                 double read_nu) const noexcept;
};

namespace {

/// f = F/(mu Fn) and its derivatives with respect to X, Y, Z.
struct Unit {
  double f[3], by[3][3];
  double adhesion;
};

/// Lets the length of (fx, fy) end at 1: from 1 - bend on it follows a curve with the same slope and curvature there.
template <bool gradient> void bound(Unit& u) {
  const double length = std::sqrt(u.f[0] * u.f[0] + u.f[1] * u.f[1]);
  const double excess = (length - (1 - bend)) / bend;
  if (!(excess > 0)) return;
  const double root = std::sqrt(1 + excess * excess);
  const double ratio = (1 - bend + bend * excess / root) / length;
  if constexpr (gradient)
    for (int k = 0; k < 3; ++k) {
      const double by_length = (u.f[0] * u.by[0][k] + u.f[1] * u.by[1][k]) / length;
      const double change = (1 / (root * root * root) - ratio) / length * by_length;
      for (int n = 0; n < 2; ++n) u.by[n][k] = ratio * u.by[n][k] + change * u.f[n];
    }
  u.f[0] *= ratio;
  u.f[1] *= ratio;
}

} // namespace

template <bool gradient>
Status CreepForceTable::Data::find(const EllipticContact& contact, ContactDerivatives& out) const noexcept {
  if (!is_valid_simplified(contact)) return Status::invalid_input;
  const Creepage& creepage = contact.creepage;
  const double slip = std::sqrt(creepage.longitudinal * creepage.longitudinal + creepage.lateral * creepage.lateral);
  const auto friction =
      contact.friction.coefficient(Dual<double, 1>::variable(slip * contact.rolling_speed, 0)); // and its slope
  const double mu = friction.value, capacity = mu * contact.normal_force;
  const double area = std::numbers::pi * contact.a * contact.b;
  out = {};
  out.forces.slip_area = area;
  if (!(capacity > 0)) return Status::ok;

  const Shape shape = shape_of(axes, contact.a, contact.b);
  const double nu = contact.poisson_ratio;
  const double read_nu = std::clamp(nu, materials.front().poisson_ratio, materials.back().poisson_ratio);
  const Place ratio((std::log(shape.a_over_b) - log_least) * per_log_step, axes.ratios - 1);
  const auto known =
      std::find_if(materials.begin(), materials.end(), [nu](const Material& m) { return m.poisson_ratio == nu; });
  const bool in_range = shape.in_range && read_nu == nu;
  const CreepageCoefficients own = in_range && known != materials.end()
                                       ? known->linear.at(ratio.interval + ratio.fraction)
                                       : creepage_coefficients(contact.a / contact.b, nu, CreepageTable::computed);
  const Scale scale = scale_of(contact, shape, capacity, own, read_nu);

  // X, Y, Z on the quarter of the sphere.
  double x = scale.xi * side * creepage.longitudinal, y = scale.eta * creepage.lateral,
         z = scale.phi * side * creepage.spin;
  const double turned = z < 0 ? -1 : 1;
  x *= turned, y *= turned, z *= turned;
  const double mirrored = x < 0 ? -1 : 1;
  x *= mirrored;
  const double across = std::sqrt(x * x + y * y), r = std::sqrt(across * across + z * z);
  if (!std::isfinite(r)) return Status::invalid_input;
  // At the pole alpha has no value: a point beside it has the same forces and derivatives.
  const double cos_alpha = across > 0 ? x / across : 1, sin_alpha = across > 0 ? y / across : 0;
  const double cos_theta = r > 0 ? std::max(across / r, 1e-6) : 1, sin_theta = r > 0 ? z / r : 0;
  const double w = half_way / (r + half_way), t = r / (r + half_way);

  const Place level(t * axes.levels, axes.levels);
  const Place elevation(std::atan2(sin_theta, cos_theta) / axes.elevation_step(), axes.elevations - 1);
  const Place azimuth((std::atan2(sin_alpha, cos_alpha) + std::numbers::pi / 2) / axes.azimuth_step(),
                      axes.azimuths - 1);
  const CreepSample sample = read<gradient>(ratio, level, elevation, azimuth, read_nu);

  Unit u;
  const double q[] = {x, scale.y_y * y + scale.y_z * z, scale.m_y * y + scale.m_z * z};
  for (int n = 0; n < 3; ++n) u.f[n] = t * t * sample.value[n] - q[n] * w * w;
  if constexpr (gradient) {
    const double by_q[3][3] = {{1, 0, 0}, {0, scale.y_y, scale.y_z}, {0, scale.m_y, scale.m_z}};
    const double along_r[] = {cos_theta * cos_alpha, cos_theta * sin_alpha, sin_theta};
    const double along_theta[] = {-sin_theta * cos_alpha, -sin_theta * sin_alpha, cos_theta};
    const double along_alpha[] = {-sin_alpha, cos_alpha, 0};
    for (int n = 0; n < 3; ++n) {
      const double by_r = (2 * q[n] * w + 2 * t * sample.value[n] + t * t * sample.by_level[n] * axes.levels) * w * w;
      const double by_theta = t * w * sample.by_elevation[n] / axes.elevation_step();
      const double by_alpha = t * w * sample.by_azimuth[n] / (axes.azimuth_step() * cos_theta);
      for (int k = 0; k < 3; ++k)
        u.by[n][k] =
            (by_r * along_r[k] + by_theta * along_theta[k] + by_alpha * along_alpha[k]) / half_way - by_q[n][k] * w * w;
    }
  }
  bound<gradient>(u);

  // Back to the contact's own creepages and forces.
  const double sign[] = {mirrored, 1, 1}, own_side[] = {side, 1, side};
  const double force[] = {capacity, capacity, capacity * shape.arm};
  double* const forces[] = {&out.forces.fx, &out.forces.fy, &out.forces.mz};
  for (int n = 0; n < 3; ++n) *forces[n] = force[n] * u.f[n] * sign[n] * turned * own_side[n];
  out.forces.adhesion_area = area * std::clamp(sample.value[3], 0.0, 1.0);
  out.forces.slip_area = area - out.forces.adhesion_area;
  if constexpr (gradient) {
    const double by[] = {scale.xi, scale.eta, scale.phi}, place[] = {x, y, z};
    for (int n = 0; n < 3; ++n) {
      double by_capacity = u.f[n]; // of F at given creepages, over what F is a multiple of
      for (int k = 0; k < 3; ++k) {
        by_capacity -= place[k] * u.by[n][k];
        out.jacobian[n][k] = force[n] * u.by[n][k] * by[k] * sign[n] * sign[k] * own_side[n] * own_side[k];
      }
      by_capacity *= force[n] * sign[n] * turned * own_side[n];
      out.jacobian[n][3] = by_capacity / contact.normal_force;
      if (slip > 0 && friction.partial[0] != 0) {
        const double by_slip = by_capacity / mu * friction.partial[0] * contact.rolling_speed / slip;
        out.jacobian[n][0] += by_slip * creepage.longitudinal;
        out.jacobian[n][1] += by_slip * creepage.lateral;
      }
    }
  }
  return in_range ? Status::ok : Status::not_converged;
}

Scale CreepForceTable::Data::scale_of(const EllipticContact& contact, const Shape& shape, double capacity,
                                      const CreepageCoefficients& own, double read_nu) const noexcept {
  const double c = std::sqrt(contact.a * contact.b), g = contact.shear_modulus * c * c / capacity;
  const double spin_scale = creep_coordinates::spin_scale(shape.a_over_b);
  Scale scale = {.xi = g * own.c11, .eta = g * own.c22, .phi = g * own.c11 * spin_scale * shape.arm};
  if (!shape.in_range) {
    const auto there = creepage_coefficients(shape.a_over_b, read_nu, CreepageTable::computed);
    scale.eta = scale.xi * there.c22 / there.c11;
  }
  scale.y_y = g * own.c22 / scale.eta;
  scale.y_z = g * own.c23 * c / scale.phi;
  scale.m_y = -g * own.c23 * c / (scale.eta * shape.arm);
  scale.m_z = g * own.c33 * c * c / (scale.phi * shape.arm);
  return scale;
}

template <bool gradient>
CreepSample CreepForceTable::Data::read(const Place& ratio, const Place& level, const Place& elevation,
                                        const Place& azimuth, double nu) const noexcept {
  CreepStencil stencil;
  const auto ratios = cubic_weights(ratio.fraction), levels = cubic_weights(level.fraction),
             elevations = cubic_weights(elevation.fraction), azimuths = azimuth_weights(azimuth.fraction);
  for (std::size_t k = 0; k < 4; ++k) {
    stencil.ratio[k] = ratios.value[k];
    stencil.level[k] = levels.value[k];
    stencil.level_slope[k] = levels.slope[k];
    stencil.elevation[k] = elevations.value[k];
    stencil.elevation_slope[k] = elevations.slope[k];
    stencil.azimuth[k] = azimuths.value[k];
    stencil.azimuth_slope[k] = azimuths.slope[k];
  }
  const std::ptrdiff_t first = ratio.interval * strides.ratio + level.interval * strides.level +
                               elevation.interval * strides.elevation +
                               std::ptrdiff_t{azimuth.interval} * creep_channels;
  const auto sum = gradient ? sums.gradients : sums.values;
  CreepSample total = {};
  for (std::size_t m = 0; m < materials.size(); ++m) {
    const double share = weight(m, nu);
    if (share == 0) continue;
    stencil.first = materials[m].coefficients.data() + first;
    CreepSample sample;
    sum(stencil, strides, sample);
    if (share == 1) return sample;
    for (int c = 0; c < creep_channels; ++c) {
      total.value[c] += share * sample.value[c];
      if constexpr (gradient) {
        total.by_level[c] += share * sample.by_level[c];
        total.by_elevation[c] += share * sample.by_elevation[c];
        total.by_azimuth[c] += share * sample.by_azimuth[c];
      }
    }
  }
  return total;
}

namespace {

void set_invalid(ContactDerivatives& result) {
  result.forces = {nan, nan, nan, nan, nan, Status::invalid_input};
  for (auto& row : result.jacobian) std::fill(row, row + 4, nan);
}

} // namespace

CreepForceTable::CreepForceTable(const CreepTableNodes& nodes, RollingDirection direction) {
  auto data = std::make_shared<Data>(nodes, direction);
  for (std::size_t m = 0; m < nodes.axes.poisson_ratios.size(); ++m) data->add(nodes, m);
  data_ = std::move(data);
}

CreepForceTable::CreepForceTable(const CreepTableNodes& nodes, double poisson_ratio, RollingDirection direction) {
  require_between("poisson_ratio", poisson_ratio, "-", nodes.axes.poisson_ratios.front(),
                  nodes.axes.poisson_ratios.back());
  auto data = std::make_shared<Data>(nodes, direction);
  data->add(nodes, poisson_ratio);
  data->axes.poisson_ratios = {poisson_ratio};
  data_ = std::move(data);
}

const CreepTableAxes& CreepForceTable::axes() const {
  return data_->axes;
}

RollingDirection CreepForceTable::direction() const {
  return data_->side > 0 ? RollingDirection::forward : RollingDirection::backward;
}

ContactForces CreepForceTable::solve(const EllipticContact& contact) const noexcept {
  ContactDerivatives out;
  const Status status = data_->find<false>(contact, out);
  if (status == Status::invalid_input) set_invalid(out);
  out.forces.status = status;
  return out.forces;
}

void CreepForceTable::solve(std::span<const EllipticContact> contacts, std::span<ContactForces> forces) const noexcept {
  for (std::size_t i = 0; i < contacts.size(); ++i) forces[i] = solve(contacts[i]);
}

ContactDerivatives CreepForceTable::differentiate(const EllipticContact& contact) const noexcept {
  ContactDerivatives out;
  const Status status = data_->find<true>(contact, out);
  if (status == Status::invalid_input) set_invalid(out);
  out.forces.status = status;
  return out;
}

void CreepForceTable::differentiate(std::span<const EllipticContact> contacts,
                                    std::span<ContactDerivatives> derivatives) const noexcept {
  for (std::size_t i = 0; i < contacts.size(); ++i) derivatives[i] = differentiate(contacts[i]);
}

} // namespace microslip
