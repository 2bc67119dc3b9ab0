#include "microslip/rolling/step_derivatives.hpp"

#include <utility>

namespace microslip {

ExactDerivatives with_derivatives(ContactSequence& sequence, ContactStep step, ContactSolution solution,
                                  const Progress& progress) {
  ExactDerivatives out{.solution = std::move(solution)};
  if (out.solution.report.status != Status::ok || !(out.solution.totals.peak_pressure > 0)) return out;
  step.motion.progress = progress;
  const ForceChanges changes = sequence.differentiate(step, out.solution);
  const auto column = [](const ForceChange& change, auto set) {
    set(change.fx, 0), set(change.fy, 1), set(change.mz, 2);
  };
  for (int i = 0; i < 3; ++i) column(changes.by_creepage[i], [&](double of, int k) { out.jacobian[k][i] = of; });
  column(changes.by_load, [&](double of, int k) { out.by_load[k] = of; });
  out.products = changes.products;
  return out;
}

} // namespace microslip
