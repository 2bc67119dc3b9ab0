#include "implicit_integrator.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

using SimTK::Mat33, SimTK::Matrix, SimTK::MobilizedBodyIndex, SimTK::Vec3, SimTK::Vector;

namespace {

constexpr double shortest_step = 1e-9; // [s]

/// Weights of the Lagrange polynomial through past times at a new one.
std::vector<double> extrapolation(const std::vector<double>& times, double time) {
  std::vector<double> weights(times.size(), 1.0);
  for (std::size_t i = 0; i < times.size(); ++i)
    for (std::size_t j = 0; j < times.size(); ++j)
      if (i != j) weights[i] *= (time - times[j]) / (times[i] - times[j]);
  return weights;
}

double largest(const Vector& v) {
  double most = 0;
  for (int k = 0; k < v.size(); ++k) most = std::max(most, std::abs(v[k]));
  return std::isfinite(v.sum()) ? most : std::numeric_limits<double>::infinity();
}

} // namespace

ImplicitIntegrator::ImplicitIntegrator(Vehicle& vehicle, const Options& options)
    : vehicle_(vehicle), options_(options), slopes_(vehicle.bodies()),
      matrix_(6 * vehicle.bodies(), 6 * vehicle.bodies()), mass_(6 * vehicle.bodies(), 6) {}

void ImplicitIntegrator::start(const SimTK::State& state) {
  state_ = state;
  past_ = {{state.getTime(), state.getQ(), state.getU(), state.getZ()}};
  matrix_g_ = 0, rate_ = 0.5;
  next_ = options_.step / 100;
}

void ImplicitIntegrator::set(double time, const Vector& q, const Vector& u) {
  state_.updTime() = time, state_.updQ() = q, state_.updU() = u;
  vehicle_.system().realize(state_, SimTK::Stage::Acceleration);
  ++counts_.evaluations;
}

void ImplicitIntegrator::predict(double h, Vector& q, Vector& u) const {
  std::vector<double> times;
  for (const Point& point : past_) times.push_back(point.time);
  const auto weights = extrapolation(times, past_[0].time + h);
  q = weights[0] * past_[0].q, u = weights[0] * past_[0].u;
  for (std::size_t k = 1; k < weights.size(); ++k) q += weights[k] * past_[k].q, u += weights[k] * past_[k].u;
}

/// In generalised coordinates: the columns of H of a body are its axes of rotation and of displacement in the ground.
void ImplicitIntegrator::make_newton_matrix(double g) {
  slopes_.clear();
  for (const SlopedForce* force : vehicle_.sloped_forces()) force->add_slopes(state_, slopes_);
  const int bodies = vehicle_.bodies();
  std::vector<std::array<Mat33, 2>> axes(static_cast<std::size_t>(bodies));
  for (int k = 0; k < bodies; ++k) {
    const auto& body = vehicle_.matter().getMobilizedBody(MobilizedBodyIndex(k + 1));
    auto& [rotation, displacement] = axes[static_cast<std::size_t>(k)];
    for (int c = 0; c < 3; ++c) {
      rotation.col(c) = body.getHCol(state_, SimTK::MobilizerUIndex(c))[0];
      displacement.col(c) = body.getHCol(state_, SimTK::MobilizerUIndex(c + 3))[1];
    }
    const auto inertia = body.getBodySpatialInertiaInGround(state_);
    const Mat33 turning = ~rotation * inertia.getUnitInertia().toMat33() * rotation * inertia.getMass();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        mass_(6 * k + i, j) = turning(i, j), mass_(6 * k + 3 + i, j) = i == j ? inertia.getMass() : 0;
  }
  for (int a = 0; a < bodies; ++a)
    for (int b = 0; b < bodies; ++b)
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) {
          Mat33 slope;
          for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 3; ++c) {
              const int row = 6 * a + 3 * i + r, column = 6 * b + 3 * j + c;
              slope(r, c) = -g * slopes_.by_velocity(row, column) - g * g * slopes_.by_position(row, column);
            }
          const Mat33 turned = ~axes[static_cast<std::size_t>(a)][static_cast<std::size_t>(i)] * slope *
                               axes[static_cast<std::size_t>(b)][static_cast<std::size_t>(j)];
          for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 3; ++c)
              matrix_(6 * a + 3 * i + r, 6 * b + 3 * j + c) =
                  turned(r, c) + (a == b && i == j ? mass_(6 * a + 3 * i + r, c) : 0);
        }
  factors_.factor(matrix_);
  matrix_g_ = g;
  ++counts_.jacobians;
}

double ImplicitIntegrator::error_of(const Vector& q, const Vector& u, double h) const {
  if (past_.size() < 3) return 0;
  // The predictor is off by h^3 y'''/6 (times the products of the steps), the method by 2/9 h^3 y''' at equal steps.
  const double h1 = past_[0].time - past_[1].time, h2 = past_[1].time - past_[2].time, w = h / h1;
  const double of_predictor = h * (h + h1) * (h + h1 + h2) / 6,
               of_method = h * h * h * (1 + w) * (1 + w) / (6 * w * (1 + 2 * w));
  const double unit = 1e-3 / of_method * (of_predictor + of_method);
  double most = 0;
  for (int k = 0; k < q.size(); ++k)
    most = std::max({most, std::abs(q[k] - predicted_q_[k]) / unit, 1e-3 * std::abs(u[k] - predicted_u_[k]) / unit});
  return most;
}

bool ImplicitIntegrator::try_step(double h) {
  const Point& last = past_[0];
  Vector q, u;
  predict(h, q, u);
  predicted_q_ = q, predicted_u_ = u;
  double g = h;
  Vector a = last.u, b = last.q, z = last.z;
  if (past_.size() > 1) {
    const double w = h / (last.time - past_[1].time), c0 = (1 + w) * (1 + w) / (1 + 2 * w), c1 = w * w / (1 + 2 * w);
    g = h * (1 + w) / (1 + 2 * w);
    a = c0 * last.u - c1 * past_[1].u, b = c0 * last.q - c1 * past_[1].q, z = c0 * last.z - c1 * past_[1].z;
  }
  q = b + g * u;
  const long changes = patch_changes();
  double before = 0;
  bool fresh = false;
  for (int k = 0; k < options_.most_iterations; ++k) {
    set(last.time + h, q, u);
    ++counts_.iterations;
    if (matrix_g_ == 0 || std::abs(g / matrix_g_ - 1) > 0.3) make_newton_matrix(g), fresh = true;
    const Vector short_of = a + g * state_.getUDot() - u;
    Vector right(short_of.size()), du;
    for (int row = 0; row < right.size(); ++row) {
      right[row] = 0;
      for (int c = 0; c < 3; ++c) right[row] += mass_(row, c) * short_of[row / 3 * 3 + c];
    }
    factors_.solve(right, du);
    const double size = largest(du);
    if (!std::isfinite(size)) break;
    u += du, q = b + g * u;
    if (k > 0) rate_ = std::max(size / before, 1e-3);
    if (size * rate_ / std::max(1 - rate_, 1e-3) <= options_.newton_tolerance ||
        size <= 1e-3 * options_.newton_tolerance) {
      if (k == 0) rate_ = std::min(0.5, 1.2 * rate_);
      error_ = error_of(q, u, h);
      z += g * state_.getZDot();
      if (options_.accuracy && error_ > *options_.accuracy) {
        ++counts_.rejected_by_error;
        counts_.rejected_at_patch_change += patch_changes() != changes;
        return false;
      }
      past_.insert(past_.begin(), {last.time + h, q, u, z});
      if (past_.size() > 3) past_.pop_back();
      ++counts_.steps;
      return true;
    }
    if (k > 0 && rate_ > options_.slow && !fresh) make_newton_matrix(g), fresh = true, rate_ = 0.5;
    before = size;
  }
  if (!fresh) { // once more with new derivatives
    matrix_g_ = 0, rate_ = 0.5;
    return try_step(h);
  }
  ++counts_.rejected_by_newton;
  counts_.rejected_at_patch_change += patch_changes() != changes;
  matrix_g_ = 0, rate_ = 0.5;
  return false;
}

void ImplicitIntegrator::step_to(double time) {
  while (past_[0].time < time - shortest_step) {
    const double left = time - past_[0].time;
    double h = std::min(next_, left);
    if (h < left && h > left / 2) h = left / 2; // no short step at the end
    const bool done = try_step(h);
    const double accuracy = options_.accuracy.value_or(1);
    const double growth = done && (!options_.accuracy || past_.size() < 3) ? 2
                          : options_.accuracy && error_ > 0                ? 0.9 * std::cbrt(accuracy / error_)
                                                                           : 0.25;
    if (done)
      next_ = std::min(options_.step, std::max(next_, h) * std::clamp(growth, 0.5, 2.0));
    else
      next_ = h * std::clamp(growth, 0.1, 0.5);
    if (next_ < shortest_step) throw std::runtime_error("the implicit integrator cannot go on: its step is too short");
  }
  state_.updTime() = past_[0].time, state_.updQ() = past_[0].q, state_.updU() = past_[0].u, state_.updZ() = past_[0].z;
}
