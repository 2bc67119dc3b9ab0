// The influences of a wheel's rows on each other, compiled once for every instruction set.

#include "microslip/railway/rows/kernel/row_pairs.hpp"

#include "microslip/railway/rows/kernel/row_pair.hpp"

namespace microslip::detail {
namespace {

using Vector = Lanes<double>;
static_assert(row_block % Vector::width == 0);

void add_row(const RowPairs& r, int k, int j) {
  const int at = k * r.stride + j;
  const Vector distance = Vector::load(r.distance + at), factor = Vector::load(r.factor + at), half = r.half_width[k];
  const auto v =
      RowPair<Vector>::between(distance - half, distance + half, Vector::load(r.half_length + j), r.half_length[k]);
  const Vector load = r.load[k], by_load = load * Vector(r.by_load[k]), weighted = factor * load;
  (factor * (v.p + v.by_b * by_load)).store(r.gap_by_load + at);
  (Vector(-0.5) * weighted * v.by_b).store(r.gap_by_kappa + at);
  (-(factor * (v.by_a + v.by_ab * by_load))).store(r.turn_by_load + at);
  (Vector(0.5) * weighted * v.by_ab).store(r.turn_by_kappa + at);
  (Vector::load(r.displacement + j) + weighted * v.p).store(r.displacement + j);
  (Vector::load(r.turn + j) - weighted * v.by_a).store(r.turn + j);
  (Vector::load(r.turn_by_length + j) - weighted * v.by_aa).store(r.turn_by_length + j);
}

void find(const RowPairs& r) {
  for (int j = 0; j < r.stride; ++j) r.displacement[j] = r.turn[j] = r.turn_by_length[j] = 0;
  for (int k = 0; k < r.count; ++k)
    for (int j = 0; j < r.stride; j += Vector::width) add_row(r, k, j);
}

} // namespace

namespace MICROSLIP_INSTRUCTION_SET {

FindRowPairs find_row_pairs() {
  return find;
}

} // namespace MICROSLIP_INSTRUCTION_SET
} // namespace microslip::detail
