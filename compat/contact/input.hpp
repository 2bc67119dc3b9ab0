#pragma once

#include "compat/contact/digits.hpp"
#include "compat/contact/geometry.hpp"
#include "compat/contact/influence_file.hpp"
#include "compat/contact/words.hpp"

#include <array>
#include <filesystem>
#include <istream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace microslip::contact_program {

/// The law in force and its data, CONTACT's units (mm/s, deg C).
struct FrictionData {
  Law law = Law::coulomb;                ///< never keep
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
  Coefficients coefficients = Coefficients::constant; ///< never keep or form
  std::shared_ptr<const InfluenceTable> table = {};   ///< of C = 9, SI
  double poisson1 = 0, poisson2 = 0, shear1 = 0, shear2 = 0;
  double sheet_flexibility = 0; ///< FLXZ [mm3/N], of B = 1
  Bulk model = Bulk::elastic;   ///< M that `model_data` was read for
  std::vector<double> model_data = {};
};

/// The solvers' parameters; most of them belong to CONTACT's own methods.
struct SolverData {
  SolverChoice method = SolverChoice::standard; ///< never keep
  int maxgs = 0, maxin = 0, maxnr = 0, maxout = 0;
  double eps = 1e-5;
  double omegah = 1, omegas = 1; ///< G = 2, 3
  double inislp = 0, omgslp = 1; ///< the slip that an iteration for falling friction starts from

  /// Whether INISLP and OMGSLP are read.
  bool starts_from_slip() const {
    return method == SolverChoice::convex_gs || method == SolverChoice::steady_gs ||
           method == SolverChoice::slip_iteration;
  }
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
  Normal formed_norm = Normal::force; ///< N when the potential contact was formed,
  double formed_normal = 0;           ///< and PEN or FN
  Geometry geometry = {};
  std::vector<double> extra_slip = {}; ///< wx, wy of each element (E = 9)
  ExtraSlip extra = ExtraSlip::none;   ///< never keep
  std::optional<HeatData> heat = {};   ///< of H = 3 now or before
  SubsFile subs_file = SubsFile::none; ///< of S = 2 or 3 now or before
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
  /// `stream` must outlive the reader. Files of influence coefficients are looked for in the folder of `name`.
  InputReader(std::istream& stream, std::string name);

  /// The next case, nullptr at the end of the file or at MODULE 0. It holds until the next call.
  const Case* next();
  /// Whether the end that next() has found is the one that MODULE 0 makes, and not that of a file cut short.
  bool is_complete() const { return complete_; }

private:
  int read_module();
  const Case* give_up(const std::string& why);
  void read_case(Case& c);
  void check_digits(const Case& c);
  bool keeps_lost(const Case& c) const;
  void check_kept(Case& c);
  void read_solver(Case& c);
  void read_kinematics(Case& c);
  std::vector<double> read_friction_set(Law law);
  void read_friction(Case& c);
  void read_rolling(Case& c);
  void read_material(Case& c);
  std::shared_ptr<const InfluenceTable> coefficients_from(const std::string& file, const MaterialData& m);
  void check_read(const Case& c);
  void read_damping_and_heat(Case& c);
  void read_potential(Case& c);
  bool keeps_geometry(Case& c);
  void read_geometry(Case& c);
  void read_friction_by_rows(Case& c);
  void read_extra_slip(Case& c);
  void read_points(Case& c);
  [[noreturn]] void fail_keep(const Case& c, const std::string& digit, const char* what) const;

  /// What the last case of a sequence has left.
  struct Sequence {
    Case last = {};
    bool has_case = false, has_solver = false, has_friction = false, has_geometry = false, has_damping = false;
    int lost = 0; ///< number of a later case that could not be read
  };

  Words words_;
  std::filesystem::path folder_; ///< of the file
  /// By file and combined modulus [Pa], so that cases with the same ones share them.
  std::map<std::pair<std::string, double>, std::shared_ptr<const InfluenceTable>> tables_;
  std::map<std::pair<int, int>, Sequence> sequences_;
  Sequence* now_ = nullptr;
  std::pair<int, int> sequence_ = {1, 1};
  int cases_ = 0;
  bool in_module_ = false, ended_ = false, complete_ = false;
  Case lost_;
};

} // namespace microslip::contact_program
