#pragma once

#include "cases/creep_curve.hpp"
#include "cases/nip_result.hpp"
#include "cases/stored_number.hpp"
#include "io/case_file.hpp"
#include "io/result_writer.hpp"
#include "microslip/interior/layered_interior.hpp"
#include "microslip/rolling/accurate_contact.hpp"
#include "microslip/rolling/contact_warnings.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace microslip::cases {

/// Differences of totals from those on another grid; NaN where there is none, as for a single element.
struct DiscretisationError {
  double fx = 0, fy = 0;       ///< in units of mu Fn
  double mz = 0;               ///< in units of mu Fn sqrt(a b)
  double frictional_power = 0; ///< [W]; for a shift of the work [J]
};

/// Results of the simplified theory for a case.
struct SimplifiedResult {
  ContactSolution solution;
  DiscretisationError discretisation_error; ///< to the grid with twice the cells in each direction
  CreepCurve curve;
};

/// Results of the exact theory for a case.
struct ExactResult {
  ContactSolution contact;
  DiscretisationError discretisation_error; ///< to the grid with half the elements in each direction
  std::optional<AccurateContact> limit;     ///< if an accuracy is asked for; `contact` is its finest then
  std::vector<InteriorState> interior;      ///< at the case's points inside the bodies
  std::optional<NipResult> nip;             ///< of bodies with layers
  std::optional<LayeredPeaks> peaks;        ///< likewise, with constant elements
  std::optional<CreepCurve> curve;          ///< if it converges for steady rolling
};

/// Results of a creep-force table for a case.
struct TableResult {
  ContactSolution solution; ///< without fields
  CreepCurve curve;
};

/// All that `microslip solve` computes of a case.
struct RollingContactResult {
  HertzContact hertz;
  EllipticContact contact; ///< with the creepages that the exact theory found, where a force is given
  std::optional<ExactResult> exact;
  std::optional<TableResult> table;
  std::optional<SimplifiedResult> simplified; ///< also beside a table, and the exact theory's converged steady rolling
  Status status = Status::ok;                 ///< of the theory that the case asks for
  std::string reason;                         ///< why it is not ok; empty if it is
  std::vector<std::string> warnings;          ///< what makes it doubtful: case_warnings
};

/// hertz/normal_force and so on, tolerances/hertz_relative.
std::vector<StoredNumber> hertz_quantities(const HertzContact& hertz);
/// hertz/shear_modulus and hertz/poisson_ratio, combined.
std::vector<StoredNumber> material_quantities(const CombinedMaterial& material);

/// Name of the simplified theory's group in result files.
std::string simplified_name(const io::RollingCase& input);

/// Simpler bodies that Hertz's solution, a table's and the simplified theory's take instead of the case's.
/// Empty: of the same.
std::string hertz_assumption(const io::RollingCase& input);
std::string simplified_assumption(const io::RollingCase& input);

/// Doubts about the case, by its Hertzian contact.
ContactWarnings case_warnings(const io::RollingCase& input, const HertzContact& hertz);

/// Kind of such a case's result files.
constexpr const char* kind_of(const io::RollingCase&) {
  return "rolling_contact";
}

/// Extent of the computation by the exact theory.
enum class ExactExtent {
  full,    ///< the solution, its gap and its error on the grid, a creep curve: some ten times the work of the solution
  solution ///< the solution alone
};

/// Solves a case by the theory it asks for, and beside the exact theory and a table by FASTSIM2. `progress` is called
/// during long work. Throws Stopped if it returns false.
RollingContactResult solve_case(const io::RollingCase& input, const Progress& progress = {},
                                ExactExtent extent = ExactExtent::full);

/// Writes inputs, solutions and their tolerances.
void write_result(const io::RollingCase& input, const RollingContactResult& result, io::ResultWriter& file);
/// Writes it as HDF5. Error if that is impossible.
void write_result(const io::RollingCase& input, const RollingContactResult& result, const io::Provenance& provenance,
                  const std::filesystem::path& path);

} // namespace microslip::cases
