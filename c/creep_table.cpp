#include "c/contact.hpp"
#include "c/guarded_call.hpp"
#include "io/creep_table_file.hpp"

#include <algorithm>

using namespace microslip;
using namespace microslip::c;

struct microslip_creep_table {
  CreepForceTable table;
};

namespace {

/// The worse of two codes: a contact without a result before one with that of a limit.
microslip_code worse(microslip_code so_far, Status status) {
  if (so_far == MICROSLIP_INVALID_INPUT || status == Status::ok) return so_far;
  return code_of(status);
}

} // namespace

microslip_code microslip_creep_table_read(const char* file, int direction, microslip_creep_table** table,
                                          microslip_error* error) {
  return guarded(error, [&] {
    require_pointer("table", table);
    const auto rolling = choice<RollingDirection>("direction", direction, 2);
    *table = new microslip_creep_table{CreepForceTable(io::creep_table_source(require_pointer("file", file)), rolling)};
  });
}

void microslip_creep_table_destroy(microslip_creep_table* table) {
  delete table;
}

microslip_code microslip_creep_table_solve(const microslip_creep_table* table, size_t count,
                                           const microslip_contact* contacts, microslip_forces* forces) {
  if (!table || ((!contacts || !forces) && count > 0)) return MICROSLIP_NULL_POINTER;
  microslip_code code = MICROSLIP_OK;
  for (std::size_t i = 0; i < count; ++i) {
    const ContactForces found = table->table.solve(contact_of(contacts[i]));
    forces[i] = forces_of(found);
    code = worse(code, found.status);
  }
  return code;
}

microslip_code microslip_creep_table_differentiate(const microslip_creep_table* table, size_t count,
                                                   const microslip_contact* contacts,
                                                   microslip_derivatives* derivatives) {
  if (!table || ((!contacts || !derivatives) && count > 0)) return MICROSLIP_NULL_POINTER;
  microslip_code code = MICROSLIP_OK;
  for (std::size_t i = 0; i < count; ++i) {
    const ContactDerivatives found = table->table.differentiate(contact_of(contacts[i]));
    derivatives[i].forces = forces_of(found.forces);
    for (int row = 0; row < 3; ++row) std::copy_n(found.jacobian[row], 4, derivatives[i].jacobian[row]);
    code = worse(code, found.forces.status);
  }
  return code;
}
