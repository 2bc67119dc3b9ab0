#include "compat/contact/wheel_rail/records.hpp"

#include "compat/contact/wheel_rail/record_numbers.hpp"
#include "io/file_beside.hpp"

#include <algorithm>
#include <span>

namespace microslip::contact_program {

PatchRules read_patch_rules(Words& words) {
  constexpr double least = 1e-8, most = 1e20;
  PatchRules d;
  d.dx = words.between("DX", least, most, mm);
  d.ds = words.between("DS", least, most, mm);
  d.dqrel = words.between("DQREL", 1e-3, 10);
  d.a_sep = std::max(0.0, words.angle("A_SEP"));
  d.d_sep = std::max(0.0, words.real("D_SEP", mm));
  d.d_comb = words.real("D_COMB", mm);
  if (d.d_comb > d.d_sep) words.fail("D_COMB", d.d_comb * per_m, "must not be above D_SEP");
  d.d_turn = words.optional_real("D_TURN", 2 * d.d_sep - d.d_comb, mm);
  d.g_miss = words.optional_real("G_MISS", d.g_miss, mm);
  words.end_record();
  return d;
}

namespace {

/// What PRFOPT > 0 says is to follow.
void read_profile_options(Words& words, int options, ProfileRecord& p) {
  if (options < 1) return;
  p.smoothing = words.integer("ISMOOTH", 0, 2);
  p.zigzag = std::max(ProfileThresholds::least_zigzag, words.angle("ZIGTHRS"));
  p.kink_high = words.angle("KINKHIGH");
  p.kink_low = words.angle("KINKLOW");
  p.kink_width = words.real("KINKWID");
  words.end_record();
  if (options < 2) return;
  p.error_handling = words.integer("ERRHND", -2, 1);
  p.most_omitted = words.between("MAXOMIT", 0, 1);
  words.end_record();
}

} // namespace

ProfileRecord read_profile_record(Words& words, const std::string& folder) {
  ProfileRecord p;
  p.name = words.text("FNAME");
  p.file = io::file_beside(folder, p.name).string();
  p.mirror_y = words.integer("MIRRORY", -1, 1);
  const double scale = words.real("SCALE");
  p.scale = scale > ProfileThresholds::no_scale ? scale : 1;
  p.smooth = std::max(0.0, words.real("SMOOTH"));
  p.mirror_z = words.optional_integer("MIRRORZ", 0, -1, 1);
  const int options = words.optional_integer("PRFOPT", 0, 0, 2);
  words.end_record();
  read_profile_options(words, options, p);
  return p;
}

TrackDimensions read_track(Words& words, bool roller) {
  TrackDimensions t;
  t.gauge_height = words.real("GAUGHT", mm);
  if (t.by_gauge()) {
    words.real("GAUGSQ");
    t.gauge_width = words.real("GAUGWD", mm);
  } else {
    t.rail_y0 = words.real("RAILY0", mm);
    t.rail_z0 = words.real("RAILZ0", mm);
  }
  if (roller) {
    t.roller_radius = words.real("NOMRADR", mm);
  } else {
    t.cant = words.angle("CANT");
    t.curvature = words.optional_real("CURV", 0, per_mm);
  }
  words.end_record();
  return t;
}

namespace {

template <class Table, class Record> void read_numbers(Words& words, const Table& numbers, Record& record) {
  for (const auto& [name, member, unit, mirrored] : numbers)
    record.*member = unit.is_angle ? words.angle(name) : words.real(name, unit.value());
}

PitchDrive read_pitch_drive(Words& words, TotalForce digit) {
  if (digit == TotalForce::force_x) return LongitudinalForce{words.real("FX_WS")};
  if (digit == TotalForce::moment_y) return PitchMoment{words.real("MY_WS", mm)};
  return PitchVelocity{words.angle("VPITCH_WS")};
}

} // namespace

RailPosition read_rail_position(Words& words) {
  RailPosition p;
  read_numbers(words, rail_position_numbers, p);
  words.end_record();
  return p;
}

RailSupport read_rail_support(Words& words) {
  RailSupport s;
  read_numbers(words, rail_support_numbers, s);
  s.first_step = words.optional_real("DYSTEP0", s.first_step, mm);
  words.end_record();
  return s;
}

WheelsetDimensions read_wheelset(Words& words) {
  WheelsetDimensions w;
  w.flange_back_distance = words.real("FBDIST", mm);
  w.flange_back_position = words.real("FBPOS", mm);
  w.nominal_radius = words.between("NOMRADW", w.least_radius / mm, w.greatest_radius / mm, mm);
  w.tape_circle = words.optional_real("YTAPE", w.tape_circle, mm);
  words.end_record();
  return w;
}

WheelsetPosition read_position(Words& words, Normal norm) {
  const std::span<const RecordNumber<WheelsetPosition>> numbers(wheelset_position_numbers);
  WheelsetPosition p;
  read_numbers(words, numbers.first(before_vertical), p);
  if (norm == Normal::force)
    p.vertical = VerticalForce{words.real("FZ")};
  else
    p.vertical = VerticalPosition{words.real("Z_WS", mm)};
  read_numbers(words, numbers.subspan(before_vertical), p);
  words.end_record();
  return p;
}

WheelsetVelocity read_velocity(Words& words, const WheelRailDigits& digits) {
  WheelsetVelocity v;
  v.vs = digits.is_roller() ? words.angle("RPITCH") : words.real("VS_WS", mm);
  read_numbers(words, wheelset_velocity_numbers, v);
  v.pitch = read_pitch_drive(words, digits.force);
  words.end_record();
  return v;
}

WheelDeflection read_deflection(Words& words) {
  constexpr std::size_t in_a_record = 6;
  const std::span<const RecordNumber<WheelDeflection>> numbers(wheel_deflection_numbers);
  WheelDeflection d;
  for (const auto record : {numbers.first(in_a_record), numbers.subspan(in_a_record)}) {
    read_numbers(words, record, d);
    words.end_record();
  }
  return d;
}

} // namespace microslip::contact_program
