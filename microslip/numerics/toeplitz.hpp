#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace microslip {

/// Products with block Toeplitz matrices on an mx x my grid: out(I) = sum_J kernel(I - J) in(J), by fast Fourier
/// transforms on a grid padded to at least (2 mx - 1) x (2 my - 1). Grid functions have index j mx + i, x fastest. The
/// half of the padded grid that is zero is skipped. Cost O(N log N), memory O(N). Distinct objects may be used from
/// distinct threads.
class ToeplitzTransform {
public:
  /// Transforms grid functions with at most `components` components, which are transformed together.
  ToeplitzTransform(int mx, int my, int components);
  ToeplitzTransform(ToeplitzTransform&&) noexcept;
  ToeplitzTransform& operator=(ToeplitzTransform&&) noexcept;
  ~ToeplitzTransform();

  using Spectrum = std::vector<double>;

  /// Transform of a kernel given at the offsets i = 1 - mx .. mx - 1, j = 1 - my .. my - 1, as an array with index
  /// (j + my - 1) (2 mx - 1) + (i + mx - 1). Includes the scaling of the inverse transform.
  Spectrum kernel_spectrum(std::span<const double> kernel);

  /// Transforms grid functions; they stay inside until the next call of load.
  void load(std::span<const std::span<const double>> in);
  /// out_r = sum_c kernels[r components + c] * in_c, for as many grid functions as were loaded; a null kernel is zero.
  void apply(std::span<const Spectrum* const> kernels, std::span<const std::span<double>> out);

  /// Complex numbers in a padded transform: what a Spectrum has.
  static std::size_t padded_size(int mx, int my);

  int mx() const;
  int my() const;
  /// Products made so far: pairs of load and apply.
  long products() const;

private:
  struct Plans;
  std::unique_ptr<Plans> plans_;
};

} // namespace microslip
