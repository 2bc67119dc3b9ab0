#pragma once

#include "microslip/numerics/transform_plans.hpp"
#include "microslip/progress.hpp"

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace microslip {

/// Parity of a function in x and in y: odd if it changes its sign with the coordinate, else even.
struct Parity {
  bool odd_x = false, odd_y = false;
};

/// Products with sums of block Toeplitz matrices on an mx x my grid, out(I) = sum_n sum_J kernel_n(I - J) in_n(J), by
/// fast Fourier transforms, where each kernel is even or odd in both components of the offset. Its transform is then
/// i^p times a real function, p = 0, 1, 2, that is known from a quarter of the plane: a quarter of the numbers and of
/// the work that a kernel without symmetry takes. Grid functions have index j mx + i, x fastest; the padded grid has at
/// least 2 mx x 2 my points, but a single row is not padded. Results do not depend on the number of OpenMP threads,
/// which large grids use. Distinct objects may be used from distinct threads.
class ParityToeplitz {
public:
  explicit ParityToeplitz(int mx, int my, const TransformPlans& plans = {});
  ParityToeplitz(ParityToeplitz&&) noexcept;
  ParityToeplitz& operator=(ParityToeplitz&&) noexcept;
  ~ParityToeplitz();

  /// A kernel's transform on a quarter of the plane, with the scaling of the inverse transform. About mx my numbers.
  using Spectrum = std::vector<double>;
  /// Sets a kernel's entries at the offsets of j rows and 0, 1 ... mx - 1 columns.
  using KernelRow = std::function<void(int j, std::span<double> entries)>;
  /// The kernel is asked for j = 0 ... my - 1 in turn. What is not zero where parity demands it counts as zero.
  /// `progress` is called often, here and below; where it returns false Stopped is thrown.
  Spectrum spectrum(Parity parity, const KernelRow& kernel, const Progress& progress = {});

  /// Transforms grid functions; they stay inside until the next call of load.
  void load(std::span<const std::span<const double>> in, const Progress& progress = {});

  struct Term {
    std::size_t in; ///< number of the grid function
    const Spectrum* kernel;
    Parity parity;
  };
  /// The sum of the terms' products in some rows of the grid, one after another: out holds mx numbers of each. A
  /// few rows cost less than all.
  void apply(std::span<const Term> terms, std::span<const int> rows, std::span<double> out,
             const Progress& progress = {});

private:
  struct Plans;
  std::unique_ptr<Plans> plans_;
};

} // namespace microslip
