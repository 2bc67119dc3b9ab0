#include "compat/contact/wheel_rail/case_reader.hpp"

namespace microslip::contact_program {
namespace {

/// The alternative of PitchDrive that a case with this digit has.
std::size_t drive_of(TotalForce digit) {
  if (digit == TotalForce::force_x) return PitchDrive(LongitudinalForce{}).index();
  return digit == TotalForce::moment_y ? PitchDrive(PitchMoment{}).index() : PitchDrive(PitchVelocity{}).index();
}

} // namespace

void WheelRailReader::read() {
  WheelRailData data = c_.wheel_rail.value_or(WheelRailData());
  data.digits = read_digits(words_, c_.damping ? Damping::keep : Damping::none, c_.digits);
  check_digits(c_.digits);
  check_kept(data);
  if (data.digits.reads_grid()) data.search = data.digits.discns;
  read_solver(words_, c_.digits.gausei, c_.solver);
  sequence_.has_solver = true;
  read_friction(data.digits);
  read_material(c_.digits);
  read_damping(words_, c_);
  if (c_.digits.heat == Heat::read) c_.heat = read_heat(words_, c_.digits.mater);
  if (data.digits.reads_grid()) data.grid = read_patch_rules(words_);
  read_track(data);
  read_wheelset(data);
  c_.wheel_rail = data;
  read_points(words_, c_);
}

/// Values that only module 3 has, and digits that cannot be combined.
void WheelRailReader::check_digits(const Digits& d) const {
  const auto fail = [&](auto digit, const char* must) {
    words_.fail(std::string("digit ") + values_of<decltype(digit)>.name, number(digit), must);
  };
  const bool of_ellipse = d.bound == PressureModel::elliptic || d.bound == PressureModel::parabolic ||
                          d.bound == PressureModel::half_ellipses;
  if (of_ellipse) fail(d.bound, "must be 0, 1, 5 or 6 in module 1");
  if (d.inflcf == Coefficients::from_file) fail(d.inflcf, "must be 0 to 4 in module 1");
  if (d.heat != Heat::none && d.has_history()) fail(d.heat, "must be 0 with T = 1 or 2");
  if (d.mater == Bulk::viscoelastic && d.has_history()) fail(d.mater, "must go with T = 3 (or 0)");
}

/// What is to be kept must be there. The first case of a sequence cannot continue anything.
void WheelRailReader::check_kept(const WheelRailData& data) {
  Digits& d = c_.digits;
  const WheelRailDigits& own = data.digits;
  const auto need = [&](bool keeps, bool has, auto digit, const char* what) {
    sequence_.need(words_, keeps, has, written(digit), what);
  };
  const bool has = sequence_.has_case;
  need(d.gausei == SolverChoice::keep, sequence_.has_solver, d.gausei, "the solvers' parameters");
  need(d.frclaw == Law::keep, sequence_.has_friction, d.frclaw, "the friction law");
  need(!d.reads_material(), c_.material.has_value(), d.inflcf, "the material");
  need(!own.reads_grid(), has, own.discns, "the discretisation");
  need(own.ztrack != TrackSource::all, has, own.ztrack, "the rail's profile");
  need(!own.reads_wheel(), has, own.ewheel, "the wheel's profile");
  need(own.ewheel == WheelsetSource::keep, data.position.by_force() == (d.norm == Normal::force), d.norm,
       d.norm == Normal::force ? "a vertical force" : "a vertical position");
  need(!own.reads_velocity(), data.velocity.pitch.index() == drive_of(own.force), own.force,
       "what drives the wheelset about its axle");
  need(d.heat == Heat::keep, c_.heat.has_value(), d.heat, "the heat parameters");
  need(keeps_points(d), !c_.points.empty(), d.stress, "the points of the interior field");
  if (d.damping == Damping::keep && !c_.damping) d.damping = Damping::none;
  if (has) return;
  d.pvtime = Continuation::nothing;
  d.iestim = InitialGuess::nothing;
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
  if (d.reads_material()) {
    MaterialData m;
    m.coefficients = d.inflcf;
    if (d.inflcf == Coefficients::angle_corrected) {
      m.correction.method = words_.integer("IF_METH", 0, 1);
      m.correction.variant = words_.integer("VARIANT", 1, 4);
      words_.end_record();
    }
    read_elasticity(words_, m);
    read_model(words_, d, m);
    c_.material = m;
  } else if (d.mater != Bulk::elastic && c_.material->model != d.mater) {
    words_.fail("digit M", number(d.mater), "must go with C >= 2, which reads its data");
  }
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

} // namespace microslip::contact_program
