#include "compat/libcontact/arguments.hpp"
#include "compat/libcontact/call.hpp"
#include "microslip/contact/limits.hpp"

#include <algorithm>
#include <cmath>

// What contact problems of module 3 are set by.

namespace microslip::libcontact {
namespace {

using namespace contact_program;

void set_hertzian(ContactProblem& p, int method, std::span<const double> v) {
  if (method < -6 || method > -1)
    throw Refusal(CNTC_err_discr, "IPOTCN = " + std::to_string(method) + " does not exist");
  const std::size_t lengths = method == -6 ? 3 : 2;
  require_count("rparam", v.size(), 3 + lengths, 3 + lengths);
  PotentialContact potential;
  potential.kind = static_cast<Potential>(method);
  potential.mx = as_integer("MX", v[0], 1, most_cells);
  potential.my = as_integer("MY", v[1], 1, most_cells);
  potential.scale = v[2 + lengths];
  for (std::size_t k = 0; k < lengths; ++k) {
    potential.values[k] = v[2 + k] * p.units.of(unit_of_hertz(potential.kind, k));
    if (!(potential.values[k] > 0)) throw Refusal(CNTC_err_discr, "curvatures and semi-axes must be > 0");
  }
  if (!(potential.scale > 0)) throw Refusal(CNTC_err_discr, "SCALE must be > 0");
  p.data.potential = potential;
  if (potential.is_line()) p.data.digits.bound = PressureModel::elliptic; // as CONTACT does
}

/// NN, XM, RM, Y1, DY1 and NN heights; all but the first are kept.
std::vector<double> circle(const Units& u, std::span<const double> v) {
  require_count("prmudf", v.size(), 6, 5 + most_cells);
  const int heights = as_integer("NN", v[0], 1, most_cells);
  const std::size_t count = 5 + static_cast<std::size_t>(heights);
  require_count("prmudf", v.size(), count, count);
  auto values = u.in_si(v.subspan(1), UnitList(count - 1, 1));
  if (values[1] == 0) throw Refusal(CNTC_err_discr, "RM must not be 0");
  if (heights > 1 && !(values[3] > 0)) throw Refusal(CNTC_err_discr, "DY1 must be > 0");
  return values;
}

void set_distance(ContactProblem& p, int method, std::span<const double> v) {
  Geometry g;
  if (method != 1 && method != 2 && method != 3 && method != 9)
    throw Refusal(CNTC_err_discr, "IBASE = " + std::to_string(method) + " does not exist");
  g.base = static_cast<Base>(method);
  if (g.base == Base::by_element && !p.data.potential) throw Refusal(CNTC_err_discr, "there is no potential contact");
  if (g.base == Base::circle) {
    g.values = circle(p.units, v);
  } else {
    const UnitList units = g.base == Base::quadratic ? units_of_quadratic
                           : g.base == Base::waves   ? units_of_waves
                                                     : UnitList(p.data.potential->elements(), 1);
    require_count("prmudf", v.size(), units.size(), units.size());
    g.values = p.units.in_si(v, units);
  }
  if (g.base == Base::waves && (g.values[6] == 0 || g.values[7] == 0))
    throw Refusal(CNTC_err_discr, "B7 and B8 must not be 0");
  p.data.geometry = std::move(g);
}

void set_extra_slip(ContactProblem& p, std::span<const double> wx, std::span<const double> wy) {
  if (!p.data.potential) throw Refusal(CNTC_err_discr, "there is no potential contact");
  std::vector<double> slip(2 * p.data.potential->elements(), 0); // elements beyond the arrays have none
  for (std::size_t k = 0; k < wx.size() && 2 * k < slip.size(); ++k) {
    slip[2 * k] = wx[k]; // of a shift in mm, whatever the units
    slip[2 * k + 1] = wy[k];
  }
  p.data.extra_slip = std::move(slip);
  p.data.extra = ExtraSlip::by_element;
}

} // namespace

extern "C" {

int cntc_setreferencevelocity(int* ire, int* icp, double* veloc) {
  return guarded(contact_call(__func__, ire, icp), [&](ContactProblem& p) {
    constexpr double least = 1e-12; // [m/s]
    p.data.rolling->veloc = std::max(least, std::abs(real("veloc", veloc)) * p.units.length());
  });
}

int cntc_sethertzcontact(int* ire, int* icp, int* ipotcn, int* nparam, double* rparam) {
  return set_by(contact_call(__func__, ire, icp), set_hertzian, "ipotcn", ipotcn, "rparam", nparam, rparam);
}

int cntc_setpenetration(int* ire, int* icp, double* pen) {
  return guarded(contact_call(__func__, ire, icp), [&](ContactProblem& p) {
    p.approach = real("pen", pen) * p.units.length();
    p.data.digits.norm = Normal::approach;
  });
}

int cntc_setnormalforce(int* ire, int* icp, double* fn) {
  return guarded(contact_call(__func__, ire, icp), [&](ContactProblem& p) {
    p.normal_force = real("fn", fn);
    p.data.digits.norm = Normal::force;
  });
}

int cntc_setundeformeddistc(int* ire, int* icp, int* ibase, int* nparam, double* prmudf) {
  return set_by(contact_call(__func__, ire, icp), set_distance, "ibase", ibase, "prmudf", nparam, prmudf);
}

int cntc_setcreepages(int* ire, int* icp, double* vx, double* vy, double* phi) {
  return guarded(contact_call(__func__, ire, icp), [&](ContactProblem& p) {
    p.creepages = {real("vx", vx), real("vy", vy), real("phi", phi), p.units.length()};
  });
}

int cntc_setextrarigidslip(int* ire, int* icp, int* lenarr, double* wx, double* wy) {
  return guarded(contact_call(__func__, ire, icp),
                 [&](ContactProblem& p) { set_extra_slip(p, reals("wx", lenarr, wx), reals("wy", lenarr, wy)); });
}

} // extern "C"
} // namespace microslip::libcontact
