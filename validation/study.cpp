#include "validation/study.hpp"

#include "validation/bentall_johnson.hpp"
#include "validation/carter.hpp"
#include "validation/cattaneo.hpp"
#include "validation/cattaneo_to_carter.hpp"
#include "validation/conicity.hpp"
#include "validation/contact_cases.hpp"
#include "validation/contact_wheel_rail.hpp"
#include "validation/creep_curve.hpp"
#include "validation/creep_table.hpp"
#include "validation/creep_table_patches.hpp"
#include "validation/edge_constants.hpp"
#include "validation/exact_112.hpp"
#include "validation/exact_test_set.hpp"
#include "validation/falling_friction.hpp"
#include "validation/fastsim2_table1.hpp"
#include "validation/fastsim2_table2.hpp"
#include "validation/frictional_power.hpp"
#include "validation/hertz.hpp"
#include "validation/kalker_coefficients.hpp"
#include "validation/manchester.hpp"
#include "validation/model_problem.hpp"
#include "validation/random_problems.hpp"
#include "validation/random_wheels.hpp"
#include "validation/refinement.hpp"
#include "validation/second_order.hpp"
#include "validation/solver_growth.hpp"
#include "validation/spence.hpp"
#include "validation/subsurface.hpp"
#include "validation/temperature.hpp"
#include "validation/viscoelastic_cylinders.hpp"
#include "validation/wheel_rail.hpp"
#include "validation/wheel_surfaces.hpp"

#include <algorithm>
#include <array>

namespace microslip::validation {
namespace {

constexpr std::array all_studies = {
    Study{"bentall-johnson", "rolling cylinders of different materials: the cases of Bentall and Johnson",
          run_bentall_johnson},
    Study{"carter", "rolling cylinders against Carter's closed form", run_carter},
    Study{"cattaneo", "a shifted sphere against the closed form of Cattaneo and Mindlin", run_cattaneo},
    Study{"cattaneo-to-carter", "a shifted sphere that begins to roll, step by step to the steady state",
          run_cattaneo_to_carter},
    Study{"conicity", "rolling radius difference and equivalent conicity beside closed forms and EN 15302",
          run_conicity},
    Study{"contact-cases", "the input files of the program CONTACT, every quantity beside what it printed",
          run_contact_cases},
    Study{"contact-wheel-rail", "wheels on rails of the program CONTACT, every quantity beside what it printed",
          run_contact_wheel_rail},
    Study{"creep-curve", "longitudinal creep forces of a locomotive's wheel by exact theory", run_creep_curve},
    Study{"creep-table", "the creep-force table beside exact theory, FASTSIM2 and Polach's formula; times",
          run_creep_table},
    Study{"creep-table-patches", "the creep-force table on patches between wheel and rail that are not elliptic",
          run_creep_table_patches},
    Study{"edge-constants", "where leading elements end inside the edge of contact, for second order",
          run_edge_constants},
    Study{"exact-112", "112 of the 3,220 cases by exact theory", run_exact_112},
    Study{"exact-test-set", "all 3,220 cases by exact theory: failures, steps, products, time", run_exact_test_set},
    Study{"falling-friction", "friction that falls with the slip: two branches, and a locomotive's creep curve",
          run_falling_friction},
    Study{"fastsim2-table1", "Table 1 of the FASTSIM2 paper: FASTSIM2 against exact theory on 3,220 cases",
          run_fastsim2_table1},
    Study{"fastsim2-table2", "Table 2 of the FASTSIM2 paper: discretisation errors on 3,220 cases",
          run_fastsim2_table2},
    Study{"frictional-power", "power of the classical discretisation on refined elements, for bodies of all kinds",
          run_frictional_power},
    Study{"hertz", "the normal problem against Hertz's closed form, and its order", run_hertz},
    Study{"kalker-coefficients", "creepage coefficients without slip beside Kalker's table, and a finer table",
          run_kalker_coefficients},
    Study{"manchester", "a wheelset of the Manchester benchmark beside CONTACT, at both levels", run_manchester},
    Study{"model-problem", "the 1-D model problem of the FASTSIM2 paper: exact solutions and three strategies",
          run_model_problem},
    Study{"random-problems", "20,000 random contacts of all kinds: which are solved, in how many steps",
          run_random_problems},
    Study{"random-wheels", "100,000 random wheels on new, worn and measured profiles: statuses, contradictions, times",
          run_random_wheels},
    Study{"refinement", "the test of the refinement paper: its figures 1 to 8, and times beside its Table 1",
          run_refinement},
    Study{"second-order", "rolling at second order: Carter, the refinement paper's test, other rolling, the 112 cases",
          run_second_order},
    Study{"solver-growth", "Table 1 of the refinement paper: how the cost of ConvexGS grows, beside Newton's",
          run_solver_growth},
    Study{"spence", "a sphere pressed on a rigid plane with friction, stage by stage", run_spence},
    Study{"subsurface", "displacements and stresses inside the bodies; how near to the surface they hold",
          run_subsurface},
    Study{"temperature", "surface temperatures of a sliding wheel beside CONTACT's, and Hertzian heat",
          run_temperature},
    Study{"viscoelastic-cylinders",
          "viscoelastic cylinders in steady rolling, between relaxed and instantaneous modulus",
          run_viscoelastic_cylinders},
    Study{"wheel-rail", "a wheel on a rail: continuity, 100,000 random states, derivatives, energy", run_wheel_rail},
    Study{"wheel-surfaces", "the exact level of wheels on rails on planes and on the true surfaces",
          run_wheel_surfaces},
};

} // namespace

Progress part_of(const Progress& whole, double begin, double end) {
  if (!whole) return {};
  return [whole, begin, end](double fraction) { return whole(begin + fraction * (end - begin)); };
}

std::span<const Study> studies() {
  return all_studies;
}

const Study* find_study(std::string_view name) {
  const auto found =
      std::find_if(all_studies.begin(), all_studies.end(), [name](const Study& s) { return s.name == name; });
  return found == all_studies.end() ? nullptr : &*found;
}

} // namespace microslip::validation
