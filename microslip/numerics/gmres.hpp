#pragma once

#include "microslip/numerics/precision.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace microslip {

/// Most products in one linear system of Newton's methods: the largest size of a Krylov basis.
inline constexpr int most_gmres_products = 300;

/// So many unknowns are many: memory counts, and vectors of the basis are kept in single precision.
inline constexpr std::size_t many_unknowns = std::size_t(1) << 19;

/// The generalised minimal residual method (Saad & Schultz 1986) for A x = b with any square matrix, given by its
/// product. The object keeps the memory of its basis, which grows as needed and is used again. In double or in single
/// precision, the small least squares problem always in double.
template <class Real> class Gmres {
public:
  using Product = std::function<void(std::span<const Real> in, std::span<Real> out)>;

  struct Result {
    int products;    ///< with the matrix
    double residual; ///< |b - A x| as the method's recurrence has it
    /// x is the sum of these times the vectors that the products were asked for, in their order: what else is linear
    /// and was found with a product, x has the same sum of it.
    std::vector<double> weights;
  };

  /// Starts from x = 0 and stops when |b - A x| <= tolerance |b| or after `most` products. Cost: products, and for k of
  /// them 2 k^2 operations with vectors. With a basis in
  /// single precision |b - A x| is known, and reached, to about 1e-7 |b| only.
  /// `basis`: in which precision its vectors are kept, single in any case with many_unknowns.
  Result solve(const Product& matrix, std::span<const Real> b, std::span<Real> x, double tolerance, int most,
               Precision basis = Precision::full);

private:
  template <class Stored>
  Result solve_in(std::vector<std::vector<Stored>>& basis, const Product& matrix, std::span<const Real> b,
                  std::span<Real> x, double tolerance, int most);

  std::vector<std::vector<Real>> basis_;
  std::vector<std::vector<float>> narrow_; ///< instead of it with many unknowns,
  std::vector<Real> in_, next_;            ///< and a vector of it, and the next one, as products have them
};

/// sum = the sum of weights[k] vectors[k]; there may be more vectors than weights. Long vectors use OpenMP's threads;
/// results do not depend on their number.
template <class Stored, class Real>
void combine(std::span<const double> weights, const std::vector<std::vector<Stored>>& vectors, std::span<Real> sum);

} // namespace microslip
