#include "compat/contact/input.hpp"

#include "microslip/elasticity/material.hpp"

#include <cmath>
#include <fstream>
#include <limits>
#include <string>

namespace microslip::contact_program {
namespace {

constexpr int most_angles = 10000;
constexpr double largest_friction = 10;

/// Whether the points of the interior field are those of an earlier case.
bool keeps_points(const Digits& d) {
  return d.stress == InteriorPoints::stored || d.stress == InteriorPoints::stored_again;
}

/// How many numbers M adds to the material's.
std::size_t numbers_of(Bulk model) {
  switch (model) {
  case Bulk::viscoelastic:
  case Bulk::fastsim_one:
  case Bulk::layer:
    return 4;
  case Bulk::fastsim:
  case Bulk::fastrip:
    return 3;
  case Bulk::elastic:
  case Bulk::fastrip_first:
  case Bulk::fastrip_first_bounded:
    break;
  }
  return 0;
}

} // namespace

InputReader::InputReader(std::istream& stream, std::string name)
    : words_(stream, name), folder_(std::filesystem::path(name).parent_path()) {}

const Case* InputReader::next() {
  const int module = ended_ ? 0 : in_module_ ? 3 : read_module();
  ended_ = module == 0;
  if (ended_) return nullptr;
  if (module == 1) {
    lost_.line = words_.line();
    ++cases_;
    return give_up("MODULE = 1 (wheel on rail)");
  }
  ended_ = words_.at_end();
  if (ended_) return nullptr;
  now_ = &sequences_[sequence_];
  Case& c = now_->last;
  c.number = ++cases_;
  c.line = lost_.line = words_.line();
  c.sequence = sequence_;
  c.unreadable.clear();
  read_case(c);
  if (!c.unreadable.empty()) return give_up(c.unreadable);
  now_->has_case = true;
  now_->lost = 0;
  in_module_ = c.digits.stays_in_module();
  return &c;
}

/// The number of the next module; 0 at the end.
int InputReader::read_module() {
  if (words_.at_end()) return 0;
  const int module = words_.integer("MODULE", std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
  if (module != 0 && module != 1 && module != 3) words_.fail("MODULE", module, "must be 0, 1 or 3");
  complete_ = module == 0;
  if (complete_) return 0;
  const int element = words_.optional_integer("RE", 1, 1, 999);
  sequence_ = {element, words_.optional_integer("CP", 1, 1, 9)};
  words_.end_record();
  return module;
}

/// A case that cannot be read; later cases of its sequence may keep something of it.
const Case* InputReader::give_up(const std::string& why) {
  const auto line = lost_.line;
  lost_ = {};
  lost_.line = line;
  lost_.number = cases_;
  lost_.sequence = sequence_;
  lost_.unreadable = why;
  sequences_[sequence_].lost = cases_;
  in_module_ = false;
  ended_ = !words_.skip_to_module();
  return &lost_;
}

void InputReader::read_case(Case& c) {
  c.digits = read_digits(words_, now_->has_damping ? Damping::keep : Damping::none);
  check_digits(c);
  if (keeps_lost(c)) {
    c.unreadable = "it keeps what case " + std::to_string(now_->lost) + " has changed, which cannot be run";
    return;
  }
  check_kept(c);
  read_solver(c);
  read_kinematics(c);
  read_friction(c);
  if (c.digits.reads_material()) {
    read_rolling(c);
    read_material(c);
  }
  check_read(c);
  read_damping_and_heat(c);
  read_potential(c);
  read_geometry(c);
  if (!c.unreadable.empty()) return;
  read_friction_by_rows(c);
  read_extra_slip(c);
  read_points(c);
}

/// Digits that cannot be combined.
void InputReader::check_digits(const Case& c) {
  const Digits& d = c.digits;
  if (d.heat != Heat::none && d.has_history()) words_.fail("digit H", number(d.heat), "must be 0 with T = 1 or 2");
  if (d.mater == Bulk::viscoelastic && d.has_history())
    words_.fail("digit M", number(d.mater), "must go with T = 3 (or 0)");
}

void InputReader::fail_keep(const Case& c, const std::string& digit, const char* what) const {
  words_.fail("case " + std::to_string(c.number) + ": digit " + digit + " keeps " + what +
              ", which no earlier case has given");
}

/// Whether it keeps something that a case has changed which could not be read.
bool InputReader::keeps_lost(const Case& c) const {
  const Digits& d = c.digits;
  return now_->lost > 0 &&
         (d.gausei == SolverChoice::keep || d.frclaw == Law::keep || !d.reads_material() ||
          d.discns != GridSource::read || d.exrhs == ExtraSlip::keep || d.heat == Heat::keep || keeps_points(d));
}

/// What is to be kept must be there. The first case of a sequence cannot continue anything.
void InputReader::check_kept(Case& c) {
  Digits& d = c.digits;
  const auto need = [&](bool keeps, bool has, auto digit, const char* what) {
    if (keeps && !has) fail_keep(c, written(digit), what);
  };
  need(d.gausei == SolverChoice::keep, now_->has_solver, d.gausei, "the solvers' parameters");
  need(d.frclaw == Law::keep, now_->has_friction, d.frclaw, "the friction law");
  need(!d.reads_material(), c.material.has_value(), d.inflcf, "the material");
  need(d.discns != GridSource::read, c.potential.has_value(), d.discns, "the potential contact");
  need(d.exrhs == ExtraSlip::keep, now_->has_case, d.exrhs, "the extra rigid slip");
  need(d.heat == Heat::keep, c.heat.has_value(), d.heat, "the heat parameters");
  need(keeps_points(d), !c.points.empty(), d.stress, "the points of the interior field");
  if (d.damping == Damping::keep && !now_->has_damping) d.damping = Damping::none;
  if (!now_->has_case) {
    d.pvtime = Continuation::nothing;
    d.iestim = InitialGuess::nothing;
  }
}

void InputReader::read_solver(Case& c) {
  if (c.digits.gausei == SolverChoice::keep) return;
  constexpr int most = 1000000;
  SolverData& s = c.solver;
  s.method = c.digits.gausei;
  s.maxgs = words_.integer("MAXGS", 1, most);
  s.maxin = words_.integer("MAXIN", 1, most);
  s.maxnr = words_.integer("MAXNR", 1, most);
  s.maxout = words_.integer("MAXOUT", 1, most);
  s.eps = words_.positive("EPS");
  words_.end_record();
  if (s.method == SolverChoice::convex_gs || s.method == SolverChoice::steady_gs) {
    s.omegah = words_.real("OMEGAH");
    s.omegas = words_.real("OMEGAS");
  }
  if (s.starts_from_slip()) {
    s.inislp = words_.real("INISLP");
    s.omgslp = words_.real("OMGSLP");
    words_.end_record();
  }
  if (s.method == SolverChoice::gd_steady) words_.reals("FDECAY to POW_S", 8);
  now_->has_solver = true;
}

void InputReader::read_kinematics(Case& c) {
  const Digits& d = c.digits;
  c.normal = d.norm == Normal::force ? words_.positive("FN") : words_.real("PEN");
  c.x = words_.real(d.force != Prescribed::creepages ? "FX" : "CKSI");
  c.y = words_.real(d.force == Prescribed::force_x_and_y ? "FY" : "CETA");
  c.phi = words_.real("CPHI");
  c.spin_x = words_.optional_real("SPINXO", 0);
  c.spin_y = words_.optional_real("SPINYO", 0);
  words_.end_record();
}

/// A set of friction data, by the law.
std::vector<double> InputReader::read_friction_set(Law law) {
  const auto coefficient = [&](const char* field) { return words_.between(field, 0, largest_friction); };
  std::vector<double> set;
  if (law == Law::coulomb) {
    set = {coefficient("FSTAT"), coefficient("FKIN")};
    if (std::abs(set[0] - set[1]) > 1e-3 * set[0])
      words_.fail("FKIN", set[1], "must be FSTAT; a static coefficient above the kinetic one is not supported");
  } else if (law == Law::thermal) {
    set = {coefficient("FREF"), words_.real("TREF"), words_.real("DFHEAT"), words_.positive("DTHEAT")};
    if (set[0] + set[2] < 0 || set[0] + set[2] > largest_friction)
      words_.fail("DFHEAT", set[2], "must keep FREF + DFHEAT in [0, 10]");
  } else {
    for (const char* field : {"FKIN", "FIN1", "SABSH1", "FIN2", "SABSH2"})
      set.push_back(words_.between(field, 0, 1e12));
  }
  words_.end_record();
  if (law == Law::coulomb) return set;
  set.push_back(words_.between("MEMDST", 0, 1e12));
  set.push_back(words_.between("MEM_S0", 0, 1e12));
  words_.end_record();
  return set;
}

void InputReader::read_friction(Case& c) {
  if (c.digits.frclaw == Law::keep) return;
  c.friction.law = c.digits.frclaw;
  c.friction.by_row = c.digits.varfrc == FrictionSets::by_row;
  c.friction.sets.clear();
  if (!c.friction.by_row) c.friction.sets.push_back(read_friction_set(c.friction.law));
  now_->has_friction = true;
}

void InputReader::read_rolling(Case& c) {
  if (!c.digits.rolls()) return;
  RollingData rolling;
  rolling.chi = words_.angle("CHI");
  rolling.dq = words_.positive("DQ");
  rolling.veloc = words_.positive("VELOC");
  rolling.facphi = words_.optional_real("FACPHI", rolling.facphi);
  if (!(rolling.facphi >= 0 && rolling.facphi <= 1)) words_.fail("FACPHI", rolling.facphi, "must be in [0, 1]");
  words_.end_record();
  c.rolling = rolling;
}

void InputReader::read_material(Case& c) {
  const Digits& d = c.digits;
  MaterialData m;
  m.coefficients = d.inflcf;
  if (d.inflcf == Coefficients::angle_corrected) {
    words_.integer("IF_METH", 0, 1);
    words_.integer("VARIANT", 1, 4);
    const int count = words_.integer("NN", 1, most_angles);
    words_.end_record();
    for (int k = 0; k < count; ++k) {
      words_.real("Y");
      words_.angle("ALPHA");
    }
    words_.end_record();
  }
  std::string coefficients;
  if (d.inflcf == Coefficients::from_file) {
    coefficients = words_.text("CFNAME");
    words_.end_record();
  }
  m.poisson1 = words_.between("POISS1", 0, 0.5);
  m.poisson2 = words_.between("POISS2", 0, 0.5);
  m.shear1 = words_.positive("GG1");
  m.shear2 = words_.positive("GG2");
  words_.end_record();
  if (d.inflcf == Coefficients::from_file) m.table = coefficients_from(coefficients, m);
  if (d.bound == PressureModel::thin_sheet) {
    m.sheet_flexibility = words_.positive("FLXZ");
    words_.end_record();
  }
  m.model = d.mater;
  if (const auto count = numbers_of(d.mater)) m.model_data = words_.reals("material", count);
  c.material = m;
}

/// Read once for all cases.
std::shared_ptr<const InfluenceTable> InputReader::coefficients_from(const std::string& file, const MaterialData& m) {
  constexpr double newton_per_mm2 = 1e6;
  const double shear_modulus =
      combine({m.shear1 * newton_per_mm2, m.poisson1}, {m.shear2 * newton_per_mm2, m.poisson2}).shear_modulus;
  auto& table = tables_[{file, shear_modulus}];
  if (table) return table;
  const std::string path = (folder_ / file).string();
  std::ifstream stream(path);
  if (!stream) words_.fail("CFNAME = '" + file + "': cannot be read");
  return table = read_influence_file(stream, path).in_si(shear_modulus);
}

/// What C = 0 or 1 has not read must be there from before.
void InputReader::check_read(const Case& c) {
  const Digits& d = c.digits;
  if (d.mater != Bulk::elastic && c.material->model != d.mater)
    words_.fail("digit M", number(d.mater), "must go with C >= 2, which reads its data");
  if (d.rolls() && !c.rolling)
    words_.fail("digit T", number(d.tang), "must go with C >= 2, which reads CHI, DQ and VELOC");
}

void InputReader::read_damping_and_heat(Case& c) {
  if (c.digits.damping == Damping::read) {
    words_.reals("damping", 4);
    now_->has_damping = true;
  }
  if (c.digits.heat != Heat::read) return;
  HeatData heat;
  for (auto* body : {&heat.body1, &heat.body2}) {
    for (std::size_t k = 0; k < 4; ++k) {
      constexpr const char* fields[] = {"BKTEMP", "HEATCP", "LAMBDA", "DENS"};
      (*body)[k] = words_.real(fields[k]);
    }
    words_.end_record();
  }
  if (c.digits.mater == Bulk::layer) {
    heat.plastic_share = words_.real("BETAPL");
    words_.end_record();
  }
  c.heat = heat;
}

void InputReader::read_potential(Case& c) {
  const Digits& d = c.digits;
  if (d.discns == GridSource::read) {
    c.potential = read_potential_contact(words_);
    if (c.potential->is_hertzian()) now_->has_geometry = false;
  }
  if (d.discns != GridSource::keep && c.potential->is_hertzian() && d.norm == Normal::approach && !(c.normal > 0))
    words_.fail("PEN", c.normal, "must be > 0 with Hertz's geometry, IPOTCN < 0");
  if (d.discns != GridSource::keep) {
    c.formed_norm = d.norm;
    c.formed_normal = c.normal;
  }
  const bool needs_ellipse = d.bound == PressureModel::elliptic || d.bound == PressureModel::parabolic ||
                             d.bound == PressureModel::half_ellipses;
  if (needs_ellipse && !c.potential->is_hertzian())
    words_.fail("digit B", number(d.bound), "must go with Hertz's geometry, IPOTCN < 0");
}

/// Whether the undeformed distance stays; then it must fit the elements.
bool InputReader::keeps_geometry(Case& c) {
  const DistanceSource digit = c.digits.rznorm;
  if (digit == DistanceSource::read) return false;
  if (now_->lost > 0) {
    c.unreadable = "it keeps the undeformed distance that case " + std::to_string(now_->lost) +
                   " has changed, which cannot be run";
    return true;
  }
  if (!now_->has_geometry) fail_keep(c, written(digit), "the undeformed distance");
  if (c.geometry.base == Base::by_element && c.geometry.values.size() != c.potential->elements())
    words_.fail("case " + std::to_string(c.number) + ": digit " + written(digit) +
                " keeps the undeformed distance of " + std::to_string(c.geometry.values.size()) +
                " elements, and there are " + std::to_string(c.potential->elements()));
  return true;
}

void InputReader::read_geometry(Case& c) {
  if (c.potential->is_hertzian() || keeps_geometry(c)) return;
  c.geometry = contact_program::read_geometry(words_, *c.potential);
  now_->has_geometry = true;
}

void InputReader::read_friction_by_rows(Case& c) {
  if (!c.friction.by_row) return;
  const auto rows = static_cast<std::size_t>(c.potential->my);
  if (c.digits.frclaw != Law::keep)
    for (std::size_t row = 0; row < rows; ++row) c.friction.sets.push_back(read_friction_set(c.friction.law));
  if (c.friction.sets.size() != rows)
    words_.fail("V = 3: there are friction data for " + std::to_string(c.friction.sets.size()) + " rows, and MY is " +
                std::to_string(rows));
}

void InputReader::read_extra_slip(Case& c) {
  const Digits& d = c.digits;
  if (d.exrhs != ExtraSlip::keep) c.extra = d.exrhs;
  const std::size_t count = 2 * c.potential->elements();
  if (d.exrhs == ExtraSlip::by_element) c.extra_slip = words_.reals("EXRHS", count);
  if (c.extra != ExtraSlip::by_element) c.extra_slip.clear();
  if (c.extra == ExtraSlip::by_element && c.extra_slip.size() != count)
    words_.fail("digit E", number(d.exrhs), "keeps the extra rigid slip of another number of elements");
}

void InputReader::read_points(Case& c) {
  const InteriorPoints digit = c.digits.stress;
  if (digit == InteriorPoints::none || digit == InteriorPoints::stored) return;
  c.subs_file = read_choice<SubsFile>(words_);
  words_.integer("O_s", 0, 6);
  words_.end_record();
  if (digit == InteriorPoints::read) c.points = contact_program::read_points(words_);
}

} // namespace microslip::contact_program
