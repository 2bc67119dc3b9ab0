#include "microslip/exact/classical/slip_friction.hpp"

#include "microslip/error.hpp"
#include "microslip/exact/halfspace/coarser_elements.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace microslip {
namespace {

/// Calls at(v) with slip velocities [m/s] between which no law falls much steeper than at them.
template <class At> void for_velocities(const FrictionLaw& law, At at) {
  constexpr double lowest = 1e-4, ratio = 1.6; // over those of the laws
  constexpr int count = 40;                    // up to 1e4
  const auto around = [&](double velocity) {
    double v = lowest;
    for (int k = 0; k < count; ++k, v *= ratio) at(v * velocity);
  };
  if (law.table() == nullptr) {
    for (const FrictionTerm& term : law.terms()) around(term.half_velocity);
    return;
  }
  const std::vector<double>& v = law.table()->grid().slip_velocities;
  around(v.back());
  constexpr int parts = 8;
  for (std::size_t i = 0; i + 1 < v.size(); ++i)
    for (int k = 0; k < parts; ++k) at(v[i] + (v[i + 1] - v[i]) * k / parts);
}

/// mu = base + share mu_table(v, p, T) of a table that depends on the temperature, where that friction heats the point
/// at which it acts: T = ahead + own mu, own >= 0 [K]. Between the table's temperatures mu(T) is linear, so that the
/// solution is closed; of several it is that of the least heat.
template <class Real>
Real heated_coefficient(const FrictionTable& table, const Real& v, const Real& pressure, const Real& base,
                        const Real& share, const Real& ahead, const Real& own) {
  const std::vector<double>& t = table.grid().temperatures;
  const auto at = [&](double temperature) { return base + share * table.coefficient(v, pressure, Real(temperature)); };
  for (auto k = static_cast<std::size_t>(std::upper_bound(t.begin(), t.end(), value_of(ahead)) - t.begin());
       k < t.size(); ++k) {
    const Real hot = at(t[k]);
    if (value_of(ahead + own * hot) > t[k]) continue;
    if (k == 0) return hot;
    const Real cold = at(t[k - 1]), slope = (hot - cold) / Real(t[k] - t[k - 1]), gain = own * slope;
    return value_of(gain) < 1 ? (cold + slope * (ahead - Real(t[k - 1]))) / (Real(1.0) - gain) : hot;
  }
  return at(t.back());
}

void require_for_rows(const char* field, std::size_t count, int rows) {
  if (count != 1 && count != static_cast<std::size_t>(rows))
    throw Error(std::string(field) + ": must have one law or one for each of the " + std::to_string(rows) + " rows");
}

} // namespace

SlipFriction::SlipFriction(const ElementGrid& grid, std::span<const FrictionLaw> laws, const FrictionMemory& memory,
                           const InterfaceLayer& layer, Passage passage, std::optional<FrictionHeating> heating)
    : grid_(grid), laws_(laws.begin(), laws.end()), memory_(memory), layer_(layer), passage_(std::move(passage)),
      heating_(std::move(heating)), hardening_(layer.hardening * passage_.time * passage_.speed) {
  require_for_rows("friction", laws_.size(), grid.my);
  constexpr double largest = std::numeric_limits<double>::max();
  require_between("friction_memory.distance", memory.distance, "m", 0, largest);
  require_between("friction_memory.slowest", memory.slowest, "m/s", 0, largest);
  check(layer);
  if (!heating_) return;
  require_for_rows("temperature_effect", heating_->effects.size(), grid.my);
  require_positive("rolling_speed", heating_->rolling_speed, "m/s");
  check(heating_->bodies);
  for (int j = 0; j < grid.my; ++j) {
    check(effect(j));
    require_between("temperature_effect.change", effect(j).change, "-", -law(j).least_coefficient(),
                    FrictionLaw::largest_coefficient - law(j).peak_coefficient());
  }
  flash_.emplace(grid.mx, grid.dx, heating_->rolling_speed, heating_->bodies);
}

bool SlipFriction::falls() const {
  return heating_ || std::any_of(laws_.begin(), laws_.end(),
                                 [](const FrictionLaw& law) { return law.kind() != FrictionLaw::Kind::coulomb; });
}

bool SlipFriction::is_constant() const {
  return !falls() && !layer_.yields();
}

std::vector<double> SlipFriction::static_coefficients() const {
  std::vector<double> mu;
  mu.reserve(grid_.count());
  for (int j = 0; j < grid_.my; ++j)
    mu.insert(mu.end(), static_cast<std::size_t>(grid_.mx), law(j).static_coefficient());
  return mu;
}

/// Calls at(row, element, first in its row) in the order in which particles come through.
template <class At> void SlipFriction::for_particles(At at) const {
  for (int j = 0; j < grid_.my; ++j)
    for (int n = 0; n < grid_.mx; ++n) {
      const int i = passage_.from_high_x ? grid_.mx - 1 - n : n;
      at(j, static_cast<std::size_t>(j) * grid_.mx + i, n == 0);
    }
}

/// Calls find(row, element, particle) in this order, which returns the Element that it then has.
template <class Find> void SlipFriction::pass(std::span<const double> pressure, Find find) const {
  Particle particle;
  std::vector<double> heat; // of the elements of the row [W/m^2]
  for_particles([&](int row, std::size_t k, bool first) {
    if (first || !passage_.along_rows) {
      particle = {.friction = law(row).static_coefficient()};
      if (flash_) particle.friction = law(row).coefficient(0.0, 0.0, flash_->mean()) + effect(row).at(flash_->mean());
      if (!passage_.before.empty()) particle.friction = passage_.before[k];
      if (!passage_.deformation_before.empty()) particle.deformation = passage_.deformation_before[k];
      heat.clear();
    }
    if (flash_) particle.temperature = flash_->mean() + flash_->rise(heat, static_cast<int>(heat.size()));
    const Element there = find(row, k, particle);
    if (flash_) heat.push_back(there.friction * pressure[k] * passage_.speed * there.slip);
    particle.friction = there.friction;
    particle.deformation = there.deformation;
  });
}

/// mu (B6) after a slip, with the temperature's effect (T4).
template <class Real>
Real SlipFriction::coefficient(int row, const Real& slip, const Real& before, const Real& temperature,
                               const Real& pressure) const {
  const Real velocity = Real(passage_.speed) * slip;
  if (memory_.distance == 0 && !flash_) return law(row).coefficient(velocity, pressure, temperature);
  Real theta(0.0);
  if (memory_.distance > 0) {
    const Real counts = value_of(velocity) > memory_.slowest ? velocity : Real(memory_.slowest);
    theta = Real(memory_.distance) / (Real(memory_.distance) + Real(passage_.time) * counts);
  }
  const Real fresh = Real(1.0) - theta;
  if (flash_ && law(row).depends_on_temperature())
    return heated_coefficient(*law(row).table(), velocity, pressure, Real(theta * before), fresh, temperature,
                              Real(Real(flash_->rise(0)) * pressure * velocity));
  const Real mu = theta * before + fresh * law(row).coefficient(velocity, pressure, temperature);
  if (!flash_) return mu;
  return effect(row).coefficient(mu, fresh, temperature, Real(flash_->rise(0)) * pressure * velocity);
}

SlipFriction::Element SlipFriction::with_slip(int row, double slip, const Particle& before, double pressure) const {
  Element e{.slip = slip, .deformation = before.deformation};
  e.friction = coefficient(row, slip, before.friction, before.temperature, pressure);
  e.bound = e.friction * pressure;
  const double stress = layer_.yield_stress_after(before.deformation);
  if (!(stress < e.bound)) return e;
  const double hardened = std::max(0.0, stress + hardening_ * slip);
  if (hardened < e.bound) {
    e.bound = hardened;
    e.yields = slip > 0;
    e.deformation += passage_.time * passage_.speed * slip;
  } else if (layer_.hardening > 0) {
    e.deformation = (e.bound - layer_.yield_stress) / layer_.hardening; // the rest of the slip is friction's
  }
  return e;
}

/// The slip l with mu(l) p_n + rho l = |z|, by Newton's method, whose last step squares the error of the one before.
double SlipFriction::slip_by_friction(int row, double size, double rho, const Particle& before, double pressure) const {
  using Dual1 = Dual<double, 1>;
  constexpr int most = 100;
  constexpr double last_step = 1e-8; // over the slip
  double low = 0, high = size / rho, slip = low;
  for (int n = 0; n < most; ++n) {
    const Dual1 l = Dual1::variable(slip, 0);
    const Dual1 mu = coefficient<Dual1>(row, l, before.friction, before.temperature, pressure);
    const double excess = pressure * mu.value + rho * slip - size, slope = pressure * mu.partial[0] + rho;
    (excess > 0 ? high : low) = slip;
    double next = slip - excess / slope;
    const bool is_inside = next >= low && next <= high;
    if (!is_inside) next = (low + high) / 2;
    const double step = is_inside ? last_step : 4 * std::numeric_limits<double>::epsilon();
    if (std::abs(next - slip) <= step * slip || excess == 0) return next;
    slip = next;
  }
  return slip;
}

/// The slip l with tau_c + kappa l + rho l = |z|, and tau_c + kappa l not below zero.
double SlipFriction::slip_by_yielding(double size, double rho, const Particle& before) const {
  const double stress = layer_.yield_stress_after(before.deformation), slip = (size - stress) / (hardening_ + rho);
  return stress + hardening_ * slip > 0 ? slip : size / rho;
}

SlipFriction::Element SlipFriction::with_size(int row, double size, double rho, const Particle& before,
                                              double pressure) const {
  if (!(pressure > 0)) return with_slip(row, 0, before, 0);
  const Element at_rest = with_slip(row, 0, before, pressure);
  if (size <= at_rest.bound) return at_rest;
  // q is the smaller one of two bounds, and its slip the larger one of theirs.
  const double friction = at_rest.friction * pressure, stress = layer_.yield_stress_after(before.deformation);
  double slip = size > stress ? slip_by_yielding(size, rho, before) : 0;
  // mu p_n + rho l rises with l, so that what it is after yielding tells which slip is the larger one.
  const auto carried = [&] {
    return pressure * coefficient(row, slip, before.friction, before.temperature, pressure) + rho * slip;
  };
  if (size > friction && (slip == 0 || carried() < size)) slip = slip_by_friction(row, size, rho, before, pressure);
  return with_slip(row, slip, before, pressure);
}

SlipFriction::State SlipFriction::state(std::span<const double> slip_velocity, std::span<const double> pressure) const {
  const auto n = grid_.count();
  State s{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n), std::vector<char>(n)};
  pass(pressure, [&](int row, std::size_t k, const Particle& before) {
    const Element e = with_slip(row, slip_velocity[k] / passage_.speed, before, pressure[k]);
    s.friction[k] = e.friction;
    s.bound[k] = e.bound;
    s.deformation[k] = e.deformation;
    s.yields[k] = e.yields;
    return e;
  });
  return s;
}

void SlipFriction::largest(std::span<const double> pressure, std::span<double> bound) const {
  for_particles([&](int row, std::size_t k, bool) {
    double mu = law(row).peak_coefficient(pressure[k]);
    if (heating_) mu += std::max(0.0, effect(row).change);
    bound[k] = mu * pressure[k];
    if (!(layer_.hardening > 0)) bound[k] = std::min(bound[k], layer_.yield_stress);
  });
}

/// Pressures [Pa] up to a peak and temperatures [deg C] between which friction is linear.
std::vector<SlipFriction::Condition> SlipFriction::conditions(int row, double peak) const {
  std::vector<double> pressures = {peak};
  std::vector<double> temperatures = {heating_ ? effect(row).begin + effect(row).range / 4 : 0};
  if (const FrictionTable* table = law(row).table()) {
    for (const double p : table->grid().pressures)
      if (p > 0 && p < peak) pressures.push_back(p);
    if (table->depends_on_temperature()) temperatures = table->grid().temperatures;
  }
  std::vector<Condition> all;
  for (const double p : pressures)
    for (const double t : temperatures) all.push_back({p, t});
  return all;
}

/// The steepest fall of mu p_n and tau_c with the slip, and a little more.
double SlipFriction::least_rho(std::span<const double> pressure) const {
  constexpr double more = 1.2;
  using Dual1 = Dual<double, 1>;
  const double peak = pressure.empty() ? 0 : *std::max_element(pressure.begin(), pressure.end());
  double steepest = std::max(0.0, -hardening_);
  const int rows = laws_.size() == 1 && (!heating_ || heating_->effects.size() == 1) ? 1 : grid_.my;
  for (int row = 0; row < rows && falls(); ++row)
    for (const Condition& at : conditions(row, peak))
      for_velocities(law(row), [&](double v) {
        const Dual1 slip = Dual1::variable(v / passage_.speed, 0);
        const Dual1 mu = coefficient<Dual1>(row, slip, law(row).static_coefficient(), at.temperature, at.pressure);
        steepest = std::max(steepest, -at.pressure * mu.partial[0]);
      });
  return more * steepest;
}

void SlipFriction::project(std::span<const double> size, std::span<const double> pressure, double rho,
                           std::span<double> bound) const {
  pass(pressure, [&](int row, std::size_t k, const Particle& before) {
    const Element e = with_size(row, size[k], rho, before, pressure[k]);
    bound[k] = pressure[k] > 0 ? e.bound : 0;
    return e;
  });
}

SlipFriction::Slope SlipFriction::slope_at(int row, const Element& at, double rho, const Particle& before,
                                           double pressure) const {
  using Dual4 = Dual<double, 4>;
  using Regime = Slope::Regime;
  Slope s{.slip = at.slip, .friction = at.friction, .pressure = pressure};
  const Dual4 mu = coefficient<Dual4>(row, Dual4::variable(at.slip, 0), Dual4::variable(before.friction, 1),
                                      Dual4::variable(before.temperature, 2), Dual4::variable(pressure, 3));
  s.friction_by_slip = mu.partial[0];
  s.friction_by_before = mu.partial[1];
  s.friction_by_temperature = mu.partial[2];
  s.friction_by_pressure = mu.partial[3];
  if (!(at.slip > 0)) return s;
  double bound_by_slip = pressure * s.friction_by_slip;
  s.regime = Regime::friction;
  if (at.yields) {
    s.regime = Regime::yielding;
    s.bound_by_deformation = at.bound > 0 ? layer_.hardening : 0;
    bound_by_slip = at.bound > 0 ? hardening_ : 0;
  } else if (at.deformation != before.deformation) {
    s.regime = Regime::friction_after_yielding;
  }
  s.slip_by_size = 1 / (rho + bound_by_slip);
  return s;
}

void SlipFriction::linearise(std::span<const double> size, std::span<const double> pressure, double rho,
                             std::span<double> bound, std::span<double> own) {
  slopes_.resize(grid_.count());
  rho_ = rho;
  pass(pressure, [&](int row, std::size_t k, const Particle& before) {
    const Element e = with_size(row, size[k], rho, before, pressure[k]);
    slopes_[k] = slope_at(row, e, rho, before, pressure[k]);
    bound[k] = pressure[k] > 0 ? e.bound : 0;
    own[k] = pressure[k] > 0 ? 1 - rho * slopes_[k].slip_by_size : 0;
    return e;
  });
}

bool SlipFriction::carry(std::span<const double> size_change, std::span<const double> pressure_change,
                         std::span<double> bound_change) const {
  const bool brings_along = passage_.along_rows && (memory_.distance > 0 || flash_ || layer_.hardening != 0);
  if (pressure_change.empty() && !brings_along) return false;
  Particle particle; // the changes of what it has
  std::vector<double> heat;
  for_particles([&](int, std::size_t k, bool first) {
    if (first || !passage_.along_rows) particle = {}, heat.clear();
    if (flash_) particle.temperature = flash_->rise(heat, static_cast<int>(heat.size()));
    const Slope& s = slopes_[k];
    const double dp = pressure_change.empty() ? 0 : pressure_change[k];
    double mu = s.friction_by_before * particle.friction + s.friction_by_temperature * particle.temperature +
                s.friction_by_pressure * dp;
    const bool yields = s.regime == Slope::Regime::yielding;
    const double bound = yields ? s.bound_by_deformation * particle.deformation : s.pressure * mu + s.friction * dp;
    const double slip = s.slip_by_size * (size_change[k] - bound);
    bound_change[k] = rho_ * s.slip_by_size * bound;
    mu += s.friction_by_slip * slip;
    if (flash_)
      heat.push_back(passage_.speed * (s.slip * (s.pressure * mu + s.friction * dp) + s.friction * s.pressure * slip));
    particle.friction = mu;
    if (yields) particle.deformation += passage_.time * passage_.speed * slip;
    if (s.regime == Slope::Regime::friction_after_yielding)
      particle.deformation = (s.pressure * mu + s.friction * dp) / layer_.hardening;
  });
  return true;
}

std::unique_ptr<SlipDependentBound> SlipFriction::on_coarser(double longer) const {
  if (falls() || layer_.hardening < 0) return nullptr;
  const ElementGrid coarse = coarser_grid(grid_);
  std::vector<FrictionLaw> laws = {laws_[0]};
  if (laws_.size() > 1) {
    laws.clear();
    for (int j = 0; j < coarse.my; ++j) laws.push_back(laws_[2 * static_cast<std::size_t>(j)]);
  }
  Passage passage = passage_;
  passage.time *= longer;
  passage.before = mean_on_coarser(grid_, passage_.before);
  passage.deformation_before = mean_on_coarser(grid_, passage_.deformation_before);
  return std::make_unique<SlipFriction>(coarse, laws, memory_, layer_, std::move(passage));
}

} // namespace microslip
