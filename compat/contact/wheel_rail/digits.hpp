#pragma once

#include "compat/contact/digits.hpp"

namespace microslip::contact_program {

// What the digits of module 1 say that are not those of module 3, with CONTACT's values.

/// C1: which wheel, and on what.
enum class Config { left_on_track = 0, right_on_track = 1, left_on_roller = 4, right_on_roller = 5 };
/// F: which of the totals is prescribed besides the vertical one. rail_deflection: rails without mass on springs.
enum class TotalForce { none = 0, force_x = 1, moment_y = 2, rail_deflection = 3 };
/// V: where friction data differ: with the surface's inclination, or along the track.
enum class FrictionStations { one = 0, by_inclination = 1, along_track = 2 };
/// D: how patches are found and laid out. true_slip: planar, with the rigid slip of the true surfaces; conformal: on a
/// curved surface; steep: brute force on a finer grid; first_point: at the point of deepest penetration.
enum class ContactSearch {
  keep = 0,
  form = 1,
  locus = 2,
  true_slip = 3,
  conformal = 4,
  brute_force = 5,
  steep = 6,
  first_point = 7,
  oblique = 8,
  oblique_brute_force = 9
};
/// Z: what of the track is read.
enum class TrackSource { keep = 0, dimensions = 1, deviations = 2, all = 3 };
/// E: what of the wheelset is read.
enum class WheelsetSource { keep = 0, position = 1, velocity = 2, all = 3, flexible = 4, all_flexible = 5 };

template <> inline constexpr Values values_of<Config> = {"C", {0, 1, 4, 5}};
template <> inline constexpr Values values_of<TotalForce> = {"F", {0, 1, 2, 3}};
template <> inline constexpr Values values_of<FrictionStations> = {"V", {0, 1, 2}};
template <> inline constexpr Values values_of<ContactSearch> = {"D", {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}};
template <> inline constexpr Values values_of<TrackSource> = {"Z", {0, 1, 2, 3}};
template <> inline constexpr Values values_of<WheelsetSource> = {"E", {0, 1, 2, 3, 4, 5}};

/// The control digits of a case of module 1 that Digits does not have.
struct WheelRailDigits {
  Config config = Config::right_on_track;
  TotalForce force = TotalForce::none;
  FrictionStations varfrc = FrictionStations::one;
  ContactSearch discns = ContactSearch::keep;
  TrackSource ztrack = TrackSource::keep;
  WheelsetSource ewheel = WheelsetSource::keep;

  bool is_left() const { return config == Config::left_on_track || config == Config::left_on_roller; }
  bool is_roller() const { return config == Config::left_on_roller || config == Config::right_on_roller; }
  bool reads_dimensions() const { return ztrack == TrackSource::dimensions || ztrack == TrackSource::all; }
  bool reads_rail_position() const { return ztrack == TrackSource::deviations || ztrack == TrackSource::all; }
  bool reads_wheel() const { return ewheel == WheelsetSource::all || ewheel == WheelsetSource::all_flexible; }
  bool reads_velocity() const { return ewheel != WheelsetSource::keep && ewheel != WheelsetSource::position; }
  bool reads_flexibility() const {
    return ewheel == WheelsetSource::flexible || ewheel == WheelsetSource::all_flexible;
  }
  bool reads_grid() const { return discns != ContactSearch::keep && discns != ContactSearch::form; }
};

/// Reads and checks the three control integers CPBTNFS, VLDCMZE and HGIAOWR; `damping` is M2 where the file has none.
/// The digits that module 3 has alike go to `digits`.
WheelRailDigits read_digits(Words& words, Damping damping, Digits& digits);

} // namespace microslip::contact_program
