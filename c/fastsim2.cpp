#include "microslip/simplified/fastsim2.hpp"
#include "c/contact.hpp"
#include "c/growing_struct.hpp"

#include <algorithm>
#include <array>
#include <optional>

using namespace microslip;
using namespace microslip::c;

namespace {

/// Contacts that are handed over together: more than the solver marches together on 10 x 10 cells.
constexpr std::size_t chunk = 64;
/// Bytes of the options' first version.
constexpr std::size_t oldest_options = offsetof(microslip_fastsim2_options, precision);

microslip_fastsim2_options default_options() {
  const SimplifiedOptions o;
  return {.struct_size = sizeof(microslip_fastsim2_options),
          .mx = o.mx,
          .my = o.my,
          .bound = static_cast<int>(o.bound),
          .flexibility = static_cast<int>(o.flexibility),
          .coefficients = static_cast<int>(o.creepage_table),
          .direction = static_cast<int>(o.direction),
          .slope_initial = o.slope_reduction.initial,
          .slope_at_infinity = o.slope_reduction.at_infinity,
          .slope_decay = o.slope_reduction.decay,
          .precision = static_cast<int>(o.precision)};
}

SimplifiedOptions options_of(const microslip_fastsim2_options& o) {
  return {.mx = o.mx,
          .my = o.my,
          .bound = choice<TractionBound>("bound", o.bound, 2),
          .flexibility = choice<FlexibilityModel>("flexibility", o.flexibility, 3),
          .creepage_table = choice<CreepageTable>("coefficients", o.coefficients, 2),
          .slope_reduction = {o.slope_initial, o.slope_at_infinity, o.slope_decay},
          .direction = choice<RollingDirection>("direction", o.direction, 2),
          .precision = choice<Precision>("precision", o.precision, 2)};
}
static_assert(static_cast<int>(TractionBound::elliptic) == MICROSLIP_ELLIPTIC);
static_assert(static_cast<int>(FlexibilityModel::one) == MICROSLIP_ONE);
static_assert(static_cast<int>(FlexibilityModel::blended) == MICROSLIP_BLENDED);
static_assert(static_cast<int>(CreepageTable::computed) == MICROSLIP_COMPUTED);
static_assert(static_cast<int>(RollingDirection::backward) == MICROSLIP_BACKWARD);
static_assert(static_cast<int>(Precision::single) == MICROSLIP_SINGLE);

} // namespace

struct microslip_fastsim2 {
  Fastsim2 solver;
  std::array<EllipticContact, chunk> contacts = {};
  std::array<ContactForces, chunk> forces = {};
  std::array<ContactDerivatives, chunk> derivatives = {};
  std::optional<ContactSolution> fields = {};
  mutable InUse in_use = false;
};

namespace {

void store(const ContactForces& from, microslip_forces& to) noexcept {
  to = forces_of(from);
}
void store(const ContactDerivatives& from, microslip_derivatives& to) noexcept {
  to.forces = forces_of(from.forces);
  for (int row = 0; row < 3; ++row) std::copy_n(from.jacobian[row], 4, to.jacobian[row]);
}
int status_of(const microslip_forces& forces) {
  return forces.status;
}
int status_of(const microslip_derivatives& derivatives) {
  return derivatives.forces.status;
}

/// Solves chunk by chunk in the handle's memory; `solve` takes contacts and fills in results.
template <class Own, class Result, class Solve>
microslip_code solve_in_chunks(microslip_fastsim2& handle, std::array<Own, chunk>& own, std::size_t count,
                               const microslip_contact* contacts, Result* results, Solve solve) noexcept {
  microslip_code code = MICROSLIP_OK;
  for (std::size_t first = 0; first < count; first += chunk) {
    const std::size_t n = std::min(chunk, count - first);
    for (std::size_t k = 0; k < n; ++k) handle.contacts[k] = contact_of(contacts[first + k]);
    solve(std::span<const EllipticContact>(handle.contacts.data(), n), std::span<Own>(own.data(), n));
    for (std::size_t k = 0; k < n; ++k) {
      store(own[k], results[first + k]);
      if (status_of(results[first + k]) != MICROSLIP_OK) code = MICROSLIP_INVALID_INPUT;
    }
  }
  return code;
}

const ContactSolution& solution_of(const microslip_fastsim2& solver) {
  return require_solution(solver.fields, "microslip_fastsim2_solve_fields");
}

} // namespace

microslip_code microslip_fastsim2_options_init(microslip_fastsim2_options* options, size_t size) {
  return guarded(nullptr, [&] { write_growing("options", default_options(), options, size, oldest_options); });
}

microslip_code microslip_fastsim2_create(const microslip_fastsim2_options* options, microslip_fastsim2** solver,
                                         microslip_error* error) {
  return guarded(error, [&] {
    require_pointer("solver", solver);
    const auto known = options ? read_growing("options", options, oldest_options) : default_options();
    *solver = new microslip_fastsim2{Fastsim2(options_of(known))};
  });
}

void microslip_fastsim2_destroy(microslip_fastsim2* solver) {
  delete solver;
}

microslip_code microslip_fastsim2_solve(microslip_fastsim2* solver, size_t count, const microslip_contact* contacts,
                                        microslip_forces* forces) {
  if ((!contacts || !forces) && count > 0) return MICROSLIP_NULL_POINTER;
  return with_handle(solver, [&] {
    return solve_in_chunks(*solver, solver->forces, count, contacts, forces,
                           [&](auto some, auto results) { solver->solver.solve(some, results); });
  });
}

microslip_code microslip_fastsim2_differentiate(microslip_fastsim2* solver, size_t count,
                                                const microslip_contact* contacts, microslip_derivatives* derivatives) {
  if ((!contacts || !derivatives) && count > 0) return MICROSLIP_NULL_POINTER;
  return with_handle(solver, [&] {
    return solve_in_chunks(*solver, solver->derivatives, count, contacts, derivatives,
                           [&](auto some, auto results) { solver->solver.differentiate(some, results); });
  });
}

microslip_code microslip_fastsim2_solve_fields(microslip_fastsim2* solver, const microslip_contact* contact,
                                               microslip_forces* forces, microslip_error* error) {
  const microslip_code checked = microslip_contact_check(contact, error);
  if (checked != MICROSLIP_OK) return checked;
  return guarded_use(error, "solver", solver, [&] {
    solver->fields = solver->solver.fields(contact_of(*contact));
    if (forces) *forces = forces_of(solver->fields->forces());
  });
}

microslip_code microslip_fastsim2_quantity(const microslip_fastsim2* solver, const char* name, double* value,
                                           microslip_error* error) {
  return guarded_use(error, "solver", solver, [&] {
    *require_pointer("value", value) = quantity_of(solution_of(*solver), require_pointer("name", name));
  });
}

microslip_code microslip_fastsim2_field(const microslip_fastsim2* solver, const char* name, size_t count,
                                        double* values, microslip_error* error) {
  return guarded_use(error, "solver", solver, [&] {
    copy_field(solution_of(*solver), require_pointer("name", name), {require_pointer("values", values), count});
  });
}
