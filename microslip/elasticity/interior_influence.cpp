#include "microslip/elasticity/interior_influence.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace microslip {
namespace {

/// Nearer than this part of a side counts as on an edge, and of the shorter side as on the surface.
constexpr double on_edge = 1e-12;

/// Derivatives of the potential (I2) in the depth z: second, third, and z times fourth ones.
struct Derivatives {
  double z;
  double xx, xy, yy, xz, yz, zz;
  double xxx, xxy, xyy, yyy, xxz, xyz, yyz, xzz, yzz, zzz;
  double z_xxxz, z_xxyz, z_xyyz, z_yyyz, z_xxzz, z_xyzz, z_yyzz, z_xzzz, z_yzzz, z_zzzz;
};

/// ln(q2/q1) from q1, q2 and their difference.
double log_ratio(double q1, double q2, double difference) {
  return std::abs(difference) < q1 / 2 ? std::log1p(difference / q1) : std::log(q2 / q1);
}

/// An edge along t from t1 to t2 at the distances h and z: what becomes of the primitives between its ends, and
/// integrals over it. rho is the distance, q = rho + z.
struct Edge {
  double h;
  double log;          ///< integral of 1/rho (I6)
  double angle;        ///< of h/(rho q) (I7)
  double cubed;        ///< of 1/rho^3, for z > 0 (I8)
  double rho_step;     ///< rho2 - rho1
  double log_q_step;   ///< ln(q2/q1)
  double inverse_q;    ///< 1/q2 - 1/q1
  double inverse_rho;  ///< 1/rho2 - 1/rho1, for z > 0
  double inverse_rhoq; ///< 1/(rho2 q2) - 1/(rho1 q1), for z > 0

  Edge(double h, double t1, double t2, double length, double z, double tiny);
};

Edge::Edge(double at, double t1, double t2, double length, double z, double tiny)
    : h(at), cubed(0), inverse_rho(0), inverse_rhoq(0) {
  const double c2 = h * h + z * z, middle = t1 + t2;
  const double rho1 = std::sqrt(c2 + t1 * t1), rho2 = std::sqrt(c2 + t2 * t2);
  const double q1 = std::max(rho1 + z, tiny), q2 = std::max(rho2 + z, tiny);

  // t2 rho1 - t1 rho2
  const bool between = t1 < 0 && t2 > 0;
  const double sum = t2 * rho1 + t1 * rho2;
  const double cross = between ? t2 * rho1 - t1 * rho2 : sum == 0 ? 0 : c2 * length * middle / sum;

  // rho1 + t1 and rho2 - t2
  const double floor2 = std::max(c2, tiny * tiny);
  const double e1 = t1 >= 0 ? std::max(rho1 + t1, tiny) : floor2 / (rho1 - t1);
  const double e2 = t2 <= 0 ? std::max(rho2 - t2, tiny) : floor2 / (rho2 + t2);
  log = std::log1p(2 * length / (e1 + e2));
  angle = h == 0 ? 0
                 : std::atan2(h * (h * h * length + z * (cross + z * length)),
                              (h * h + z * q1) * (h * h + z * q2) + h * h * t1 * t2);

  rho_step = length * middle / (rho1 + rho2);
  log_q_step = log_ratio(q1, q2, rho_step);
  inverse_q = -rho_step / (q1 * q2);
  if (z == 0) return;
  cubed = (between ? cross / c2 : length * middle / sum) / (rho1 * rho2);
  inverse_rho = -rho_step / (rho1 * rho2);
  inverse_rhoq = -rho_step * (rho1 + rho2 + z) / (rho1 * q1 * rho2 * q2);
}

/// The second edge's value less the first one's, of f or h f.
double step(const Edge (&e)[2], double Edge::*f) {
  return e[1].*f - e[0].*f;
}
double moment_step(const Edge (&e)[2], double Edge::*f) {
  return e[1].h * e[1].*f - e[0].h * e[0].*f;
}

/// A distance that is zero to the accuracy of coordinates becomes zero.
double snapped(double value, double tiny) {
  return std::abs(value) < tiny ? 0 : value;
}

Derivatives rectangle(double dx, double dy, double x, double y, double depth) {
  const double tiny_x = on_edge * dx, tiny_y = on_edge * dy, tiny = std::min(tiny_x, tiny_y);
  const double z = snapped(depth, tiny);
  const double x1 = snapped(x - dx / 2, tiny_x), x2 = snapped(x + dx / 2, tiny_x);
  const double y1 = snapped(y - dy / 2, tiny_y), y2 = snapped(y + dy / 2, tiny_y);
  const Edge along_y[2] = {{x1, y1, y2, dy, z, tiny}, {x2, y1, y2, dy, z, tiny}};
  const Edge along_x[2] = {{y1, x1, x2, dx, z, tiny}, {y2, x1, x2, dx, z, tiny}};

  Derivatives d;
  d.z = z;
  d.xzz = step(along_y, &Edge::log);
  d.yzz = step(along_x, &Edge::log);
  d.xxz = step(along_y, &Edge::angle);
  d.yyz = step(along_x, &Edge::angle);
  d.zzz = -d.xxz - d.yyz;
  d.xyz = step(along_y, &Edge::log_q_step);
  d.xxy = -moment_step(along_y, &Edge::inverse_q);
  d.xyy = -moment_step(along_x, &Edge::inverse_q);
  d.xxx = -d.xyy - d.xzz;
  d.yyy = -d.xxy - d.yzz;

  d.xx = z * d.xxz - moment_step(along_y, &Edge::log);
  d.yy = z * d.yyz - moment_step(along_x, &Edge::log);
  d.zz = -d.xx - d.yy;
  d.xy = z * d.xyz - step(along_y, &Edge::rho_step);
  d.xz = moment_step(along_x, &Edge::log_q_step) + z * d.xzz + moment_step(along_y, &Edge::angle);
  d.yz = moment_step(along_y, &Edge::log_q_step) + z * d.yzz + moment_step(along_x, &Edge::angle);

  d.z_xxzz = -z * moment_step(along_y, &Edge::cubed);
  d.z_yyzz = -z * moment_step(along_x, &Edge::cubed);
  d.z_zzzz = -d.z_xxzz - d.z_yyzz;
  d.z_xzzz = -z * z * step(along_y, &Edge::cubed);
  d.z_yzzz = -z * z * step(along_x, &Edge::cubed);
  d.z_xyzz = z * step(along_y, &Edge::inverse_rho);
  d.z_xxyz = z * moment_step(along_y, &Edge::inverse_rhoq);
  d.z_xyyz = z * moment_step(along_x, &Edge::inverse_rhoq);
  d.z_xxxz = -d.z_xyyz - d.z_xzzz;
  d.z_yyyz = -d.z_xxyz - d.z_yzzz;
  return d;
}

/// The limit of long rectangles, without the constant of the second derivatives that grows with their length.
Derivatives strip(double dx, double x, double depth, double far) {
  const double tiny = on_edge * dx, z = snapped(depth, tiny);
  const double h[2] = {snapped(x - dx / 2, tiny), snapped(x + dx / 2, tiny)};
  double log[2], angle[2], cubed[2];
  for (int i = 0; i < 2; ++i) {
    const double c = std::max(std::hypot(h[i], z), tiny);
    log[i] = 2 * std::log(far / c);
    angle[i] = h[i] == 0 ? 0 : 2 * std::atan2(h[i], z);
    cubed[i] = z == 0 ? 0 : 2 / (c * c);
  }
  Derivatives d{};
  d.z = z;
  d.xzz = log[1] - log[0];
  d.xxz = angle[1] - angle[0];
  d.zzz = -d.xxz;
  d.xxx = -d.xzz;
  d.zz = h[1] * log[1] - h[0] * log[0] + 2 * dx - z * d.xxz;
  d.xx = -d.zz;
  d.xz = z * d.xzz + h[1] * angle[1] - h[0] * angle[0];
  d.z_xxzz = -z * (h[1] * cubed[1] - h[0] * cubed[0]);
  d.z_zzzz = -d.z_xxzz;
  d.z_xzzz = -z * z * (cubed[1] - cubed[0]);
  d.z_xxxz = -d.z_xzzz;
  return d;
}

/// x and y exchanged.
Derivatives exchanged(Derivatives d) {
  for (const auto& [a, b] : {std::pair{&Derivatives::xx, &Derivatives::yy},
                             {&Derivatives::xz, &Derivatives::yz},
                             {&Derivatives::xxx, &Derivatives::yyy},
                             {&Derivatives::xxy, &Derivatives::xyy},
                             {&Derivatives::xxz, &Derivatives::yyz},
                             {&Derivatives::xzz, &Derivatives::yzz},
                             {&Derivatives::z_xxxz, &Derivatives::z_yyyz},
                             {&Derivatives::z_xxyz, &Derivatives::z_xyyz},
                             {&Derivatives::z_xxzz, &Derivatives::z_yyzz},
                             {&Derivatives::z_xzzz, &Derivatives::z_yzzz}})
    std::swap(d.*a, d.*b);
  return d;
}

/// (I3) and (I4).
InteriorState from_pressure(const Derivatives& d, const Material& m) {
  const double nu = m.poisson_ratio, f = 1 / (4 * std::numbers::pi * m.shear_modulus), g = 1 / (2 * std::numbers::pi);
  InteriorState s;
  s.ux = -f * ((1 - 2 * nu) * d.xz + d.z * d.xzz);
  s.uy = -f * ((1 - 2 * nu) * d.yz + d.z * d.yzz);
  s.uz = f * (2 * (1 - nu) * d.zz - d.z * d.zzz);
  s.stress.xx = g * (2 * nu * d.zzz - (1 - 2 * nu) * d.xxz - d.z_xxzz);
  s.stress.yy = g * (2 * nu * d.zzz - (1 - 2 * nu) * d.yyz - d.z_yyzz);
  s.stress.zz = g * (d.zzz - d.z_zzzz);
  s.stress.xy = -g * ((1 - 2 * nu) * d.xyz + d.z_xyzz);
  s.stress.xz = -g * d.z_xzzz;
  s.stress.yz = -g * d.z_yzzz;
  return s;
}

/// (I5).
InteriorState from_traction_x(const Derivatives& d, const Material& m) {
  const double nu = m.poisson_ratio, f = 1 / (4 * std::numbers::pi * m.shear_modulus), g = 1 / (2 * std::numbers::pi);
  InteriorState s;
  s.ux = f * (2 * d.zz + 2 * nu * d.xx - d.z * d.xxz);
  s.uy = f * (2 * nu * d.xy - d.z * d.xyz);
  s.uz = f * ((1 - 2 * nu) * d.xz - d.z * d.xzz);
  s.stress.xx = g * (2 * (1 + nu) * d.xzz + 2 * nu * d.xxx - d.z_xxxz);
  s.stress.yy = g * (2 * nu * (d.xzz + d.xyy) - d.z_xyyz);
  s.stress.zz = -g * d.z_xzzz;
  s.stress.xy = g * (d.yzz + 2 * nu * d.xxy - d.z_xxyz);
  s.stress.xz = g * (d.zzz - d.z_xxzz);
  s.stress.yz = -g * d.z_xyzz;
  return s;
}

InteriorState exchanged(InteriorState s) {
  std::swap(s.ux, s.uy);
  std::swap(s.stress.xx, s.stress.yy);
  std::swap(s.stress.xz, s.stress.yz);
  return s;
}

/// State of the reflection at the surface.
InteriorState reflected(const InteriorState& s) {
  return {s.ux, s.uy, -s.uz, {s.stress.xx, s.stress.yy, s.stress.zz, s.stress.xy, -s.stress.xz, -s.stress.yz}};
}
InteriorState opposite(const InteriorState& s) {
  return {-s.ux, -s.uy, -s.uz, {-s.stress.xx, -s.stress.yy, -s.stress.zz, -s.stress.xy, -s.stress.xz, -s.stress.yz}};
}

InteriorInfluence all_tractions(const Derivatives& d, const Material& material, Body body) {
  const InteriorInfluence first = {from_traction_x(d, material), exchanged(from_traction_x(exchanged(d), material)),
                                   from_pressure(d, material)};
  return body == Body::first ? first : of_body_2(first);
}

} // namespace

void add(InteriorState& to, double factor, const InteriorState& a) {
  to.ux += factor * a.ux;
  to.uy += factor * a.uy;
  to.uz += factor * a.uz;
  to.stress.xx += factor * a.stress.xx;
  to.stress.yy += factor * a.stress.yy;
  to.stress.zz += factor * a.stress.zz;
  to.stress.xy += factor * a.stress.xy;
  to.stress.xz += factor * a.stress.xz;
  to.stress.yz += factor * a.stress.yz;
}

void add(InteriorInfluence& to, double factor, const InteriorInfluence& a) {
  add(to.px, factor, a.px);
  add(to.py, factor, a.py);
  add(to.pn, factor, a.pn);
}

InteriorInfluence of_body_2(const InteriorInfluence& of_body_1) {
  return {opposite(reflected(of_body_1.px)), opposite(reflected(of_body_1.py)), reflected(of_body_1.pn)};
}

InteriorInfluence interior_influence(const Material& material, Body body, double dx, double dy, double x, double y,
                                     double depth) {
  return all_tractions(rectangle(dx, dy, x, y, depth), material, body);
}

InteriorInfluence line_interior_influence(const Material& material, Body body, double dx, double x, double depth,
                                          double far) {
  return all_tractions(strip(dx, x, depth, far), material, body);
}

} // namespace microslip
