#include "microslip/exact/fitted/nested_rolling.hpp"

#include "microslip/exact/fitted/coarse_start.hpp"

#include <algorithm>
#include <utility>

namespace microslip {
namespace {

constexpr double tolerance_of_coarser = 1e-3; // of the order of the discretisation error between the grids
constexpr double share_of_coarser = 0.2;      // of the work

} // namespace

NestedRolling::NestedRolling(const CombinedMaterial& material, FittedContact contact,
                             std::unique_ptr<NestedRolling> coarser, const Progress& progress,
                             const TransformPlans& plans)
    : rolling_(material, std::move(contact), progress, plans), coarser_(std::move(coarser)) {}

std::vector<double> NestedRolling::bound(double capacity) const {
  std::vector<double> bound = contact().load_share;
  for (double& g : bound) g *= capacity;
  return bound;
}

SecondOrderSolution NestedRolling::solve(double capacity, SecondOrderInput input, const StartOf& start_of) {
  const std::vector<double> bound = this->bound(capacity);
  std::optional<Creepage> near;
  VectorField tractions;
  bool stopped = false;
  if (coarser_) {
    SecondOrderInput on_coarser = input;
    on_coarser.tolerance = std::max(tolerance_of_coarser, input.tolerance);
    on_coarser.progress = [&](double done) {
      return !(stopped = input.progress && !input.progress(share_of_coarser * done));
    };
    const SecondOrderSolution coarse = coarser_->solve(capacity, std::move(on_coarser), start_of);
    if (coarse.friction.status == Status::ok) {
      near = coarse.creepage;
      tractions = start_from_coarser(coarser_->contact(), coarser_->bound(capacity), coarse.friction, contact(), bound);
    }
  }
  RollingStart start = start_of ? start_of(contact(), bound, near) : RollingStart();
  if (near) {
    start.tractions = std::move(tractions);
    start.creepage = Vec2{near->longitudinal, near->lateral};
  }
  input.start = {.px = start.tractions.x, .py = start.tractions.y, .constants = start.creepage, .by_constants = {}};
  for (std::size_t i = 0; i < start.by_creepage.size(); ++i)
    input.start.by_constants[i] = {start.by_creepage[i].x, start.by_creepage[i].y};
  const Progress whole = input.progress;
  if (coarser_) input.progress = part(whole, share_of_coarser, 1);
  if (stopped) input.progress = [](double) { return false; };
  return rolling_.solve(bound, input);
}

} // namespace microslip
