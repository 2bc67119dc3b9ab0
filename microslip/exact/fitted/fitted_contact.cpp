#include "microslip/exact/fitted/fitted_contact.hpp"

#include "microslip/error.hpp"
#include "microslip/exact/fitted/contact_edges.hpp"
#include "microslip/exact/fitted/edge_element.hpp"
#include "microslip/exact/fitted/pressure_curvature.hpp"
#include "microslip/numerics/fade.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

namespace microslip {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int margin = 3; // interpolation and moments of the fitted elements reach that far ahead

/// Rule by which leading elements are fitted.
struct LeadingFit {
  double nearest; ///< the distance from their rear sides to the edge is between this and 1 more [elements]
  double (*width)(double distance);
  bool by_centres; ///< displacements are taken at their centres, else at those of the grid's elements
};

/// Widths of 0.6 to 1.57.
constexpr LeadingFit in_steady_rolling = {0.92, leading_element_width, true};
constexpr LeadingFit in_steps = {nearest_edge_of_step, leading_element_width_of_step, false};

/// Appends the elements of a row in contact from `trailing` to `leading`. The elements `behind` are another run's.
void fit_row(const ElementGrid& grid, int row, double trailing, double leading, std::vector<FittedElement>& elements,
             const LeadingFit& fit = in_steady_rolling, double behind = -infinity) {
  const double h = grid.dx, origin = grid.x0 - h / 2;
  const auto cell = [&](int column) {
    return static_cast<std::uint32_t>(row * grid.mx + std::clamp(column, 0, grid.mx - 1));
  };
  const int last = static_cast<int>(std::floor((leading - origin) / h - fit.nearest));
  const double left = origin + last * h, width = h * fit.width((leading - left) / h);
  if (left + width / 2 <= trailing || left < behind) { // shorter than an element
    const double centre = (leading + trailing) / 2;
    const int column = static_cast<int>(std::floor((centre - origin) / h));
    const double point = fit.by_centres ? centre : grid.x(column);
    const double end = fit.by_centres ? leading + h / 2 : point + h;
    elements.push_back({row, cell(column), trailing, leading, point, end, true, true, true});
    return;
  }
  int first = last;
  while (origin + first * h > trailing + 1e-12 * h && origin + (first - 1) * h >= behind) --first;
  const auto point = [&](int column) {
    return column == last && fit.by_centres ? left + width / 2 : origin + column * h + h / 2;
  };
  for (int column = first; column <= last; ++column) {
    const double from = origin + column * h;
    const bool leads = column == last;
    const double to = from + (leads ? width : h);
    const double end = leads && fit.by_centres ? to + h / 2 : point(column + 1);
    elements.push_back({row, cell(column), from, to, point(column), end, leads, leads, column == first});
  }
}

/// The integral of sqrt(1 - t^2) from -1 to t.
double half_disk(double t) {
  const double clamped = std::clamp(t, -1.0, 1.0);
  return (clamped * std::sqrt(1 - clamped * clamped) + std::asin(clamped)) / 2 + std::numbers::pi / 4;
}

/// Gauss and Legendre's rule of eight points on (-1, 1): nodes and weights of the positive half.
constexpr std::array<std::array<double, 2>, 4> gauss = {{{0.1834346424956498, 0.3626837833783620},
                                                         {0.5255324099163290, 0.3137066458778873},
                                                         {0.7966664774136267, 0.2223810344533745},
                                                         {0.9602898564975363, 0.1012285362903763}}};

/// Integrates f(y/b) over a row of the ellipse from y0 b to y1 b; in the angle, as f has square roots at y = +-b.
template <class Function> double integrate_row(double y0, double y1, const Function& f) {
  const double low = std::asin(std::clamp(y0, -1.0, 1.0)), high = std::asin(std::clamp(y1, -1.0, 1.0));
  const double middle = (low + high) / 2, half = (high - low) / 2;
  double sum = 0;
  for (const auto& [node, weight] : gauss)
    for (const double side : {-node, node}) {
      const double angle = middle + side * half;
      sum += weight * std::cos(angle) * f(std::sin(angle));
    }
  return sum * half;
}

} // namespace

FittedContact fit_line(double a, int n, double length) {
  FittedContact contact{ElementGrid::across_line(a, n, margin, length), {}, {}};
  fit_row(contact.grid, 0, -a, a, contact.elements);
  for (const FittedElement& e : contact.elements) {
    // Of sqrt(1 - x^2/a^2), whose integral is pi a/2.
    const double part = half_disk(e.leads ? 1 : e.right / a) - half_disk(e.trails ? -1 : e.left / a);
    contact.load_share.push_back(part * 2 / std::numbers::pi / (e.width() * length));
  }
  return contact;
}

FittedContact fit_ellipse(double a, double b, int n, int m, ContactMotion motion) {
  const LeadingFit& fit = motion == ContactMotion::transient ? in_steps : in_steady_rolling;
  FittedContact contact;
  ElementGrid& grid = contact.grid = ElementGrid::across_ellipse(a, b, n, m, 0);
  grid.mx += 2 * margin;
  grid.x0 -= margin * grid.dx;
  for (int row = 0; row < m; ++row) {
    const double y = (2 * row + 1.0) / m - 1, edge = a * std::sqrt((1 - y) * (1 + y));
    const std::size_t first = contact.elements.size();
    fit_row(grid, row, -edge, edge, contact.elements, fit);

    const double y0 = 2.0 * row / m - 1, y1 = 2.0 * (row + 1) / m - 1;
    double row_sum = 0;
    for (std::size_t k = first; k < contact.elements.size(); ++k) {
      const FittedElement& e = contact.elements[k];
      const double from = e.trails ? -infinity : e.left / a, to = e.leads ? infinity : e.right / a;
      const double share = integrate_row(y0, y1, [&](double t) {
        const double half = std::sqrt((1 - t) * (1 + t)); // of the row's length over a
        return half * half * (half_disk(to / half) - half_disk(from / half));
      });
      contact.load_share.push_back(share);
      row_sum += share;
    }
    // The row's share in closed form: the integral of (3/4) (1 - y^2).
    const double exact = 0.75 * (y1 - y0 - (y1 * y1 * y1 - y0 * y0 * y0) / 3);
    for (std::size_t k = first; k < contact.elements.size(); ++k)
      contact.load_share[k] *= exact / (row_sum * contact.elements[k].width() * grid.dy);
  }
  return contact;
}

FittedContact stretched(FittedContact contact, double along, double across) {
  ElementGrid& grid = contact.grid;
  grid.x0 *= along, grid.dx *= along;
  grid.y0 *= across, grid.dy *= across;
  check(grid); // sizes whose elements underflow or overflow have no positions
  for (FittedElement& e : contact.elements) e.left *= along, e.right *= along, e.point *= along, e.end *= along;
  for (double& share : contact.load_share) share /= along * across;
  return contact;
}

namespace {

void check_pressure(const ElementGrid& grid, std::span<const double> pressure) {
  check(grid);
  if (grid.shape != ElementShape::constant)
    throw Error("grid.shape: elements that are fitted to the edges are constant ones");
  if (pressure.size() != grid.count())
    throw Error("pressure: must have mx times my = " + std::to_string(grid.count()) + " values");
  bool contact = false;
  for (std::size_t k = 0; k < pressure.size(); ++k) {
    if (!(pressure[k] >= 0) || !std::isfinite(pressure[k]))
      throw Error("pressure[" + std::to_string(k) + "]", pressure[k], "Pa", "at least 0 and finite");
    if (!(pressure[k] > 0)) continue;
    contact = true;
    const int column = static_cast<int>(k % grid.mx);
    if (column < 1 || column >= grid.mx - margin)
      throw Error("grid: must have " + std::to_string(margin) + " columns to spare ahead of the contact and 1 behind");
  }
  if (!contact) throw Error("pressure: must be positive at an element at least");
}

/// The traction bound along a run: factor(x) sqrt((x - low)(high - x)), the factor constant on every element. An
/// element's own factor, that of its pressure, counts from 1 to 2 elements inside on; nearer to the edge pressures are
/// bad, and the factor is a straight line through those further inside.
class RunProfile {
public:
  /// `mean` pressures of the grid's elements.
  RunProfile(const ElementGrid& grid, std::span<const double> mean, const ContactRun& run) : grid_(grid), run_(run) {
    first_ = column_of(run.low);
    const int last = std::max(column_of(run.high), first_);
    std::vector<double> own, good;
    for (int i = first_; i <= last; ++i) {
      const double x = grid.x(i), share = 1 - fade(inset(x), good_from, good_to);
      const double shape = shape_between(x - grid.dx / 2, x + grid.dx / 2);
      good.push_back(share);
      own.push_back(share > 0 ? mean[static_cast<std::size_t>(run.row) * grid.mx + i] / shape : 0);
    }
    const double all = mean_factor(own, good);
    const Line low = line(own, good, all, -1), high = line(own, good, all, 1);
    for (int i = first_; i <= last; ++i) {
      const double x = grid.x(i), share = good[i - first_];
      const double nearer_low = fade((x - (run.low + run.high) / 2) / grid.dx, -1, 1);
      const double beside =
          nearer_low * low.at((x - run.low) / grid.dx) + (1 - nearer_low) * high.at((run.high - x) / grid.dx);
      factors_.push_back(share * own[i - first_] + (1 - share) * std::max(beside, smallest_share * all));
    }
  }

  /// The integral from `from` to `to`; infinite ones are the edges.
  double integral(double from, double to) const {
    double sum = 0;
    const int last = first_ + static_cast<int>(factors_.size()) - 1;
    for (int i = from > run_.low ? std::clamp(column_of(from), first_, last) : first_; i <= last; ++i) {
      const double low = i == first_ ? -infinity : grid_.x(i) - grid_.dx / 2;
      const double high = i == last ? infinity : grid_.x(i) + grid_.dx / 2;
      if (low >= to) break;
      sum += factors_[static_cast<std::size_t>(i - first_)] * shape_between(std::max(low, from), std::min(high, to));
    }
    return sum;
  }

private:
  static constexpr double good_from = 1, good_to = 2; // elements from the edge
  static constexpr double reach = 6;                  // elements from the edge, of the straight line
  static constexpr double smallest_share = 0.2;       // of the run's mean factor, that is left at an edge
  static constexpr double trust = 1e-2;               // weight of the run's mean factor without a slope, in elements

  /// Line of the factor over the distance from an edge [elements].
  struct Line {
    double value, slope;
    double at(double distance) const { return value + slope * (distance - good_to); }
  };

  int column_of(double x) const { return static_cast<int>(std::floor((x - grid_.x0) / grid_.dx + 0.5)); }
  double inset(double x) const { return std::min(x - run_.low, run_.high - x) / grid_.dx; }

  double mean_factor(const std::vector<double>& own, const std::vector<double>& good) const {
    double sum = 0, weights = 0;
    for (std::size_t k = 0; k < own.size(); ++k) sum += good[k] * own[k], weights += good[k];
    return weights > 0 ? sum / weights : 1;
  }

  /// Least squares over the elements beside an edge.
  Line line(const std::vector<double>& own, const std::vector<double>& good, double all, int side) const {
    double weights = trust, first = 0, second = trust, values = 0, products = 0;
    for (std::size_t k = 0; k < own.size(); ++k) {
      const double x = grid_.x(first_ + static_cast<int>(k));
      const double distance = (side > 0 ? run_.high - x : x - run_.low) / grid_.dx;
      const double w = good[k] * fade(distance, good_to, reach), d = distance - good_to;
      weights += w, first += w * d, second += w * d * d;
      values += w * (own[k] - all), products += w * d * (own[k] - all);
    }
    const double determinant = weights * second - first * first;
    return {all + (second * values - first * products) / determinant,
            (weights * products - first * values) / determinant};
  }

  double shape_between(double from, double to) const {
    const double middle = (run_.low + run_.high) / 2, half = (run_.high - run_.low) / 2;
    return half_disk((to - middle) / half) - half_disk((from - middle) / half);
  }

  const ElementGrid& grid_;
  const ContactRun& run_;
  int first_ = 0;
  std::vector<double> factors_;
};

} // namespace

namespace {

struct Interval {
  double low = -infinity, high = infinity;
};

/// Shares of the load of a pressure's runs.
class RunShares {
public:
  RunShares(const ElementGrid& grid, std::span<const double> pressure)
      : grid_(grid), pressure_(pressure), mean_(pressure_curvature(grid, pressure)) {
    for (std::size_t k = 0; k < mean_.size(); ++k) mean_[k] = pressure[k] + mean_[k] / 12;
    for (const double p : pressure) total_ += p;
  }

  /// Adds the shares of elements in a run, of which they stand for what lies within the limits.
  void add(const ContactRun& run, const Interval& limits, std::span<const FittedElement> elements,
           std::span<double> shares) const {
    const RunProfile profile(grid_, mean_, run);
    const double* begin = &pressure_[static_cast<std::size_t>(run.row) * grid_.mx];
    double load = 0;
    for (int i = run.first; i <= run.last; ++i) load += begin[i];
    const double whole = profile.integral(-infinity, infinity);
    for (std::size_t k = 0; k < elements.size(); ++k) {
      const FittedElement& e = elements[k];
      const double part = profile.integral(e.trails ? limits.low : e.left, e.leads ? limits.high : e.right) / whole;
      shares[k] += part * load / (total_ * e.width() * grid_.dy);
    }
  }

private:
  const ElementGrid& grid_;
  std::span<const double> pressure_;
  std::vector<double> mean_; ///< pressures of the elements
  double total_ = 0;
};

std::span<const ContactRun> runs_of_row(std::span<const ContactRun> runs, int row) {
  const auto [first, last] = std::equal_range(runs.begin(), runs.end(), ContactRun{.row = row},
                                              [](const ContactRun& a, const ContactRun& b) { return a.row < b.row; });
  return {first, last};
}

/// Columns that two runs of a row have in common.
int common_columns(const ContactRun& a, const ContactRun& b) {
  return std::max(std::min(a.last, b.last) - std::max(a.first, b.first) + 1, 0);
}

/// What a run's elements stand for: up to the middles between it and the runs of its row before and after it.
Interval limits_of(std::span<const ContactRun> runs, std::size_t k) {
  Interval limits;
  const ContactRun& run = runs[k];
  if (k > 0 && runs[k - 1].row == run.row) limits.low = (runs[k - 1].high + run.low) / 2;
  if (k + 1 < runs.size() && runs[k + 1].row == run.row) limits.high = (run.high + runs[k + 1].low) / 2;
  return limits;
}

/// Moves the elements of a run with its edges.
void move_edges(const ElementGrid& grid, const ContactRun& before, const Interval& after,
                std::span<FittedElement> elements) {
  FittedElement& leading = elements.back();
  if (elements.size() == 1 && leading.left == before.low) { // shorter than an element
    leading.left = after.low, leading.right = after.high;
  } else {
    const double distance = std::clamp((after.high - leading.left) / grid.dx, edge_distance(narrowest_leading_element),
                                       edge_distance(widest_leading_element));
    leading.right = leading.left + grid.dx * leading_element_width(distance);
  }
  leading.point = leading.centre(), leading.end = leading.right + grid.dx / 2;
  if (elements.size() > 1) elements[elements.size() - 2].end = leading.point;
}

} // namespace

FittedContact fit_contact(const ElementGrid& grid, std::span<const double> pressure) {
  check_pressure(grid, pressure);
  FittedContact contact{grid, {}, {}};
  const RunShares shares(grid, pressure);
  for (const ContactRun& run : contact_runs(grid, pressure)) {
    const std::size_t first = contact.elements.size();
    const bool follows = first > 0 && contact.elements.back().row == run.row;
    fit_row(grid, run.row, run.low, run.high, contact.elements, in_steady_rolling,
            follows ? contact.elements.back().right : -infinity);
    contact.load_share.resize(contact.elements.size());
    shares.add(run, {}, std::span(contact.elements).subspan(first), std::span(contact.load_share).subspan(first));
  }
  return contact;
}

FittedContact refitted(FittedContact contact, std::span<const double> before, std::span<const double> pressure) {
  check_pressure(contact.grid, pressure);
  const RunShares shares(contact.grid, pressure);
  const std::vector<ContactRun> runs = contact_runs(contact.grid, pressure), olds = contact_runs(contact.grid, before);
  std::fill(contact.load_share.begin(), contact.load_share.end(), 0.0);
  std::size_t first = 0;
  for (std::size_t k = 0; k < olds.size(); ++k) {
    const ContactRun& old = olds[k];
    std::size_t end = first + 1;
    while (end < contact.elements.size() && !contact.elements[end].trails) ++end;
    const std::span elements = std::span(contact.elements).subspan(first, end - first);
    const std::span share = std::span(contact.load_share).subspan(first, end - first);
    const Interval limits = limits_of(olds, k);
    const auto row = runs_of_row(runs, old.row);
    const auto most = std::max_element(row.begin(), row.end(), [&](const ContactRun& a, const ContactRun& b) {
      return common_columns(a, old) < common_columns(b, old);
    });
    if (most != row.end() && common_columns(*most, old) > 0)
      move_edges(contact.grid, old, {std::max(most->low, limits.low), std::min(most->high, limits.high)}, elements);
    for (const ContactRun& run : row) // several into which it has parted
      if (common_columns(run, old) > 0) shares.add(run, limits, elements, share);
    first = end;
  }
  return contact;
}

} // namespace microslip
