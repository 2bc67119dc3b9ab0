#pragma once

#include <array>
#include <string_view>

namespace microslip::description {

using Word = std::string_view;

// The words by which all interfaces name the values of options, in the order of the enumerators.

inline constexpr std::array<Word, 6> theories{"fastsim", "fastsim_half_step", "fastsim2", "exact", "fastrip", "table"};
inline constexpr std::array<Word, 2> traction_bounds{"parabolic", "elliptic"};
inline constexpr std::array<Word, 3> flexibility_models{"three", "one", "blended"};
inline constexpr std::array<Word, 2> creepage_tables{"kalker", "computed"};
inline constexpr std::array<Word, 2> precisions{"double", "single"};
inline constexpr std::array<Word, 2> rolling_directions{"forward", "backward"};
inline constexpr std::array<Word, 2> discretisations{"second_order", "classical"};
inline constexpr std::array<Word, 2> element_shapes{"constant", "bilinear"};
inline constexpr std::array<Word, 2> couplings{"newton", "alternating"};
inline constexpr std::array<Word, 2> slip_starts{"below", "above"};
inline constexpr std::array<Word, 3> contact_motions{"shift", "transient", "steady"};
inline constexpr std::array<Word, 2> profile_roles{"rail", "wheel"};
inline constexpr std::array<Word, 3> profile_formats{"simpack", "miniprof", "columns"};
inline constexpr std::array<Word, 2> lateral_senses{"field", "gauge"};
inline constexpr std::array<Word, 2> vertical_senses{"up", "down"};
inline constexpr std::array<Word, 3> wheel_theories{"fastsim2", "exact", "table"};
inline constexpr std::array<Word, 3> patch_shapes{"flat", "curved", "conformal"};
inline constexpr std::array<Word, 2> track_sides{"left", "right"};
inline constexpr std::array<Word, 2> roll_rules{"equilibrium", "none"};
inline constexpr std::array<Word, 2> sweep_scales{"linear", "logarithmic"};
inline constexpr std::array<Word, 5> distributions{"uniform", "normal", "log_normal", "triangular", "empirical"};
inline constexpr std::array<Word, 3> point_sets{"random", "latin_hypercube", "sobol"};
inline constexpr std::array<Word, 2> sample_aims{"quantiles", "sobol_indices"};

/// Kinds of cases: of two bodies, a wheel on a rail, a wheelset.
inline constexpr std::array<Word, 3> case_kinds{"bodies", "wheel", "wheelset"};
/// Kinds of inputs: those of cases, of files of sweeps, of the commands for conicity and creep-force tables.
inline constexpr std::array<Word, 6> input_kinds{"bodies", "wheel", "wheelset", "sweep", "conicity", "table"};

} // namespace microslip::description
