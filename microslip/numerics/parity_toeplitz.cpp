#include "microslip/numerics/parity_toeplitz.hpp"

#include "microslip/error.hpp"
#include "microslip/numerics/wave_blocks.hpp"

#include <algorithm>
#include <complex>
#include <cstddef>
#include <numbers>

namespace microslip {
namespace {

using Complex = std::complex<double>;

constexpr int lanes = block_lanes<double>, line = line_size<double>;
/// So many rows are summed wave by wave sooner than all of a column are transformed.
constexpr std::size_t few_rows = 8;

/// z = z + f k v, or z + i f k v if `turned`, for the numbers of a line.
void add_product(const double* k, double f, bool turned, const double* v, double* z) {
  if (turned)
    for (int m = 0; m < lanes; ++m) {
      z[m] -= f * k[m] * v[lanes + m];
      z[lanes + m] += f * k[m] * v[m];
    }
  else
    for (int m = 0; m < lanes; ++m) {
      z[m] += f * k[m] * v[m];
      z[lanes + m] += f * k[m] * v[lanes + m];
    }
}

/// to = to + w v for the numbers of a line.
void add_wave(Complex w, const double* v, double* to) {
  for (int m = 0; m < lanes; ++m) {
    to[m] += w.real() * v[m] - w.imag() * v[lanes + m];
    to[lanes + m] += w.real() * v[lanes + m] + w.imag() * v[m];
  }
}

} // namespace

struct ParityToeplitz::Plans {
  /// Work of a thread: lines of all waves of a block's columns, there and back, and memory of the transforms.
  struct Work {
    Buffer<double> sum, rows, scratch;

    explicit Work(std::size_t size)
        : sum(allocate<double>(size)), rows(allocate<double>(size)), scratch(allocate<double>(size)) {}
  };

  int mx, my, nx, ny;
  int kernel_lines; ///< of a block in a kernel's transform: ky = 0 .. ny/2
  WaveBlocks<double> waves;
  ColumnTransforms<double> columns;
  std::vector<double> loaded; ///< transforms of the grid functions, each block after block of ny lines
  std::vector<Work> works;

  Plans(int x, int y, const TransformPlans& plans)
      : mx(x), my(y), nx(padded_size(x)), ny(padded_size(y)), kernel_lines(ny / 2 + 1),
        waves(my, nx, threads_for_grid(nx, ny), 0, plans), columns(ny, plans) {
    for (int i = 0; i < waves.threads(); ++i) works.emplace_back(columns.work_size());
  }

  std::size_t table_size() const { return static_cast<std::size_t>(kernel_lines) * lanes; }
  std::size_t column_size() const { return static_cast<std::size_t>(ny) * line; }
  std::size_t loaded_size() const { return waves.count() * column_size(); }
  template <class Function> void share(int count, const Progress& progress, const Function& function) {
    distribute(count, waves.threads(), progress, [&](int b, int thread, const Progress&) { function(b, thread); });
  }
  static double* line_of(double* lines, int j) { return lines + static_cast<std::ptrdiff_t>(j) * line; }

  // --- kernels

  /// Rows of a kernel, whose transforms are real or imaginary, to the first lines of the table.
  void transform_kernel_rows(bool odd, const KernelRow& kernel, const Progress& progress, Spectrum& to) {
    std::vector<double> rows(static_cast<std::size_t>(my + my % 2) * nx);
    for (int j = 0; j < my; ++j) {
      double* row = rows.data() + static_cast<std::size_t>(j) * nx;
      kernel(j, {row, static_cast<std::size_t>(mx)});
      if (odd) row[0] = 0;
      for (int i = 1; i < mx; ++i) row[nx - i] = odd ? -row[i] : row[i];
    }
    const RowPairs<const double> all = {rows.data(), rows.data() + nx, 2 * static_cast<std::size_t>(nx)};
    share(waves.batches(), progress, [&](int b, int thread) { waves.forward(b, all, nx, thread); });
    for (int b = 0; b < waves.count(); ++b)
      for (int j = 0; j < my; ++j)
        // Waves only: what earlier products left beside them would be rounding errors of the block that is transformed
        // with it.
        std::copy_n(line_of(waves.block(b), j) + (odd ? lanes : 0), waves.lanes_of(b),
                    &to[b * table_size() + static_cast<std::size_t>(j) * lanes]);
  }

  Spectrum spectrum_of(Parity parity, const KernelRow& kernel, const Progress& progress) {
    Spectrum found(waves.count() * table_size());
    transform_kernel_rows(parity.odd_x, kernel, progress, found);
    for (int b = 0; b < waves.count(); b += 2) {
      go_on(progress, 0);
      double* const block = &found[b * table_size()];
      transform_kernel_columns(columns, ny, parity.odd_y, my, block,
                               b + 1 < waves.count() ? block + table_size() : nullptr,
                               {works[0].sum.get(), works[0].rows.get(), works[0].scratch.get()});
    }
    const double scale = 1.0 / nx / ny;
    for (double& value : found) value *= scale;
    return found;
  }

  // --- grid functions

  void transform(std::span<const double> in, const Progress& progress, double* to) {
    const RowPairs<const double> rows = {in.data(), in.data() + mx, 2 * static_cast<std::size_t>(mx)};
    share(waves.batches(), progress, [&](int b, int thread) { waves.forward(b, rows, mx, thread); });
    share(waves.count(), progress, [&](int b, int thread) {
      columns.forward({waves.block(b), line, my}, waves.lanes_of(b), to + b * column_size(),
                      works[thread].scratch.get());
    });
  }

  /// A block of the transform of the terms' sum.
  void add_terms(std::span<const Term> terms, int b, double* sum) const {
    std::fill_n(sum, column_size(), 0.0);
    for (const Term& term : terms) {
      const int power = int(term.parity.odd_x) + int(term.parity.odd_y);
      const double sign = power == 2 ? -1 : 1, mirrored = term.parity.odd_y ? -sign : sign;
      const double* quarter = term.kernel->data() + b * table_size();
      const double* v = loaded.data() + term.in * loaded_size() + b * column_size();
      for (int j = 0; j < ny; ++j) {
        const bool given = j < kernel_lines;
        add_product(quarter + static_cast<std::size_t>(given ? j : ny - j) * lanes, given ? sign : mirrored, power == 1,
                    v + static_cast<std::size_t>(j) * line, line_of(sum, j));
      }
    }
  }

  /// exp(2 pi i ky row/ny).
  Complex wave(int ky, int row) const {
    return std::polar(1.0, 2 * std::numbers::pi * double(static_cast<long>(ky) * row % ny) / ny);
  }

  /// Columns of the product in the chosen rows, to the first lines of the blocks of waves.
  void columns_back(std::span<const Term> terms, std::span<const int> chosen, const Progress& progress) {
    const bool few = chosen.size() <= few_rows;
    std::vector<Complex> w;
    for (std::size_t r = 0; few && r < chosen.size(); ++r)
      for (int ky = 0; ky < ny; ++ky) w.push_back(wave(ky, chosen[r]));
    share(waves.count(), progress, [&](int b, int thread) {
      Work& work = works[thread];
      add_terms(terms, b, work.sum.get());
      if (!few) columns.backward(work.sum.get(), {work.rows.get(), line, my}, waves.lanes_of(b), work.scratch.get());
      for (std::size_t r = 0; r < chosen.size(); ++r) {
        double* to = line_of(waves.block(b), static_cast<int>(r));
        if (!few) {
          std::copy_n(line_of(work.rows.get(), chosen[r]), line, to);
          continue;
        }
        std::fill_n(to, line, 0.0);
        for (int ky = 0; ky < ny; ++ky) add_wave(w[r * ny + ky], line_of(work.sum.get(), ky), to);
      }
      for (const int k : {0, nx / 2}) // real rows have no imaginary part there, rounding apart
        if (k / lanes == b)
          for (std::size_t r = 0; r < chosen.size(); ++r)
            line_of(waves.block(b), static_cast<int>(r))[lanes + k % lanes] = 0;
    });
  }

  void rows_back(int count, const Progress& progress, std::span<double> out) {
    const RowPairs<double> to = {out.data(), out.data() + mx, 2 * static_cast<std::size_t>(mx)};
    share(WaveBlocks<double>::batches_of(count), progress,
          [&](int b, int thread) { waves.backward(b, count, to, mx, thread); });
  }
};

ParityToeplitz::ParityToeplitz(int mx, int my, const TransformPlans& plans) {
  require_count("mx", mx, 1, 100000000);
  require_count("my", my, 1, 100000000);
  plans_ = std::make_unique<Plans>(mx, my, plans);
}
ParityToeplitz::ParityToeplitz(ParityToeplitz&&) noexcept = default;
ParityToeplitz& ParityToeplitz::operator=(ParityToeplitz&&) noexcept = default;
ParityToeplitz::~ParityToeplitz() = default;

ParityToeplitz::Spectrum ParityToeplitz::spectrum(Parity parity, const KernelRow& kernel, const Progress& progress) {
  return plans_->spectrum_of(parity, kernel, progress);
}

void ParityToeplitz::load(std::span<const std::span<const double>> in, const Progress& progress) {
  Plans& p = *plans_;
  p.loaded.resize(in.size() * p.loaded_size());
  for (std::size_t n = 0; n < in.size(); ++n) p.transform(in[n], progress, p.loaded.data() + n * p.loaded_size());
}

void ParityToeplitz::apply(std::span<const Term> terms, std::span<const int> rows, std::span<double> out,
                           const Progress& progress) {
  plans_->columns_back(terms, rows, progress);
  plans_->rows_back(static_cast<int>(rows.size()), progress, out);
}

} // namespace microslip
