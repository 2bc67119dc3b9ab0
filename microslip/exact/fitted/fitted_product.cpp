#include "microslip/exact/fitted/fitted_product.hpp"

#include "microslip/numerics/lanes.hpp"
#include "microslip/numerics/precision.hpp"

#include <algorithm>
#include <utility>

namespace microslip {
namespace {

template <class Real>
typename FittedProduct<Real>::Corrections converted(const FittedProduct<double>::Corrections& from) {
  typename FittedProduct<Real>::Corrections to;
  for (const auto& run : from.runs) to.runs.push_back({run.point, run.element, run.count});
  for (auto [values, other] : {std::pair{&from.xx, &to.xx}, {&from.xy, &to.xy}, {&from.yy, &to.yy}}) {
    other->resize(values->size());
    convert(*values, 1, *other);
  }
  return to;
}

template <class Real> typename FittedProduct<Real>::Tables converted(const FittedProduct<double>::Tables& from) {
  typename FittedProduct<Real>::Tables to;
  for (const auto& p : from.grid_elements) to.grid_elements.push_back({p.element, p.cell});
  for (const auto& m : from.moments) {
    to.moments.push_back({m.element, m.first_cell, {}});
    convert(m.weight, 1, to.moments.back().weight);
  }
  for (const auto& s : from.stencils) {
    to.stencils.push_back({s.point, s.first_cell, {}});
    convert(s.weight, 1, to.stencils.back().weight);
  }
  to.nodes = from.nodes;
  to.at_points = converted<Real>(from.at_points);
  to.of_elements = converted<Real>(from.of_elements);
  to.points = from.points;
  to.end_point = from.end_point;
  to.slip_distance.resize(from.slip_distance.size());
  convert(from.slip_distance, 1, to.slip_distance);
  return to;
}

} // namespace

template <class Real>
FittedProduct<Real>::FittedProduct(Tables tables, SymmetricToeplitz<Real> transform, double compliance)
    : tables_(std::move(tables)), transform_(std::move(transform)), compliance_(compliance),
      px_(tables_.slip_distance.size() + lanes), py_(px_), ux_(tables_.points + lanes), uy_(ux_) {}

template <class Real>
FittedProduct<Real>::FittedProduct(const FittedProduct<double>& other, double factor, const TransformPlans& plans)
    : FittedProduct(converted<Real>(other.tables_), SymmetricToeplitz<Real>(other.transform_, 1, plans),
                    factor * other.compliance_) {}

template <class Real> void FittedProduct<Real>::load(std::span<const Real> px, std::span<const Real> py) {
  std::copy(px.begin(), px.end(), px_.begin());
  std::copy(py.begin(), py.end(), py_.begin());
  const auto [x, y] = transform_.cleared_field();
  for (const GridElement& p : tables_.grid_elements) x[p.cell] = px[p.element], y[p.cell] = py[p.element];
  for (const Moments& m : tables_.moments)
    for (std::size_t i = 0; i < 3; ++i) {
      x[m.first_cell + i] += m.weight[i] * px[m.element];
      y[m.first_cell + i] += m.weight[i] * py[m.element];
    }
}

/// The displacements by the transforms.
template <class Real> void FittedProduct<Real>::read() {
  const auto [x, y] = transform_.apply();
  for (const GridElement& p : tables_.grid_elements) ux_[p.element] = x[p.cell], uy_[p.element] = y[p.cell];
  for (const Stencil& s : tables_.stencils) {
    Real ux = 0, uy = 0;
    for (int i = 0; i < tables_.nodes; ++i) {
      ux += s.weight[i] * x[s.first_cell + i];
      uy += s.weight[i] * y[s.first_cell + i];
    }
    ux_[s.point] = ux, uy_[s.point] = uy;
  }
}

/// A point's sums are kept apart for each lane until its last run.
template <class Real> void FittedProduct<Real>::correct_points() {
  using Vector = WideLanes<Real, lanes>;
  const auto& [runs, xx, xy, yy] = tables_.at_points;
  std::size_t at = 0;
  for (auto run = runs.begin(); run != runs.end();) {
    const std::size_t point = run->point;
    Vector ux = 0, uy = 0;
    for (; run != runs.end() && run->point == point; ++run)
      for (std::size_t k = run->element; k < run->element + run->count; k += lanes, at += lanes) {
        const Vector px = Vector::load(&px_[k]), py = Vector::load(&py_[k]), mixed = Vector::load(&xy[at]);
        ux += Vector::load(&xx[at]) * px + mixed * py;
        uy += mixed * px + Vector::load(&yy[at]) * py;
      }
    ux_[point] += sum(ux);
    uy_[point] += sum(uy);
  }
}

template <class Real> void FittedProduct<Real>::correct_for_elements() {
  using Vector = WideLanes<Real, lanes>;
  const auto& [runs, xx, xy, yy] = tables_.of_elements;
  std::size_t at = 0;
  for (const Run& run : runs) {
    const Vector px = px_[run.element], py = py_[run.element];
    for (std::size_t k = run.point; k < run.point + run.count; k += lanes, at += lanes) {
      const Vector mixed = Vector::load(&xy[at]);
      (Vector::load(&ux_[k]) + Vector::load(&xx[at]) * px + mixed * py).store(&ux_[k]);
      (Vector::load(&uy_[k]) + mixed * px + Vector::load(&yy[at]) * py).store(&uy_[k]);
    }
  }
}

template <class Real>
void FittedProduct<Real>::apply(std::span<const Real> px, std::span<const Real> py, std::span<Real> sx,
                                std::span<Real> sy) {
  load(px, py);
  read();
  correct_points();
  correct_for_elements();
  const auto compliance = static_cast<Real>(compliance_);
  for (std::size_t k = 0; k < tables_.slip_distance.size(); ++k) {
    const std::size_t end = tables_.end_point[k];
    const Real factor = compliance / tables_.slip_distance[k];
    sx[k] = factor * (ux_[k] - ux_[end]);
    sy[k] = factor * (uy_[k] - uy_[end]);
  }
}

template <class Real>
void FittedProduct<Real>::find_displacement_over_way(std::span<Real> ux, std::span<Real> uy) const {
  const auto compliance = static_cast<Real>(compliance_);
  for (std::size_t k = 0; k < tables_.slip_distance.size(); ++k) {
    const Real factor = compliance / tables_.slip_distance[k];
    ux[k] = factor * ux_[k];
    uy[k] = factor * uy_[k];
  }
}

template class FittedProduct<double>;
template class FittedProduct<float>;

} // namespace microslip
