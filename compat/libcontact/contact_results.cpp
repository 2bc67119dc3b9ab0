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
  const double per_length = p.units.per_length();
  const RollingData& r = *c.data.rolling;
  const auto& model = c.data.material->model_data;
  const double yield = c.data.digits.mater == Bulk::layer ? model[2] : 0;
  return {r.veloc * per_length,       r.chi,
          r.dq * per_length,          c.data.spin_x * per_length,
          c.data.spin_y * per_length, yield * p.units.per_pressure()};
}

/// What M adds to the material, where CONTACT has it: flexibilities, K0, ALFA and BETA, K_EFF, the layer's.
std::vector<double> model_parameters(const ContactProblem& p, const MaterialData& m, Bulk model) {
  const double volume = p.units.length() / p.units.pressure(), pressure = p.units.pressure();
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
    found[8] = v[1] / p.units.length();
    found[9] = v[2] / pressure;
    found[10] = v[3] / pressure * p.units.length();
  }
  return found;
}

std::vector<double> material(const ContactProblem& p, const Contact& c) {
  const MaterialData& m = *c.data.material;
  const CombinedMaterial pair = combined_material(c.data);
  const double per_pressure = p.units.per_pressure(), g = pair.shear_modulus;
  const double k = g / 4 * ((1 - 2 * m.poisson1) / m.shear1 - (1 - 2 * m.poisson2) / m.shear2);
  std::vector<double> found = {m.shear1 * per_pressure,
                               m.shear2 * per_pressure,
                               g * per_pressure,
                               m.poisson1,
                               m.poisson2,
                               pair.poisson_ratio,
                               k};
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
  const bool along = p.is_wheel() && p.wheel().digits.varfrc == FrictionStations::along_track;
  const double unit_of_station = along ? mm : 1; // in mm, as the memory, whatever the units
  std::vector<double> found = {static_cast<double>(number(f.law)), static_cast<double>(f.sets.size()),
                               has_memory ? first[first.size() - 2] / mm : 0, has_memory ? first.back() / mm : 0};
  for (std::size_t k = 0; k < f.sets.size(); ++k) {
    const auto [at_rest, kinetic] = coefficients(f.law, f.sets[k]);
    found.insert(found.end(), {f.stations.empty() ? 0 : f.stations[k] / unit_of_station, at_rest, kinetic});
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
  const double per_length = p.units.length(), length = p.units.per_length();
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
          (is_halved ? potential.values[1] : shape->b) * length,
          (is_halved ? potential.values[2] : shape->b) * length,
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

extern "C" {

int cntc_getparameters(int* ire, int* icp, int* itask, int* lenarr, double* values) {
  const auto find = [&](ContactProblem& p) { return parameters(p, p.contact(*icp), integer("itask", itask)); };
  return get_array(patch_call(__func__, ire, icp), lenarr, values, find, most_parameters);
}

int cntc_getreferencevelocity(int* ire, int* icp, double* veloc) {
  return get_numbers<double>(patch_call(__func__, ire, icp), {{"veloc", veloc}}, [&](ContactProblem& p) {
    return std::array{p.contact(*icp).data.rolling->veloc * p.units.per_length()};
  });
}

int cntc_gethertzcontact(int* ire, int* icp, int* lenarr, double* values) {
  const auto find = [&](ContactProblem& p) { return hertzian(p, p.contact(*icp)); };
  return get_array(contact_call(__func__, ire, icp), lenarr, values, find, 10);
}

int cntc_getnumelements(int* ire, int* icp, int* mx, int* my) {
  return get_numbers<int>(patch_call(__func__, ire, icp), {{"mx", mx, no_columns}, {"my", my, no_rows}},
                          [&](ContactProblem& p) {
                            const auto& grid = p.contact(*icp).outcome.step.grid;
                            return std::array{grid.mx, grid.my};
                          });
}

int cntc_getgriddiscretization(int* ire, int* icp, double* dx, double* dy) {
  return get_numbers<double>(either_call(__func__, ire, icp), {{"dx", dx}, {"dy", dy}}, [&](ContactProblem& p) {
    if (p.is_wheel() && *icp < 0)
      return std::array{p.wheel().grid.dx * p.units.per_length(), p.wheel().grid.ds * p.units.per_length()};
    const auto& g = p.contact(*icp).outcome.step.grid;
    return std::array{g.dx * p.units.per_length(), g.dy * p.units.per_length()};
  });
}

int cntc_getpotcontact(int* ire, int* icp, int* lenarr, double* values) {
  const auto elements = results<double>(lenarr, values, 2, no_columns);
  return answered(patch_call(__func__, ire, icp), into(results(lenarr, values, 6), elements), [&](ContactProblem& p) {
    const auto& g = p.contact(*icp).outcome.step.grid;
    const double length = p.units.per_length();
    fill(room("values", lenarr, values),
         {double(g.mx), double(g.my), g.x0 * length, g.y0 * length, g.dx * length, g.dy * length});
  });
}

int cntc_getpenetration(int* ire, int* icp, double* pen) {
  return get_numbers<double>(patch_call(__func__, ire, icp), {{"pen", pen}}, [&](ContactProblem& p) {
    return std::array{p.contact(*icp).outcome.solution.normal.approach * p.units.per_length()};
  });
}

int cntc_getcreepages(int* ire, int* icp, double* vx, double* vy, double* phi) {
  return get_numbers<double>(
      patch_call(__func__, ire, icp), {{"vx", vx}, {"vy", vy}, {"phi", phi}}, [&](ContactProblem& p) {
        const Contact c = p.contact(*icp);
        const bool shifts = c.data.digits.tang == Tangential::shift;
        const double unit = shifts ? p.units.per_length() : 1, turn = shifts ? 1 : p.units.length();
        const PrintedTotals& t = c.outcome.totals;
        const auto *given_x = std::get_if<Slip>(&c.data.x), *given_y = std::get_if<Slip>(&c.data.y);
        const double x = given_x ? given_x->value : shifts ? t.x * mm : t.x;
        const double y = given_y ? given_y->value : shifts ? t.y * mm : t.y;
        return std::array{p.units.body * unit * x, p.units.body * unit * y, p.units.body * turn * c.data.phi};
      });
}

int cntc_getcontactforces(int* ire, int* icp, double* fn, double* tx, double* ty, double* mz) {
  return get_numbers<double>(
      patch_call(__func__, ire, icp), {{"fn", fn}, {"tx", tx}, {"ty", ty}, {"mz", mz}}, [&](ContactProblem& p) {
        const auto& t = p.contact(*icp).outcome.totals;
        const double body = p.units.body;
        return std::array{t.fn, body * t.fx, body * t.fy, body * t.mz * (mm * p.units.per_length())};
      });
}

int cntc_getcontactpatchareas(int* ire, int* icp, double* carea, double* harea, double* sarea) {
  return get_numbers<double>(
      patch_call(__func__, ire, icp), {{"carea", carea}, {"harea", harea}, {"sarea", sarea}}, [&](ContactProblem& p) {
        const auto& o = p.contact(*icp).outcome;
        const double element = o.step.grid.element_area() * p.units.per_length() * p.units.per_length();
        return std::array{o.totals.contact * element, o.totals.adhesion * element, o.totals.slip * element};
      });
}

int cntc_getmaximumpressure(int* ire, int* icp, double* pnmax) {
  return get_numbers<double>(patch_call(__func__, ire, icp), {{"pnmax", pnmax}}, [&](ContactProblem& p) {
    return std::array{p.contact(*icp).outcome.solution.normal.peak_pressure * p.units.per_pressure()};
  });
}

int cntc_getmaximumtraction(int* ire, int* icp, double* ptmax) {
  return get_numbers<double>(patch_call(__func__, ire, icp), {{"ptmax", ptmax}}, [&](ContactProblem& p) {
    return std::array{largest_traction(p.contact(*icp).outcome) * p.units.per_pressure()};
  });
}

int cntc_getmaximumtemperature(int* ire, int* icp, double* t1max, double* t2max) {
  return get_numbers<double>(patch_call(__func__, ire, icp), {{"t1max", t1max}, {"t2max", t2max}},
                             [&](ContactProblem& p) {
                               const Outcome& o = p.contact(*icp).outcome;
                               if (!o.has_temperatures())
                                 throw Refusal(CNTC_err_other, "there are no temperatures without H > 0 and T = 3");
                               const auto& f = o.solution.fields;
                               return std::array{std::ranges::max(f.temperature1), std::ranges::max(f.temperature2)};
                             });
}

int cntc_getsensitivities(int* ire, int* icp, int* lenout, int* lenin, double* sens) {
  return answered(patch_call(__func__, ire, icp), into(results(lenout, lenin, sens)), [&](ContactProblem& p) {
    const Sensitivities& table = p.sensitivities(*icp);
    const int outputs = integer("lenout", lenout), inputs = integer("lenin", lenin);
    constexpr int most = 1000;
    if (outputs < 0 || inputs < 0 || outputs > most || inputs > most)
      throw Refusal(CNTC_err_other, "lenout and lenin must be in 0 to 1000");
    const int count = outputs * inputs;
    const auto found = room("sens", &count, sens);
    const bool shifts = p.contact(*icp).data.digits.tang == Tangential::shift;
    const double l = p.units.length() * per_m, of_input[] = {l, shifts ? l : 1, shifts ? l : 1, shifts ? 1 : 1 / l};
    const double of_output[] = {1, 1, 1, l};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t o = 0; o < 4; ++o)
        if (int(i) < inputs && int(o) < outputs)
          found[o + i * static_cast<std::size_t>(outputs)] = table[o][i] * of_input[i] / of_output[o];
  });
}

} // extern "C"
} // namespace microslip::libcontact
