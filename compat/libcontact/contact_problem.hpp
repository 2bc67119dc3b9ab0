#pragma once

#include "compat/contact/sensitivities.hpp"
#include "compat/contact/wheel_rail/wheel_rail_solver.hpp"
#include "compat/libcontact/defaults.hpp"
#include "compat/libcontact/units.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace microslip::libcontact {

using contact_program::Case;
using contact_program::Outcome;
using contact_program::PointBlock;
using contact_program::Sensitivities;
using contact_program::SensitivityChoice;

/// Time of all calculations since it was last set to zero [s].
struct CalculationTime {
  double cpu = 0; ///< of the calling threads
  double wall = 0;
};

/// Outcome of a calculation.
struct Calculation {
  int code = 0;                      ///< 0, elements in contact at a border, or an error's
  bool is_skipped = false;           ///< R = 2, 3: nothing was solved
  std::vector<std::string> messages; ///< why it was refused, or what was left out or done differently
};

/// A contact with its solution: that of module 3, or a patch of a wheel.
struct Contact {
  const Case& data;
  const Outcome& outcome;
};

/// CKSI, CETA and CPHI as they were given, with the unit of lengths then: whether they are those of a shift is known
/// when it is solved.
struct GivenCreepages {
  double x = 0, y = 0, spin = 0;
  double length = contact_program::mm;
};

/// A profile that was given by its points.
struct GivenProfile {
  std::vector<ProfilePoint> points = {};
  std::filesystem::path file = {}; ///< that has them; empty until they are written
};

/// One contact problem of module 3, or a wheel on its rail: what has been set so far, in SI, and what was
/// found last. Its users hold its mutex.
class ContactProblem {
public:
  /// With the defaults of defaults.hpp. `element` is ire, `number` icp, -1 for a wheel.
  ContactProblem(int element, int number);

  bool is_wheel() const { return number_ < 0; }
  contact_program::WheelRailData& wheel() { return *data.wheel_rail; }
  const contact_program::WheelRailData& wheel() const { return *data.wheel_rail; }

  /// A wheel's profile or the rail's as it is used. Throws Refusal if there is none or it cannot be read.
  contact_program::ProfileShape profile(bool of_wheel);

  /// `begins` is told of the case that is going to be solved, or skipped.
  Calculation calculate(const std::function<void(const Case&)>& begins);
  /// Fields inside the bodies below the contacts: of all, or of one patch. Throws Refusal and Error.
  void find_interior(int patch);

  /// Number of calculations.
  int calculations() const { return calculations_; }
  /// Returns whether what was solved last was a left wheel.
  bool was_left() const { return is_wheel() && solved_.wheel_rail && solved_.wheel_rail->digits.is_left(); }
  /// Returns whether cases are to be written as an input file has them, WRTINP.
  bool writes_input() const;
  /// The case that was solved last, and its outcome; none after a calculation that could not end.
  const Case& solved() const { return solved_; }
  const Outcome* outcome() const { return outcome_ ? &*outcome_ : nullptr; }
  /// Number of contacts: of a wheel its patches.
  int contacts() const;
  /// The contacts of a call: all of a wheel for -1, else this one.
  std::vector<int> contacts_of(int icp) const;
  /// The contact of this problem, or a patch, from 1. Throws Refusal if there is none.
  Contact contact(int patch) const;
  /// Throws Refusal unless this is a wheel that has been solved.
  const contact_program::WheelOutcome& solved_wheel() const;
  const contact_program::WheelPatch& patch(int patch) const;
  const Sensitivities& sensitivities(int patch) const;
  /// The blocks of points that are given for a patch, or for all contacts with -1 and in module 3.
  std::vector<PointBlock>& points(int patch);
  /// Results of find_interior, by blocks.
  const std::vector<contact_program::InteriorBlock>& interior(int patch) const;

  std::mutex mutex;
  Units units;
  Case data;
  SensitivityChoice sensitivity{default_choice<int>("S2"), default_of("EPSSENS")};
  CalculationTime time;
  double z = 0, vertical_force = 0;      ///< of a wheel: Z_WS [m] and FZ [N], of which N takes one,
  double vpitch = 0, force_x = 0;        ///< and VPITCH_WS [rad/s] and FX_WS [N], of which F takes one
  double approach = 0, normal_force = 0; ///< of module 3: PEN [m] and FN [N], of which N takes one,
  GivenCreepages creepages;              ///< and CKSI and CETA,
  double ratio_x = 0, ratio_y = 0;       ///< or FX and FY over FSTAT FN, of which F takes some
  double time_step = default_of("DT");   ///< [s]
  GivenProfile given_rail, given_wheel;  ///< no points where the profile has a file
  std::map<int, int> other_flags;        ///< by code: those that change no result

private:
  Case completed() const;
  void solve(Calculation& calculation);
  void keep_what_was_found();
  void find_sensitivities();
  /// Returns whether forces and approaches are numbers.
  bool is_finite() const;
  int code_of_refusal() const;
  int code_of_solution() const;
  std::size_t index(int patch) const;

  int element_, number_;
  contact_program::CaseSolver contact_;
  contact_program::WheelRailSolver wheel_;
  int calculations_ = 0;
  Case solved_;                              ///< what was solved last,
  std::optional<Outcome> outcome_;           ///< and how; none before the first calculation
  std::vector<Sensitivities> sensitivities_; ///< of each contact
  std::vector<PointBlock> points_;
  std::map<int, std::vector<PointBlock>> points_of_patch_;
  std::map<int, std::vector<contact_program::InteriorBlock>> interior_;
};

} // namespace microslip::libcontact
