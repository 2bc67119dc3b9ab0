#pragma once

#include "microslip/contact/element_grid.hpp"
#include "microslip/exact/halfspace/element_response.hpp"
#include "microslip/exact/halfspace/offset_kernel.hpp"
#include "microslip/numerics/toeplitz.hpp"

#include <array>
#include <span>
#include <vector>

namespace microslip {

/// The product of CoupledOperator for rows whose planes are turned against one another. Since rotations about x
/// commute, B = R(-t_I) [R(t_J) A R(-r_I)] R(r_J) with t = (1 - c) alpha, r = c alpha, and each sine and cosine of a
/// row is a factor before or behind a product with the Toeplitz matrix A: 3 fields are loaded and 15 read for c = 1, 9
/// and 5 for c = 0, 9 and 15 else, instead of 3 and 3 for a plane. Cost O(N log N), memory O(N).
class InclinedProduct {
public:
  InclinedProduct(const InclinedKernel& kernel, const ElementGrid& grid, const RowInclination& inclination);

  /// Three components, as in CoupledOperator::apply.
  using Fields = std::array<std::span<const double>, 3>;
  void apply(const Fields& p, std::span<const std::span<double>> out);
  /// The displacements of the plane.
  void apply_plane(const Fields& p, std::span<const std::span<double>> out);
  long products() const { return products_; }

private:
  /// A component of R(t) = P_x + cos t P + sin t E, which is one or none of A's, with a sign.
  enum class Part { whole, along, cosine, sine };
  /// Of A and of -A, row by row; empty where a component is zero.
  using Spectra = std::array<std::array<ToeplitzTransform::Spectrum, 9>, 2>;
  using Field = std::vector<double>;

  void transform(const std::array<OffsetTable, 9>& tables, Spectra& spectra);
  const Spectra& of_displacement() const { return slip_is_displacement_ ? slip_ : normal_; }
  void load(const Fields& p);
  void find(const Spectra& spectra, int first, int last);
  void turn_back(Field& lateral, Field& normal) const;
  const ToeplitzTransform::Spectrum* entry(const Spectra& spectra, Part before, int row, Part behind, int column) const;
  const double* factors(Part part, bool of_traction) const;

  ElementGrid grid_;
  std::vector<Part> before_, behind_; ///< the terms of R(t_J) and of R(-r_I)
  bool plane_along_x_; ///< then also (0, p_s) turned, and p_n as it is, are loaded, for the displacement along x
  std::array<std::vector<double>, 2> cosine_, sine_; ///< of t and of r, of each row
  ToeplitzTransform transform_;
  bool slip_is_displacement_; ///< then normal_ is not made
  Spectra slip_, normal_;
  std::vector<Field> loaded_;
  std::array<Field, 3> found_; ///< R(t_J) A R(-r_I) q
  Field term_;
  long products_ = 0;
};

} // namespace microslip
