#pragma once

#include "compat/contact/geometry.hpp"
#include "compat/contact/words.hpp"

#include <array>
#include <istream>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace microslip::contact_program {

/// The control digits of a case of module 3, by CONTACT's names; its letters behind. Digits that say "keep" stand here
/// as they are in the file.
struct Digits {
  int pvtime = 2;  ///< P: 0 continues, 1 continues for the normal part, 2 a new sequence, 3 repeats the step
  int bound = 0;   ///< B: 0 elastic half-space, 1 thin sheet, 2 elliptic, 3 parabolic, 4 SDEC, 5 KPEC, 6 ANALYN
  int tang = 0;    ///< T: 0 frictionless, 1 shift, 2 transient rolling, 3 steady rolling
  int norm = 0;    ///< N: 0 approach given, 1 normal force given
  int force = 0;   ///< F: 0 creepages given, 1 FX and CETA, 2 FX and FY
  int stress = 0;  ///< S: 0 no interior field, 1 at stored points, 2 new A_s and O_s, 3 new points
  int varfrc = 0;  ///< V: 0 one set of friction data, 3 one for each row of the grid
  int frclaw = 0;  ///< L: 0 Coulomb, 1 keep, 2 linear, 3 rational, 4 exponential, 6 by temperature
  int discns = 0;  ///< D: 0 keep the potential contact, 1 form it anew from what is stored, 2 read it
  int inflcf = 0;  ///< C: 0 and 1 keep, 2 constant elements, 3 bilinear, 4 angle correction, 9 from a file
  int mater = 0;   ///< M: 0 elastic, 1 viscoelastic, 2, 3 FASTSIM, 4 third-body layer, 5 to 7 FaStrip
  int damping = 0; ///< M2: 0 none, 1 keep, 2 read
  int rznorm = 0;  ///< Z: 0 keep the undeformed distance, 1 form it anew, 2 read it
  int exrhs = 0;   ///< E: 0 no extra rigid slip, 1 keep, 2 and 3 without the spin's part of wy or wx, 9 read
  int xflow = 0;   ///< X: 1 reads what to trace
  int heat = 0;    ///< H: 0 no temperatures, 1 keep the parameters, 3 read them
  int gausei = 0;  ///< G: 0 default solvers, 1 keep, 2 ConvexGS, 3 SteadyGS, 4 default with INISLP, 5 GDsteady
  int iestim = 0;  ///< I: 0 starts from nothing, 1 to 3 from what is there
  int matfil = 0;  ///< A: fields are stored for 0 no elements, 1 those in contact, 2 all
  int output = 0;  ///< O: how much is printed
  int flow = 0;    ///< W: how much of the way is printed
  int solve = 1;   ///< R: 0 and 1 solve, 2 and 3 skip; 0 and 2 stay in the module
};

/// The law in force and its data, CONTACT's units (mm/s, deg C).
struct FrictionData {
  int law = 0;                           ///< L, never 1
  bool by_row = false;                   ///< V = 3
  std::vector<std::vector<double>> sets; ///< one, or one for each row; L = 0: FSTAT, FKIN; else as in the file
};

/// How the bodies roll. [rad], [mm], [mm/s], [-]
struct RollingData {
  double chi = 0, dq = 0, veloc = 0;
  double facphi = 1.0 / 6; ///< where in a step the rigid slip is taken
};

/// Both bodies' data, and what the material digit adds (M = 1: FG1 FG2 TC1 TC2; 2: FLX K0_MF ALFAMF BETAMF; 3, 5:
/// K0_MF ALFAMF BETAMF; 4: GG3 LAYTHK TAU_C0 K_TAU). [-], [N/mm2]
struct MaterialData {
  int coefficients = 2; ///< C, never 0 or 1
  double poisson1 = 0, poisson2 = 0, shear1 = 0, shear2 = 0;
  double sheet_flexibility = 0; ///< FLXZ [mm3/N], of B = 1
  int model = 0;                ///< M that `model_data` was read for
  std::vector<double> model_data = {};
};

/// The solvers' parameters; most of them belong to CONTACT's own methods.
struct SolverData {
  int method = 0; ///< G, never 1
  int maxgs = 0, maxin = 0, maxnr = 0, maxout = 0;
  double eps = 1e-5;
  double omegah = 1, omegas = 1; ///< G = 2, 3
  double inislp = 0, omgslp = 1; ///< G = 2 to 4: the slip that an iteration for falling friction starts from
};

/// Heat parameters of a body: BKTEMP [deg C], HEATCP [J/(kg K)], LAMBDA [W/(mm K)], DENS [kg/mm3].
struct HeatData {
  std::array<double, 4> body1 = {}, body2 = {};
  double plastic_share = 0; ///< BETAPL, with M = 4
};

/// A case of module 3 in CONTACT's units: its digits, and the data that hold for it, whether read or kept.
struct Case {
  int number = 0;                        ///< in the file, from 1
  std::size_t line = 0;                  ///< where it begins
  std::pair<int, int> sequence = {1, 1}; ///< RE and CP: sequences that know nothing of each other
  /// Why the reader could not take it, e.g. of module 1; then nothing else is known.
  std::string unreadable = {};

  Digits digits = {};
  double normal = 0;             ///< PEN [mm] or FN [N]
  double x = 0, y = 0, phi = 0;  ///< CKSI or FX, CETA or FY, CPHI [rad/mm], for a shift [mm], [rad]; FX over FSTAT FN
  double spin_x = 0, spin_y = 0; ///< SPINXO, SPINYO [mm]
  SolverData solver = {};
  FrictionData friction = {};
  std::optional<RollingData> rolling = {};
  std::optional<MaterialData> material = {};
  std::optional<PotentialContact> potential = {};
  int formed_norm = 1;      ///< N when the potential contact was formed,
  double formed_normal = 0; ///< and PEN or FN
  Geometry geometry = {};
  std::vector<double> extra_slip = {}; ///< wx, wy of each element (E = 9)
  int extra = 0;                       ///< E, never 1
  std::optional<HeatData> heat = {};   ///< of H = 3 now or before
  int points_matfil = 0;               ///< A_s, S = 2 or 3 now or before: 0 no file, 2 all stresses
  std::vector<PointBlock> points = {}; ///< of the interior field, S = 3 now or before
};

/// Reads the cases of a CONTACT input file one after the other, in constant memory, and completes what they keep from
/// the ones before. Module 3; a case of module 1 is handed out as unreadable, and reading goes on at the next line that
/// names a module.
///
/// Throws Error with file, line, field, value and allowed range for whatever is against the grammar: values that are
/// missing, no numbers or out of range, digits that do not exist or that do not go together, and a digit that keeps
/// what no earlier case has given.
class InputReader {
public:
  /// `stream` must outlive the reader.
  InputReader(std::istream& stream, std::string name);

  /// The next case, nullptr at the end of the file or at MODULE 0. It holds until the next call.
  const Case* next();
  /// Whether the end that next() has found is the one that MODULE 0 makes, and not that of a file cut short.
  bool is_complete() const { return complete_; }

private:
  int read_module();
  const Case* give_up(const std::string& why);
  void read_case(Case& c);
  void read_digits(Case& c);
  void check_digits(const Case& c);
  bool keeps_lost(const Case& c) const;
  void check_kept(Case& c);
  void read_solver(Case& c);
  void read_kinematics(Case& c);
  std::vector<double> read_friction_set(int law);
  void read_friction(Case& c);
  void read_rolling(Case& c);
  void read_material(Case& c);
  void check_read(const Case& c);
  void read_damping_and_heat(Case& c);
  void read_potential(Case& c);
  bool keeps_geometry(Case& c);
  void read_geometry(Case& c);
  void read_friction_by_rows(Case& c);
  void read_extra_slip(Case& c);
  void read_points(Case& c);
  [[noreturn]] void fail_keep(const Case& c, const char* digit, int value, const char* what) const;

  /// What the last case of a sequence has left.
  struct Sequence {
    Case last = {};
    bool has_case = false, has_solver = false, has_friction = false, has_geometry = false, has_damping = false;
    int lost = 0; ///< number of a later case that could not be read
  };

  Words words_;
  std::map<std::pair<int, int>, Sequence> sequences_;
  Sequence* now_ = nullptr;
  std::pair<int, int> sequence_ = {1, 1};
  int cases_ = 0;
  bool in_module_ = false, ended_ = false, complete_ = false;
  Case lost_;
};

} // namespace microslip::contact_program
