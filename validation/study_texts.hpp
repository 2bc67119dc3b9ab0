#pragma once

#include <array>
#include <string_view>

namespace microslip::validation {

/// What a study is called and what it shows, in a line.
struct StudyText {
  std::string_view name, summary;
};

/// Of all studies, in the order of their names, for those who tell of them without running them.
inline constexpr std::array study_texts = {
    StudyText{"bentall-johnson", "rolling cylinders of different materials: the cases of Bentall and Johnson"},
    StudyText{"carter", "rolling cylinders against Carter's closed form"},
    StudyText{"cattaneo", "a shifted sphere against the closed form of Cattaneo and Mindlin"},
    StudyText{"cattaneo-to-carter", "a shifted sphere that begins to roll, step by step to the steady state"},
    StudyText{"conicity", "rolling radius difference and equivalent conicity beside closed forms and EN 15302"},
    StudyText{"contact", "a folder of CONTACT's input files, every printed quantity beside its output files"},
    StudyText{"contact-cases", "elements and stresses of the program CONTACT's input files beside what it printed"},
    StudyText{"creep-curve", "longitudinal creep forces of a locomotive's wheel by exact theory"},
    StudyText{"creep-table", "the creep-force table beside exact theory, FASTSIM2 and Polach's formula; times"},
    StudyText{"creep-table-patches", "the creep-force table on patches between wheel and rail that are not elliptic"},
    StudyText{"edge-constants", "where leading elements end inside the edge of contact, for second order"},
    StudyText{"exact-112", "112 of the 3,220 cases by exact theory"},
    StudyText{"exact-test-set", "all 3,220 cases by exact theory: failures, steps, products, time"},
    StudyText{"falling-friction", "friction that falls with the slip: two branches, and a locomotive's creep curve"},
    StudyText{"fastsim2-table1", "Table 1 of the FASTSIM2 paper: FASTSIM2 against exact theory on 3,220 cases"},
    StudyText{"fastsim2-table2", "Table 2 of the FASTSIM2 paper: discretisation errors on 3,220 cases"},
    StudyText{"frictional-power", "power of the classical discretisation on refined elements, for bodies of all kinds"},
    StudyText{"hertz", "the normal problem against Hertz's closed form, and its order"},
    StudyText{"kalker-coefficients", "creepage coefficients without slip beside Kalker's table, and a finer table"},
    StudyText{"layers", "layered bodies beside closed forms and published figures: responses, contact, rolling"},
    StudyText{"manchester", "a wheelset of the Manchester benchmark beside CONTACT, with both theories"},
    StudyText{"measurements", "measured profiles with noise: forces, pressures and conicity beside those without"},
    StudyText{"model-problem", "the 1-D model problem of the FASTSIM2 paper: exact solutions and three strategies"},
    StudyText{"models", "laws of creep forces beside the exact theory on 3,220 ellipses: errors, where, cost"},
    StudyText{"normal-models",
              "models of the normal problem of wheels on rails beside the exact theory: errors, where, cost"},
    StudyText{"random-problems", "20,000 random contacts of all kinds: which are solved, in how many steps"},
    StudyText{"random-wheels",
              "100,000 random wheels on new, worn and measured profiles: statuses, contradictions, times"},
    StudyText{"refinement", "the test of the refinement paper: its figures 1 to 8, and times beside its Table 1"},
    StudyText{"response", "responses over frequency beside differences and transient rolling at five wavelengths"},
    StudyText{"second-order",
              "rolling at second order: Carter, the refinement paper's test, other rolling, the 112 cases"},
    StudyText{"solver-growth", "Table 1 of the refinement paper: how the cost of ConvexGS grows, beside Newton's"},
    StudyText{"spence", "a sphere pressed on a rigid plane with friction, stage by stage"},
    StudyText{"subsurface", "displacements and stresses inside the bodies; how near to the surface they hold"},
    StudyText{"temperature", "surface temperatures of a sliding wheel beside CONTACT's, and Hertzian heat"},
    StudyText{"vehicle", "a car on a multibody program: energy, wavelengths, integrators, forces in a curve"},
    StudyText{"viscoelastic-cylinders", "viscoelastic cylinders in steady rolling, between slow and quick loads"},
    StudyText{"wheel-rail", "a wheel on a rail: continuity, 100,000 random states, derivatives, energy"},
    StudyText{"wheel-surfaces", "the exact theory of wheels on rails on planes and on the true surfaces"},
    StudyText{"wheel-theories", "fast theories of a wheel on a rail beside the exact one; their largest jumps"},
};

} // namespace microslip::validation
