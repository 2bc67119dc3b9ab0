#include "microslip/exact/fitted/patch_response.hpp"

#include "microslip/decimal.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace microslip {

using Complex = std::complex<double>;

namespace {

constexpr double normal_tolerance = 1e-9;
constexpr double edge_movement = 0.1; // of changes, in elements

/// Columns that are in contact.
int columns_in_contact(const ElementGrid& grid, const std::vector<double>& pressure) {
  int low = grid.mx, high = -1;
  for (std::size_t k = 0; k < pressure.size(); ++k) {
    if (!(pressure[k] > 0)) continue;
    const int column = static_cast<int>(k % grid.mx);
    low = std::min(low, column), high = std::max(high, column);
  }
  return high - low + 1;
}

} // namespace

ResponseAmplitudes response_amplitudes(const FittedContact& contact, const FrictionSolution& steady,
                                       const RollingResponse::Change& change, double wavenumber) {
  ResponseAmplitudes out;
  for (std::size_t k = 0; k < contact.elements.size(); ++k) {
    const FittedElement& e = contact.elements[k];
    const double area = e.width() * contact.grid.dy, x = e.centre(), y = contact.grid.y(e.row);
    out.force[0] += area * change.px[k];
    out.force[1] += area * change.py[k];
    out.force[2] += area * (x * change.py[k] - y * change.px[k]);
    if (!steady.sliding[k]) continue;
    const Complex work = change.px[k] * steady.slip.x[k] + steady.traction.x[k] * change.sx[k] +
                         change.py[k] * steady.slip.y[k] + steady.traction.y[k] * change.sy[k];
    out.work -= area * work * std::polar(1.0, -wavenumber * x);
  }
  return out;
}

PatchResponse::PatchResponse(RollingPatch patch, const Progress& progress)
    : patch_(std::move(patch)), bound_(friction_bound(patch_.rolling->contact(), patch_.capacity, patch_.variation)),
      normal_problem_(patch_.material, patch_.grid, progress, patch_.plans) {
  const double least = *std::min_element(patch_.gap.begin(), patch_.gap.end());
  indentation_ = -least;
  for (double& h : patch_.gap) h -= least;
  const int columns = columns_in_contact(patch_.grid, patch_.normal->pressure);
  half_length_ = columns * patch_.grid.dx / 2;
  share_ = std::min(6 * edge_movement / columns, 0.1); // an edge of Hertz's contact moves by a third of it, times a
  path_slip_ = patch_.rolling->slip_by(patch_.solution->friction.traction);
  if (patch_.variation.displacement) {
    const FittedContact& contact = patch_.rolling->contact();
    for (std::size_t k = 0; k < contact.elements.size(); ++k) {
      const FittedElement& e = contact.elements[k];
      const double y = contact.grid.y(e.row), d = e.end - e.point;
      const Vec2 here = patch_.variation.displacement(e.point, y), there = patch_.variation.displacement(e.end, y);
      path_slip_.x[k] += (here.x - there.x) / d, path_slip_.y[k] += (here.y - there.y) / d;
    }
  }
  press(progress);
}

PatchResponse::Pressed PatchResponse::pressed(const NormalSolution& normal) const {
  if (normal.status != Status::ok)
    throw Error("response: the normal problem is not solved with a little more or less load or roughness: residual " +
                rounded_text(normal.residual, 2));
  if (normal.touches_border && !patch_.normal->touches_border)
    throw Error("grid: with a little more load or roughness contact reaches its rim; responses need a row and a column "
                "more around it");
  const double capacity = patch_.capacity * normal.normal_force / patch_.normal->normal_force;
  return {{refitted(patch_.rolling->contact(), patch_.normal->pressure, normal.pressure), capacity},
          normal.normal_force,
          normal.approach};
}

ContactChange PatchResponse::change(const Pressed& less, const Pressed& more, double step,
                                    const Progress& progress) const {
  return contact_change(patch_.material, less.contact, more.contact, step, patch_.solution->friction.traction,
                        patch_.variation, progress, patch_.plans);
}

/// Finds what changes with the load.
void PatchResponse::press(const Progress& progress) {
  const NormalSolution& at = *patch_.normal;
  const auto with_load = [&](double factor) {
    return pressed(normal_problem_.solve_from(
        at.pressure, patch_.gap, {NormalLoad::Given::force, factor * at.normal_force}, normal_tolerance, progress));
  };
  const Pressed less = with_load(1 - share_), more = with_load(1 + share_);
  stiffness_ = 2 * share_ * at.normal_force / (more.approach - less.approach);
  by_load_ = change(less, more, share_ * at.normal_force, progress);
}

/// Of a change that is `even`, and i times another one that is `odd`.
RollingResponse::Cause PatchResponse::cause_of(const ContactChange& even, const ContactChange* odd,
                                               double wavenumber) const {
  const FittedContact& contact = patch_.rolling->contact();
  RollingResponse::Cause out(contact.elements.size());
  out.bound.resize(contact.elements.size());
  for (const auto& [change, factor] : {std::pair{&even, Complex(1)}, {odd, Complex(0, 1)}}) {
    if (!change) continue;
    for (std::size_t k = 0; k < contact.elements.size(); ++k) {
      const FittedElement& e = contact.elements[k];
      const double d = e.end - e.point;
      const double spin = patch_.solution->creepage.spin + patch_.variation.creepage_at(contact.grid.y(e.row)).spin;
      const Complex before = std::polar(1.0, -wavenumber * d), end = before * change->end[k];
      const Complex stretch = (end - change->point[k]) / d, shift = (change->point[k] + end) / 2.0;
      out.cx[k] += factor * ((change->at_point.x[k] - before * change->at_end.x[k]) / d - path_slip_.x[k] * stretch);
      out.cy[k] += factor * ((change->at_point.y[k] - before * change->at_end.y[k]) / d - path_slip_.y[k] * stretch +
                             spin * shift);
      out.bound[k] += factor * change->bound[k];
    }
  }
  return out;
}

ResponseAmplitudes PatchResponse::amplitudes_of(const RollingResponse::Change& change, double wavenumber) const {
  return response_amplitudes(patch_.rolling->contact(), patch_.solution->friction, change, wavenumber);
}

/// Adds those of the steady tractions on elements that change their sizes and places.
void PatchResponse::add_moved(const ContactChange& change, Complex factor, double wavenumber,
                              ResponseAmplitudes& out) const {
  const FittedContact& contact = patch_.rolling->contact();
  const FrictionSolution& friction = patch_.solution->friction;
  for (std::size_t k = 0; k < contact.elements.size(); ++k) {
    const FittedElement& e = contact.elements[k];
    const double px = friction.traction.x[k], py = friction.traction.y[k], x = e.centre(), y = contact.grid.y(e.row);
    const Complex area = factor * (change.width[k] * contact.grid.dy);
    const Complex moved = factor * (change.point[k] * e.width() * contact.grid.dy);
    out.force[0] += area * px;
    out.force[1] += area * py;
    out.force[2] += area * (x * py - y * px) + moved * py;
    if (!friction.sliding[k]) continue;
    const double work = -(px * friction.slip.x[k] + py * friction.slip.y[k]);
    out.work += work * (area - Complex(0, wavenumber) * moved) * std::polar(1.0, -wavenumber * x);
  }
}

ResponseAmplitudes PatchResponse::respond_to(const ContactChange& even, const ContactChange* odd, double wavenumber,
                                             double tolerance, const Progress& progress) {
  const RollingResponse::Change change = patch_.rolling->respond_to(cause_of(even, odd, wavenumber), bound_,
                                                                    *patch_.solution, wavenumber, tolerance, progress);
  products_ += change.products;
  ResponseAmplitudes out = amplitudes_of(change, wavenumber);
  add_moved(even, 1, wavenumber, out);
  if (odd) add_moved(*odd, Complex(0, 1), wavenumber, out);
  return out;
}

void PatchResponse::find_by_roughness(double wavenumber, double tolerance, ForceResponse& out,
                                      const Progress& progress) {
  const NormalSolution& at = *patch_.normal;
  const double amplitude = share_ * at.normal_force / (stiffness_ * (1 + wavenumber * half_length_));
  const auto with_roughness = [&](double height, bool is_odd) {
    std::vector<double> gap = patch_.gap;
    for (std::size_t k = 0; k < gap.size(); ++k) {
      const double phase = wavenumber * patch_.grid.x(static_cast<int>(k % patch_.grid.mx));
      gap[k] -= height * (is_odd ? std::sin(phase) : std::cos(phase));
    }
    return pressed(normal_problem_.solve_from(at.pressure, gap, {NormalLoad::Given::approach, indentation_},
                                              normal_tolerance, progress));
  };
  const Pressed lower = with_roughness(-amplitude, false), higher = with_roughness(amplitude, false);
  const Pressed behind = with_roughness(-amplitude, true), ahead = with_roughness(amplitude, true);
  const ContactChange even = change(lower, higher, amplitude, progress);
  const ContactChange odd = change(behind, ahead, amplitude, progress);
  out.load_by_roughness =
      Complex(higher.normal_force - lower.normal_force, ahead.normal_force - behind.normal_force) / (2 * amplitude);
  const ResponseAmplitudes found = respond_to(even, &odd, wavenumber, tolerance, progress);
  std::copy_n(found.force, 3, out.by_roughness);
  out.work_by_roughness = found.work;
}

void PatchResponse::find_by_creepages(double wavenumber, double tolerance, ForceResponse& out,
                                      const Progress& progress) {
  const auto changes = patch_.rolling->respond_to_creepages(bound_, *patch_.solution, wavenumber, tolerance, progress);
  for (std::size_t i = 0; i < changes.size(); ++i) {
    products_ += changes[i].products;
    const ResponseAmplitudes found = amplitudes_of(changes[i], wavenumber);
    for (int k = 0; k < 3; ++k) out.by_creepage[k][i] = found.force[k];
    out.work_by_creepage[i] = found.work;
  }
}

ForceResponse PatchResponse::at(double wavenumber, ResponseTo causes, double tolerance, const Progress& progress) {
  ForceResponse out{.wavenumber = wavenumber};
  if (causes != ResponseTo::load_and_roughness) find_by_creepages(wavenumber, tolerance, out, progress);
  const ResponseAmplitudes by_load = respond_to(by_load_, nullptr, wavenumber, tolerance, progress);
  std::copy_n(by_load.force, 3, out.by_load);
  out.work_by_load = by_load.work;
  if (causes != ResponseTo::motion_and_load) find_by_roughness(wavenumber, tolerance, out, progress);
  return out;
}

} // namespace microslip
