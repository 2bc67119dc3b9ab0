#include "compat/contact/plastic_deformation.hpp"
#include "compat/libcontact/arguments.hpp"
#include "compat/libcontact/call.hpp"
#include "microslip/exact/classical/tangential_totals.hpp"

#include <functional>

// Fields of the elements of a potential contact, x fastest.

namespace microslip::libcontact {
namespace {

using namespace contact_program;

/// An element's value of a field.
using Value = std::function<double(std::size_t)>;

/// Of an array that holds none where there are no tractions.
Value scaled(const std::vector<double>& field, double factor) {
  if (field.empty()) return [](std::size_t) { return 0.0; };
  return [&field, factor](std::size_t k) { return factor * field[k]; };
}

/// The rigid slip in x or y, with the extra one: w = (xi - phi y, eta + phi x), taken some distance ahead.
Value rigid_slip(const Outcome& o, bool in_x, double factor) {
  const auto& motion = o.step.motion;
  const bool shifts = motion.motion == ContactMotion::shift;
  const Vec2 ahead =
      shifts || o.step.frictionless ? Vec2{} : way_of(motion, motion.spin_offset * signed_step(motion, o.step.grid));
  const Creepage creepage = o.solution.creepage;
  return [&o, in_x, factor, ahead, creepage](std::size_t k) {
    const ElementGrid& g = o.step.grid;
    const auto row = static_cast<std::size_t>(g.mx);
    const double x = g.x(static_cast<int>(k % row)) + ahead.x, y = g.y(static_cast<int>(k / row)) + ahead.y;
    const auto& extra = in_x ? o.step.extra_slip_x : o.step.extra_slip_y;
    const double slip = in_x ? creepage.longitudinal - creepage.spin * y : creepage.lateral + creepage.spin * x;
    return factor * (slip + (extra.empty() ? 0 : extra[k]));
  };
}

/// Where a layer yields after what it has yielded, tau_c = tau_c0 + k_tau u_pl; 0 where it never does.
Value yield_stress(const Contact& c, double pressure) {
  if (c.data.digits.mater != Bulk::layer) throw Refusal(CNTC_err_other, "there is no layer, M = 4");
  const InterfaceLayer& layer = c.outcome.step.bodies.layer;
  const auto& plastic = c.outcome.solution.slip_friction.deformation;
  const double untouched = layer.yields() ? layer.yield_stress : 0;
  return [&layer, &plastic, untouched, pressure](std::size_t k) {
    return pressure * (plastic.empty() ? untouched : layer.yield_stress_after(plastic[k]));
  };
}

Value plastic(const Contact& c, bool in_x, double length) {
  const auto found = plastic_deformation(c.data, c.outcome);
  if (!found) throw Refusal(CNTC_err_other, "the direction of plastic deformation of cases before is not kept");
  return [field = in_x ? found->x : found->y, length](std::size_t k) { return length * field[k]; };
}

/// Of one of CNTC_fld_...
Value field(const ContactProblem& p, const Contact& c, int code) {
  const Outcome& o = c.outcome;
  const SurfaceFields& f = o.solution.fields;
  const double length = p.units.per_length(), pressure = p.units.per_pressure();
  // Of a shift the slip is a distance in mm, whatever the units.
  const double slip = p.units.body * (c.data.digits.tang == Tangential::shift ? per_m : 1);
  switch (code) {
  case CNTC_fld_h:
    return [&o, length](std::size_t k) { return length * (o.step.gap[k] - o.solution.approach); };
  case CNTC_fld_mu:
    return scaled(f.friction, 1);
  case CNTC_fld_px:
    return scaled(f.traction.x, p.units.body * pressure);
  case CNTC_fld_py:
    return scaled(f.traction.y, p.units.body * pressure);
  case CNTC_fld_pn:
    return scaled(f.pressure, pressure);
  case CNTC_fld_ux:
    return scaled(f.displacement.x, length);
  case CNTC_fld_uy:
    return scaled(f.displacement.y, length);
  case CNTC_fld_un:
    return scaled(o.solution.normal.displacement, length);
  case CNTC_fld_taucrt:
    return yield_stress(c, pressure);
  case CNTC_fld_sx:
    return scaled(f.slip.x, slip);
  case CNTC_fld_sy:
    return scaled(f.slip.y, slip);
  case CNTC_fld_wx:
    return rigid_slip(o, true, slip);
  case CNTC_fld_wy:
    return rigid_slip(o, false, slip);
  case CNTC_fld_temp1:
  case CNTC_fld_temp2:
    if (!o.has_temperatures()) throw Refusal(CNTC_err_other, "there are no temperatures without H > 0 and T = 3");
    return scaled(code == CNTC_fld_temp1 ? f.temperature1 : f.temperature2, 1);
  case CNTC_fld_uplsx:
  case CNTC_fld_uplsy:
    return plastic(c, code == CNTC_fld_uplsx, length);
  default:
    throw Refusal(CNTC_err_other, "field " + std::to_string(code) + " does not exist");
  }
}

/// 0 exterior, 1 adhesion, 2 slip, 3 where a layer yields.
int division_of(const Outcome& o, std::size_t k) {
  const int state = element_state(o, k);
  const auto& yields = o.solution.slip_friction.yields;
  return state == 2 && o.totals.plastic && !yields.empty() && yields[k] ? 3 : state;
}

void get_field(const ContactProblem& p, int icp, int code, std::span<double> found) {
  const Contact c = p.contact(icp);
  const Value value = field(p, c, code);
  for (std::size_t k = 0; k < found.size() && k < c.outcome.step.grid.count(); ++k) found[k] = value(k);
}

/// An array that a field is to be written to: its name in messages, and one of CNTC_fld_...
struct Wanted {
  const char* name;
  int code;
  double* to;
};

/// Writes fields of a patch once there is room for all of them.
template <class... Fields> int fields(const char* call, int* ire, int* icp, int* lenarr, const Fields&... wanted) {
  return answered(patch_call(call, ire, icp), into(results(lenarr, wanted.to)...), [&](ContactProblem& p) {
    const std::span<double> rooms[] = {room(wanted.name, lenarr, wanted.to)...};
    const auto* to = rooms;
    (get_field(p, *icp, wanted.code, *to++), ...);
  });
}

} // namespace

extern "C" {

int cntc_getfielddata(int* ire, int* icp, int* ifld, int* lenarr, double* fld) {
  return answered(patch_call(__func__, ire, icp), into(results(lenarr, fld)),
                  [&](ContactProblem& p) { get_field(p, *icp, integer("ifld", ifld), room("fld", lenarr, fld)); });
}

int cntc_gettractions(int* ire, int* icp, int* lenarr, double* pn, double* px, double* py) {
  return fields(__func__, ire, icp, lenarr, Wanted{"pn", CNTC_fld_pn, pn}, Wanted{"px", CNTC_fld_px, px},
                Wanted{"py", CNTC_fld_py, py});
}

int cntc_getmicroslip(int* ire, int* icp, int* lenarr, double* sx, double* sy) {
  return fields(__func__, ire, icp, lenarr, Wanted{"sx", CNTC_fld_sx, sx}, Wanted{"sy", CNTC_fld_sy, sy});
}

int cntc_getdisplacements(int* ire, int* icp, int* lenarr, double* un, double* ux, double* uy) {
  return fields(__func__, ire, icp, lenarr, Wanted{"un", CNTC_fld_un, un}, Wanted{"ux", CNTC_fld_ux, ux},
                Wanted{"uy", CNTC_fld_uy, uy});
}

int cntc_getelementdivision(int* ire, int* icp, int* lenarr, int* eldiv) {
  return answered(patch_call(__func__, ire, icp), into(results(lenarr, eldiv)), [&](ContactProblem& p) {
    const Contact c = p.contact(*icp);
    const auto found = room("eldiv", lenarr, eldiv);
    for (std::size_t k = 0; k < found.size() && k < c.outcome.step.grid.count(); ++k)
      found[k] = division_of(c.outcome, k);
  });
}

} // extern "C"
} // namespace microslip::libcontact
