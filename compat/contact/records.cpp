#include "compat/contact/records.hpp"

#include "compat/contact/rules.hpp"

#include <cmath>
#include <utility>

namespace microslip::contact_program {
namespace {

constexpr double largest_friction = 10;
constexpr int most_stations = 10;

double read_coefficient(Words& words, const char* field) {
  return words.between(field, 0, largest_friction);
}

/// The numbers of a law but for its memory.
std::vector<double> read_friction_values(Words& words, Law law) {
  std::vector<double> set;
  if (law == Law::coulomb) {
    set = {read_coefficient(words, "FSTAT"), read_coefficient(words, "FKIN")};
    if (std::abs(set[0] - set[1]) > 1e-3 * set[0])
      words.fail("FKIN", set[1],
                 "must equal FSTAT, " + short_number(set[0]) +
                     "; friction at rest above that of sliding is not supported");
  } else if (law == Law::thermal) {
    set = {read_coefficient(words, "FREF"), words.real("TREF"), words.real("DFHEAT"), words.positive("DTHEAT")};
    if (set[0] + set[2] < 0 || set[0] + set[2] > largest_friction)
      words.fail("DFHEAT", set[2], "must keep FREF + DFHEAT in [0, 10]");
  } else {
    for (const char* field : {"FKIN", "FIN1", "SABSH1", "FIN2", "SABSH2"}) set.push_back(words.between(field, 0, 1e12));
  }
  words.end_record();
  return set;
}

/// MEMDST and MEM_S0, where the law has them.
std::vector<double> read_memory(Words& words, Law law) {
  if (law == Law::coulomb) return {};
  const double distance = words.between("MEMDST", 0, 1e12), velocity = words.between("MEM_S0", 0, 1e12);
  words.end_record();
  return {distance, velocity};
}

} // namespace

UnitList units_of_friction(Law law) {
  if (law == Law::coulomb) return {0, 0};
  if (law == Law::thermal) return {0, 0, 0, 0, 1, 1};
  return {0, 0, 1, 0, 1, 1, 1};
}

UnitList units_of_model(Bulk model) {
  switch (model) {
  case Bulk::viscoelastic:
    return {0, 0, 0, 0};
  case Bulk::fastsim_one:
    return {3, 0, 0, 0};
  case Bulk::layer:
    return {-2, 1, -2, -3};
  case Bulk::fastsim:
  case Bulk::fastrip:
    return {0, 0, 0};
  case Bulk::elastic:
  case Bulk::fastrip_first:
  case Bulk::fastrip_first_bounded:
    break;
  }
  return {};
}

void CaseSequence::need(const Words& words, bool keeps, bool has, const std::string& digit, const char* what) const {
  if (keeps && !has)
    words.fail("case " + std::to_string(last.number) + ": digit " + digit + " keeps " + what +
               ", which no earlier case has given");
}

void CaseSequence::check_digits(const Words& words) {
  Digits& d = last.digits;
  if (const auto broken = rule_broken_by_digits(last)) words.fail(broken->text);
  const auto check = [&](bool keeps, bool has, auto digit, const char* what) {
    need(words, keeps, has, written(digit), what);
  };
  const bool keeps_points = d.stress == InteriorPoints::stored || d.stress == InteriorPoints::stored_again;
  check(d.gausei == SolverChoice::keep, has_solver, d.gausei, "the solvers' parameters");
  check(d.frclaw == Law::keep, has_friction, d.frclaw, "the friction law");
  check(!d.reads_material(), last.material.has_value(), d.inflcf, "the material");
  check(d.heat == Heat::keep, last.heat.has_value(), d.heat, "the heat parameters");
  check(keeps_points, !last.points.empty(), d.stress, "the points of the interior field");
  if (d.damping == Damping::keep && !last.damping) d.damping = Damping::none;
  if (has_case) return;
  d.pvtime = Continuation::nothing;
  d.iestim = InitialGuess::nothing;
}

void read_solver(Words& words, SolverChoice method, SolverData& s) {
  if (method == SolverChoice::keep) return;
  constexpr int most = 1000000;
  s.method = method;
  s.maxgs = words.integer("MAXGS", 1, most);
  s.maxin = words.integer("MAXIN", 1, most);
  s.maxnr = words.integer("MAXNR", 1, most);
  s.maxout = words.integer("MAXOUT", 1, most);
  s.eps = words.positive("EPS");
  s.npot_max = words.optional_integer("NPOT_MAX", SolverData().npot_max, 0, 2000000000);
  words.end_record();
  if (s.method == SolverChoice::convex_gs || s.method == SolverChoice::steady_gs) {
    s.omegah = words.real("OMEGAH");
    s.omegas = words.real("OMEGAS");
  }
  if (s.starts_from_slip()) {
    s.inislp = words.real("INISLP");
    s.omgslp = words.real("OMGSLP");
    words.end_record();
  }
  if (s.method == SolverChoice::gd_steady) words.reals("FDECAY to POW_S", 8);
}

std::vector<double> read_friction_set(Words& words, Law law) {
  auto set = read_friction_values(words, law);
  const auto memory = read_memory(words, law);
  set.insert(set.end(), memory.begin(), memory.end());
  return in_si(std::move(set), units_of_friction(law));
}

FrictionData read_friction_stations(Words& words, Law law, FrictionStations by) {
  FrictionData friction;
  friction.law = law;
  const int count = words.integer("NVF", 1, most_stations);
  words.end_record();
  for (int k = 0; k < count; ++k) {
    const bool inclined = by == FrictionStations::by_inclination;
    const double station = inclined ? words.angle("ALPHA") : words.real("S", mm);
    if (k > 0 && !(station > friction.stations.back()))
      words.fail(inclined ? "ALPHA" : "S", inclined ? station : station * per_m, "must be above the one before");
    friction.stations.push_back(station);
    friction.sets.push_back(read_friction_values(words, law));
  }
  const auto memory = read_memory(words, law);
  for (auto& set : friction.sets) {
    set.insert(set.end(), memory.begin(), memory.end());
    set = in_si(std::move(set), units_of_friction(law));
  }
  return friction;
}

void read_correction(Words& words, AngleCorrection& correction) {
  correction.method = words.integer("IF_METH", 0, 1);
  correction.variant = words.integer("VARIANT", 1, 4);
}

void read_elasticity(Words& words, MaterialData& m) {
  m.poisson1 = words.between("POISS1", 0, 0.5);
  m.poisson2 = words.between("POISS2", 0, 0.5);
  m.shear1 = words.positive("GG1", newton_per_mm2);
  m.shear2 = words.positive("GG2", newton_per_mm2);
  words.end_record();
}

void read_model(Words& words, const Digits& digits, MaterialData& m) {
  if (digits.bound == PressureModel::thin_sheet) {
    m.sheet_flexibility = words.positive("FLXZ", mm3_per_newton);
    words.end_record();
  }
  m.model = digits.mater;
  const UnitList units = units_of_model(digits.mater);
  if (!units.empty()) m.model_data = in_si(words.reals("material", units.size()), units);
}

void read_damping(Words& words, Case& c) {
  if (c.digits.damping == Damping::none) c.damping.reset();
  if (c.digits.damping != Damping::read) return;
  DampingData& d = c.damping.emplace();
  d.normal = words.not_negative("CDAMPN");
  d.tangential = words.not_negative("CDAMPT");
  d.normal_limit = words.not_negative("DFNMAX");
  d.tangential_limit = words.not_negative("DFTMAX");
  words.end_record();
}

HeatData read_heat(Words& words, Bulk model) {
  HeatData heat;
  for (auto* body : {&heat.body1, &heat.body2}) {
    for (std::size_t k = 0; k < 4; ++k) {
      constexpr const char* fields[] = {"BKTEMP", "HEATCP", "LAMBDA", "DENS"};
      (*body)[k] = words.real(fields[k], units_of_heat[k].value());
    }
    words.end_record();
  }
  if (model == Bulk::layer) {
    heat.plastic_share = words.real("BETAPL");
    words.end_record();
  }
  return heat;
}

void read_points(Words& words, Case& c) {
  const InteriorPoints digit = c.digits.stress;
  if (digit == InteriorPoints::none || digit == InteriorPoints::stored) return;
  c.subs_file = read_choice<SubsFile>(words);
  c.interior_level = words.integer("O_s", 0, 6);
  words.end_record();
  if (digit == InteriorPoints::read) c.points = read_points(words);
}

} // namespace microslip::contact_program
