#include "suspension.hpp"

using SimTK::Mat33, SimTK::MobilizedBody, SimTK::Rotation, SimTK::SpatialVec, SimTK::State, SimTK::Vec3;

namespace {

/// One side's deflection in the first body's axes, and its levers in the ground's.
struct Side {
  Vec3 deflection, rate;                ///< [m], [m/s]
  Vec3 lever_of_first, lever_of_second; ///< from the bodies' origins to the second one's point [m]
};

Side side_of(const State& state, const MobilizedBody& first, const MobilizedBody& second, const SpringPair& pair,
             double sign) {
  const Vec3 on_first(pair.on_first[0], sign * pair.on_first[1], pair.on_first[2]),
      on_second(pair.on_second[0], sign * pair.on_second[1], pair.on_second[2]);
  const Rotation& axes = first.getBodyRotation(state);
  Side side;
  side.lever_of_second = second.getBodyRotation(state) * on_second;
  side.lever_of_first = second.getBodyOriginLocation(state) + side.lever_of_second - first.getBodyOriginLocation(state);
  const SpatialVec &v1 = first.getBodyVelocity(state), &v2 = second.getBodyVelocity(state);
  side.deflection = ~axes * side.lever_of_first - on_first;
  side.rate = ~axes * ((v2[1] + v2[0] % side.lever_of_second) - (v1[1] + v1[0] % side.lever_of_first));
  return side;
}

Vec3 times(const Vec3& a, const Vec3& b) {
  return {a[0] * b[0], a[1] * b[1], a[2] * b[2]};
}

/// On the second body.
Vec3 force_of(const SpringPair& pair, const Side& side) {
  return -(times(pair.stiffness, side.deflection) + times(pair.damping, side.rate)) - Vec3(0, 0, pair.preload);
}

template <class Work>
void of_all_sides(const State& state, const SimTK::SimbodyMatterSubsystem& matter, const std::vector<SpringPair>& pairs,
                  const Work& work) {
  for (const SpringPair& pair : pairs) {
    const MobilizedBody &first = matter.getMobilizedBody(pair.first), &second = matter.getMobilizedBody(pair.second);
    work(pair, side_of(state, first, second, pair, 1), side_of(state, first, second, pair, -1),
         first.getBodyRotation(state));
  }
}

/// Derivatives of the moment and force on a body (row) by small rotations and displacements of a body (column).
using Block = SimTK::Mat66;

/// -levers^T stiffness levers, by which forces turn into moments and rotations into deflections, of one side.
Block block_of(const Mat33& stiffness, const Vec3& lever_of_row, const Vec3& lever_of_column, double sign) {
  const Mat33 lever = SimTK::crossMat(lever_of_row), by_rotation = -sign * stiffness * SimTK::crossMat(lever_of_column),
              by_displacement = sign * stiffness;
  Block block;
  block.updSubMat<3, 3>(0, 0) = lever * by_rotation, block.updSubMat<3, 3>(0, 3) = lever * by_displacement;
  block.updSubMat<3, 3>(3, 0) = by_rotation, block.updSubMat<3, 3>(3, 3) = by_displacement;
  return block;
}

void add_sides(const SpringPair& pair, const Side& left, const Side& right, const Rotation& axes, const Vec3& stiffness,
               SimTK::Matrix& slopes) {
  const Mat33 k = axes.asMat33() * Mat33(stiffness[0], 0, 0, 0, stiffness[1], 0, 0, 0, stiffness[2]) * ~axes.asMat33();
  const SimTK::MobilizedBodyIndex bodies[] = {pair.first, pair.second};
  const auto lever = [](const Side& side, int of) { return of == 0 ? side.lever_of_first : side.lever_of_second; };
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 2; ++column) {
      const double sign = row == column ? -1 : 1;
      const Block sum = block_of(k, lever(left, row), lever(left, column), sign) +
                        block_of(k, lever(right, row), lever(right, column), sign);
      const int i0 = SpatialSlopes::first(bodies[row]), j0 = SpatialSlopes::first(bodies[column]);
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) slopes(i0 + i, j0 + j) += sum(i, j);
    }
}

} // namespace

/// Both sides are added up before the bodies' forces, so that a mirrored run is the mirror image to the last bit.
void Suspension::calcForce(const State& state, SimTK::Vector_<SpatialVec>& body_forces, SimTK::Vector_<Vec3>&,
                           SimTK::Vector&) const {
  of_all_sides(state, matter_, pairs_,
               [&](const SpringPair& pair, const Side& left, const Side& right, const Rotation& axes) {
                 const Vec3 on_left = axes * force_of(pair, left), on_right = axes * force_of(pair, right);
                 body_forces[pair.second] +=
                     SpatialVec(left.lever_of_second % on_left + right.lever_of_second % on_right, on_left + on_right);
                 body_forces[pair.first] -=
                     SpatialVec(left.lever_of_first % on_left + right.lever_of_first % on_right, on_left + on_right);
               });
}

double Suspension::calcPotentialEnergy(const State& state) const {
  double energy = 0;
  of_all_sides(state, matter_, pairs_,
               [&](const SpringPair& pair, const Side& left, const Side& right, const Rotation&) {
                 for (const Side* side : {&left, &right})
                   energy += dot(times(pair.stiffness, side->deflection), side->deflection) / 2 +
                             pair.preload * side->deflection[2];
               });
  return energy;
}

double Suspension::power(const State& state) const {
  double power = 0;
  of_all_sides(
      state, matter_, pairs_, [&](const SpringPair& pair, const Side& left, const Side& right, const Rotation&) {
        power += dot(times(pair.damping, left.rate), left.rate) + dot(times(pair.damping, right.rate), right.rate);
      });
  return power;
}

void Suspension::add_slopes(const State& state, SpatialSlopes& slopes) const {
  of_all_sides(state, matter_, pairs_,
               [&](const SpringPair& pair, const Side& left, const Side& right, const Rotation& axes) {
                 add_sides(pair, left, right, axes, pair.stiffness, slopes.by_position);
                 add_sides(pair, left, right, axes, pair.damping, slopes.by_velocity);
               });
}
