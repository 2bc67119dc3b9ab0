#include "validation/clauses.hpp"

#include <array>

namespace microslip::validation {
namespace {

constexpr std::array closed_forms = {
    Clause{"1.1", "Hertz: load, approach and peak pressure of ellipsoids, and the order of their errors", "hertz"},
    Clause{"1.2", "Carter: steady rolling of cylinders, and its order", "carter"},
    Clause{"1.3", "Cattaneo and Mindlin: a sphere that is pressed and shifted", "cattaneo"},
    Clause{"1.4", "Exact solutions of the one-dimensional model problem of the simplified theory", "model-problem"},
    Clause{"1.5", "Stresses inside the bodies below Hertz's and below uniform pressure", "subsurface"},
    Clause{"1.6", "Surface temperature below Hertz's heat", "temperature", "Hertzian heat"},
    Clause{"1.7", "Layered bodies: responses to waves, influence numbers, rolling on thin layers", "layers"},
    Clause{"1.8", "Cylinders that relax, between slow and quick loads", "viscoelastic-cylinders", "Limits"},
    Clause{"1.9", "A wheel on a rail: ellipsoids on cylinders, forces, energy and derivatives", "wheel-rail"},
    Clause{"1.10", "Leading elements that end inside the edge of contact", "edge-constants"},
    Clause{"1.11", "Power of friction as forces times creepages and as tractions times slip", "frictional-power"},
};

constexpr std::array published = {
    Clause{"2.1", "Kalker 1990, table of the creepage coefficients", "kalker-coefficients"},
    Clause{"2.2", "Vollebregt and Wilders 2011, Table 1: FASTSIM2 against the exact theory, 3,220 cases",
           "fastsim2-table1"},
    Clause{"2.3", "Vollebregt and Wilders 2011, Table 2: errors of discretisation, 3,220 cases", "fastsim2-table2"},
    Clause{"2.4", "Vollebregt and Wilders 2011, (F20) to (F34): transition points and orders", "model-problem"},
    Clause{"2.5", "Vollebregt 2009, figures 1 to 8: refinement of the exact theory", "refinement"},
    Clause{"2.6", "Vollebregt 2009, Table 1: growth of the cost of ConvexGS", "solver-growth"},
    Clause{"2.7", "Exact forces of 112 of the 3,220 cases, 31 elements across and extrapolated", "exact-112"},
    Clause{"2.8", "Bentall and Johnson 1967: rolling cylinders of different materials", "bentall-johnson"},
    Clause{"2.9", "Spence 1975: a sphere on a rigid plane with friction", "spence"},
    Clause{"2.10", "Kalker 1990, 5.2.2.5: from a shift to steady rolling", "cattaneo-to-carter"},
    Clause{"2.11", "Wang and Knothe 1993: viscoelastic cylinders", "viscoelastic-cylinders", "CONTACT's grid"},
    Clause{"2.12", "Ertz and Knothe 2002: temperatures of a wheel that slides and of one that brakes", "temperature"},
    Clause{"2.13", "Yu, Wang and Wang 2014: a rigid sphere on two layers on steel", "layers", "A rigid sphere"},
    Clause{"2.14", "Polach 2005: creep curves of a locomotive", "creep-curve"},
    Clause{"2.15", "Friction that falls with the slip: two branches, a locomotive's creep curve", "falling-friction"},
    Clause{"2.16", "A measured creep curve: fits, and intervals that hold the truth", "measurements"},
};

constexpr std::array contact = {
    Clause{"3.1", "Every quantity that CONTACT 25.1 printed for the input files of its examples", "contact"},
    Clause{"3.2", "Elements and stresses of these files", "contact-cases"},
};

constexpr std::array manchester = {
    Clause{"4.1", "A-1, and states with yaw: contact of rigid profiles", "manchester", "A-1, and"},
    Clause{"4.2", "A-1: patches under 10 kN", "manchester", "A-1: patches"},
    Clause{"4.3", "A-2.2, 42 forces: exact theory on planes", "manchester", "Exact theory on planes"},
    Clause{"4.4", "A-2.2, 42 forces: exact theory on the true surfaces", "manchester",
           "Exact theory on the true surfaces"},
    Clause{"4.5", "A-2.2, 42 forces: theory fastsim2", "manchester", "Theory fastsim2"},
    Clause{"4.6", "A-2.2: what each rule changes where fastsim2 differs", "manchester", "A-2.2, states"},
    Clause{"4.7", "A-2.2: two patches with friction by inclination", "manchester", "A-2.2 at 5 mm"},
};

constexpr std::array conicity = {
    Clause{"5, annex B", "Reference procedure: integration of the equation of motion, without roll", "conicity",
           "closed forms", "with cones and arcs, whose conicity is known"},
    Clause{"6, annex E", "Conicity from the standard's own rolling radius differences", "conicity", "EN 15302, annex E",
           "the integration alone"},
    Clause{"6, annexes D to F", "Reference wheel A: profiles, conicity, tolerances", "conicity", "EN 15302, wheel A"},
    Clause{"6, annexes D to F", "Reference wheel B: profiles, conicity, tolerances", "conicity", "EN 15302, wheel B"},
    Clause{"6, annexes D to F", "Further combinations of reference profiles", "", "", "profiles not at hand"},
    Clause{"annex A", "Presentation of rolling radius difference and conicity", "", "",
           "informative; microslip conicity prints and draws both"},
    Clause{"annex C", "Conicity by linear regression", "", "", "informative; not offered: annex B is used"},
    Clause{"annexes G, H", "Profiles with introduced errors", "measurements", "Equivalent conicity",
           "informative; with white noise of our own, not the annex's errors"},
    Clause{"annex I", "Guidelines for application", "", "", "informative; concerns the user"},
};

constexpr std::array trust = {
    Clause{"6.1", "20,000 random contacts of all kinds, each of which has a solution", "random-problems"},
    Clause{"6.2", "100,000 random wheels far beyond service: failures and contradictions", "random-wheels"},
    Clause{"6.3", "3,220 cases by the exact theory: failures, steps", "exact-test-set"},
    Clause{"6.4", "Second order of the exact theory, and its estimate of the error", "second-order"},
    Clause{"6.5", "Fast theories of a wheel beside the exact one, largest jumps", "wheel-theories"},
    Clause{"6.6", "Planes, curved and conformal patches beside finer ones", "wheel-surfaces"},
    Clause{"6.7", "Creep-force table beside the exact theory", "creep-table"},
    Clause{"6.8", "Creep-force table on patches that are not elliptic", "creep-table-patches"},
    Clause{"6.9", "Measured profiles with noise: forces, pressures", "measurements"},
    Clause{"6.10", "A running vehicle: energy, wavelengths, integrators", "vehicle"},
    Clause{"6.11", "Laws of creep forces in use, beside the exact theory", "models"},
    Clause{"6.12", "Models of the normal problem in use, beside the exact theory", "normal-models"},
    Clause{"6.13", "Forces over the frequency of creepages: the limit of long waves, transient rolling", "response"},
};

constexpr std::array groups = {
    ClauseGroup{"Closed forms", "Solutions that are known in formulas or up to quadratures.", closed_forms},
    ClauseGroup{"Published results", "Tables and figures of papers and books.", published},
    ClauseGroup{"The program CONTACT", "Version 25.1, its example files and what it printed.", contact},
    ClauseGroup{"Manchester contact benchmark",
                "Shackleton and Iwnicki 2008, wheelset S1002 on UIC 60, beside CONTACT.", manchester},
    ClauseGroup{"Statement of conformity with EN 15302",
                "EN 15302:2008+A1:2010, Method for determining the equivalent conicity, clause by clause. The data of "
                "the edition of 2021 were not at hand.",
                conicity},
    ClauseGroup{"Reliability and accuracy", "Beside finer grids of the same theory, and in random states.", trust},
};

} // namespace

std::span<const ClauseGroup> clause_groups() {
  return groups;
}

ClauseResult judge(const Clause& clause, std::span<const Figure> figures) {
  ClauseResult result;
  bool is_shown = false;
  for (const Figure& figure : figures) {
    if (!figure.section.starts_with(clause.section)) continue;
    is_shown = true;
    if (!figure.met) continue;
    ++result.judged;
    result.met += *figure.met ? 1 : 0;
    result.known += figure.is_known ? 1 : 0;
  }
  if (clause.study.empty() || !is_shown) return result;
  if (result.judged == 0)
    result.verdict = Verdict::only_shown;
  else if (result.met + result.known < result.judged)
    result.verdict = Verdict::failed;
  else
    result.verdict = result.known == 0 ? Verdict::passed : Verdict::passed_with_known_limits;
  return result;
}

} // namespace microslip::validation
