#pragma once

#include "microslip/contact/element_grid.hpp"
#include "microslip/elasticity/viscoelastic.hpp"
#include "microslip/exact/halfspace/slip_operator.hpp"
#include "microslip/numerics/even_toeplitz.hpp"
#include "microslip/numerics/toeplitz.hpp"
#include "microslip/progress.hpp"
#include "microslip/vec2.hpp"

#include <array>
#include <span>

namespace microslip {

struct CoupledKernel;
struct TangentialKernel;

/// Normal displacement difference u_z = A_zz p_n (E12) on a grid of elements, for elastically similar
/// bodies.
class NormalOperator {
public:
  /// Throws Stopped if `progress`, which is told of the rows of coefficients, returns false; as the others do.
  NormalOperator(const CombinedMaterial& material, const ElementGrid& grid, const Progress& progress = {},
                 const TransformPlans& plans = {});
  void apply(std::span<const double> pressure, std::span<double> displacement) { zz_.apply(pressure, displacement); }
  /// A symmetric positive map near the inverse of A_zz, also of its part on any area: a preconditioner.
  void apply_near_inverse(std::span<const double> displacement, std::span<double> pressure) {
    zz_.apply_circulant_inverse(displacement, pressure);
  }
  /// Diagonal entry [m/Pa].
  double diagonal() const { return diagonal_; }
  /// Of both kinds, which cost the same.
  long products() const { return zz_.products(); }

private:
  EvenToeplitz zz_;
  double diagonal_;
};

/// What the tangential displacement difference u = A p (E12) on a grid of elements contributes to the slip, D p.
class TangentialOperator : public SlipOperator {
public:
  /// u at the points `shift` [m] further, over the distance `length` [m]: D = A(x + shift)/length.
  static TangentialOperator displacement(const Bodies& bodies, const ElementGrid& grid, Vec2 shift = {},
                                         double length = 1, const Progress& progress = {});
  /// Difference of u along the rolling direction, for particles that come from x + step, over the distance |step| [m]:
  /// D = (A(x) - A(x + step))/|step| (E14).
  static TangentialOperator difference(const Bodies& bodies, const ElementGrid& grid, double step,
                                       const Progress& progress = {});

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

/// What tractions and pressure on a grid of elements contribute to slip and to the normal displacement difference (B1).
/// For any two bodies.
class CoupledOperator {
public:
  /// Slip: u at the points `shift` [m] further, over the distance `length` [m].
  static CoupledOperator displacement(const Bodies& bodies, const ElementGrid& grid, Vec2 shift = {}, double length = 1,
                                      const Progress& progress = {});
  /// Slip: difference of u along the rolling direction, for particles that come from x + step, over the distance |step|
  /// [m].
  static CoupledOperator difference(const Bodies& bodies, const ElementGrid& grid, double step,
                                    const Progress& progress = {});

  /// p = (px, py, p_n) [Pa]; out = (sx, sy, u_n) or its first two.
  using Fields = std::array<std::span<const double>, 3>;
  void apply(const Fields& p, std::span<const std::span<double>> out);
  /// Diagonal entries of an interior element: the mean of D_xx and D_yy; A_zz [m/Pa].
  double slip_diagonal() const { return slip_diagonal_; }
  double normal_diagonal() const { return normal_diagonal_; }
  long products() const { return transform_.products(); }

private:
  explicit CoupledOperator(const CoupledKernel& kernel);

  ToeplitzTransform transform_;
  ToeplitzTransform::Spectrum xx_, xy_, yy_, xz_, yz_, zx_, zy_, zz_;
  double slip_diagonal_, normal_diagonal_;
};

} // namespace microslip
