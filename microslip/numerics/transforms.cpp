#include "microslip/error.hpp"
#include "microslip/numerics/kernel/dispatch.hpp"
#include "microslip/numerics/kernel/transform.hpp"

#include <complex>
#include <map>
#include <mutex>
#include <numbers>
#include <string>
#include <vector>

namespace microslip {
namespace detail {

MICROSLIP_DECLARE_KERNEL(void set_kernels(TransformKernels<double>& kernels))
MICROSLIP_DECLARE_KERNEL(void set_kernels(TransformKernels<float>& kernels))

} // namespace detail

namespace {

/// exp(-2 pi i m/n), m = 0 .. n - 1.
std::vector<std::complex<double>> roots_of_unity(int n) {
  std::vector<std::complex<double>> roots(n);
  const auto root = [n](int m) { return std::polar(1.0, -2 * std::numbers::pi * m / n); };
  if (n % 4 != 0) {
    for (int m = 0; m < n; ++m) roots[m] = root(m);
    return roots;
  }
  const int quarter = n / 4;
  for (int m = 0; 2 * m <= quarter; ++m) {
    roots[m] = root(m);
    roots[quarter - m] = {-roots[m].imag(), -roots[m].real()};
  }
  for (int m = quarter; m < n; ++m) roots[m] = {roots[m - quarter].imag(), -roots[m - quarter].real()};
  return roots;
}

/// Large ones first, which read and write least often; a 2 only if nothing else divides.
std::vector<int> radices(int n) {
  std::vector<int> all, odd;
  int rest = n;
  for (const int radix : {5, 3})
    for (; rest % radix == 0; rest /= radix) odd.push_back(radix);
  int twos = 0;
  for (; rest % 2 == 0; rest /= 2) ++twos;
  if (rest != 1) throw Error("transform: n is " + std::to_string(n) + ", with other factors than 2, 3 and 5");
  for (; twos > 4 || twos == 3; twos -= 3) all.push_back(8);
  for (; twos >= 2; twos -= 2) all.push_back(4);
  if (twos == 1) all.push_back(2);
  all.insert(all.end(), odd.begin(), odd.end());
  if (all.empty()) all.push_back(1);
  return all;
}

/// The passes for one length.
template <class Real> class Table {
public:
  explicit Table(int n) : n_(n) {
    if (n < 1) throw Error("transform: n is " + std::to_string(n) + ", not a positive number");
    const auto roots = roots_of_unity(n);
    std::vector<std::size_t> begin;
    int length = n, together = 1;
    for (const int radix : radices(n)) {
      const int groups = length / radix;
      begin.push_back(factors_.size());
      for (int k = 1; k < groups; ++k)
        for (int j = 1; j < radix; ++j) {
          const auto& factor = roots[static_cast<std::size_t>(j) * k * together];
          factors_.push_back(static_cast<Real>(factor.real()));
          factors_.push_back(static_cast<Real>(factor.imag()));
        }
      passes_.push_back({radix, groups, together, nullptr});
      length = groups, together *= radix;
    }
    for (std::size_t i = 0; i < passes_.size(); ++i) passes_[i].factors = factors_.data() + begin[i];
  }
  Table(const Table&) = delete;
  Table& operator=(const Table&) = delete;

  detail::TransformPasses<Real> passes() const { return {n_, static_cast<int>(passes_.size()), passes_.data()}; }

private:
  int n_;
  std::vector<Real> factors_;
  std::vector<detail::TransformPass<Real>> passes_;
};

template <class Real> detail::TransformKernels<Real> kernels_for(InstructionSet instruction_set) {
  using namespace detail;
  TransformKernels<Real> kernels{};
  MICROSLIP_CALL_KERNEL(instruction_set, set_kernels(kernels));
  return kernels;
}

} // namespace

struct TransformPlans::Kept {
  std::mutex mutex;
  std::map<int, std::shared_ptr<const Table<double>>> double_precision;
  std::map<int, std::shared_ptr<const Table<float>>> single_precision;

  auto& tables(double) { return double_precision; }
  auto& tables(float) { return single_precision; }

  template <class Real> std::shared_ptr<const Table<Real>> table(int n) {
    const std::lock_guard lock(mutex);
    auto& kept = tables(Real())[n];
    if (!kept) kept = std::make_shared<const Table<Real>>(n);
    return kept;
  }
};

TransformPlans::TransformPlans() : kept_(std::make_shared<Kept>()) {}

template <class Real> struct RowTransforms<Real>::Implementation {
  std::shared_ptr<const Table<Real>> table;
  detail::TransformKernels<Real> kernels;
};
template <class Real> struct ColumnTransforms<Real>::Implementation {
  std::shared_ptr<const Table<Real>> table;
  detail::TransformKernels<Real> kernels;
};

template <class Real>
RowTransforms<Real>::RowTransforms(int n, const TransformPlans& plans, InstructionSet instruction_set)
    : implementation_(std::make_shared<const Implementation>(
          Implementation{plans.kept().table<Real>(n), kernels_for<Real>(instruction_set)})) {}
template <class Real>
ColumnTransforms<Real>::ColumnTransforms(int n, const TransformPlans& plans, InstructionSet instruction_set)
    : implementation_(std::make_shared<const Implementation>(
          Implementation{plans.kept().table<Real>(n), kernels_for<Real>(instruction_set)})) {}

template <class Real> std::size_t RowTransforms<Real>::work_size() const {
  return detail::row_work_size<Real>(implementation_->table->passes().n);
}
template <class Real> std::size_t ColumnTransforms<Real>::work_size() const {
  return static_cast<std::size_t>(implementation_->table->passes().n) * line_size<Real>;
}

template <class Real>
void RowTransforms<Real>::forward(const RowPairs<const Real>& rows, int count, int length, Real* waves,
                                  std::size_t block_stride, Real* work) const {
  implementation_->kernels.rows_forward(implementation_->table->passes(), rows, count, length, waves, block_stride,
                                        work);
}
template <class Real>
void RowTransforms<Real>::backward(const Real* waves, std::size_t block_stride, const RowPairs<Real>& rows, int count,
                                   int length, Real* work) const {
  implementation_->kernels.rows_backward(implementation_->table->passes(), waves, block_stride, rows, count, length,
                                         work);
}
template <class Real>
void ColumnTransforms<Real>::forward(const BlockLines<const Real>& in, int lanes, Real* out, Real* work) const {
  implementation_->kernels.columns_forward(implementation_->table->passes(), in, lanes, out, work);
}
template <class Real>
void ColumnTransforms<Real>::backward(Real* in, const BlockLines<Real>& out, int lanes, Real* work) const {
  implementation_->kernels.columns_backward(implementation_->table->passes(), in, out, lanes, work);
}

template class RowTransforms<double>;
template class RowTransforms<float>;
template class ColumnTransforms<double>;
template class ColumnTransforms<float>;

} // namespace microslip
