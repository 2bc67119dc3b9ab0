#pragma once

#include "compat/contact/run.hpp"
#include "tests/support/case_text.hpp"
#include "tests/support/expect_error.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace microslip::contact_program {

/// A sphere on a plane, R = 50 mm, shifted by half of the friction limit.
inline const std::string first_shift = R"( 3 MODULE
 201110  P-B-T-N-F-S
 022020  L-D-C-M-Z-E
 0000331 H-G-I-A-O-W-R
 100 100 30 1 1e-7   MAXGS, MAXIN, MAXNR, MAXOUT, EPS
 9.1954 -.5 0 0      FN, FX, CETA, CPHI
 .4 .4               FSTAT, FKIN
 .42 .42 200. 200.   POISS, GG
 1                   IPOTCN
 19 19 -1.26667 -1.26667 .13333 .13333
 1 1                 IBASE, IPLAN
 .01 0 .01 0 0 0
)";

/// A right wheel on a rail with its height given.
inline const std::string first_wheel = R"( 1 MODULE
 1203000  C-P-B-T-N-F-S
 0022033  V-L-D-C-M-Z-E
 0000331  H-G-I-A-O-W-R
 999 100 30 1 1e-7     MAXGS, MAXIN, MAXNR, MAXOUT, EPS
 .3 .3                 FSTAT, FKIN
 .28 .28 82000. 82000. POISS, GG
 .2 .2 1. 90d 8. 4.    DX, DS, DQREL, A_SEP, D_SEP, D_COMB
 -1. 200. 0. 0.        GAUGHT, RAILY0, RAILZ0, CANT
 'rail.prr' 0 1. 0.    RFNAME, MIRRORY, SCALE, SMOOTH
 0 0 0 0 0 0           DY, DZ, ROLL, VY, VZ, VROLL
 200. -100. 100.       FBDIST, FBPOS, NOMRAD_W
 'wheel.prw' 0 1. 0.   WFNAME, MIRRORY, SCALE, SMOOTH
 0 0 .16 0 0 0         S, Y, Z, ROLL, YAW, PITCH
 100. 0 0 0 0 -1.      VS, VY, VZ, VROLL, VYAW, VPITCH
)";

/// A text with C = 2 made one with C = 4.
inline std::string with_corrected_coefficients(std::string text, const std::string& correction) {
  const std::string material = ".42 .42 200. 200.";
  return with(std::move(text), {{"022020", "024020"}, {material, correction + "\n " + material}});
}

/// A shift of thin sheets with C = 4, which is refused.
inline std::string refused_shift() {
  const std::string material = ".42 .42 200. 200.";
  return with(with_corrected_coefficients(first_shift, "0 4 2\n 0. 0. 1. .1"),
              {{" 201110", " 211110"}, {material, material + "\n 1e-4 FLXZ"}});
}

/// Rolling of a Hertzian contact with 12 elements across: FN, CKSI, CETA, CPHI; CHI, DQ, VELOC; the first control
/// integer.
inline std::string steady_rolling(const std::string& kinematics, const std::string& rolling = "0 .1 30000.",
                                  const std::string& control = "203100") {
  return " 3 MODULE\n " + control + "\n 022020\n 0000331\n 100 100 30 1 1e-7\n " + kinematics + "\n .3 .3\n " +
         rolling + "\n .28 .28 82000. 82000.\n -3\n 16 16 1. .8 1.33333\n";
}

struct RunCase {
  Case input;
  Outcome outcome;
};

/// All cases of a text, whose file has this name.
inline std::vector<Case> read_cases(const std::string& text, const std::string& file = "a.inp") {
  std::istringstream stream(text);
  InputReader reader(stream, file);
  std::vector<Case> cases;
  while (const Case* c = reader.next()) cases.push_back(*c);
  return cases;
}

inline Case first_case(const std::string& text) {
  return read_cases(text).at(0);
}

/// The words with which a text is refused.
inline void expect_message(const std::string& text, const std::string& message, const std::string& file = "a.inp") {
  EXPECT_EQ(error_of([&] { read_cases(text, file); }), message);
}

/// All cases of a text, run in order; profiles lie beside its file.
inline std::vector<RunCase> run_cases(const std::string& text, const std::string& file = "a.inp") {
  std::istringstream stream(text);
  InputReader reader(stream, file);
  Run run;
  std::vector<RunCase> cases;
  while (const Case* c = reader.next()) cases.push_back({*c, run.run(*c)});
  return cases;
}

/// The same where none is refused.
inline std::vector<Outcome> outcomes_of(const std::string& text, const std::string& file = "a.inp") {
  std::vector<Outcome> outcomes;
  for (RunCase& c : run_cases(text, file)) {
    for (const auto& reason : c.outcome.reasons) ADD_FAILURE() << reason;
    outcomes.push_back(std::move(c.outcome));
  }
  return outcomes;
}

} // namespace microslip::contact_program
