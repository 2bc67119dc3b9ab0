#pragma once

#include "microslip/exact/halfspace/element_response.hpp"

#include <istream>
#include <memory>
#include <string>

namespace microslip::contact_program {

/// Influence coefficients times the combined modulus G, of elements of sides dx, dy: all lengths in mm.
struct InfluenceFile {
  std::string name;
  InfluenceTable table;

  /// The coefficients [m/Pa] and the sides [m], for a combined modulus [Pa].
  std::shared_ptr<const InfluenceTable> in_si(double shear_modulus) const;
};

/// A file of influence coefficients as CONTACT has them (C = 9): NMATRIX IACONVEX / LQUASID XYZORDER / LSYMMX LSYMMY /
/// MX MY DX DY, then, for each offset of rows from 1 - MY to MY - 1, two lines of text and MX lines of IX X and the
/// nine coefficients zz zx zy xz xx xy yz yx yy. `%` begins a comment.
///
/// NMATRIX = 1, the same coefficients wherever the loaded element is; LQUASID = 0, XYZORDER = 312, LSYMMX = 1, LSYMMY =
/// 0. Throws Error with file, line, field, value and range for other values, for what is missing, and for numbers that
/// are not finite.
InfluenceFile read_influence_file(std::istream& stream, const std::string& name);

} // namespace microslip::contact_program
