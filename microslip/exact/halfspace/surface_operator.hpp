#pragma once

#include "microslip/contact/element_grid.hpp"
#include "microslip/contact/motion.hpp"
#include "microslip/elasticity/viscoelastic.hpp"
#include "microslip/exact/halfspace/element_response.hpp"
#include "microslip/exact/halfspace/inclined_product.hpp"
#include "microslip/exact/halfspace/rolling_preconditioner.hpp"
#include "microslip/exact/halfspace/slip_operator.hpp"
#include "microslip/exact/halfspace/table_rolling_preconditioner.hpp"
#include "microslip/numerics/coupled_toeplitz.hpp"
#include "microslip/numerics/even_toeplitz.hpp"
#include "microslip/numerics/symmetric_toeplitz.hpp"
#include "microslip/numerics/toeplitz.hpp"
#include "microslip/progress.hpp"
#include "microslip/vec2.hpp"

#include <array>
#include <optional>
#include <span>

namespace microslip {

struct CoupledKernel;
struct TangentialKernel;

/// Normal displacement difference u_z = A_zz p_n (E12) on a grid of elements, for elastically similar
/// bodies, or any whose tractions count apart.
class NormalOperator {
public:
  /// Throws Stopped if `progress`, called for the rows of coefficients, returns false; as the others do.
  NormalOperator(const CombinedMaterial& material, const ElementGrid& grid, const Progress& progress = {},
                 const TransformPlans& plans = {});
  /// The part of a table's A_zz that is even along x and y: all of it for elastic bodies.
  NormalOperator(const InfluenceTable& table, const ElementGrid& grid);
  void apply(std::span<const double> pressure, std::span<double> displacement) { zz_.apply(pressure, displacement); }
  /// A symmetric positive map near the inverse of A_zz, also of its part on any area: a preconditioner.
  void apply_near_inverse(std::span<const double> displacement, std::span<double> pressure) {
    zz_.apply_circulant_inverse(displacement, pressure);
  }
  /// Diagonal entry [m/Pa].
  double diagonal() const { return diagonal_; }
  /// Number of products of both kinds; those with the near inverse cost a quarter.
  long products() const { return zz_.products(); }

private:
  EvenToeplitz zz_;
  double diagonal_;
};

/// Contribution of the tangential displacement difference u = A p (E12) on a grid of elements to the slip, D p.
class TangentialOperator : public SlipOperator {
public:
  /// u at the points `shift` [m] further, over the distance `length` [m]: D = A(x + shift)/length.
  static TangentialOperator displacement(const Bodies& bodies, const ElementGrid& grid, Vec2 shift = {},
                                         double length = 1, const Progress& progress = {});
  /// Difference of u along the rolling direction, for particles that come from x + step, over the distance |step| [m]:
  /// D = (A(x) - A(x + step))/|step| (E14). A number is a step along x.
  static TangentialOperator difference(const Bodies& bodies, const ElementGrid& grid, Vec2 step,
                                       const Progress& progress = {});
  static TangentialOperator difference(const Bodies& bodies, const ElementGrid& grid, double step) {
    return difference(bodies, grid, Vec2{step, 0});
  }

  void apply(std::span<const double> px, std::span<const double> py, std::span<double> ux,
             std::span<double> uy) override;
  double diagonal() const override { return diagonal_; }
  long products() const override { return transform_.products(); }

private:
  explicit TangentialOperator(const TangentialKernel& kernel);

  ToeplitzTransform transform_;
  ToeplitzTransform::Spectrum xx_, xy_, yy_;
  double diagonal_;
};

/// Slip and normal displacement difference (B1) due to tractions and pressure on a grid of elements.
/// For any two bodies, and any response of their elements, a product for each of its patches then.
class CoupledOperator {
public:
  /// Slip: u at the points `shift` [m] further, over the distance `length` [m]. With a table of coefficients a shift or
  /// step must be a whole number of elements, else Error is thrown.
  static CoupledOperator displacement(const Bodies& bodies, const ElementGrid& grid, Vec2 shift = {}, double length = 1,
                                      const Progress& progress = {}, const ElementResponse& response = {});
  /// Slip: difference of u along the rolling direction, for particles that come from x + step, over the distance |step|
  /// [m].
  static CoupledOperator difference(const Bodies& bodies, const ElementGrid& grid, Vec2 step,
                                    const Progress& progress = {}, const ElementResponse& response = {});

  /// p = (px, py, p_n) [Pa]; out = (sx, sy, u_n) or its first two.
  using Fields = std::array<std::span<const double>, 3>;
  void apply(const Fields& p, std::span<const std::span<double>> out);
  /// Diagonal entries of an interior element: the mean of D_xx and D_yy; A_zz [m/Pa].
  double slip_diagonal() const { return slip_diagonal_; }
  double normal_diagonal() const { return normal_diagonal_; }
  /// Scales, as SlipOperator::scale, of slip from tractions and of A_zz.
  double slip_scale() const { return slip_scale_; }
  double normal_scale() const { return normal_scale_; }

  /// (qx, qy) = M^-1 (px, py) and q_n = M_n^-1 p_n, where M is near the map from tractions to slip over its scale, M_n
  /// near A_zz over that of the element itself: SymmetricToeplitz::near_inverse, and where slip is a difference
  /// RollingPreconditioner or TableRollingPreconditioner. The influence of pressure on slip, and of tractions on the
  /// normal displacement, is neglected.
  void precondition_tractions(std::span<const double> px, std::span<const double> py, std::span<double> qx,
                              std::span<double> qy);
  void precondition_pressure(std::span<const double> pressure, std::span<double> q);
  /// Sets the elements that are about in contact, those with a pressure, for steady rolling.
  void expect_contact(std::span<const double> pressure, RollingDirection direction);

  long products() const {
    return inclined_ ? inclined_->products() : symmetric_ ? symmetric_->products() : transform_->products();
  }

private:
  using NearInverse = SymmetricToeplitz<double>;

  CoupledOperator(const CoupledKernel& kernel, const ElementGrid& grid, const WeightedPatches& patches);
  void transform(const CoupledKernel& kernel);
  void apply_alike(const Fields& p, std::span<const std::span<double>> out);
  void add_weight_of(int patch, std::span<const double> pressure, std::span<double> displacement);

  ElementGrid grid_;
  WeightedPatches patches_;
  std::optional<CoupledToeplitz> symmetric_;   ///< displacements, where these have its symmetries; slip is over ...
  double length_ = 1;                          ///< [m]
  std::optional<ToeplitzTransform> transform_; ///< else
  ToeplitzTransform::Spectrum xx_, xy_, yx_, yy_, xz_, yz_, zx_, zy_, zz_; ///< of it; no yx: it is xy
  double slip_diagonal_, normal_diagonal_, slip_scale_, normal_scale_;
  std::optional<InclinedProduct> inclined_; ///< instead of the spectra
  std::optional<NearInverse> slip_inverse_; ///< of displacements
  EvenToeplitz normal_inverse_;
  std::optional<RollingPreconditioner<double>> rolling_;    ///< of differences, of half-spaces
  std::optional<TableRollingPreconditioner> table_rolling_; ///< and with a table
};

} // namespace microslip
