#pragma once

#include "compat/contact/digits.hpp"
#include "compat/contact/units.hpp"

#include <array>
#include <vector>

namespace microslip::contact_program {

/// The potential contact as a CONTACT file gives it [m], [1/m], [-].
struct PotentialContact {
  Potential kind = Potential::corner_and_size;
  int mx = 0, my = 0;
  /// -1: A1 B1; -2: A1 AOB; -3: AA BB; -4: A1 BB; -5: AA BB; -6: AA BNEG BPOS; 1: XL YL DX DY; 2: XL YL XH YH; 3: XC1
  /// YC1 DX DY; 4: XC1 YC1 XCM YCM.
  std::array<double, 4> values = {};
  double scale = 1; ///< of Hertz's ellipse

  bool is_hertzian() const { return number(kind) < 0; }
  bool is_line() const { return kind == Potential::line_curvature || kind == Potential::line_half_width; }
  std::size_t elements() const { return static_cast<std::size_t>(mx) * static_cast<std::size_t>(my); }
};

/// The undeformed distance and the region in which contact is possible [m].
struct Geometry {
  Base base = Base::quadratic;
  std::vector<double> values = {}; ///< 1: B1 to B6; 2: XM RM Y1 DY1, heights; 3: B1 to B8; 9: each element's
  Planform planform = Planform::all;
  std::vector<double> plan_values = {}; ///< 2: six; 3: XL XH YL YH twice; 4: NPATCH, YSEP, FAC
};

/// Points of the interior field: one of CONTACT's blocks. Indices count from 1, lengths are in m.
struct PointBlock {
  Points kind = Points::end;
  std::vector<int> range = {};                ///< of a range: IXL INC IXH IYL INC IYH
  std::vector<double> x = {}, y = {}, z = {}; ///< indices, or coordinates; z at equal distances: NZ ZL DZ

  bool has_equal_depths() const { return kind == Points::all || kind == Points::range || kind == Points::listed; }
};

/// Unit of a number of Hertz's geometry, from k = 0 on.
Unit unit_of_hertz(Potential kind, std::size_t k);
/// Units of a quadratic form, and of waves.
inline const UnitList units_of_quadratic = {-1, -1, -1, 0, 0, 1};
inline const UnitList units_of_waves = {1, -1, 1, 1, -1, 1, 1, 1};

/// Each reads the records at which `words` stands. Errors as those of Words.
PotentialContact read_potential_contact(Words& words);
Geometry read_geometry(Words& words, const PotentialContact& potential);
std::vector<PointBlock> read_points(Words& words);

} // namespace microslip::contact_program
