#include "microslip/exact/newton/coupled_derivative.hpp"

#include <algorithm>
#include <utility>

namespace microslip {

CoupledDerivative::CoupledDerivative(const CoupledFrictionProblem& problem, const CoupledFrictionSolution& solution)
    : problem_(problem), equations_(problem, solution.pressure),
      linearised_(equations_, gmres_, equations_.responses()) {
  std::vector<double> unknowns(equations_.size()), response(equations_.responses());
  equations_.take(solution, unknowns, response);
  equations_.linearise(unknowns, response);
}

CoupledDerivative::Change CoupledDerivative::solve(std::span<const double> dcx, std::span<const double> dcy,
                                                   double dload, double tolerance, const Progress& progress) {
  constexpr int most = 1000;
  const std::size_t n = dcx.size();
  std::vector<double> change(equations_.size()), response(equations_.responses()), right(equations_.size());
  std::transform(dcx.begin(), dcx.end(), response.begin(), [](double c) { return -c; });
  std::transform(dcy.begin(), dcy.end(), response.begin() + static_cast<std::ptrdiff_t>(n),
                 [](double c) { return -c; });
  const bool by_approach = problem_.load.given == NormalLoad::Given::approach;
  if (by_approach) std::fill(response.begin() + static_cast<std::ptrdiff_t>(2 * n), response.end(), dload);
  equations_.derivative(change, response, 0, right);
  if (!by_approach) equations_.add_load(dload, right);
  linearised_.solve(right, 0, tolerance, most, change, {}, [&] { go_on(progress, 0); });
  auto [px, py, pressure] = equations_.fields_of(change);
  return {std::move(px), std::move(py), std::move(pressure)};
}

} // namespace microslip
