#pragma once

#include "compat/contact/run.hpp"

#include <sstream>
#include <string>
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
  const std::string digits = "022020", material = ".42 .42 200. 200.";
  text.replace(text.find(digits), digits.size(), "024020");
  return text.insert(text.find(material), correction + "\n ");
}

/// A shift of thin sheets with C = 4, which is refused.
inline std::string refused_shift() {
  const std::string digits = " 201110", material = ".42 .42 200. 200.";
  std::string text = with_corrected_coefficients(first_shift, "0 4 2\n 0. 0. 1. .1");
  text.replace(text.find(digits), digits.size(), " 211110");
  return text.insert(text.find(material) + material.size(), "\n 1e-4 FLXZ");
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

/// All cases of a text, run in order.
inline std::vector<RunCase> run_cases(const std::string& text) {
  std::istringstream stream(text);
  InputReader reader(stream, "a.inp");
  Run run;
  std::vector<RunCase> cases;
  while (const Case* c = reader.next()) cases.push_back({*c, run.run(*c)});
  return cases;
}

} // namespace microslip::contact_program
