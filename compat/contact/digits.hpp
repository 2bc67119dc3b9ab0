#pragma once

#include "compat/contact/words.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <string>

namespace microslip::contact_program {

// What the digits and selecting numbers of CONTACT's files say, with CONTACT's values. `keep` and `form` go on with
// what an earlier case has given; here both mean the same.

/// P: what the tractions of a shift or a step of rolling go on from.
enum class Continuation { previous = 0, previous_pressure = 1, nothing = 2, repeated = 3 };
/// B: where the pressure comes from. half_ellipses: SDEC, kik_piotrowski: KPEC.
enum class PressureModel {
  half_space = 0,
  thin_sheet = 1,
  elliptic = 2,
  parabolic = 3,
  half_ellipses = 4,
  kik_piotrowski = 5,
  analyn = 6
};
/// T: how the bodies move over each other.
enum class Tangential { frictionless = 0, shift = 1, transient = 2, steady = 3 };
/// N: what is prescribed in the normal direction.
enum class Normal { approach = 0, force = 1 };
/// F: what is prescribed tangentially; force_x leaves CETA.
enum class Prescribed { creepages = 0, force_x = 1, force_x_and_y = 2 };
/// S: where the interior field is wanted. stored_again reads A_s and O_s only.
enum class InteriorPoints { none = 0, stored = 1, stored_again = 2, read = 3 };
/// V: sets of friction data.
enum class FrictionSets { one = 0, by_row = 3 };
/// L: the friction law.
enum class Law { coulomb = 0, keep = 1, linear = 2, rational = 3, exponential = 4, thermal = 6 };
/// D: the potential contact.
enum class GridSource { keep = 0, form = 1, read = 2 };
/// C: influence coefficients, and whether material and rolling data are read: all but keep and form do.
enum class Coefficients { keep = 0, form = 1, constant = 2, bilinear = 3, angle_corrected = 4, from_file = 9 };
/// M: what the bodies are made of, and the theory for it. fastsim_one: one flexibility, read; fastsim: three, from the
/// material; fastrip_first and _bounded: FaStrip's first form, the latter bounded by friction.
enum class Bulk {
  elastic = 0,
  viscoelastic = 1,
  fastsim_one = 2,
  fastsim = 3,
  layer = 4,
  fastrip = 5,
  fastrip_first = 6,
  fastrip_first_bounded = 7
};
/// M2: damping forces.
enum class Damping { none = 0, keep = 1, read = 2 };
/// Z: the undeformed distance.
enum class DistanceSource { keep = 0, form = 1, read = 2 };
/// E: extra rigid slip; without_spin_y drops the spin's part of wy, without_spin_x that of wx.
enum class ExtraSlip { none = 0, keep = 1, without_spin_y = 2, without_spin_x = 3, by_element = 9 };
/// X: whether a word follows that says what to trace.
enum class Trace { none = 0, read = 1 };
/// H: heat parameters.
enum class Heat { none = 0, keep = 1, read = 3 };
/// G: CONTACT's solver. slip_iteration: the default one, with INISLP and OMGSLP.
enum class SolverChoice { standard = 0, keep = 1, convex_gs = 2, steady_gs = 3, slip_iteration = 4, gd_steady = 5 };
/// I: what the iteration starts from.
enum class InitialGuess { nothing = 0, regularised = 1, pressure = 2, previous = 3 };
/// A: elements whose fields are stored.
enum class Stored { none = 0, contact = 1, all = 2 };
/// O: how much CONTACT prints, 0 to 6.
enum class PrintLevel {};
/// W: how much of the solution's progress CONTACT prints, 0 to 6 and 9.
enum class FlowLevel {};
/// R: what to do with the case, and whether the next one follows without a line MODULE.
enum class Treatment { solve_and_stay = 0, solve = 1, skip_and_stay = 2, skip = 3 };
/// IPOTCN: what the potential contact is given by. Negative: Hertz's geometry.
enum class Potential {
  half_ellipses = -6,
  line_half_width = -5,
  line_curvature = -4,
  semi_axes = -3,
  curvature_and_ratio = -2,
  curvatures = -1,
  corner_and_size = 1,
  corners = 2,
  centre_and_size = 3,
  centres = 4
};
/// IBASE: the undeformed distance. circle: in x, with heights along y.
enum class Base { quadratic = 1, circle = 2, waves = 3, by_element = 9 };
/// IPLAN: where contact is possible. quadratic: where such a form is negative.
enum class Planform { all = 1, quadratic = 2, rectangles = 3, sub_patches = 4 };
/// ISUBS: a block of points below elements, at equal distances in z or (_at) at depths that are listed.
enum class Points { end = 0, all = 1, range = 2, listed = 3, all_at = 5, range_at = 6, listed_at = 7, anywhere = 9 };
/// A_s: what the .subs file has; stresses: the hydrostatic one and von Mises' only.
enum class SubsFile { none = 0, stresses = 1, components = 2 };

/// Name of a choice in a file, and its values.
struct Values {
  const char* name;
  std::array<int, 10> list = {};
  std::size_t count;

  constexpr Values(const char* field, std::initializer_list<int> allowed) : name(field), count(allowed.size()) {
    std::copy(allowed.begin(), allowed.end(), list.begin());
  }
};

/// The one table of names and values.
template <class Choice> struct NoValues;
template <class Choice> inline constexpr NoValues<Choice> values_of;
template <> inline constexpr Values values_of<Continuation> = {"P", {0, 1, 2, 3}};
template <> inline constexpr Values values_of<PressureModel> = {"B", {0, 1, 2, 3, 4, 5, 6}};
template <> inline constexpr Values values_of<Tangential> = {"T", {0, 1, 2, 3}};
template <> inline constexpr Values values_of<Normal> = {"N", {0, 1}};
template <> inline constexpr Values values_of<Prescribed> = {"F", {0, 1, 2}};
template <> inline constexpr Values values_of<InteriorPoints> = {"S", {0, 1, 2, 3}};
template <> inline constexpr Values values_of<FrictionSets> = {"V", {0, 3}};
template <> inline constexpr Values values_of<Law> = {"L", {0, 1, 2, 3, 4, 6}};
template <> inline constexpr Values values_of<GridSource> = {"D", {0, 1, 2}};
template <> inline constexpr Values values_of<Coefficients> = {"C", {0, 1, 2, 3, 4, 9}};
template <> inline constexpr Values values_of<Bulk> = {"M", {0, 1, 2, 3, 4, 5, 6, 7}};
template <> inline constexpr Values values_of<Damping> = {"M2", {0, 1, 2}};
template <> inline constexpr Values values_of<DistanceSource> = {"Z", {0, 1, 2}};
template <> inline constexpr Values values_of<ExtraSlip> = {"E", {0, 1, 2, 3, 9}};
template <> inline constexpr Values values_of<Trace> = {"X", {0, 1}};
template <> inline constexpr Values values_of<Heat> = {"H", {0, 1, 3}};
template <> inline constexpr Values values_of<SolverChoice> = {"G", {0, 1, 2, 3, 4, 5}};
template <> inline constexpr Values values_of<InitialGuess> = {"I", {0, 1, 2, 3}};
template <> inline constexpr Values values_of<Stored> = {"A", {0, 1, 2}};
template <> inline constexpr Values values_of<PrintLevel> = {"O", {0, 1, 2, 3, 4, 5, 6}};
template <> inline constexpr Values values_of<FlowLevel> = {"W", {0, 1, 2, 3, 4, 5, 6, 9}};
template <> inline constexpr Values values_of<Treatment> = {"R", {0, 1, 2, 3}};
template <> inline constexpr Values values_of<Potential> = {"IPOTCN", {-6, -5, -4, -3, -2, -1, 1, 2, 3, 4}};
template <> inline constexpr Values values_of<Base> = {"IBASE", {1, 2, 3, 9}};
template <> inline constexpr Values values_of<Planform> = {"IPLAN", {1, 2, 3, 4}};
template <> inline constexpr Values values_of<Points> = {"ISUBS", {0, 1, 2, 3, 5, 6, 7, 9}};
template <> inline constexpr Values values_of<SubsFile> = {"A_s", {0, 1, 2}};

/// CONTACT's number.
template <class Choice> constexpr int number(Choice choice) {
  return static_cast<int>(choice);
}

/// As messages name it: `P = 0`.
template <class Choice> std::string written(Choice choice) {
  return std::string(values_of<Choice>.name) + " = " + std::to_string(number(choice));
}

/// Throws Error with file, line, `field`, value and the values that there are unless the value is one of them.
void check_value(const Words& words, const std::string& field, int value, const Values& values);

template <class Choice> Choice to_choice(const Words& words, const std::string& field, int value) {
  check_value(words, field, value, values_of<Choice>);
  return static_cast<Choice>(value);
}

/// The next number of the file.
template <class Choice> Choice read_choice(Words& words) {
  using Limits = std::numeric_limits<int>;
  const char* name = values_of<Choice>.name;
  return to_choice<Choice>(words, name, words.integer(name, Limits::min(), Limits::max()));
}

/// The control digits of a case of module 3, by CONTACT's names. Those that say "keep" stand here as they are in the
/// file.
struct Digits {
  Continuation pvtime = Continuation::nothing;
  PressureModel bound = PressureModel::half_space;
  Tangential tang = Tangential::frictionless;
  Normal norm = Normal::approach;
  Prescribed force = Prescribed::creepages;
  InteriorPoints stress = InteriorPoints::none;
  FrictionSets varfrc = FrictionSets::one;
  Law frclaw = Law::coulomb;
  GridSource discns = GridSource::keep;
  Coefficients inflcf = Coefficients::keep;
  Bulk mater = Bulk::elastic;
  Damping damping = Damping::none;
  DistanceSource rznorm = DistanceSource::keep;
  ExtraSlip exrhs = ExtraSlip::none;
  Trace xflow = Trace::none;
  Heat heat = Heat::none;
  SolverChoice gausei = SolverChoice::standard;
  InitialGuess iestim = InitialGuess::nothing;
  Stored matfil = Stored::none;
  PrintLevel output = {};
  FlowLevel flow = {};
  Treatment solve = Treatment::solve;

  bool has_friction() const { return tang != Tangential::frictionless; }
  /// In transient or steady rolling.
  bool rolls() const { return tang == Tangential::transient || tang == Tangential::steady; }
  /// Returns whether tractions depend on the ones before: in shifts and transient rolling.
  bool has_history() const { return tang == Tangential::shift || tang == Tangential::transient; }
  /// Returns whether the pressure is that of Hertz's ellipse, or of two half ones.
  bool takes_ellipse() const {
    return bound == PressureModel::elliptic || bound == PressureModel::parabolic ||
           bound == PressureModel::half_ellipses;
  }
  bool is_fastrip() const {
    return mater == Bulk::fastrip || mater == Bulk::fastrip_first || mater == Bulk::fastrip_first_bounded;
  }
  /// FaStrip as it was published.
  bool is_first_fastrip() const { return mater == Bulk::fastrip_first || mater == Bulk::fastrip_first_bounded; }
  /// Returns whether tractions are those of the simplified theory.
  bool is_simplified() const {
    return has_friction() && (mater == Bulk::fastsim_one || mater == Bulk::fastsim || is_fastrip());
  }
  /// Returns whether material and rolling data are read.
  bool reads_material() const { return inflcf != Coefficients::keep && inflcf != Coefficients::form; }
  bool is_skipped() const { return solve == Treatment::skip_and_stay || solve == Treatment::skip; }
  bool stays_in_module() const { return solve == Treatment::solve_and_stay || solve == Treatment::skip_and_stay; }
};

/// Reads and checks the three control integers; `damping` is M2 where the file has none.
Digits read_digits(Words& words, Damping damping);

} // namespace microslip::contact_program
