#pragma once

#include "compat/contact/units.hpp"
#include "compat/contact/wheel_rail/profile_thresholds.hpp"
#include "compat/libcontact/include/contact_addon.h"

#include <numbers>
#include <string_view>

namespace microslip::libcontact {

/// Whose default it is: of all problems, of wheels (module 1), or of contact problems (module 3).
enum class DefaultOf { both, wheel, contact };

using contact_program::ProfileThresholds;

/// Value of a digit or a number of CONTACT until it is set.
struct Default {         // NOLINT(clang-analyzer-optin.performance.Padding): in the order of the table's columns
  std::string_view name; ///< CONTACT's
  DefaultOf of;
  double value;               ///< in CONTACT's units
  std::string_view unit = {}; ///< none of digits, counts and ratios
  int flag = 0;               ///< the code by which cntc_getflags has it; 0: it has not
};

/// The one table of what a new result element or contact problem has. The values are CONTACT's; above each group stands
/// where CONTACT gives them, and where there are others here, why. Numbers that are not in the table are 0, in CONTACT
/// and here, except for those of CONTACT's iterations, which do not exist here (MXSENS and what G = 5 has).
inline constexpr Default defaults[] = {
    // Digits: ic_init (m_hierarch_data.f90), after which cntc_activate_wtd and cntc_activate_gd (m_global_data.f90, in
    // versions before m_caddon_data.f90) make N, A, A_s, O and O_s 0 and W 1 for the library. G is 1 there, "keep",
    // which keeps the 0 of solv_init.
    {"UNITS", DefaultOf::both, CNTC_un_cntc, "", CNTC_if_units},
    {"C", DefaultOf::wheel, 1, "", CNTC_ic_config},
    {"P", DefaultOf::both, 2, "", CNTC_ic_pvtime},
    {"B", DefaultOf::both, 0, "", CNTC_ic_bound},
    {"T", DefaultOf::both, 3, "", CNTC_ic_tang},
    {"N", DefaultOf::both, 0, "", CNTC_ic_norm},
    {"F", DefaultOf::both, 0, "", CNTC_ic_force},
    {"L", DefaultOf::both, 0, "", CNTC_ic_frclaw},
    {"D", DefaultOf::wheel, 2, "", CNTC_ic_discns},
    {"C3", DefaultOf::both, 2, "", CNTC_ic_inflcf},
    {"M", DefaultOf::both, 0, "", CNTC_ic_mater},
    {"E", DefaultOf::contact, 0, "", CNTC_ic_exrhs},
    {"X", DefaultOf::both, 0, "", CNTC_ic_xflow},
    {"H", DefaultOf::both, 0, "", CNTC_ic_heat},
    {"G", DefaultOf::both, 0},
    {"I", DefaultOf::both, 0, "", CNTC_ic_iestim},
    {"A", DefaultOf::both, 0, "", CNTC_ic_matfil},
    {"O", DefaultOf::both, 0, "", CNTC_ic_output},
    {"W", DefaultOf::both, 1, "", CNTC_ic_flow},
    {"R", DefaultOf::both, 1, "", CNTC_ic_return},
    {"S2", DefaultOf::both, 1, "", CNTC_ic_sens},
    {"A_s", DefaultOf::both, 0, "", CNTC_ic_sbsfil},
    {"O_s", DefaultOf::both, 0, "", CNTC_ic_sbsout},
    {"WRTINP", DefaultOf::both, 0, "", CNTC_if_wrtinp},

    // Solvers: solv_init (m_hierarch_data.f90); NPOT_MAX: the wheel's beginning (m_wrprof_data.f90).
    {"MAXGS", DefaultOf::both, 999},
    {"MAXIN", DefaultOf::both, 20},
    {"MAXNR", DefaultOf::both, 25},
    {"MAXOUT", DefaultOf::both, 1},
    {"EPS", DefaultOf::both, 1e-5},
    {"OMEGAH", DefaultOf::both, 0.9},
    {"OMEGAS", DefaultOf::both, 1},
    {"OMGSLP", DefaultOf::both, 0.5},
    {"EPSSENS", DefaultOf::both, 1e-4},
    {"NPOT_MAX", DefaultOf::wheel, 20000, "", CNTC_ic_npomax},

    // Material: mater_init (m_hierarch_data.f90). Heat has no default here: CONTACT's thermal conductivity of 50,000
    // W/(mm K) is a million times that of steel, so that H = 1 without data is refused.
    {"POISS1", DefaultOf::both, 0.28},
    {"POISS2", DefaultOf::both, 0.28},
    {"GG1", DefaultOf::both, 1, "N/mm2"},
    {"GG2", DefaultOf::both, 1, "N/mm2"},
    {"FLX", DefaultOf::both, 1e-5, "mm3/N"},
    {"K0_MF", DefaultOf::both, 1},
    {"ALFAMF", DefaultOf::both, 1},
    {"BETAMF", DefaultOf::both, 1},
    {"GG3", DefaultOf::both, 1, "N/mm2"},
    {"BETAPL", DefaultOf::both, 1},
    {"IF_METH", DefaultOf::wheel, 0, "", CNTC_ic_ifmeth},
    {"VARIANT", DefaultOf::wheel, 4, "", CNTC_ic_ifvari},

    // Friction: fric_init (m_friclaw.f90).
    {"FSTAT", DefaultOf::both, 0.3},
    {"FKIN", DefaultOf::both, 0.3},
    {"SABSH2", DefaultOf::both, 1e4, "mm/s"},
    {"MEMDST", DefaultOf::both, 1e-3, "mm"},
    {"MEM_S0", DefaultOf::both, 10, "mm/s"},

    // Motion: kincns_init (m_hierarch_data.f90).
    {"DT", DefaultOf::both, 1, "s"},
    {"VELOC", DefaultOf::contact, 1000, "mm/s"},
    {"DQ", DefaultOf::contact, 2, "mm"},
    {"FACPHI", DefaultOf::contact, 1.0 / 6},

    // Contact problems: geom_init and potcon_init (m_hierarch_data.f90). One element is what they are said to have
    // before there is a solution. In CONTACT they have one of 2 x 2 mm also when they are calculated without a
    // potential contact, which is refused here: there is no contact that it would be right for.
    {"IBASE", DefaultOf::contact, 1},
    {"B1", DefaultOf::contact, 1, "1/mm"},
    {"B3", DefaultOf::contact, 1, "1/mm"},
    {"MX", DefaultOf::contact, 1},
    {"MY", DefaultOf::contact, 1},

    // Wheels on rails: the wheel's beginning and wheelset_ini (m_wrprof_data.f90), cntc_setpotcontact for G_MISS
    // (contact_addon.f90). YTAPE and DYSTEP0 are what the input files of CONTACT leave out.
    {"DX", DefaultOf::wheel, 0.5, "mm"},
    {"DS", DefaultOf::wheel, 0.5, "mm"},
    {"DQREL", DefaultOf::wheel, 1},
    {"A_SEP", DefaultOf::wheel, std::numbers::pi, "rad"},
    {"D_SEP", DefaultOf::wheel, 8, "mm"},
    {"D_COMB", DefaultOf::wheel, 4, "mm"},
    {"D_TURN", DefaultOf::wheel, 12, "mm"},
    {"G_MISS", DefaultOf::wheel, -1, "mm"},
    {"GAUGHT", DefaultOf::wheel, 14, "mm"},
    {"GAUGWD", DefaultOf::wheel, 1435, "mm"},
    {"KYRAIL", DefaultOf::wheel, 1e3, "N/mm"},
    {"KZRAIL", DefaultOf::wheel, 1e3, "N/mm"},
    {"DYSTEP0", DefaultOf::wheel, 1, "mm"},
    {"FBDIST", DefaultOf::wheel, 1360, "mm"},
    {"FBPOS", DefaultOf::wheel, -70, "mm"},
    {"NOMRADW", DefaultOf::wheel, 460, "mm"},
    {"YTAPE", DefaultOf::wheel, 1000, "mm"},
    {"VS", DefaultOf::wheel, 30e3, "mm/s"},

    // Profiles: profile_ini (m_profile.f90).
    {"MIRRORY", DefaultOf::wheel, 0},
    {"MIRRORZ", DefaultOf::wheel, 0},
    {"ERRHND", DefaultOf::wheel, 0},
    {"ISMOOTH", DefaultOf::wheel, 0},
    {"SMOOTH", DefaultOf::wheel, 0},
    {"MAXOMIT", DefaultOf::wheel, ProfileThresholds::most_omitted},
    {"ZIGTHRS", DefaultOf::wheel, ProfileThresholds::zigzag, "rad"},
    {"KINKHIGH", DefaultOf::wheel, ProfileThresholds::kink_high, "rad"},
    {"KINKLOW", DefaultOf::wheel, ProfileThresholds::kink_high / ProfileThresholds::kink_ratio, "rad"},
    {"KINKWID", DefaultOf::wheel, ProfileThresholds::kink_width, "mm"},
};

/// The default of a name, for all problems or one module's, as files have it. A name that the table does not have does
/// not compile.
consteval double default_in_file(std::string_view name, DefaultOf of = DefaultOf::both) {
  for (const Default& row : defaults)
    if (row.name == name && (row.of == of || row.of == DefaultOf::both)) return row.value;
  throw "there is no such default";
}

/// The same in SI.
consteval double default_of(std::string_view name, DefaultOf of = DefaultOf::both) {
  using namespace contact_program;
  const double value = default_in_file(name, of);
  for (const Default& row : defaults) {
    if (row.name != name) continue;
    if (row.unit == "mm" || row.unit == "mm/s") return value * mm;
    if (row.unit == "1/mm" || row.unit == "N/mm") return value * per_mm;
    if (row.unit == "N/mm2") return value * newton_per_mm2;
    if (row.unit == "mm3/N") return value * mm3_per_newton;
  }
  return value;
}

template <class Choice> consteval Choice default_choice(std::string_view name, DefaultOf of = DefaultOf::both) {
  return static_cast<Choice>(static_cast<int>(default_of(name, of)));
}

/// That of a flag, 0 if the table has none.
constexpr int default_flag(int code) {
  for (const Default& row : defaults)
    if (row.flag == code) return static_cast<int>(row.value);
  return 0;
}

} // namespace microslip::libcontact
