#include "compat/contact/input.hpp"

#include "compat/contact/rules.hpp"
#include "compat/contact/wheel_rail/case_reader.hpp"
#include "io/file_beside.hpp"
#include "microslip/elasticity/material.hpp"

#include <fstream>
#include <limits>
#include <string>

namespace microslip::contact_program {
namespace {

constexpr int most_angles = 10000;

} // namespace

InputReader::InputReader(std::istream& stream, const std::string& name)
    : words_(stream, name), folder_(std::filesystem::path(name).parent_path()) {}

const Case* InputReader::next() {
  if (!ended_ && !in_module_) module_ = read_module();
  ended_ = ended_ || module_ == 0 || words_.at_end();
  if (ended_) return nullptr;
  now_ = &sequences_[{module_, sequence_}];
  Case& c = now_->last;
  c.number = ++cases_;
  c.line = words_.line();
  c.sequence = sequence_;
  c.number_in_element = ++cases_of_element_[sequence_.first];
  c.names_element = cases_of_element_.size() > 1;
  if (module_ == 1)
    WheelRailReader(words_, folder_.string(), *now_).read();
  else
    read_case(c);
  if (const auto broken = broken_rule(c)) words_.fail(broken->text);
  now_->has_case = true;
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

void InputReader::read_case(Case& c) {
  c.digits = read_digits(words_, c.damping ? Damping::keep : Damping::none);
  now_->check_digits(words_);
  check_kept(c);
  read_solver(words_, c.digits.gausei, c.solver);
  now_->has_solver = true;
  read_kinematics(c);
  read_friction(c);
  if (c.digits.reads_material()) {
    read_rolling(c);
    read_material(c);
  }
  read_damping(words_, c);
  if (c.digits.heat == Heat::read) c.heat = read_heat(words_, c.digits.mater);
  read_potential(c);
  read_geometry(c);
  read_friction_by_rows(c);
  read_extra_slip(c);
  read_points(words_, c);
}

/// What this module's digits keep must be there.
void InputReader::check_kept(const Case& c) {
  const Digits& d = c.digits;
  now_->need(words_, d.discns != GridSource::read, c.potential.has_value(), written(d.discns), "the potential contact");
  now_->need(words_, d.exrhs == ExtraSlip::keep, now_->has_case, written(d.exrhs), "the extra rigid slip");
}

void InputReader::read_kinematics(Case& c) {
  const Digits& d = c.digits;
  c.load = d.norm == Normal::force ? NormalLoad{NormalLoad::Given::force, words_.positive("FN")}
                                   : NormalLoad{NormalLoad::Given::approach, words_.real("PEN", mm)};
  const double unit = unit_of_slip(d), turn = unit_of_spin(d);
  c.x = d.force == Prescribed::creepages ? SlipOrForce(Slip{words_.real("CKSI", unit)}) : ForceRatio{words_.real("FX")};
  c.y = d.force != Prescribed::force_x_and_y ? SlipOrForce(Slip{words_.real("CETA", unit)})
                                             : ForceRatio{words_.real("FY")};
  c.phi = words_.real("CPHI", turn);
  c.spin_x = words_.optional_real("SPINXO", 0, mm);
  c.spin_y = words_.optional_real("SPINYO", 0, mm);
  words_.end_record();
}

void InputReader::read_friction(Case& c) {
  if (c.digits.frclaw == Law::keep) return;
  c.friction.law = c.digits.frclaw;
  c.friction.by_row = c.digits.varfrc == FrictionSets::by_row;
  c.friction.sets.clear();
  if (!c.friction.by_row) c.friction.sets.push_back(read_friction_set(words_, c.friction.law));
  now_->has_friction = true;
}

void InputReader::read_rolling(Case& c) {
  if (!c.digits.rolls()) return;
  RollingData rolling;
  rolling.chi = words_.angle("CHI");
  rolling.dq = words_.positive("DQ", mm);
  rolling.veloc = words_.positive("VELOC", mm);
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
    read_correction(words_, m.correction);
    const int count = words_.integer("NN", 2, most_angles);
    words_.end_record();
    auto& angles = m.correction.angles;
    for (int k = 0; k < count; ++k) {
      const double y = words_.real("Y", mm);
      if (k > 0 && !(y > angles.back().first)) words_.fail("Y", y * per_m, "must be above the one before");
      angles.emplace_back(y, words_.angle("ALPHA"));
    }
    words_.end_record();
  }
  std::string coefficients;
  if (d.inflcf == Coefficients::from_file) {
    coefficients = words_.text("CFNAME");
    words_.end_record();
  }
  read_elasticity(words_, m);
  if (d.inflcf == Coefficients::from_file) m.table = coefficients_from(coefficients, m);
  if (!m.table) m.missing_table = coefficients;
  read_model(words_, d, m);
  c.material = m;
}

/// Read once for all cases; nothing if there is no such file.
std::shared_ptr<const InfluenceTable> InputReader::coefficients_from(const std::string& file, const MaterialData& m) {
  const double shear_modulus = combine({m.shear1, m.poisson1}, {m.shear2, m.poisson2}).shear_modulus;
  auto& table = tables_[{file, shear_modulus}];
  if (table) return table;
  const std::string path = io::file_beside(folder_, file).string();
  std::ifstream stream(path);
  if (!stream) return nullptr;
  return table = read_influence_file(stream, path).in_si(shear_modulus);
}

void InputReader::read_potential(Case& c) {
  const Digits& d = c.digits;
  if (d.discns == GridSource::read) {
    c.potential = read_potential_contact(words_);
    if (c.potential->is_hertzian()) now_->has_geometry = false;
  }
  if (d.discns != GridSource::keep) c.formed = c.load;
}

void InputReader::read_geometry(Case& c) {
  if (c.potential->is_hertzian()) return;
  const DistanceSource digit = c.digits.rznorm;
  now_->need(words_, digit != DistanceSource::read, now_->has_geometry, written(digit), "the undeformed distance");
  if (digit != DistanceSource::read) return;
  c.geometry = contact_program::read_geometry(words_, *c.potential);
  now_->has_geometry = true;
}

void InputReader::read_friction_by_rows(Case& c) {
  if (!c.friction.by_row) return;
  const auto rows = static_cast<std::size_t>(c.potential->my);
  if (c.digits.frclaw != Law::keep)
    for (std::size_t row = 0; row < rows; ++row) c.friction.sets.push_back(read_friction_set(words_, c.friction.law));
  if (c.friction.sets.size() != rows)
    words_.fail("V = 3: there are friction data for " + std::to_string(c.friction.sets.size()) + " rows, and MY is " +
                std::to_string(rows));
}

void InputReader::read_extra_slip(Case& c) {
  const Digits& d = c.digits;
  if (d.exrhs != ExtraSlip::keep) c.extra = d.exrhs;
  if (d.exrhs == ExtraSlip::by_element) c.extra_slip = words_.reals("EXRHS", 2 * c.potential->elements());
  if (c.extra != ExtraSlip::by_element) c.extra_slip.clear();
}

} // namespace microslip::contact_program
