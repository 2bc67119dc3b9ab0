#include "compat/contact/wheel_rail/case_reader.hpp"

#include <filesystem>
#include <limits>

namespace microslip::contact_program {
namespace {

/// The alternative of PitchDrive that a case with this digit has.
std::size_t drive_of(TotalForce digit) {
  if (digit == TotalForce::force_x) return PitchDrive(LongitudinalForce{}).index();
  return digit == TotalForce::moment_y ? PitchDrive(PitchMoment{}).index() : PitchDrive(PitchVelocity{}).index();
}

} // namespace

void WheelRailReader::read() {
  WheelRailData& data = c_.wheel_rail ? *c_.wheel_rail : c_.wheel_rail.emplace();
  data.digits = read_digits(words_, c_.damping ? Damping::keep : Damping::none, c_.digits);
  sequence_.check_digits(words_);
  check_kept(data);
  read_settings(data);
  read_track(data);
  read_wheelset(data);
  read_points(words_, c_);
}

void WheelRailReader::read_pair() {
  WheelRailData& data = *c_.wheel_rail;
  const Digits before = c_.digits;
  const WheelRailDigits own_before = data.digits;
  data.digits = read_digits(words_, c_.damping ? Damping::keep : Damping::none, c_.digits);
  const WheelRailDigits own = data.digits;
  if (own.ztrack != TrackSource::keep && own.ztrack != TrackSource::all)
    words_.fail("digit Z", number(own.ztrack), "must be 0 or 3");
  if (own.ewheel != WheelsetSource::keep && own.ewheel != WheelsetSource::all)
    words_.fail("digit E", number(own.ewheel), "must be 0 or 3");
  c_.digits.pvtime = before.pvtime;
  c_.digits.tang = before.tang;
  c_.digits.norm = before.norm;
  c_.digits.stress = before.stress;
  c_.digits.heat = before.heat;
  c_.digits.iestim = before.iestim;
  data.digits.config = own_before.config;
  data.digits.force = own_before.force;
  sequence_.check_digits(words_);
  read_settings(data);
  if (own.ztrack == TrackSource::all) {
    data.track = contact_program::read_track(words_, data.digits.is_roller());
    data.rail = read_profile_record(words_, folder_);
  }
  if (own.ewheel == WheelsetSource::all) {
    data.wheelset = contact_program::read_wheelset(words_);
    data.wheel = read_profile_record(words_, folder_);
  }
  data.digits.ztrack = own_before.ztrack;
  data.digits.ewheel = own_before.ewheel;
}

/// Records in front of the track's.
void WheelRailReader::read_settings(WheelRailData& data) {
  if (data.digits.reads_grid()) data.search = data.digits.discns;
  read_solver(words_, c_.digits.gausei, c_.solver);
  sequence_.has_solver = true;
  read_friction(data.digits);
  read_material(c_.digits);
  read_damping(words_, c_);
  if (c_.digits.heat == Heat::read) c_.heat = read_heat(words_, c_.digits.mater);
  if (data.digits.reads_grid()) data.grid = read_patch_rules(words_);
}

/// What this module's digits keep must be there.
void WheelRailReader::check_kept(const WheelRailData& data) const {
  const Normal norm = c_.digits.norm;
  const WheelRailDigits& own = data.digits;
  const auto need = [&](bool keeps, bool has, auto digit, const char* what) {
    sequence_.need(words_, keeps, has, written(digit), what);
  };
  const bool has = sequence_.has_case;
  need(!own.reads_grid(), has, own.discns, "the discretisation");
  need(own.ztrack != TrackSource::all, has, own.ztrack, "the rail's profile");
  need(!own.reads_wheel(), has, own.ewheel, "the wheel's profile");
  need(own.ewheel == WheelsetSource::keep, data.position.by_force() == (norm == Normal::force), norm,
       norm == Normal::force ? "a vertical force" : "a vertical position");
  need(!own.reads_velocity(), data.velocity.pitch.index() == drive_of(own.force), own.force,
       "what drives the wheelset about its axle");
}

void WheelRailReader::read_friction(const WheelRailDigits& own) {
  const Law law = c_.digits.frclaw;
  if (law == Law::keep) return;
  c_.friction = {};
  c_.friction.law = law;
  if (own.varfrc == FrictionStations::one)
    c_.friction.sets.push_back(read_friction_set(words_, law));
  else
    c_.friction = read_friction_stations(words_, law, own.varfrc);
  sequence_.has_friction = true;
}

void WheelRailReader::read_material(const Digits& d) {
  if (!d.reads_material()) return;
  MaterialData m;
  m.coefficients = d.inflcf;
  if (d.inflcf == Coefficients::angle_corrected) {
    read_correction(words_, m.correction);
    words_.end_record();
  }
  read_elasticity(words_, m);
  read_model(words_, d, m);
  c_.material = m;
}

void WheelRailReader::read_track(WheelRailData& data) {
  const WheelRailDigits& own = data.digits;
  if (own.reads_dimensions()) data.track = contact_program::read_track(words_, own.is_roller());
  if (own.ztrack == TrackSource::all) data.rail = read_profile_record(words_, folder_);
  if (!own.reads_rail_position()) return;
  data.rail_position = read_rail_position(words_);
  if (own.force == TotalForce::rail_deflection) data.support = read_rail_support(words_);
}

void WheelRailReader::read_wheelset(WheelRailData& data) {
  const WheelRailDigits& own = data.digits;
  if (own.reads_wheel()) {
    data.wheelset = contact_program::read_wheelset(words_);
    data.wheel = read_profile_record(words_, folder_);
  }
  if (own.ewheel == WheelsetSource::keep) return;
  data.position = read_position(words_, c_.digits.norm);
  if (!own.reads_velocity()) return;
  data.velocity = read_velocity(words_, own);
  if (own.reads_flexibility()) data.deflection = read_deflection(words_);
}

Case read_pair(std::istream& stream, const std::string& name, const Case& before) {
  Words words(stream, name);
  constexpr int pair_module = 11;
  const int module = words.integer("MODULE", std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
  if (module != 0 && module != pair_module) words.fail("MODULE", module, "must be 11");
  words.end_record();
  CaseSequence sequence{before, true, true, true, true};
  WheelRailReader(words, std::filesystem::path(name).parent_path().string(), sequence).read_pair();
  return sequence.last;
}

} // namespace microslip::contact_program
