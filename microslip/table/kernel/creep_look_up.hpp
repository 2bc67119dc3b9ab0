#pragma once

#include "microslip/table/creep_table_axes.hpp"

#include <cstddef>

namespace microslip::detail {

/// Coefficients of a table's spline in memory, those of all its materials alike.
struct CreepGrid {
  int ratios, levels, elevations, azimuths;                    ///< nodes
  std::ptrdiff_t ratio_stride, level_stride, elevation_stride; ///< between neighbours
  double azimuth_step, azimuth_scale;                          ///< of its TrigonometricSpline
};

inline constexpr int most_creep_materials = 8;

/// Contacts that are looked up together: arrays of one number of each, along which loops run. Those from `count` on
/// are not there, but have finite numbers.
template <int size> struct CreepBlock {
  using Numbers = double[size];

  int count, materials;
  const float* coefficients[most_creep_materials]; ///< by material
  Numbers weight[most_creep_materials];            ///< of a material in a contact
  Numbers ratio;                                   ///< position of a/b among its nodes, from 0
  Numbers stretch;                                 ///< s
  Numbers x, y, z;                                 ///< X, Y, Z
  Numbers y_y, y_z, m_y, m_z;                      ///< linear theory: f = -(X, y_y Y + y_z Z, m_y Y + m_z Z)

  Numbers force[3], adhesion; ///< Fx, Fy over mu Fn, Mz over mu Fn c, share of the contact that adheres
  Numbers derivative[3][3];   ///< of the force with respect to X, Y, Z
};

/// Looks up blocks; `forces` leaves the derivatives as they are. The same bits for every size and instruction set.
template <int size> struct CreepLookUp {
  void (*forces)(const CreepGrid& grid, CreepBlock<size>& block);
  void (*derivatives)(const CreepGrid& grid, CreepBlock<size>& block);
};

/// Contacts of a batch, and of a single look-up.
inline constexpr int creep_batch = 8;
struct CreepKernels {
  CreepLookUp<creep_batch> batch;
  CreepLookUp<1> single;
};

} // namespace microslip::detail
