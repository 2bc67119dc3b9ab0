#pragma once

#include "app/creep_curve.hpp"
#include "io/case_file.hpp"
#include "io/result_file.hpp"

#include <filesystem>

namespace microslip {

/// How far totals are from those on the grid with twice the cells in each direction.
struct GridError {
  double fx = 0, fy = 0; ///< in units of mu Fn
  double mz = 0;         ///< in units of mu Fn sqrt(a b)
};

/// All that `microslip solve` computes of a case.
struct RollingContactResult {
  HertzContact hertz;
  EllipticContact contact;
  ContactFields fields;
  GridError grid_error;
  CreepCurve curve;
};

/// Solves a case by the simplified theory it asks for.
RollingContactResult solve_case(const RollingCase& input);

/// Writes it as HDF5. Error if that is impossible.
void write_result(const RollingCase& input, const RollingContactResult& result, const Provenance& provenance,
                  const std::filesystem::path& path);

} // namespace microslip
