#pragma once

#include "validation/study.hpp"

#include <iosfwd>

namespace microslip::validation {

/// The study `bentall-johnson`. Cylinders of different materials in steady rolling: the examples of Bentall and Johnson
/// as CONTACT's guide has them.
bool run_bentall_johnson(const StudyOptions& options, std::ostream& out);

/// The study `carter`: steady rolling of cylinders against Carter's closed form, by the kernel of line contact, along
/// +x and -x, and on the grid of CONTACT's example.
bool run_carter(const StudyOptions& options, std::ostream& out);

/// The study `cattaneo`: a sphere pressed on a plane and shifted, against the closed form of Cattaneo and Mindlin and
/// CONTACT's figures, and how far that closed form is from the exact solution.
bool run_cattaneo(const StudyOptions& options, std::ostream& out);

/// The study `cattaneo-to-carter`: a sphere is shifted and then rolls two diameters under the same force (Kalker 1990,
/// section 5.2.2.5), beside CONTACT's figures, and its end beside steady rolling solved directly.
bool run_cattaneo_to_carter(const StudyOptions& options, std::ostream& out);

/// Rolling radius difference and equivalent conicity beside closed forms and the tables of EN 15302.
bool run_conicity(const StudyOptions& options, std::ostream& out);

/// Runs the input files of CONTACT in a folder, and puts every quantity that it printed beside ours, digit by digit;
/// groups what differs by its explanation. Throws Error for a folder without such files; without a folder, and where
/// the published results are not there, it says so.
bool run_contact_folder(const StudyOptions& options, std::ostream& out);

/// Runs CONTACT's input files of module 3 on the same elements, and puts every quantity that CONTACT printed beside
/// ours. What is not supported is named and not judged. Needs the folders of published results; without them it says
/// so.
bool run_contact_cases(const StudyOptions& options, std::ostream& out);

/// The study `creep-curve`: longitudinal forces of a locomotive's wheel (Polach 2005) beside CONTACT's on the same
/// grid, and their limit.
bool run_creep_curve(const StudyOptions& options, std::ostream& out);

/// The creep-force table that microslip has beside the exact theory, FASTSIM2 and Polach's formula, on random cases
/// and on the 3,220 cases; smoothness; times.
bool run_creep_table(const StudyOptions& options, std::ostream& out);

/// Forces that the creep-force table gives patches between wheel and rail, at given creepages and spin, beside the
/// exact theory on the same patches; beside them FASTSIM2, the equivalent ellipse and the exact theory on another
/// shape, the simple double-elliptical contact.
bool run_creep_table_patches(const StudyOptions& options, std::ostream& out);

/// The study `edge-constants`: beta(omega) of the leading element that is fitted to the edge of contact, from the
/// half-line in closed form up to quadratures; beside it the limit of finite systems, and edge_inset() of the library.
/// Prints the coefficients of edge_inset().
bool run_edge_constants(const StudyOptions& options, std::ostream& out);

/// The study `exact-112`: forces on 31 x 31 elements beside CONTACT's on the same grid for 112 of the 3,220 cases, and
/// extrapolated beside CONTACT's extrapolated ones. Reads exact_theory_112.csv in the folder of published results that
/// the build was configured with; says so where it is not there.
bool run_exact_112(const StudyOptions& options, std::ostream& out);

/// The study `exact-test-set`: all 3,220 cases by exact theory on three grids, at second order and classically, that
/// from FASTSIM2's tractions and from none: failures, the distribution of Newton steps and products, and time.
bool run_exact_test_set(const StudyOptions& options, std::ostream& out);

/// The study `falling-friction`. Friction that falls with the slip: a cylinder with two branches of solutions, and
/// creep curves of a locomotive's wheel.
bool run_falling_friction(const StudyOptions& options, std::ostream& out);

/// The study `fastsim2-table1`: forces of FASTSIM2 on 640 x 640 cells against those of exact theory for the 3,220
/// cases, beside Table 1 of the FASTSIM2 paper. Writes fastsim2_table1.h5, from which figure 3 is drawn.
bool run_fastsim2_table1(const StudyOptions& options, std::ostream& out);

/// The study `fastsim2-table2`: discretisation errors of FASTSIM and FASTSIM2 on the 3,220 cases beside Table 2 of the
/// FASTSIM2 paper, and the order of convergence. Writes fastsim2_table2.h5, from which figures 4 and 5 are drawn.
bool run_fastsim2_table2(const StudyOptions& options, std::ostream& out);

/// The study `frictional-power`: how `frictional_power` of the classical discretisation and the sum over the fields
/// approach their common limit, for all kinds.
bool run_frictional_power(const StudyOptions& options, std::ostream& out);

/// The study `response`: responses over frequency beside differences of the forces and transient rolling; their cost.
bool run_response(const StudyOptions& options, std::ostream& out);

/// The study `hertz`: load and peak pressure with the approach given, approach with the load given, against the closed
/// form, and the order of convergence; the products that it takes.
bool run_hertz(const StudyOptions& options, std::ostream& out);

/// The study `kalker-coefficients`: creepage coefficients by the series of linear theory and by the solver without
/// slip, beside Kalker's table, and the computed table of the library, which it writes anew.
bool run_kalker_coefficients(const StudyOptions& options, std::ostream& out);

/// The study `layers`: responses of layered bodies beside closed forms, influence numbers beside integrals, a rigid
/// sphere on two layers on steel beside the figures of Yu, Wang & Wang (2014), rolling on thin layers beside springs,
/// and random contacts.
bool run_layers(const StudyOptions& options, std::ostream& out);

/// The study `manchester`: the Manchester benchmark's wheelset (S1002 on UIC 60, Shackleton & Iwnicki 2008) in the 42
/// states of its part, left and right, with both theories beside the forces that CONTACT printed. Needs CONTACT's
/// input files, profiles and stored results; without them it says so.
bool run_manchester(const StudyOptions& options, std::ostream& out);

/// The study `measurements`. Wheels and rails with errors as instruments have them, smoothed by themselves: forces,
/// peak pressures and conicity beside those without errors, and how uncertain pressures are said to be.
bool run_measurements(const StudyOptions& options, std::ostream& out);

/// The study `model-problem`: the paper's three cases of (F20). Transition points beside the printed ones, errors and
/// orders of all strategies; writes model_problem.h5.
bool run_model_problem(const StudyOptions& options, std::ostream& out);

/// The study `models`: laws of creep forces that vehicle programs use beside the exact theory on the 3,220 cases:
/// errors of forces and T-gamma, where the worst ones are, and time. Writes models.h5, from which its picture is drawn.
bool run_models(const StudyOptions& options, std::ostream& out);

/// The study `normal-models`: models of the normal problem, and the laws of creep forces, beside the exact theory for
/// wheels on new, worn and measured rails: errors of area, pressure, extent, height, forces and T-gamma, where the
/// worst ones are, and time. Writes normal_models.h5, from which its picture is drawn.
bool run_normal_models(const StudyOptions& options, std::ostream& out);

/// The study `random-problems`: 20,000 seeded random contacts of all kinds (steady and transient rolling, shifts,
/// forces given, bodies of different materials, viscoelastic ones, layers that yield, friction that falls or heats),
/// each of which has a solution: with creepages given because the traction bound is a continuous function of tractions
/// within it (Brouwer), with forces given because they are those of a problem solved before. Counts those that are not
/// solved and names the first of each kind with its number, which seeds it.
bool run_random_problems(const StudyOptions& options, std::ostream& out);

/// The study `random-wheels`: 100,000 random states of wheels on new, hollow, worn and measured profiles at all levels
/// of theory, up to flange climbing and derailment: what their statuses are, whether these and the numbers agree,
/// whether an unsolved state has a height that would bear its load, and how long the slowest take.
bool run_random_wheels(const StudyOptions& options, std::ostream& out);

/// The study `refinement`: the test of the refinement paper (Vollebregt 2009, sections 3 to 5), its figures 1 to 8 and
/// the times of its Table 1.
bool run_refinement(const StudyOptions& options, std::ostream& out);

/// The study `second-order`: the order of the second-order discretisation on Carter's problem, on the test of the
/// refinement paper and in other rolling; its errors and those of extrapolated forces on the partial-slip ones of the
/// 112 cases, against its limit and against the published one; and how honest the estimate of the error is.
bool run_second_order(const StudyOptions& options, std::ostream& out);

/// The study `solver-growth`: how the cost of ConvexGS grows with the grid on the refinement paper's test, beside its
/// Table 1 and beside FrictionNewton in the same run. Times depend on the machine and are not judged; sweeps, and that
/// both find the same force, are.
bool run_solver_growth(const StudyOptions& options, std::ostream& out);

/// The study `spence`. A sphere pressed on a rigid plane with friction (Spence 1975): step by step, extrapolated.
bool run_spence(const StudyOptions& options, std::ostream& out);

/// The study `subsurface`: displacements and stresses inside the bodies. CONTACT's example of a loaded square; Hertz's
/// contacts against closed forms, how near to the surface that holds; cost; von Mises' stress in wheel and rail.
bool run_subsurface(const StudyOptions& options, std::ostream& out);

/// The study `temperature`: a locomotive's wheel that slides and one that has braked (Ertz & Knothe 2002), beside what
/// CONTACT prints for the same grid, and the closed form of Hertz's heat.
bool run_temperature(const StudyOptions& options, std::ostream& out);

/// The study `vehicle`: a wheelset, a bogie and a car of examples/vehicle, of Simbody's bodies, on our contacts.
/// Energy, mirrored runs, wavelengths, integrators and their steps, forces in a curve; ten minutes with `thorough`.
/// Says so where microslip was built without Simbody.
bool run_vehicle(const StudyOptions& options, std::ostream& out);

/// The study `viscoelastic-cylinders`. Viscoelastic cylinders (Wang and Knothe 1993): CONTACT's table, and the limits
/// of slow and quick loads.
bool run_viscoelastic_cylinders(const StudyOptions& options, std::ostream& out);

/// The study `wheel-theories`: forces of a wheel by the fast theories and on coarse elements beside the exact theory on
/// fine ones, in random states of new and worn profiles; and the largest jump of each, found by bisection.
bool run_wheel_theories(const StudyOptions& options, std::ostream& out);

/// The study `wheel-rail`: a wheel on a rail in sweeps through contact jumps, in 100,000 random states, its derivatives
/// beside differences, and the energy that it loses, on profiles of the examples and, where they are there, measured
/// and worn ones beside CONTACT's cases.
bool run_wheel_rail(const StudyOptions& options, std::ostream& out);

/// The study `wheel-surfaces`: forces of the exact theory on planes, on the true surfaces, as conformal patches and as
/// it chooses by itself, beside those on the true surfaces with 48 elements across each contact, for random states of
/// wheels on new, hollow and worn profiles; what the warning of flat patches says there.
bool run_wheel_surfaces(const StudyOptions& options, std::ostream& out);

} // namespace microslip::validation
