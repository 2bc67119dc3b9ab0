#include "compat/contact/carried_tractions.hpp"

#include <algorithm>
#include <cmath>

namespace microslip::contact_program {
namespace {

using Field = std::vector<double>;
using State = ContactSequence::State;

void keep(State& state, double low, double high) {
  const ElementGrid& grid = state.grid;
  for (Field* field : state.tractions.fields()) {
    if (field->empty()) continue;
    for (int j = 0; j < grid.my; ++j) {
      if (grid.y(j) >= low && grid.y(j) < high) continue;
      const auto row = field->begin() + static_cast<std::ptrdiff_t>(j) * grid.mx;
      std::fill(row, row + grid.mx, 0.0);
    }
  }
}

/// The elements of one axis continued to cover those of another grid as well.
void extend(double& first, int& count, double size, double other_first, double other_last) {
  constexpr double slack = 1e-3;
  const int before = std::max(0, static_cast<int>(std::ceil((first - other_first) / size - slack)));
  const int behind = std::max(0, static_cast<int>(std::ceil((other_last - first) / size - slack)) - (count - 1));
  first -= before * size;
  count += before + behind;
}

void add(Field& sum, const Field& more) {
  if (more.empty()) return;
  if (sum.empty()) {
    sum = more;
    return;
  }
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += more[k];
}

State sum_of(const std::vector<State>& states) {
  State sum;
  for (const State& state : states) {
    if (state.tractions.traction.x.empty()) continue;
    if (sum.tractions.traction.x.empty()) {
      sum = state;
      continue;
    }
    const ElementGrid before = sum.grid, &other = state.grid;
    extend(sum.grid.x0, sum.grid.mx, before.dx, other.x0, other.x(other.mx - 1));
    extend(sum.grid.y0, sum.grid.my, before.dy, other.y0, other.y(other.my - 1));
    sum.tractions = moved_to(sum.grid, sum.tractions, before);
    TangentialState more = moved_to(sum.grid, state.tractions, other);
    const auto from = more.fields(), to = sum.tractions.fields();
    for (std::size_t k = 0; k < to.size(); ++k) add(*to[k], *from[k]);
  }
  return sum;
}

} // namespace

void move_origin(CarriedTractions& carried, double dx, double dy) {
  const auto move = [&](ElementGrid& grid) {
    grid.x0 += dx;
    grid.y0 += dy;
  };
  move(carried.tractions.grid);
  if (carried.springs) move(carried.springs->grid);
}

CarriedTractions part_of(CarriedTractions carried, double low, double high) {
  keep(carried.tractions, low, high);
  if (carried.springs) keep(*carried.springs, low, high);
  return carried;
}

CarriedTractions sum_of(const std::vector<CarriedTractions>& parts) {
  std::vector<State> tractions, springs;
  for (const CarriedTractions& part : parts) {
    tractions.push_back(part.tractions);
    if (part.springs) springs.push_back(*part.springs);
  }
  CarriedTractions sum{sum_of(tractions)};
  if (springs.size() == parts.size()) sum.springs = sum_of(springs);
  return sum;
}

} // namespace microslip::contact_program
