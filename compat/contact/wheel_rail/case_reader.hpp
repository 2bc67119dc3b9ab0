#pragma once

#include "compat/contact/records.hpp"

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
  /// Into it, what a vehicle code does not give: read_pair of pair_file.hpp behind the line MODULE.
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

} // namespace microslip::contact_program
