#pragma once

#include "compat/contact/digits.hpp"
#include "compat/contact/geometry.hpp"
#include "compat/contact/influence_file.hpp"
#include "compat/contact/wheel_rail/records.hpp"
#include "microslip/contact/normal_load.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace microslip::contact_program {

/// The law in force and its data.
struct FrictionData {
  Law law = Law::coulomb; ///< never keep
  bool by_row = false;    ///< V = 3
  std::vector<std::vector<double>>
      sets; ///< one, or one for each row; L = 0: FSTAT, FKIN; else as in the file [-], [m/s], [m], [deg C]
  /// With V = 1, 2 of module 1: the inclination [rad], or the position along the track [m], of each of the sets,
  /// ascending.
  std::vector<double> stations = {};
};

/// Rolling of the bodies. [rad], [m], [m/s], [-]
struct RollingData {
  double chi = 0, dq = 0, veloc = 0;
  double facphi = 1.0 / 6; ///< where in a step the rigid slip is taken
};

/// C = 4: influence coefficients corrected for the angles of a curved surface.
struct AngleCorrection {
  int method = 0;  ///< IF_METH: 0 angles along a straight line, 1 as they are
  int variant = 1; ///< VARIANT: 1, 2 (but pressure along x) of the traction, 3 of the displacement, 4 half of each
  std::vector<std::pair<double, double>> angles = {}; ///< Y [m] and ALPHA [rad], ascending
};

/// Both bodies' data, and what the material digit adds (M = 1: FG1 FG2 TC1 TC2; 2: FLX K0_MF ALFAMF BETAMF; 3, 5:
/// K0_MF ALFAMF BETAMF; 4: GG3 LAYTHK TAU_C0 K_TAU). [-], [Pa], [m], [Pa/m]
struct MaterialData {
  Coefficients coefficients = Coefficients::constant; ///< never keep or form
  std::shared_ptr<const InfluenceTable> table = {};   ///< of C = 9
  AngleCorrection correction = {};                    ///< of C = 4
  std::string missing_table = {};                     ///< CFNAME of C = 9 where there is no such file
  double poisson1 = 0, poisson2 = 0, shear1 = 0, shear2 = 0;
  double sheet_flexibility = 0; ///< FLXZ [m3/N], of B = 1
  Bulk model = Bulk::elastic;   ///< M that `model_data` was read for
  std::vector<double> model_data = {};
};

/// The solvers' parameters; most of them belong to CONTACT's methods.
struct SolverData {
  SolverChoice method = SolverChoice::standard; ///< never keep
  int maxgs = 0, maxin = 0, maxnr = 0, maxout = 0;
  double eps = 1e-5;
  int npot_max = 2000000;        ///< NPOT_MAX: elements that a potential contact of module 1 may have
  double omegah = 1, omegas = 1; ///< G = 2, 3
  double inislp = 0, omgslp = 1; ///< the slip that an iteration for falling friction starts from

  /// Returns whether INISLP and OMGSLP are read.
  bool starts_from_slip() const {
    return method == SolverChoice::convex_gs || method == SolverChoice::steady_gs ||
           method == SolverChoice::slip_iteration;
  }
};

/// Heat parameters of a body: BKTEMP [deg C], HEATCP [J/(kg K)], LAMBDA [W/(m K)], DENS [kg/m3].
struct HeatData {
  std::array<double, 4> body1 = {}, body2 = {};
  double plastic_share = 0; ///< BETAPL, with M = 4
};

/// Damping in proportion to the rate at which forces change, M2 = 2.
struct DampingData {
  double normal = 0, tangential = 0;             ///< CDAMPN, CDAMPT [s]
  double normal_limit = 0, tangential_limit = 0; ///< DFNMAX, DFTMAX: the most that a rate counts [N/s]
};

/// CKSI or CETA [-], in a shift the distance [m].
struct Slip {
  double value = 0;
};
/// FX or FY over FSTAT FN.
struct ForceRatio {
  double value = 0;
};
/// Units of creepages, and in a shift of distances: CKSI, CETA, wx, wy,
inline double unit_of_slip(const Digits& d) {
  return d.tang == Tangential::shift ? mm : 1;
}
/// and of the spin or a shift's rotation, CPHI.
inline double unit_of_spin(const Digits& d) {
  return d.tang == Tangential::shift ? 1 : per_mm;
}

/// What is given along an axis.
using SlipOrForce = std::variant<Slip, ForceRatio>;

/// The slip where it is given, else 0.
inline double slip_of(const SlipOrForce& given) {
  const auto* slip = std::get_if<Slip>(&given);
  return slip ? slip->value : 0;
}
/// The value of whichever is given.
inline double& number_of(SlipOrForce& either) {
  return std::visit([](auto& given) -> double& { return given.value; }, either);
}
inline double number_of(const SlipOrForce& either) {
  return std::visit([](const auto& given) { return given.value; }, either);
}

/// As a file has it.
inline double in_file(const SlipOrForce& either, const Digits& d) {
  const auto* slip = std::get_if<Slip>(&either);
  return slip ? in_file(slip->value, unit_of_slip(d)) : std::get<ForceRatio>(either).value;
}

/// A case in SI units: its digits, and the data that hold for it, whether read or kept. One of module 1 has
/// `wheel_rail`; grid, distance and motion are then those of each of its patches, and not known yet.
struct Case {
  int number = 0;                        ///< in the file, from 1
  std::size_t line = 0;                  ///< where it begins
  std::pair<int, int> sequence = {1, 1}; ///< RE and CP: sequences that know nothing of each other
  int number_in_element = 0;             ///< among the cases of its result element RE, from 1
  bool names_element = false;            ///< whether it, or a case before, has an RE other than the first case's

  Digits digits = {};
  NormalLoad load = {};          ///< PEN or FN
  SlipOrForce x = {}, y = {};    ///< CKSI or FX, CETA or FY
  double phi = 0;                ///< CPHI [rad/m], for a shift [rad]
  double spin_x = 0, spin_y = 0; ///< SPINXO, SPINYO [m]
  SolverData solver = {};
  FrictionData friction = {};
  std::optional<RollingData> rolling = {};
  std::optional<MaterialData> material = {};
  std::optional<DampingData> damping = {}; ///< none with M2 = 0
  std::optional<PotentialContact> potential = {};
  NormalLoad formed = {}; ///< PEN or FN when the potential contact was formed
  Geometry geometry = {};
  /// wx, wy of each element (E = 9), as in the file, [-] or in a shift [mm]: what it is depends on the case that keeps
  /// it.
  std::vector<double> extra_slip = {};
  ExtraSlip extra = ExtraSlip::none;   ///< never keep
  std::optional<HeatData> heat = {};   ///< of H = 3 now or before
  SubsFile subs_file = SubsFile::none; ///< of S = 2 or 3 now or before
  int interior_level = 0;              ///< O_s of the same: how much CONTACT prints of it, 0 to 6
  std::vector<PointBlock> points = {}; ///< of the interior field, S = 3 now or before
  std::optional<WheelRailData> wheel_rail = {};
};

} // namespace microslip::contact_program
