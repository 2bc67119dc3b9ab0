#include "compat/contact/wheel_rail/records.hpp"

#include "io/file_beside.hpp"

#include <algorithm>

namespace microslip::contact_program {

PatchRules read_patch_rules(Words& words) {
  constexpr double least = 1e-8, most = 1e20;
  PatchRules d;
  d.dx = words.between("DX", least, most);
  d.ds = words.between("DS", least, most);
  d.dqrel = words.between("DQREL", 1e-3, 10);
  d.a_sep = std::max(0.0, words.angle("A_SEP"));
  d.d_sep = std::max(0.0, words.real("D_SEP"));
  d.d_comb = words.real("D_COMB");
  if (d.d_comb > d.d_sep) words.fail("D_COMB", d.d_comb, "must not be above D_SEP");
  d.d_turn = words.optional_real("D_TURN", 2 * d.d_sep - d.d_comb);
  d.g_miss = words.optional_real("G_MISS", d.g_miss);
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
  t.gauge_height = words.real("GAUGHT");
  if (t.by_gauge()) {
    words.real("GAUGSQ");
    t.gauge_width = words.real("GAUGWD");
  } else {
    t.rail_y0 = words.real("RAILY0");
    t.rail_z0 = words.real("RAILZ0");
  }
  if (roller) {
    t.roller_radius = words.real("NOMRADR");
    if (t.roller_radius == 0) words.fail("NOMRADR", 0, "must not be 0");
  } else {
    t.cant = words.angle("CANT");
    t.curvature = words.optional_real("CURV", 0);
  }
  words.end_record();
  return t;
}

RailPosition read_rail_position(Words& words) {
  RailPosition p;
  p.dy = words.real("DYRAIL");
  p.dz = words.real("DZRAIL");
  p.roll = words.angle("DROLLR");
  p.vy = words.real("VYRAIL");
  p.vz = words.real("VZRAIL");
  p.vroll = words.angle("VROLLR");
  words.end_record();
  return p;
}

RailSupport read_rail_support(Words& words) {
  RailSupport s;
  s.ky = words.real("KYRAIL");
  s.fy = words.real("FYRAIL");
  s.kz = words.real("KZRAIL");
  s.fz = words.real("FZRAIL");
  s.first_step = words.optional_real("DYSTEP0", s.first_step);
  words.end_record();
  return s;
}

WheelsetDimensions read_wheelset(Words& words) {
  WheelsetDimensions w;
  w.flange_back_distance = words.real("FBDIST");
  w.flange_back_position = words.real("FBPOS");
  w.nominal_radius = words.between("NOMRADW", 1e-3, 1e20);
  w.tape_circle = words.optional_real("YTAPE", w.tape_circle);
  words.end_record();
  return w;
}

WheelsetPosition read_position(Words& words, Normal norm) {
  WheelsetPosition p;
  p.s = words.real("S_WS");
  p.y = words.real("Y_WS");
  if (norm == Normal::force)
    p.vertical = VerticalForce{words.real("FZ")};
  else
    p.vertical = VerticalPosition{words.real("Z_WS")};
  p.roll = words.angle("ROLL_WS");
  p.yaw = words.angle("YAW_WS");
  p.pitch = words.angle("PITCH_WS");
  words.end_record();
  return p;
}

namespace {

PitchDrive read_pitch_drive(Words& words, TotalForce digit) {
  if (digit == TotalForce::force_x) return LongitudinalForce{words.real("FX_WS")};
  if (digit == TotalForce::moment_y) return PitchMoment{words.real("MY_WS")};
  return PitchVelocity{words.angle("VPITCH_WS")};
}

} // namespace

WheelsetVelocity read_velocity(Words& words, const WheelRailDigits& digits) {
  WheelsetVelocity v;
  v.vs = digits.is_roller() ? words.angle("RPITCH") : words.real("VS_WS");
  v.vy = words.real("VY_WS");
  v.vz = words.real("VZ_WS");
  v.vroll = words.angle("VROLL_WS");
  v.vyaw = words.angle("VYAW_WS");
  v.pitch = read_pitch_drive(words, digits.force);
  words.end_record();
  return v;
}

WheelDeflection read_deflection(Words& words) {
  WheelDeflection d;
  d.dx = words.real("DXWHL");
  d.dy = words.real("DYWHL");
  d.dz = words.real("DZWHL");
  d.droll = words.angle("DROLLW");
  d.dyaw = words.angle("DYAWW");
  d.dpitch = words.angle("DPITCHW");
  words.end_record();
  d.vx = words.real("VXWHL");
  d.vy = words.real("VYWHL");
  d.vz = words.real("VZWHL");
  d.vroll = words.angle("VROLLW");
  d.vyaw = words.angle("VYAWW");
  d.vpitch = words.angle("VPITCHW");
  words.end_record();
  return d;
}

} // namespace microslip::contact_program
