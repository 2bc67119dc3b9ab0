#include "microslip/error.hpp"
#include "microslip/numerics/transforms.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <string>
#include <type_traits>

#include <fftw3.h>

namespace microslip {
namespace {

/// FFTW's planner is not safe from several threads.
std::mutex& planner_lock() {
  static std::mutex mutex;
  return mutex;
}

void destroy(fftw_plan plan) {
  const std::lock_guard lock(planner_lock());
  fftw_destroy_plan(plan);
}
void destroy(fftwf_plan plan) {
  const std::lock_guard lock(planner_lock());
  fftwf_destroy_plan(plan);
}

template <class Real> using PlanOf = std::conditional_t<std::is_same_v<Real, float>, fftwf_plan_s, fftw_plan_s>;
template <class Real> using ComplexOf = std::conditional_t<std::is_same_v<Real, float>, fftwf_complex, fftw_complex>;
template <class Real> using Plan = std::shared_ptr<PlanOf<Real>>;

/// FFTW's functions for sequences one after another.
template <class Real> struct Planner;
template <> struct Planner<double> {
  static auto rows(int n, int count, double* real, fftw_complex* waves) {
    return fftw_plan_many_dft_r2c(1, &n, count, real, nullptr, 1, n, waves, nullptr, 1, n / 2 + 1, FFTW_ESTIMATE);
  }
  static auto rows_back(int n, int count, double* real, fftw_complex* waves) {
    return fftw_plan_many_dft_c2r(1, &n, count, waves, nullptr, 1, n / 2 + 1, real, nullptr, 1, n, FFTW_ESTIMATE);
  }
  static auto columns(int n, int count, fftw_complex* in, fftw_complex* out, int sign) {
    return fftw_plan_many_dft(1, &n, count, in, nullptr, 1, n, out, nullptr, 1, n, sign, FFTW_ESTIMATE);
  }
  static constexpr auto execute_rows = fftw_execute_dft_r2c;
  static constexpr auto execute_rows_back = fftw_execute_dft_c2r;
  static constexpr auto execute_columns = fftw_execute_dft;
};
template <> struct Planner<float> {
  static auto rows(int n, int count, float* real, fftwf_complex* waves) {
    return fftwf_plan_many_dft_r2c(1, &n, count, real, nullptr, 1, n, waves, nullptr, 1, n / 2 + 1, FFTW_ESTIMATE);
  }
  static auto rows_back(int n, int count, float* real, fftwf_complex* waves) {
    return fftwf_plan_many_dft_c2r(1, &n, count, waves, nullptr, 1, n / 2 + 1, real, nullptr, 1, n, FFTW_ESTIMATE);
  }
  static auto columns(int n, int count, fftwf_complex* in, fftwf_complex* out, int sign) {
    return fftwf_plan_many_dft(1, &n, count, in, nullptr, 1, n, out, nullptr, 1, n, sign, FFTW_ESTIMATE);
  }
  static constexpr auto execute_rows = fftwf_execute_dft_r2c;
  static constexpr auto execute_rows_back = fftwf_execute_dft_c2r;
  static constexpr auto execute_columns = fftwf_execute_dft;
};

/// The plans for one length, which are made for any memory of the same alignment.
template <class Real> struct Plans { Plan<Real> forward, backward; };
template <class Real> using KeptPlans = std::map<int, Plans<Real>>;

template <class Real> Plan<Real> owned(PlanOf<Real>* plan) {
  if (plan == nullptr) throw Error("transform: FFTW cannot plan it");
  return {plan, [](PlanOf<Real>* p) { destroy(p); }};
}

template <class Real> ComplexOf<Real>* as_complex(Real* z) {
  return reinterpret_cast<ComplexOf<Real>*>(z);
}

/// A block's lanes one after another, each as n complex numbers; lanes that are not used are zero.
template <class Real> void to_columns(const BlockLines<const Real>& from, int n, int lanes, Real* to) {
  std::fill_n(to, static_cast<std::size_t>(n) * line_size<Real>, Real(0));
  for (int k = 0; k < from.count; ++k) {
    const Real* line = from.first + k * from.stride;
    for (int lane = 0; lane < lanes; ++lane) {
      Real* z = to + 2 * (static_cast<std::size_t>(lane) * n + k);
      z[0] = line[lane], z[1] = line[block_lanes<Real> + lane];
    }
  }
}
template <class Real> void from_columns(const Real* from, int n, int lanes, const BlockLines<Real>& to) {
  for (int k = 0; k < to.count; ++k) {
    Real* line = to.first + k * to.stride;
    for (int lane = 0; lane < lanes; ++lane) {
      const Real* z = from + 2 * (static_cast<std::size_t>(lane) * n + k);
      line[lane] = z[0], line[block_lanes<Real> + lane] = z[1];
    }
  }
}

/// Rows one after another, then their waves.
template <class Real> std::size_t rows_size(int n) {
  const auto rows = static_cast<std::size_t>(RowTransforms<Real>::most_rows) * n;
  return (rows + line_size<Real> - 1) / line_size<Real> * line_size<Real>;
}
template <class Real> ComplexOf<Real>* waves_in(Real* work, int n) {
  return as_complex(work + rows_size<Real>(n));
}

} // namespace

struct TransformPlans::Kept {
  std::mutex mutex;
  KeptPlans<double> rows, columns;
  KeptPlans<float> single_rows, single_columns;

  auto& rows_of(double) { return rows; }
  auto& rows_of(float) { return single_rows; }
  auto& columns_of(double) { return columns; }
  auto& columns_of(float) { return single_columns; }
};

TransformPlans::TransformPlans() : kept_(std::make_shared<Kept>()) {}

template <class Real> struct RowTransforms<Real>::Implementation {
  int n;
  Plans<Real> plans;
};
template <class Real> struct ColumnTransforms<Real>::Implementation {
  int n;
  Plans<Real> plans;
};

template <class Real> std::size_t RowTransforms<Real>::work_size() const {
  const auto n = implementation_->n;
  return rows_size<Real>(n) + 2 * static_cast<std::size_t>(most_rows) * (n / 2 + 1);
}
template <class Real> std::size_t ColumnTransforms<Real>::work_size() const {
  return static_cast<std::size_t>(implementation_->n) * line_size<Real>;
}

template <class Real>
RowTransforms<Real>::RowTransforms(int n, const TransformPlans& plans, InstructionSet /*FFTW chooses*/) {
  if (n < 1) throw Error("transform: n is " + std::to_string(n) + ", not a positive number");
  const std::lock_guard keep(plans.kept().mutex);
  Plans<Real>& kept = plans.kept().rows_of(Real())[n];
  if (!kept.forward) {
    const Buffer<Real> work =
        allocate<Real>(rows_size<Real>(n) + 2 * static_cast<std::size_t>(most_rows) * (n / 2 + 1));
    const std::lock_guard lock(planner_lock());
    kept = {owned<Real>(Planner<Real>::rows(n, most_rows, work.get(), waves_in(work.get(), n))),
            owned<Real>(Planner<Real>::rows_back(n, most_rows, work.get(), waves_in(work.get(), n)))};
  }
  implementation_ = std::make_shared<const Implementation>(Implementation{n, kept});
}

template <class Real>
ColumnTransforms<Real>::ColumnTransforms(int n, const TransformPlans& plans, InstructionSet /*FFTW chooses*/) {
  if (n < 1) throw Error("transform: n is " + std::to_string(n) + ", not a positive number");
  const std::lock_guard keep(plans.kept().mutex);
  Plans<Real>& kept = plans.kept().columns_of(Real())[n];
  if (!kept.forward) {
    const std::size_t size = static_cast<std::size_t>(n) * line_size<Real>;
    const Buffer<Real> in = allocate<Real>(size), out = allocate<Real>(size);
    const std::lock_guard lock(planner_lock());
    const auto plan = [&](int sign) {
      return owned<Real>(
          Planner<Real>::columns(n, block_lanes<Real>, as_complex(in.get()), as_complex(out.get()), sign));
    };
    kept = {plan(FFTW_FORWARD), plan(FFTW_BACKWARD)};
  }
  implementation_ = std::make_shared<const Implementation>(Implementation{n, kept});
}

template <class Real>
void RowTransforms<Real>::forward(const RowPairs<const Real>& rows, int count, int length, Real* waves,
                                  std::size_t block_stride, Real* work) const {
  const int n = implementation_->n, last = n / 2;
  constexpr int lanes = block_lanes<Real>;
  for (int row = 0; row < most_rows; ++row) {
    Real* to = work + static_cast<std::size_t>(row) * n;
    const int given = row < count ? length : 0;
    std::copy_n((row % 2 == 0 ? rows.even : rows.odd) + (given > 0 ? row / 2 * rows.stride : 0), given, to);
    std::fill(to + given, to + n, Real(0));
  }
  Planner<Real>::execute_rows(implementation_->plans.forward.get(), work, waves_in(work, n));
  for (int row = 0; row < count; ++row) {
    const auto* from = waves_in(work, n) + static_cast<std::size_t>(row) * (last + 1);
    for (int k = 0; k <= last; ++k) {
      Real* to = waves + k / lanes * block_stride + row * line_size<Real> + k % lanes;
      to[0] = from[k][0], to[lanes] = from[k][1];
    }
  }
}

template <class Real>
void RowTransforms<Real>::backward(const Real* waves, std::size_t block_stride, const RowPairs<Real>& rows, int count,
                                   int length, Real* work) const {
  const int n = implementation_->n, last = n / 2;
  constexpr int lanes = block_lanes<Real>;
  for (int row = 0; row < most_rows; ++row) {
    auto* to = waves_in(work, n) + static_cast<std::size_t>(row) * (last + 1);
    for (int k = 0; k <= last; ++k) {
      const Real* from = waves + k / lanes * block_stride + row * line_size<Real> + k % lanes;
      to[k][0] = row < count ? from[0] : 0, to[k][1] = row < count ? from[lanes] : 0;
    }
  }
  Planner<Real>::execute_rows_back(implementation_->plans.backward.get(), waves_in(work, n), work);
  for (int row = 0; row < count; ++row)
    std::copy_n(work + static_cast<std::size_t>(row) * n, length,
                (row % 2 == 0 ? rows.even : rows.odd) + row / 2 * rows.stride);
}

template <class Real>
void ColumnTransforms<Real>::forward(const BlockLines<const Real>& in, int lanes, Real* out, Real* work) const {
  const int n = implementation_->n;
  to_columns(in, n, lanes, out);
  Planner<Real>::execute_columns(implementation_->plans.forward.get(), as_complex(out), as_complex(work));
  from_columns(work, n, lanes, BlockLines<Real>{out, line_size<Real>, n});
}
template <class Real>
void ColumnTransforms<Real>::backward(Real* in, const BlockLines<Real>& out, int lanes, Real* work) const {
  const int n = implementation_->n;
  to_columns(BlockLines<const Real>{in, line_size<Real>, n}, n, lanes, work);
  Planner<Real>::execute_columns(implementation_->plans.backward.get(), as_complex(work), as_complex(in));
  from_columns(in, n, lanes, out);
}

template class RowTransforms<double>;
template class RowTransforms<float>;
template class ColumnTransforms<double>;
template class ColumnTransforms<float>;

} // namespace microslip
