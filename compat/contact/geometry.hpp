#pragma once

#include "compat/contact/words.hpp"

#include <array>
#include <vector>

namespace microslip::contact_program {

/// The potential contact as a CONTACT file gives it [mm], [1/mm], [-].
struct PotentialContact {
  int kind = 0; ///< IPOTCN
  int mx = 0, my = 0;
  /// -1: A1 B1; -2: A1 AOB; -3: AA BB; -4: A1 BB; -5: AA BB; -6: AA BNEG BPOS; 1: XL YL DX DY; 2: XL YL XH YH; 3: XC1
  /// YC1 DX DY; 4: XC1 YC1 XCM YCM.
  std::array<double, 4> values = {};
  double scale = 1; ///< of Hertz's ellipse

  bool is_hertzian() const { return kind < 0; }
  bool is_line() const { return kind == -4 || kind == -5; }
  std::size_t elements() const { return static_cast<std::size_t>(mx) * static_cast<std::size_t>(my); }
};

/// The undeformed distance [mm] and the region in which contact is possible.
struct Geometry {
  int base = 0;                    ///< IBASE: 1 quadratic, 2 circle in x and points in y, 3 waves, 9 by element
  std::vector<double> values = {}; ///< 1: B1 to B6; 2: XM RM Y1 DY1, heights; 3: B1 to B8; 9: each element's
  int planform = 1; ///< IPLAN: 1 all, 2 where a quadratic form is negative, 3 two rectangles, 4 sub-patches
  std::vector<double> plan_values = {}; ///< 2: six; 3: XL XH YL YH twice; 4: NPATCH, YSEP, FAC
};

/// Points of the interior field: one of CONTACT's blocks. Indices count from 1, lengths are in mm.
struct PointBlock {
  int kind = 0; ///< ISUBS: 1, 5 below all elements; 2, 6 below a range; 3, 7 below those listed; 9 anywhere
  std::vector<int> range = {};                ///< 2, 6: IXL INC IXH IYL INC IYH
  std::vector<double> x = {}, y = {}, z = {}; ///< 3, 7: indices; 9: places; z of 1 to 3: NZ ZL DZ
};

/// Each reads the records at which `words` stands. Errors as those of Words.
PotentialContact read_potential_contact(Words& words);
Geometry read_geometry(Words& words, const PotentialContact& potential);
std::vector<PointBlock> read_points(Words& words);

} // namespace microslip::contact_program
