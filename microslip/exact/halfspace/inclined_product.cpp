#include "microslip/exact/halfspace/inclined_product.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {
namespace {

constexpr int lateral = 1, normal = 2; // components; 0 is along x

/// Calls at(j, k) for each element k of each row j.
template <class At> void for_elements(const ElementGrid& grid, At at) {
  const std::size_t mx = grid.mx;
  for (std::size_t k = 0; k < grid.count(); ++k) at(k / mx, k);
}

bool are_equal(const std::array<OffsetTable, 9>& a, const std::array<OffsetTable, 9>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), [](const OffsetTable& x, const OffsetTable& y) {
    return std::equal(x.values().begin(), x.values().end(), y.values().begin());
  });
}

} // namespace

InclinedProduct::InclinedProduct(const InclinedKernel& kernel, const ElementGrid& grid,
                                 const RowInclination& inclination)
    : grid_(grid), before_{Part::along, Part::cosine, Part::sine}, behind_(before_),
      plane_along_x_(inclination.plane_along_x), transform_(grid.mx, grid.my, 3 * static_cast<int>(before_.size())),
      slip_is_displacement_(are_equal(kernel.slip, kernel.displacement)), term_(grid.count()) {
  const double shares[] = {1 - inclination.traction_share, inclination.traction_share};
  if (shares[0] == 0) before_ = {Part::whole};
  if (shares[1] == 0) behind_ = {Part::whole};
  for (std::size_t of = 0; of < 2; ++of)
    for (const double angle : inclination.angle) {
      cosine_[of].push_back(std::cos(shares[of] * angle));
      sine_[of].push_back(std::sin(shares[of] * angle));
    }
  transform(kernel.slip, slip_);
  if (!slip_is_displacement_) transform(kernel.displacement, normal_);
  loaded_.assign(3 * (before_.size() + plane_along_x_), Field(grid.count()));
  found_.fill(Field(grid.count()));
}

void InclinedProduct::transform(const std::array<OffsetTable, 9>& tables, Spectra& spectra) {
  for (std::size_t k = 0; k < tables.size(); ++k) {
    const std::span<const double> values = tables[k].values();
    if (std::all_of(values.begin(), values.end(), [](double value) { return value == 0; })) continue;
    spectra[0][k] = transform_.kernel_spectrum(values);
    spectra[1][k] = spectra[0][k];
    for (double& value : spectra[1][k]) value = -value;
  }
}

/// cos and sin of a term, of each row; none for the others.
const double* InclinedProduct::factors(Part part, bool of_traction) const {
  if (part == Part::cosine) return cosine_[of_traction].data();
  return part == Part::sine ? sine_[of_traction].data() : nullptr;
}

/// The entry of (before) A (behind), with E = [0, -1; 1, 0]; behind A it is -E.
const ToeplitzTransform::Spectrum* InclinedProduct::entry(const Spectra& spectra, Part before, int row, Part behind,
                                                          int column) const {
  const auto turned = [](int component) { return lateral + normal - component; };
  const auto is_out = [](Part part, int component) {
    return part != Part::whole && (part == Part::along) != (component == 0);
  };
  if (is_out(before, row) || is_out(behind, column)) return nullptr;
  bool negative = false;
  if (before == Part::sine) negative ^= row == lateral, row = turned(row);
  if (behind == Part::sine) negative ^= column == lateral, column = turned(column);
  const ToeplitzTransform::Spectrum& of = spectra[negative][static_cast<std::size_t>(row) * 3 + column];
  return of.empty() ? nullptr : &of;
}

/// q = R(r_J) p, times the terms of R(t_J).
void InclinedProduct::load(const Fields& p) {
  const auto &cr = cosine_[1], &sr = sine_[1]; // of the tractions' turn
  for (std::size_t m = 0; m < before_.size(); ++m) {
    const double* factor = factors(before_[m], false);
    Field *x = &loaded_[3 * m], *y = x + lateral, *z = x + normal;
    for_elements(grid_, [&](std::size_t j, std::size_t k) {
      const double f = factor ? factor[j] : 1;
      (*x)[k] = f * p[0][k];
      (*y)[k] = f * (cr[j] * p[lateral][k] - sr[j] * p[normal][k]);
      (*z)[k] = f * (sr[j] * p[lateral][k] + cr[j] * p[normal][k]);
    });
  }
  if (plane_along_x_) {
    Field *y = &loaded_[3], *z = &loaded_[4], *pressure = &loaded_[5];
    for_elements(grid_, [&](std::size_t j, std::size_t k) {
      (*y)[k] = cr[j] * p[lateral][k];
      (*z)[k] = sr[j] * p[lateral][k];
      (*pressure)[k] = p[normal][k];
    });
  }
  const std::vector<std::span<const double>> fields(loaded_.begin(), loaded_.end());
  transform_.load(fields);
}

/// Components first .. last of R(t_J) A R(-r_I) q.
void InclinedProduct::find(const Spectra& spectra, int first, int last) {
  for (int row = first; row <= last; ++row) {
    Field& sum = found_[static_cast<std::size_t>(row)];
    std::fill(sum.begin(), sum.end(), 0.0);
    for (const Part behind : behind_) {
      std::vector<const ToeplitzTransform::Spectrum*> entries;
      for (const Part before : before_)
        for (int column = 0; column < 3; ++column) entries.push_back(entry(spectra, before, row, behind, column));
      if (plane_along_x_) entries.resize(6);
      if (plane_along_x_ && row == 0) {
        std::swap(entries[1], entries[3]);
        std::swap(entries[2], entries[4]);
        if (behind == Part::along) entries[5] = entry(spectra, Part::whole, row, Part::whole, normal);
      }
      transform_.apply(entries, std::array{std::span(term_)});
      const double* factor = factors(behind, true);
      for_elements(grid_, [&](std::size_t j, std::size_t k) { sum[k] += factor ? factor[j] * term_[k] : term_[k]; });
    }
  }
}

/// R(-t_I).
void InclinedProduct::turn_back(Field& y, Field& z) const {
  const auto &c = cosine_[0], &s = sine_[0];
  for_elements(grid_, [&](std::size_t j, std::size_t k) {
    const double across = y[k];
    y[k] = c[j] * across + s[j] * z[k];
    z[k] = c[j] * z[k] - s[j] * across;
  });
}

void InclinedProduct::apply(const Fields& p, std::span<const std::span<double>> out) {
  const bool turns_back = before_.size() > 1;
  ++products_;
  load(p);
  find(slip_, 0, turns_back ? normal : lateral);
  if (turns_back) turn_back(found_[lateral], found_[normal]);
  for (const int row : {0, lateral})
    std::copy(found_[static_cast<std::size_t>(row)].begin(), found_[static_cast<std::size_t>(row)].end(),
              out[static_cast<std::size_t>(row)].begin());
  if (out.size() == 2) return;
  if (!turns_back || !slip_is_displacement_) {
    find(of_displacement(), turns_back ? lateral : normal, normal);
    if (turns_back) turn_back(found_[lateral], found_[normal]);
  }
  std::copy(found_[normal].begin(), found_[normal].end(), out[normal].begin());
}

void InclinedProduct::apply_plane(const Fields& p, std::span<const std::span<double>> out) {
  ++products_;
  transform_.load(p);
  std::array<const ToeplitzTransform::Spectrum*, 9> kernels{};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      kernels[static_cast<std::size_t>(row) * 3 + column] =
          entry(of_displacement(), Part::whole, row, Part::whole, column);
  transform_.apply(std::span(kernels).first(3 * out.size()), out);
}

} // namespace microslip
