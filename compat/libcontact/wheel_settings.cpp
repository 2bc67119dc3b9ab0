#include "compat/contact/wheel_rail/profile_reading.hpp"
#include "compat/contact/wheel_rail/record_numbers.hpp"
#include "compat/contact/words.hpp"
#include "compat/libcontact/arguments.hpp"
#include "compat/libcontact/call.hpp"
#include "compat/libcontact/defaults.hpp"

#include <algorithm>

// What wheels on rails, module 1, are set by.

namespace microslip::libcontact {
namespace {

using namespace contact_program;

constexpr int rail_profile = 0, wheel_profile = 1;

/// What is to be done with a profile's points, but for its file.
ProfileRecord profile_record(const Units& u, std::span<const int> choices, std::span<const double> numbers) {
  const auto choice = [&](std::size_t k, int otherwise) { return k < choices.size() ? choices[k] : otherwise; };
  const auto value = [&](std::size_t k, double otherwise) { return k < numbers.size() ? numbers[k] : otherwise; };
  constexpr DefaultOf of = DefaultOf::wheel;
  ProfileRecord p;
  p.mirror_y = choice(2, default_choice<int>("MIRRORY", of));
  p.mirror_z = choice(3, default_choice<int>("MIRRORZ", of));
  p.error_handling = choice(4, default_choice<int>("ERRHND", of));
  p.smoothing = choice(5, default_choice<int>("ISMOOTH", of));
  for (const int mirror : {p.mirror_y, p.mirror_z})
    if (mirror < -1 || mirror > 1) throw Refusal(CNTC_err_profil, "mirrory and mirrorz must be -1, 0 or 1");
  if (p.smoothing < 0 || p.smoothing > 2) throw Refusal(CNTC_err_profil, "ismooth must be 0, 1 or 2");
  p.scale = value(0, 0) > ProfileThresholds::no_scale ? numbers[0] : u.length() / mm;
  p.smooth = std::max(0.0, value(1, default_of("SMOOTH", of)));
  p.most_omitted = value(2, default_of("MAXOMIT", of));
  p.zigzag = std::max(ProfileThresholds::least_zigzag, value(3, default_of("ZIGTHRS", of)));
  p.kink_high = value(4, default_of("KINKHIGH", of));
  p.kink_low = value(5, numbers.size() > 4 ? p.kink_high / ProfileThresholds::kink_ratio : default_of("KINKLOW", of));
  p.kink_width = numbers.size() > 6 ? numbers[6] * u.length() / mm : default_in_file("KINKWID", of);
  return p;
}

/// Wheel or rail by the ending of a file's name.
int type_of(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  for (char& letter : ending) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  const bool is_wheel = ending == ".prw" || ending == ".whl" || ending == ".slcw";
  return is_wheel ? wheel_profile : rail_profile;
}

ProfileRecord& profile_of(ContactProblem& p, int type) {
  return type == wheel_profile ? p.wheel().wheel : p.wheel().rail;
}

ProfileRole role_of(int type) {
  return type == wheel_profile ? ProfileRole::wheel : ProfileRole::rail;
}

GivenProfile& given_profile_of(ContactProblem& p, int type) {
  return type == wheel_profile ? p.given_wheel : p.given_rail;
}

/// Reads a profile at once, so that this call tells what is wrong with it. A profile that was refused is none.
template <class Read> void set_profile(ContactProblem& p, int type, ProfileRecord record, Read read) {
  profile_of(p, type) = {};
  given_profile_of(p, type) = {};
  try {
    record.curve = read(record);
  } catch (const Error& error) {
    throw Refusal(CNTC_err_profil, error.what());
  }
  profile_of(p, type) = std::move(record);
}

void set_profile_file(ContactProblem& p, const std::string& name, std::span<const int> choices,
                      std::span<const double> numbers) {
  ProfileRecord record = profile_record(p.units, choices, numbers);
  record.name = name;
  record.file = (Registry::instance().working_folder() / name).string();
  const bool is_known = !choices.empty() && (choices[0] == rail_profile || choices[0] == wheel_profile);
  const int type = is_known ? choices[0] : type_of(name);
  set_profile(p, type, record, [&](const ProfileRecord& r) -> std::shared_ptr<const ProfileCurve> {
    if (is_variable(r)) return {};
    return read_profile_curve(r, role_of(type));
  });
}

void set_profile_values(ContactProblem& p, std::span<const double> values, std::span<const int> choices,
                        std::span<const double> numbers) {
  const int type = choices.empty() || choices[0] > 0 ? wheel_profile : rail_profile; // as in CONTACT
  std::vector<ProfilePoint> points;
  for (std::size_t k = 0; k + 1 < values.size(); k += 2) points.push_back({values[k], values[k + 1]});
  ProfileRecord record = profile_record(p.units, choices, numbers);
  record.file = type == wheel_profile ? "the wheel's profile" : "the rail's profile";
  set_profile(p, type, record, [&](const ProfileRecord& r) { return profile_curve_through(points, r, role_of(type)); });
  given_profile_of(p, type).points = std::move(points);
}

/// GAUGHT, dummy, GAUGWD or GAUGHT, RAILY0, RAILZ0; CANT, NOMRAD and, if it is there, CURV.
void set_track(ContactProblem& p, std::span<const double> v) {
  const double l = p.units.length();
  TrackDimensions t;
  t.gauge_height = v[0] * l;
  if (t.by_gauge()) {
    t.gauge_width = v[2] * l;
  } else {
    t.rail_y0 = v[1] * l;
    t.rail_z0 = v[2] * l;
  }
  t.cant = v[3];
  t.roller_radius = v[4] * l;
  t.curvature = v.size() > 5 ? v[5] / l : 0;
  p.wheel().track = t;
}

/// The numbers of a record that has a table, from the first one on.
template <class Table, class Record>
void set_numbers(const Units& u, const Table& numbers, std::span<const double> values, Record& record) {
  const auto* value = values.data();
  for (const auto& number : numbers) record.*number.member = *value++ * u.of(number.unit);
}

void set_rail_position(ContactProblem& p, std::span<const double> v) {
  set_numbers(p.units, rail_position_numbers, v, p.wheel().rail_position);
}

void set_rail_support(ContactProblem& p, std::span<const double> v) {
  set_numbers(p.units, rail_support_numbers, v, p.wheel().support);
  p.wheel().support.first_step = v.size() > 4 ? v[4] * p.units.length() : default_of("DYSTEP0", DefaultOf::wheel);
}

void set_track_dimensions(ContactProblem& p, int method, std::span<const double> v) {
  switch (method) {
  case 0:
    return require_count("rparam", v.size(), 0, 1);
  case 1:
    require_count("rparam", v.size(), 5, 6);
    return set_track(p, v);
  case 2:
    require_count("rparam", v.size(), 6, 6);
    return set_rail_position(p, v);
  case 3:
    require_count("rparam", v.size(), 11, 12);
    set_track(p, v.first(v.size() - 6));
    return set_rail_position(p, v.last(6));
  case 32:
  case 33:
    require_count("rparam", v.size(), 4, 5);
    return set_rail_support(p, v);
  default:
    throw Refusal(CNTC_err_other, "Z = " + std::to_string(method) + " does not exist");
  }
}

void check_method(int method, int least) {
  if (method < least || method > 5) throw Refusal(CNTC_err_other, "E = " + std::to_string(method) + " does not exist");
}

void set_wheelset(ContactProblem& p, int method, std::span<const double> v) {
  check_method(method, 0);
  if (method != 3 && method != 5) return require_count("rparam", v.size(), 0, 1);
  require_count("rparam", v.size(), 3, 4);
  const double l = p.units.length();
  constexpr double least = WheelsetDimensions::least_radius, greatest = WheelsetDimensions::greatest_radius;
  if (!(v[2] * l >= least && v[2] * l <= greatest))
    throw Refusal(CNTC_err_other, "NOMRAD = " + short_number(v[2] * l / mm) + " mm: must be in [" +
                                      short_number(least / mm) + ", " + short_number(greatest / mm) + "]");
  p.wheel().wheelset = {v[0] * l, v[1] * l, v[2] * l, v.size() > 3 ? v[3] * l : default_of("YTAPE", DefaultOf::wheel)};
}

void set_position(ContactProblem& p, int method, std::span<const double> v) {
  check_method(method, 1);
  require_count("rparam", v.size(), 6, 6);
  p.z = v[2] * p.units.length();
  const std::span<const RecordNumber<WheelsetPosition>> numbers(wheelset_position_numbers);
  set_numbers(p.units, numbers.first(before_vertical), v, p.wheel().position);
  set_numbers(p.units, numbers.subspan(before_vertical), v.subspan(before_vertical + 1), p.wheel().position);
}

void set_velocity(ContactProblem& p, int method, std::span<const double> v) {
  check_method(method, 1);
  require_count("rparam", v.size(), 6, 6);
  WheelsetVelocity& velocity = p.wheel().velocity;
  velocity.vs = v[0] * (p.wheel().digits.is_roller() ? 1 : p.units.length()); // of rollers the rate of rotation
  set_numbers(p.units, wheelset_velocity_numbers, v.subspan(1), velocity);
  p.vpitch = v[5];
}

void set_flexibility(ContactProblem& p, int method, std::span<const double> v) {
  check_method(method, 1);
  const bool bends = method >= 4;
  p.wheel().deflection = {};
  p.wheel().digits.ewheel = bends ? WheelsetSource::all_flexible : WheelsetSource::all;
  if (!bends) return; // what is given for no deflection does not matter
  require_count("rparam", v.size(), 12, 12);
  set_numbers(p.units, wheel_deflection_numbers, v, p.wheel().deflection);
}

} // namespace

extern "C" {

int cntc_setverticalforce(int* ire, double* fz) {
  return guarded(wheel_call(__func__, ire), [&](ContactProblem& p) {
    p.vertical_force = real("fz", fz);
    p.data.digits.norm = Normal::force;
  });
}

int cntc_setprofileinputfname(int* ire, const char* c_fname, int* len_fname, int* nints, int* iparam, int* nreals,
                              double* rparam) {
  return guarded(wheel_call(__func__, ire), [&](ContactProblem& p) {
    set_profile_file(p, text("c_fname", c_fname, len_fname), integers("iparam", nints, iparam),
                     reals("rparam", nreals, rparam));
  });
}

int cntc_setprofileinputvalues(int* ire, int* npoint, double* values, int* nints, int* iparam, int* nreals,
                               double* rparam) {
  return guarded(wheel_call(__func__, ire), [&](ContactProblem& p) {
    constexpr int most_points = 1000000;
    const int points = integer("npoint", npoint);
    if (points < 0 || points > most_points) throw Refusal(CNTC_err_profil, "npoint must be in 0 to a million");
    const int count = 2 * points;
    set_profile_values(p, reals("values", &count, values), integers("iparam", nints, iparam),
                       reals("rparam", nreals, rparam));
  });
}

int cntc_settrackdimensions(int* ire, int* ztrack, int* nparam, double* rparam) {
  return set_by(wheel_call(__func__, ire), set_track_dimensions, "ztrack", ztrack, "rparam", nparam, rparam);
}

int cntc_setwheelsetdimensions(int* ire, int* ewheel, int* nparam, double* rparam) {
  return set_by(wheel_call(__func__, ire), set_wheelset, "ewheel", ewheel, "rparam", nparam, rparam);
}

int cntc_setwheelsetposition(int* ire, int* ewheel, int* nparam, double* rparam) {
  return set_by(wheel_call(__func__, ire), set_position, "ewheel", ewheel, "rparam", nparam, rparam);
}

int cntc_setwheelsetvelocity(int* ire, int* ewheel, int* nparam, double* rparam) {
  return set_by(wheel_call(__func__, ire), set_velocity, "ewheel", ewheel, "rparam", nparam, rparam);
}

int cntc_setwheelsetflexibility(int* ire, int* ewheel, int* nparam, double* rparam) {
  return set_by(wheel_call(__func__, ire), set_flexibility, "ewheel", ewheel, "rparam", nparam, rparam);
}

} // extern "C"
} // namespace microslip::libcontact
