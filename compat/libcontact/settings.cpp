#include "compat/libcontact/arguments.hpp"
#include "compat/libcontact/call.hpp"
#include "compat/libcontact/defaults.hpp"
#include "microslip/contact/limits.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

// What both modules are set by: solvers, material, friction, heat, and the elements.

namespace microslip::libcontact {
namespace {

using namespace contact_program;

constexpr double least = 1e-6; ///< of coefficients of friction and of what M adds to the material

void set_solver(ContactProblem& p, int method, std::span<const int> counts, std::span<const double> numbers) {
  constexpr std::size_t most_counts[] = {4, 0, 5, 5, 5, 5, 1}, most_numbers[] = {1, 0, 4, 4, 2, 8, 1};
  if (method < 0 || method > 6) throw Refusal(CNTC_err_other, "G = " + std::to_string(method) + " does not exist");
  require_count("iparam", counts.size(), most_counts[method], most_counts[method]);
  require_count("rparam", numbers.size(), most_numbers[method], most_numbers[method]);
  SolverData& s = p.data.solver;
  constexpr double least_positive = 1e-20;
  if (method == 1) return;
  if (method == 6) {
    p.sensitivity.relative_step = std::clamp(numbers[0], 1e-8, 0.1);
    return;
  }
  s.method = p.data.digits.gausei = static_cast<SolverChoice>(method);
  s.eps = std::max(least_positive, numbers[0]);
  constexpr int SolverData::*limits[] = {&SolverData::maxgs, &SolverData::maxin, &SolverData::maxnr,
                                         &SolverData::maxout};
  for (std::size_t k = 0; k < std::size(limits); ++k) s.*limits[k] = std::max(1, counts[k]);
  if (s.starts_from_slip()) {
    s.inislp = counts[4];
    s.omgslp = std::max(least_positive, numbers.back());
  }
  if (s.method == SolverChoice::convex_gs || s.method == SolverChoice::steady_gs) {
    s.omegah = std::max(least_positive, numbers[1]);
    s.omegas = std::max(least_positive, numbers[2]);
  }
}

/// POISS1, POISS2, GG1, GG2.
void set_elasticity(ContactProblem& p, double nu1, double nu2, double g1, double g2) {
  MaterialData& m = *p.data.material;
  for (const double nu : {nu1, nu2})
    if (!(nu >= 0 && nu <= 0.5))
      throw Refusal(CNTC_err_other, "Poisson's ratio " + std::to_string(nu) + ": must be in [0, 0.5]");
  for (const double g : {g1, g2})
    if (!(g > 0)) throw Refusal(CNTC_err_other, "modulus of rigidity " + std::to_string(g) + ": must be > 0");
  m.poisson1 = nu1;
  m.poisson2 = nu2;
  m.shear1 = g1 * p.units.pressure();
  m.shear2 = g2 * p.units.pressure();
}

/// What M adds to them.
std::vector<double> model_data(const Units& u, Bulk model, std::span<const double> v) {
  constexpr double endless = 1e16, least_thickness = 1e-12; // [Pa], [m]
  auto data = u.in_si(v, units_of_model(model));
  if (model == Bulk::layer) {
    data = {std::max(newton_per_mm2 * least, data[0]), std::max(least_thickness, data[1]),
            data[2] >= endless ? 0 : data[2], data[3]};
  } else if (model != Bulk::viscoelastic) { // K0_MF, ALFAMF, BETAMF, behind FLX with M = 2
    for (std::size_t k = model == Bulk::fastsim_one; k < data.size(); ++k) data[k] = std::max(least, data[k]);
  }
  return data;
}

/// CDAMPN, CDAMPT, DFNMAX, DFTMAX.
void set_damping(ContactProblem& p, int method, std::span<const double> v) {
  if (method == 0) {
    p.data.damping.reset();
    p.data.digits.damping = Damping::none;
  }
  if (method != 2) return;
  require_count("rparam", v.size(), 4, 4);
  for (const double value : v)
    if (!(value >= 0)) throw Refusal(CNTC_err_other, "data of damping must not be negative");
  p.data.damping = DampingData{v[0], v[1], v[2], v[3]};
  p.data.digits.damping = Damping::read;
}

void set_material(ContactProblem& p, int method, std::span<const double> v) {
  constexpr std::size_t counts[] = {4, 8, 8, 7, 8, 7};
  if (method >= 10 && method <= 12) {
    set_damping(p, method - 10, v);
    return;
  }
  if (method < 0 || method > 5) throw Refusal(CNTC_err_other, "M = " + std::to_string(method) + " does not exist");
  require_count("rparam", v.size(), counts[method], counts[method]);
  set_elasticity(p, v[0], v[1], v[2], v[3]);
  const auto model = static_cast<Bulk>(method);
  p.data.digits.mater = p.data.material->model = model;
  p.data.material->model_data = model_data(p.units, model, v.subspan(4));
}

/// BKTEMP, HEATCP, LAMBDA, DENS of both bodies, and BETAPL, which early versions did not have.
void set_heat(ContactProblem& p, int method, std::span<const double> v) {
  if (method == 1 && !p.data.heat) throw Refusal(CNTC_err_other, "H = 1: there are no data to keep");
  if (method == 0 || method == 1) {
    p.data.digits.heat = static_cast<Heat>(method);
    return;
  }
  if (method != 3) throw Refusal(CNTC_err_other, "H = " + std::to_string(method) + " does not exist");
  require_count("rparam", v.size(), 8, 9);
  HeatData heat;
  for (std::size_t body = 0; body < 2; ++body) {
    const auto data = p.units.in_si(v.subspan(4 * body, 4), units_of_heat);
    if (!(data[1] > 0 && data[2] > 0 && data[3] > 0))
      throw Refusal(CNTC_err_other, "HEATCP, LAMBDA and DENS must be > 0");
    std::copy(data.begin(), data.end(), (body == 0 ? heat.body1 : heat.body2).begin());
  }
  heat.plastic_share = v.size() > 8 ? v[8] : default_of("BETAPL");
  p.data.heat = heat;
  p.data.digits.heat = Heat::read;
}

constexpr int polach = 5;
constexpr std::size_t friction_counts[] = {2, 0, 7, 7, 7, 3, 6}; ///< by L

/// Polach's law mu = mu0 ((1 - A) exp(-B s) + A) as an exponential one, as in CONTACT.
std::vector<double> polach_set(const Units& u, std::span<const double> v) {
  const double at_rest = std::max(least, v[0]), share = std::clamp(v[1], 0.0, 1.0), b = v[2] / u.length();
  if (!(b > 0)) throw Refusal(CNTC_err_frclaw, "Polach's B must be > 0");
  return {share * at_rest,      (1 - share) * at_rest, std::numbers::ln2 / b, 0,
          default_of("SABSH2"), default_of("MEMDST"),  default_of("MEM_S0")};
}

std::vector<double> friction_set(const Units& u, int law, std::span<const double> v) {
  constexpr double least_speed = 1e-7; // [m/s]
  if (law == polach) return polach_set(u, v);
  auto set = u.in_si(v, units_of_friction(static_cast<Law>(law)));
  if (law == number(Law::coulomb)) set[0] = set[1] = std::min(set[0], set[1]);
  set[0] = std::max(least, set[0]);
  if (law == number(Law::coulomb)) return {set[0], set[0]};
  if (law == number(Law::thermal)) {
    if (!(set[3] > 0)) throw Refusal(CNTC_err_frclaw, "DTHEAT must be > 0");
    set[2] = std::max(least - set[0], set[2]);
  } else {
    for (const std::size_t k : {1u, 3u}) set[k] = std::max(0.0, set[k]);
    for (const std::size_t k : {2u, 4u}) set[k] = std::max(least_speed, set[k]);
  }
  for (double* memory : {&set[set.size() - 2], &set.back()}) *memory = std::max(0.0, *memory);
  return set;
}

void set_friction(ContactProblem& p, int method, std::span<const double> v) {
  const int by = method / 10, law = method % 10;
  if (method < 0 || by > 2 || law > 6)
    throw Refusal(CNTC_err_frclaw, "method " + std::to_string(method) + " does not exist");
  if (law == 1) return;
  if (by > 0 && !p.is_wheel()) throw Refusal(CNTC_err_frclaw, "V = 1 and 2 are not for module 3");
  const std::size_t count = friction_counts[law];
  FrictionData friction;
  friction.law = law == polach ? Law::exponential : static_cast<Law>(law);
  if (by == 0) {
    require_count("params", v.size(), count, count);
    friction.sets = {friction_set(p.units, law, v)};
  } else {
    constexpr int most_stations = 10;
    if (v.empty()) throw Refusal(CNTC_err_frclaw, "NVF is missing");
    const auto stations = static_cast<std::size_t>(as_integer("NVF", v[0], 1, most_stations));
    require_count("params", v.size(), 1 + stations * (1 + count), 1 + stations * (1 + count));
    for (std::size_t k = 0; k < stations; ++k) {
      const auto station = v.subspan(1 + k * (1 + count), 1 + count);
      const double at = by == 1 ? station[0] : station[0] * p.units.length();
      if (k > 0 && !(at > friction.stations.back())) throw Refusal(CNTC_err_frclaw, "stations must be ascending");
      friction.stations.push_back(at);
      friction.sets.push_back(friction_set(p.units, law, station.subspan(1)));
    }
  }
  p.data.friction = friction;
  p.data.digits.frclaw = friction.law;
  if (p.is_wheel()) p.wheel().digits.varfrc = static_cast<FrictionStations>(by);
}

/// DX, DS and the rules by which patches are joined.
void set_patch_rules(ContactProblem& p, int method, std::span<const double> v) {
  if (method != 0 && method != -1)
    throw Refusal(CNTC_err_discr, "method " + std::to_string(method) + " does not exist");
  require_count("rparam", v.size(), method == 0 ? 3 : 5, method == 0 ? 3 : 7);
  constexpr double least_size = 1e-11; // [m]
  PatchRules rules = p.wheel().grid;
  const double l = p.units.length();
  rules.dx = v[0] * l;
  rules.ds = v[1] * l;
  if (!(rules.dx >= least_size && rules.ds >= least_size)) throw Refusal(CNTC_err_discr, "DX and DS must be > 0");
  if (method == -1) {
    rules.a_sep = std::max(0.0, v[2]);
    rules.d_sep = std::max(0.0, v[3] * l);
    rules.d_comb = std::max(0.0, v[4] * l);
    if (rules.d_comb > rules.d_sep) throw Refusal(CNTC_err_discr, "D_COMB must not be above D_SEP");
    rules.d_turn = v.size() > 5 ? std::max(0.0, v[5] * l) : 2 * rules.d_sep - rules.d_comb;
    rules.g_miss = v.size() > 6 ? v[6] * l : default_of("G_MISS", DefaultOf::wheel);
  }
  p.wheel().grid = rules;
}

void set_rectangle(ContactProblem& p, int method, std::span<const double> v) {
  if (method < 1 || method > 4) throw Refusal(CNTC_err_discr, "IPOTCN = " + std::to_string(method) + " does not exist");
  require_count("rparam", v.size(), 6, 6);
  PotentialContact potential;
  potential.kind = static_cast<Potential>(method);
  potential.mx = as_integer("MX", v[0], 1, most_cells);
  potential.my = as_integer("MY", v[1], 1, most_cells);
  for (std::size_t k = 0; k < 4; ++k) potential.values[k] = v[2 + k] * p.units.length();
  const bool has_sizes = potential.kind == Potential::corner_and_size || potential.kind == Potential::centre_and_size;
  for (std::size_t k = 0; k < 2; ++k) {
    const bool single = potential.kind == Potential::centres && (k == 0 ? potential.mx : potential.my) == 1;
    const double size = has_sizes ? potential.values[2 + k] : potential.values[2 + k] - potential.values[k];
    if (!(size > 0) || single) throw Refusal(CNTC_err_discr, "the elements have no size");
  }
  p.data.potential = potential;
}

} // namespace

extern "C" {

int cntc_setsolverflags(int* ire, int* icp, int* gdigit, int* nints, int* iparam, int* nreals, double* rparam) {
  return guarded(problem_call(__func__, ire, icp), [&](ContactProblem& p) {
    set_solver(p, integer("gdigit", gdigit), integers("iparam", nints, iparam), reals("rparam", nreals, rparam));
  });
}

int cntc_setmaterialparameters(int* ire, int* icp, int* mdigit, int* nparam, double* rparam) {
  return set_by(problem_call(__func__, ire, icp), set_material, "mdigit", mdigit, "rparam", nparam, rparam);
}

int cntc_setmaterialproperties(int* ire, int* icp, double* g1, double* nu1, double* g2, double* nu2) {
  return guarded(problem_call(__func__, ire, icp), [&](ContactProblem& p) {
    set_elasticity(p, real("nu1", nu1), real("nu2", nu2), real("g1", g1), real("g2", g2));
  });
}

int cntc_settemperaturedata(int* ire, int* icp, int* imeth, int* nparam, double* rparam) {
  return set_by(problem_call(__func__, ire, icp), set_heat, "imeth", imeth, "rparam", nparam, rparam);
}

int cntc_settimestep(int* ire, int* icp, double* dt) {
  return guarded(problem_call(__func__, ire, icp), [&](ContactProblem& p) {
    if (!(real("dt", dt) > 0)) throw Refusal(CNTC_err_other, "dt must be > 0");
    p.time_step = *dt;
  });
}

int cntc_setrollingstepsize(int* ire, int* icp, double* chi, double* dq) {
  return guarded(problem_call(__func__, ire, icp), [&](ContactProblem& p) {
    if (!(real("dq", dq) > 0)) throw Refusal(CNTC_err_discr, "dq must be > 0");
    if (p.is_wheel()) {
      p.wheel().grid.dqrel = *dq;
      return;
    }
    p.data.rolling->chi = real("chi", chi);
    p.data.rolling->dq = *dq * p.units.length();
  });
}

int cntc_setfrictionmethod(int* ire, int* icp, int* imeth, int* nparam, double* params) {
  return set_by(problem_call(__func__, ire, icp), set_friction, "imeth", imeth, "params", nparam, params);
}

int cntc_setpotcontact(int* ire, int* icp, int* ipotcn, int* nparam, double* rparam) {
  return guarded(problem_call(__func__, ire, icp), [&](ContactProblem& p) {
    const auto set = p.is_wheel() ? set_patch_rules : set_rectangle;
    set(p, integer("ipotcn", ipotcn), reals("rparam", nparam, rparam));
  });
}

int cntc_settangentialforces(int* ire, int* icp, double* fx, double* fy) {
  return guarded(problem_call(__func__, ire, icp), [&](ContactProblem& p) {
    if (p.is_wheel()) {
      p.force_x = real("fx", fx);
      return;
    }
    const double x = real("fx", fx), y = real("fy", fy), size = std::max(1.0, std::hypot(x, y));
    p.ratio_x = x / size;
    p.ratio_y = y / size;
  });
}

} // extern "C"
} // namespace microslip::libcontact
