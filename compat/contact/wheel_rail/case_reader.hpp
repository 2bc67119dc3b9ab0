#pragma once

#include "compat/contact/records.hpp"

#include <istream>
#include <string>

namespace microslip::contact_program {

/// Reads a case of module 1, completed by what the sequence has left. Throws Error as InputReader does.
class WheelRailReader {
public:
  /// `folder` is the input file's, from which profiles are looked for. Both must outlive the reader.
  WheelRailReader(Words& words, std::string folder, CaseSequence& sequence)
      : words_(words), folder_(std::move(folder)), sequence_(sequence), c_(sequence.last) {}

  /// Into the sequence's last case.
  void read();
  /// Into it, what a vehicle code does not give: the file of read_pair() behind the line MODULE.
  void read_pair();

private:
  void check_kept(const WheelRailData& data) const;
  void read_settings(WheelRailData& data);
  void read_friction(const WheelRailDigits& digits);
  void read_material(const Digits& digits);
  void read_track(WheelRailData& data);
  void read_wheelset(WheelRailData& data);

  Words& words_;
  std::string folder_;
  CaseSequence& sequence_;
  Case& c_;
};

/// Reads the file by which CONTACT's interface to Simpack sets a wheel and its rail: the line MODULE with 11, then the
/// records of module 1 but for positions, velocities, deviations and points inside, which the vehicle code gives. What
/// it keeps stays as it is in `before`, a case of module 1, and so do C1, P, T, N, F, S, H and I whatever the file has.
/// Throws Error as InputReader does; profiles are looked for in the folder of `name`.
Case read_pair(std::istream& stream, const std::string& name, const Case& before);

} // namespace microslip::contact_program
