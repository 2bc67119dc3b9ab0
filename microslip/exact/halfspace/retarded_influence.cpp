#include "microslip/exact/halfspace/retarded_influence.hpp"

#include "microslip/numerics/gauss_legendre.hpp"
#include "microslip/numerics/tanh_sinh.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {
namespace {

void add_retarded(InteriorState& to, double factor, const InteriorState& a) {
  to.ux += factor * a.ux;
  to.uy += factor * a.uy;
  to.uz += factor * a.uz;
}

void add_retarded(InteriorInfluence& to, double factor, const InteriorInfluence& a) {
  add_retarded(to.px, factor, a.px);
  add_retarded(to.py, factor, a.py);
  add_retarded(to.pn, factor, a.pn);
}

void add_retarded(Influence& to, double factor, const Influence& a) {
  add(to, factor, a);
}

/// Integrals of exp(-q/l)/l A(x + sign q) over q (B4), (B5), sign = +-1, l > 0.
template <class Value> class RetardedIntegral {
public:
  RetardedIntegral(const RowInfluence<Value>& influence, double dx, double length, double sign)
      : influence_(influence), dx_(dx), length_(length), sign_(sign) {}

  /// Integral from 0 to `end`.
  Value up_to(double x, double end) const {
    end = std::min(end, farthest * length_);
    std::vector<double> breaks = {0, end};
    const auto add_break = [&](double q) {
      if (q > 0 && q < end) breaks.push_back(q);
    };
    for (const double edge : {-dx_, -dx_ / 2, 0.0, dx_ / 2, dx_}) add_break(sign_ * (edge - x));
    for (const double share : {0.25, 1.0, 4.0, 10.0, 20.0}) add_break(share * length_);
    std::sort(breaks.begin(), breaks.end());
    Value sum = {};
    for (std::size_t k = 1; k < breaks.size(); ++k) add_interval(x, breaks[k - 1], breaks[k], sum);
    return sum;
  }
  Value whole(double x) const { return up_to(x, farthest * length_); }

private:
  static constexpr double farthest = 40; // exp(-40) is below rounding

  void add_interval(double x, double from, double to, Value& sum) const {
    static const TanhSinh singular;
    static const GaussLegendre smooth(8);
    const double nearer = std::max(std::abs(x + sign_ * (from + to) / 2) - (to - from) / 2 - dx_, 0.0);
    if (nearer >= 1.5 * (to - from))
      add_nodes(smooth, smooth.count(), x, from, to, sum);
    else
      add_nodes(singular, TanhSinh::count, x, from, to, sum);
  }
  template <class Rule, class Count>
  void add_nodes(const Rule& rule, Count count, double x, double from, double to, Value& sum) const {
    for (Count k = 0; k < count; ++k) {
      const double q = rule.node(k, from, to);
      add_retarded(sum, rule.weight(k, from, to) * std::exp(-q / length_) / length_, influence_(x + sign_ * q));
    }
  }

  const RowInfluence<Value>& influence_;
  double dx_, length_, sign_;
};

} // namespace

template <class Value>
std::vector<Value> retarded_row(const Retardation& retardation, const RowInfluence<Value>& influence, double dx,
                                double x_first, int count) {
  std::vector<Value> row(static_cast<std::size_t>(count));
  const bool forward = retardation.distance >= 0;
  const double length = std::abs(retardation.distance), decay = std::exp(-dx / length);
  const RetardedIntegral<Value> integral(influence, dx, length, forward ? 1 : -1);
  for (int k = 0; k < count; ++k) { // from where the particles come from
    const int i = forward ? count - 1 - k : k;
    const double x = x_first + i * dx;
    Value& here = row[static_cast<std::size_t>(i)];
    if (length == 0) {
      add_retarded(here, retardation.ratio, influence(x));
    } else if (k == 0) {
      add_retarded(here, retardation.ratio, integral.whole(x));
    } else {
      add_retarded(here, retardation.ratio, integral.up_to(x, dx));
      add_retarded(here, decay, row[static_cast<std::size_t>(forward ? i + 1 : i - 1)]);
    }
  }
  return row;
}

template std::vector<Influence> retarded_row(const Retardation&, const RowInfluence<Influence>&, double, double, int);
template std::vector<InteriorInfluence> retarded_row(const Retardation&, const RowInfluence<InteriorInfluence>&, double,
                                                     double, int);

} // namespace microslip
