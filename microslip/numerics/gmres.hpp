#pragma once

#include <functional>
#include <span>
#include <vector>

namespace microslip {

/// The generalised minimal residual method (Saad & Schultz 1986) for A x = b with any square matrix, given by its
/// product. The object keeps the memory of its basis, which grows as needed and is used again.
class Gmres {
public:
  using Product = std::function<void(std::span<const double> in, std::span<double> out)>;

  struct Result {
    int products;    ///< with the matrix
    double residual; ///< |b - A x| as the method's recurrence has it
    /// x is the sum of these times the vectors that the products were asked for, in their order: what else is linear
    /// and was found with a product, x has the same sum of it.
    std::vector<double> weights;
  };

  /// Starts from x = 0 and stops when |b - A x| <= tolerance |b| or after `most` products. Cost: products, and for k of
  /// them 2 k^2 operations with vectors.
  Result solve(const Product& matrix, std::span<const double> b, std::span<double> x, double tolerance, int most);

private:
  std::vector<std::vector<double>> basis_;
};

/// sum = the sum of weights[k] vectors[k]; there may be more vectors than weights. Long vectors use OpenMP's threads;
/// results do not depend on their number.
void combine(std::span<const double> weights, const std::vector<std::vector<double>>& vectors, std::span<double> sum);

} // namespace microslip
