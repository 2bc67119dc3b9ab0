#pragma once

#include "microslip/contact/contact_forces.hpp"
#include "microslip/contact/elliptic_contact.hpp"
#include "microslip/contact/motion.hpp"
#include "microslip/numerics/instruction_set.hpp"
#include "microslip/table/creep_table_nodes.hpp"

#include <memory>
#include <span>

namespace microslip {

/// The nodes of a table and what is made of them when it is first asked for, for all tables that are made from it:
/// these share their numbers, whatever their Poisson's ratio and direction. Copies are the same source. From any
/// thread.
class CreepTableSource {
public:
  /// Costs nothing yet.
  CreepTableSource(CreepTableNodes nodes); // NOLINT: nodes are a source that is used once

  /// Returns whether tables from both share their numbers.
  friend bool operator==(const CreepTableSource&, const CreepTableSource&) = default;

private:
  friend class CreepForceTable;
  struct Data;
  std::shared_ptr<Data> data_;
};

/// Forces of Hertzian contacts in steady rolling by interpolation between results of the exact theory: at any load,
/// modulus, size and coefficient of friction, as the table has scaled variables. The forces are continuous with their
/// first derivatives, those of linear theory for vanishing creepages, and never beyond mu Fn. Beyond the table's axis
/// ratios and Poisson's ratios the status is out_of_range, and the forces are those of limits: the ellipse, the
/// Poisson's ratio at the end of the range, with the longer semi-axis and linear theory of the contact itself.
///
/// Friction that falls with the slip is that of the rigid slip at the centre, V sqrt(xi^2 + eta^2), all over the
/// contact. Calls marked noexcept allocate nothing, take no lock, do no input or output, and may come from several
/// threads at a time.
class CreepForceTable {
public:
  /// Table of all Poisson's ratios of the nodes; with `poisson_ratio` for that one alone, at a fraction of the memory.
  /// Throws Error for a Poisson's ratio out of the nodes' range, or an instruction set that this processor lacks; the
  /// results are the same to the last bit with all of them. Cost some hundredths of a second and 8 MB for each
  /// Poisson's ratio that no table of the same source has; else nothing. A source keeps what is of the nodes' Poisson's
  /// ratios, of others what is in use.
  explicit CreepForceTable(const CreepTableSource& source, RollingDirection direction = RollingDirection::forward,
                           InstructionSet instruction_set = best_instruction_set());
  CreepForceTable(const CreepTableSource& source, double poisson_ratio,
                  RollingDirection direction = RollingDirection::forward,
                  InstructionSet instruction_set = best_instruction_set());

  const CreepTableAxes& axes() const;
  RollingDirection direction() const;

  /// Forces of one contact, of many contacts. Input out of range gives Status::invalid_input and NaN. A
  /// batch costs 0.1 to 0.2 us for each contact, one by one twice that, derivatives half as much again.
  ContactForces solve(const EllipticContact& contact) const noexcept;
  void solve(std::span<const EllipticContact> contacts, std::span<ContactForces> forces) const noexcept;

  /// Forces and their derivatives with respect to the creepages and the load, those of the interpolation itself.
  ContactDerivatives differentiate(const EllipticContact& contact) const noexcept;
  void differentiate(std::span<const EllipticContact> contacts,
                     std::span<ContactDerivatives> derivatives) const noexcept;

private:
  struct Data;
  std::shared_ptr<const Data> data_; ///< copies share it
};

} // namespace microslip
