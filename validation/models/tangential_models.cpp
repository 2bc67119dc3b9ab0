#include "validation/models/tangential_models.hpp"

#include "io/creep_table_file.hpp"
#include "microslip/rolling/solver.hpp"
#include "microslip/simplified/fastrip.hpp"
#include "microslip/simplified/row_solver.hpp"
#include "microslip/table/creep_force_table.hpp"
#include "validation/models/linear_theory.hpp"
#include "validation/models/polach.hpp"
#include "validation/models/shen_hedrick_elkins.hpp"
#include "validation/models/vermeulen_johnson.hpp"

#include <memory>
#include <utility>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr const char* kalker_1982 = "Kalker 1982";

TangentialModel marching(MarchingScheme scheme, FlexibilityModel flexibility, int cells, TractionBound bound,
                         const char* flexibilities, const char* source) {
  SimplifiedOptions options{.mx = cells, .my = cells};
  options.flexibility = flexibility;
  options.bound = bound;
  const char* name = scheme == MarchingScheme::fastsim ? "FASTSIM" : "FASTSIM2";
  const char* shape = bound == TractionBound::parabolic ? "" : ", elliptic bound";
  return {
      fmt::format("{0}, {1}, {2} x {2}{3}", name, flexibilities, cells, shape), source, true,
      [solver = std::make_shared<RowSolver>(scheme, options)](const EllipticContact& c) { return solver->solve(c); }};
}

/// A share of the initial slope, as vehicle programs have it for rails that are not clean: tractions of the simplified
/// theory depend on the creepages over the flexibilities alone.
TangentialModel with_slope(double share, TangentialModel model) {
  model.name += fmt::format(", {:.0f} % slope", 100 * share);
  model.forces = [share, whole = std::move(model.forces)](EllipticContact c) {
    c.creepage = {share * c.creepage.longitudinal, share * c.creepage.lateral, share * c.creepage.spin};
    return whole(c);
  };
  return model;
}

TangentialModel fastrip(int cells) {
  SimplifiedOptions options{.mx = cells, .my = cells};
  options.bound = TractionBound::elliptic;
  return {fmt::format("FaStrip, {0} x {0}", cells), "Sichani, Enblom & Berg 2016", true,
          [solver = std::make_shared<Fastrip>(options)](const EllipticContact& c) { return solver->solve(c); }};
}

TangentialModel exact(int elements) {
  return {fmt::format("exact theory, second order, {0} x {0}", elements), "Kalker 1990; this project", true,
          [solver = std::make_shared<Solver>(Method{.mx = elements, .my = elements})](const EllipticContact& c) {
            return solver->solve(rolling_problem(c)).forces();
          }};
}

} // namespace

std::vector<TangentialModel> tangential_models() {
  using enum FlexibilityModel;
  using enum MarchingScheme;
  constexpr auto parabolic = TractionBound::parabolic, elliptic = TractionBound::elliptic;
  std::vector<TangentialModel> models = {
      {"linear theory", "Kalker 1967", true, linear_theory},
      {"linear theory, cut off at mu Fn", "Kalker 1967", true, saturated_linear_theory},
      {"Vermeulen & Johnson, without spin", "Vermeulen & Johnson 1964", false, vermeulen_johnson},
      {"Shen, Hedrick & Elkins", "Shen, Hedrick & Elkins 1983a", true, shen_hedrick_elkins},
      {"Polach", "Polach 1999", false, polach_forces},
      marching(fastsim, one, 10, parabolic, "1 flexibility", kalker_1982),
      marching(fastsim, three, 10, parabolic, "3 flexibilities", kalker_1982),
      with_slope(0.75, marching(fastsim, three, 10, parabolic, "3 flexibilities", kalker_1982)),
      marching(fastsim, three, 50, parabolic, "3 flexibilities", kalker_1982),
      marching(fastsim, three, 50, elliptic, "3 flexibilities", kalker_1982),
      fastrip(50),
      marching(fastsim2, one, 10, parabolic, "1 flexibility", "Vollebregt & Wilders 2011"),
      marching(fastsim2, three, 10, parabolic, "3 flexibilities", "Vollebregt & Wilders 2011"),
      marching(fastsim2, blended, 10, parabolic, "blended", "Vollebregt & Wilders 2011; Vollebregt & Voltr")};
  const auto table = std::make_shared<CreepForceTable>(io::read_creep_table(io::shipped_creep_table()));
  models.push_back(
      {"creep-force table", "this project", true, [table](const EllipticContact& c) { return table->solve(c); }});
  for (const int elements : {12, 24}) models.push_back(exact(elements));
  return models;
}

} // namespace microslip::validation
