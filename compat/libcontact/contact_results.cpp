#include "compat/contact/set_up.hpp"
#include "compat/libcontact/arguments.hpp"
#include "compat/libcontact/call.hpp"
#include "compat/libcontact/defaults.hpp"
#include "microslip/elasticity/material.hpp"

#include <algorithm>
#include <cmath>

// Totals and data of contact problems, and of the patches of wheels.

namespace microslip::libcontact {
namespace {

using namespace contact_program;

std::vector<double> kinematics(const ContactProblem& p, const Contact& c) {
  const double l = p.units.length;
  const RollingData& r = *c.data.rolling;
  const auto& model = c.data.material->model_data;
  const double yield = c.data.digits.mater == Bulk::layer ? model[2] : 0;
  return {r.veloc / p.units.speed, r.chi, r.dq / l, c.data.spin_x / l, c.data.spin_y / l, yield / p.units.pressure()};
}

/// What M adds to the material, where CONTACT has it: flexibilities, K0, ALFA and BETA, K_EFF, the layer's.
std::vector<double> model_parameters(const ContactProblem& p, const MaterialData& m, Bulk model) {
  const double volume = p.units.length / p.units.pressure(), pressure = p.units.pressure();
  const auto& v = m.model_data;
  const double flexibility = default_of("FLX") / volume;
  std::vector<double> found = {flexibility,
                               flexibility,
                               0,
                               default_of("K0_MF"),
                               default_of("ALFAMF"),
                               default_of("BETAMF"),
                               0,
                               default_of("GG3") / pressure,
                               0,
                               0,
                               0};
  if (model == Bulk::fastsim_one) {
    for (std::size_t k = 0; k < 3; ++k) found[k] = v[0] / volume;
    for (std::size_t k = 0; k < 3; ++k) found[3 + k] = v[1 + k];
  }
  if (model == Bulk::fastsim || model == Bulk::fastrip)
    for (std::size_t k = 0; k < 3; ++k) found[3 + k] = v[k];
  if (model == Bulk::layer) {
    for (std::size_t k = 0; k < 3; ++k) found[k] = v[1] / v[0] / volume;
    found[7] = v[0] / pressure;
    found[8] = v[1] / p.units.length;
    found[9] = v[2] / pressure;
    found[10] = v[3] / pressure * p.units.length;
  }
  return found;
}

std::vector<double> material(const ContactProblem& p, const Contact& c) {
  const MaterialData& m = *c.data.material;
  const CombinedMaterial pair = combined_material(c.data);
  const double pressure = p.units.pressure(), g = pair.shear_modulus * newton_per_mm2;
  const double k = g / 4 * ((1 - 2 * m.poisson1) / m.shear1 - (1 - 2 * m.poisson2) / m.shear2);
  std::vector<double> found = {
      m.shear1 / pressure, m.shear2 / pressure, g / pressure, m.poisson1, m.poisson2, pair.poisson_ratio, k};
  const auto model = model_parameters(p, m, c.data.digits.mater);
  found.insert(found.end(), model.begin(), model.end());
  const DampingData d = c.data.damping.value_or(DampingData());
  found.insert(found.end(), {d.normal, d.tangential, d.normal_limit, d.tangential_limit});
  return found;
}

/// FSTAT and FKIN of a set.
std::pair<double, double> coefficients(Law law, const std::vector<double>& set) {
  if (law == Law::coulomb) return {set[0], set[1]};
  if (law == Law::thermal) return {set[0], set[0] + set[2]};
  return {set[0] + set[1] + set[3], set[0]};
}

std::vector<double> friction(const ContactProblem& p) {
  const FrictionData& f = p.data.friction;
  const bool has_memory = f.law != Law::coulomb;
  const auto& first = f.sets[0];
  std::vector<double> found = {static_cast<double>(number(f.law)), static_cast<double>(f.sets.size()),
                               has_memory ? first[first.size() - 2] : 0, has_memory ? first.back() : 0};
  for (std::size_t k = 0; k < f.sets.size(); ++k) {
    const auto [at_rest, kinetic] = coefficients(f.law, f.sets[k]);
    found.insert(found.end(), {f.stations.empty() ? 0 : f.stations[k], at_rest, kinetic});
  }
  return found;
}

std::vector<double> parameters(const ContactProblem& p, const Contact& c, int task) {
  switch (task) {
  case 1:
    return kinematics(p, c);
  case 2:
    return material(p, c);
  case 3:
    return friction(p);
  default:
    throw Refusal(CNTC_err_other, "itask = " + std::to_string(task) + ": must be 1, 2 or 3");
  }
}

/// A1, B1, AA, BB, RHO, CP, SCALE, BNEG, BPOS, AOB.
std::vector<double> hertzian(const ContactProblem& p, const Contact& c) {
  const auto shape = hertzian_shape(c.data, c.outcome.step);
  if (!shape) throw Refusal(CNTC_err_other, "the contact is not a Hertzian one");
  const double l = p.units.length, per_length = l / mm_per_m, length = mm_per_m / l;
  const PotentialContact& potential = *c.data.potential;
  const bool is_halved = potential.kind == Potential::half_ellipses;
  const double sum = shape->gap.x + shape->gap.y;
  return {shape->gap.x * per_length,
          shape->gap.y * per_length,
          shape->a * length,
          shape->b * length,
          sum > 0 ? 2 / sum * length : 0,
          std::sqrt(shape->a * shape->b) * length,
          potential.scale,
          (is_halved ? potential.values[1] : shape->b * mm_per_m) / l,
          (is_halved ? potential.values[2] : shape->b * mm_per_m) / l,
          shape->a / shape->b};
}

/// The largest number of values of cntc_getparameters: friction at ten stations.
constexpr int most_parameters = 4 + 3 * 10;
/// Elements of a potential contact that there is not: callers divide by their numbers.
constexpr int no_columns = default_choice<int>("MX", DefaultOf::contact),
              no_rows = default_choice<int>("MY", DefaultOf::contact);

double largest_traction(const Outcome& o) {
  const auto& [px, py] = o.solution.fields.traction;
  double largest = 0;
  for (std::size_t k = 0; k < px.size(); ++k) largest = std::max(largest, std::hypot(px[k], py[k]));
  return largest;
}

} // namespace
} // namespace microslip::libcontact

using namespace microslip::libcontact;

extern "C" {

int cntc_getparameters(int* ire, int* icp, int* itask, int* lenarr, double* values) {
  return answered(patch_call("cntc_getparameters", ire, icp), into(results(lenarr, values, most_parameters)),
                  [&](ContactProblem& p) {
                    fill(room("values", lenarr, values), parameters(p, p.contact(*icp), integer("itask", itask)));
                  });
}

int cntc_getreferencevelocity(int* ire, int* icp, double* veloc) {
  return answered(patch_call("cntc_getreferencevelocity", ire, icp), into(result(veloc)), [&](ContactProblem& p) {
    given("veloc", veloc) = p.contact(*icp).data.rolling->veloc / p.units.speed;
  });
}

int cntc_gethertzcontact(int* ire, int* icp, int* lenarr, double* values) {
  return answered({"cntc_gethertzcontact", ire, icp, Module::contact, Scope::patch}, into(results(lenarr, values, 10)),
                  [&](ContactProblem& p) { fill(room("values", lenarr, values), hertzian(p, p.contact(*icp))); });
}

int cntc_getnumelements(int* ire, int* icp, int* mx, int* my) {
  return answered(patch_call("cntc_getnumelements", ire, icp), into(result(mx, no_columns), result(my, no_rows)),
                  [&](ContactProblem& p) {
                    const auto& grid = p.contact(*icp).outcome.step.grid;
                    given("my", my) = grid.my;
                    given("mx", mx) = grid.mx;
                  });
}

int cntc_getgriddiscretization(int* ire, int* icp, double* dx, double* dy) {
  return answered({"cntc_getgriddiscretization", ire, icp, Module::any, Scope::either}, into(result(dx), result(dy)),
                  [&](ContactProblem& p) {
                    const bool of_wheel = p.is_wheel() && *icp < 0;
                    const double x = of_wheel ? p.wheel().grid.dx : p.contact(*icp).outcome.step.grid.dx * mm_per_m;
                    const double y = of_wheel ? p.wheel().grid.ds : p.contact(*icp).outcome.step.grid.dy * mm_per_m;
                    given("dy", dy) = y / p.units.length;
                    given("dx", dx) = x / p.units.length;
                  });
}

int cntc_getpotcontact(int* ire, int* icp, int* lenarr, double* values) {
  const auto elements = results<double>(lenarr, values, 2, no_columns);
  return answered(patch_call("cntc_getpotcontact", ire, icp), into(results(lenarr, values, 6), elements),
                  [&](ContactProblem& p) {
                    const auto& g = p.contact(*icp).outcome.step.grid;
                    const double length = mm_per_m / p.units.length;
                    fill(room("values", lenarr, values), {static_cast<double>(g.mx), static_cast<double>(g.my),
                                                          g.x0 * length, g.y0 * length, g.dx * length, g.dy * length});
                  });
}

int cntc_getpenetration(int* ire, int* icp, double* pen) {
  return answered(patch_call("cntc_getpenetration", ire, icp), into(result(pen)), [&](ContactProblem& p) {
    given("pen", pen) = p.contact(*icp).outcome.totals.approach / p.units.length;
  });
}

int cntc_getcreepages(int* ire, int* icp, double* vx, double* vy, double* phi) {
  return answered(patch_call("cntc_getcreepages", ire, icp), into(result(vx), result(vy), result(phi)),
                  [&](ContactProblem& p) {
                    using namespace microslip::contact_program;
                    const Contact c = p.contact(*icp);
                    const bool shifts = c.data.digits.tang == Tangential::shift;
                    const double unit = shifts ? 1 / p.units.length : 1, turn = shifts ? 1 : p.units.length;
                    const PrintedTotals& t = c.outcome.totals;
                    const auto *given_x = std::get_if<Slip>(&c.data.x), *given_y = std::get_if<Slip>(&c.data.y);
                    const double x = given_x ? given_x->value : t.x, y = given_y ? given_y->value : t.y;
                    given("phi", phi) = p.units.body * turn * c.data.phi;
                    given("vy", vy) = p.units.body * unit * y;
                    given("vx", vx) = p.units.body * unit * x;
                  });
}

int cntc_getcontactforces(int* ire, int* icp, double* fn, double* tx, double* ty, double* mz) {
  return answered(patch_call("cntc_getcontactforces", ire, icp), into(result(fn), result(tx), result(ty), result(mz)),
                  [&](ContactProblem& p) {
                    const auto& t = p.contact(*icp).outcome.totals;
                    given("mz", mz) = p.units.body * t.mz / p.units.length;
                    given("ty", ty) = p.units.body * t.fy;
                    given("tx", tx) = p.units.body * t.fx;
                    given("fn", fn) = t.fn;
                  });
}

int cntc_getcontactpatchareas(int* ire, int* icp, double* carea, double* harea, double* sarea) {
  return answered(patch_call("cntc_getcontactpatchareas", ire, icp), into(result(carea), result(harea), result(sarea)),
                  [&](ContactProblem& p) {
                    const auto& o = p.contact(*icp).outcome;
                    const double element = o.step.grid.element_area() * mm_per_m * mm_per_m / p.units.area();
                    given("sarea", sarea) = o.totals.slip * element;
                    given("harea", harea) = o.totals.adhesion * element;
                    given("carea", carea) = o.totals.contact * element;
                  });
}

int cntc_getmaximumpressure(int* ire, int* icp, double* pnmax) {
  return answered(patch_call("cntc_getmaximumpressure", ire, icp), into(result(pnmax)), [&](ContactProblem& p) {
    given("pnmax", pnmax) = p.contact(*icp).outcome.totals.peak_pressure / p.units.pressure();
  });
}

int cntc_getmaximumtraction(int* ire, int* icp, double* ptmax) {
  return answered(patch_call("cntc_getmaximumtraction", ire, icp), into(result(ptmax)), [&](ContactProblem& p) {
    given("ptmax", ptmax) = largest_traction(p.contact(*icp).outcome) * newton_per_mm2 / p.units.pressure();
  });
}

int cntc_getmaximumtemperature(int* ire, int* icp, double* t1max, double* t2max) {
  return answered(patch_call("cntc_getmaximumtemperature", ire, icp), into(result(t1max), result(t2max)),
                  [&](ContactProblem& p) {
                    const Outcome& o = p.contact(*icp).outcome;
                    double &first = given("t1max", t1max), &second = given("t2max", t2max);
                    if (!o.has_temperatures())
                      throw Refusal(CNTC_err_other, "there are no temperatures without H > 0 and T = 3");
                    first = *std::ranges::max_element(o.solution.fields.temperature1);
                    second = *std::ranges::max_element(o.solution.fields.temperature2);
                  });
}

int cntc_getsensitivities(int* ire, int* icp, int* lenout, int* lenin, double* sens) {
  return answered(
      patch_call("cntc_getsensitivities", ire, icp), into(results(lenout, lenin, sens)), [&](ContactProblem& p) {
        const Sensitivities& table = p.sensitivities(*icp);
        const int outputs = integer("lenout", lenout), inputs = integer("lenin", lenin);
        constexpr int most = 1000;
        if (outputs < 0 || inputs < 0 || outputs > most || inputs > most)
          throw Refusal(CNTC_err_other, "lenout and lenin must be in 0 to 1000");
        const int count = outputs * inputs;
        const auto found = room("sens", &count, sens);
        const bool shifts = p.contact(*icp).data.digits.tang == microslip::contact_program::Tangential::shift;
        const double l = p.units.length, of_input[] = {l, shifts ? l : 1, shifts ? l : 1, shifts ? 1 : 1 / l};
        const double of_output[] = {1, 1, 1, l};
        for (std::size_t i = 0; i < 4; ++i)
          for (std::size_t o = 0; o < 4; ++o)
            if (int(i) < inputs && int(o) < outputs)
              found[o + i * static_cast<std::size_t>(outputs)] = table[o][i] * of_input[i] / of_output[o];
      });
}

} // extern "C"

LIBCONTACT_UNDERSCORED(cntc_getparameters)
LIBCONTACT_UNDERSCORED(cntc_getreferencevelocity)
LIBCONTACT_UNDERSCORED(cntc_gethertzcontact)
LIBCONTACT_UNDERSCORED(cntc_getnumelements)
LIBCONTACT_UNDERSCORED(cntc_getgriddiscretization)
LIBCONTACT_UNDERSCORED(cntc_getpotcontact)
LIBCONTACT_UNDERSCORED(cntc_getpenetration)
LIBCONTACT_UNDERSCORED(cntc_getcreepages)
LIBCONTACT_UNDERSCORED(cntc_getcontactforces)
LIBCONTACT_UNDERSCORED(cntc_getcontactpatchareas)
LIBCONTACT_UNDERSCORED(cntc_getmaximumpressure)
LIBCONTACT_UNDERSCORED(cntc_getmaximumtraction)
LIBCONTACT_UNDERSCORED(cntc_getmaximumtemperature)
LIBCONTACT_UNDERSCORED(cntc_getsensitivities)
