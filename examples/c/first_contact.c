/* A wheel on a rail in C: Hertz, FASTSIM2 with derivatives, the exact theory, and a field.
 *
 *   cc first_contact.c $(pkg-config --cflags --libs microslip_c) -o first_contact
 */
#include <microslip.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static int failed(const char* where, const microslip_error* error) {
  if (error->code == MICROSLIP_OK) return 0;
  fprintf(stderr, "%s: %s (%s)\n", where, error->text, microslip_code_text(error->code));
  return 1;
}

/* Forces and derivatives by the simplified theory. The call in the middle is real-time safe. */
static int simplified_theory(const microslip_contact* contact) {
  microslip_fastsim2* solver = NULL;
  microslip_error error;
  microslip_derivatives found;
  microslip_fastsim2_create(NULL, &solver, &error);
  if (failed("create", &error)) return 1;
  if (microslip_fastsim2_differentiate(solver, 1, contact, &found) != MICROSLIP_OK)
    microslip_contact_check(contact, &error);
  microslip_fastsim2_destroy(solver);
  if (failed("FASTSIM2", &error)) return 1;
  printf("FASTSIM2 fx %.9g fy %.9g N mz %.9g N m dfx/dxi %.9g N\n", found.forces.fx, found.forces.fy, found.forces.mz,
         found.jacobian[0][0]);
  return 0;
}

/* The largest traction among the cells of the contact last solved [Pa]. */
static int largest_traction(const microslip_exact* solver, size_t count, double* largest, microslip_error* error) {
  double* tractions = malloc(2 * count * sizeof(double));
  size_t k;
  *largest = 0;
  if (!tractions) return 1;
  if (microslip_exact_get(solver, MICROSLIP_FIELD_PX, count, tractions, error) == MICROSLIP_OK &&
      microslip_exact_get(solver, MICROSLIP_FIELD_PY, count, tractions + count, error) == MICROSLIP_OK)
    for (k = 0; k < count; ++k) *largest = fmax(*largest, hypot(tractions[k], tractions[count + k]));
  free(tractions);
  return failed("get", error);
}

static int exact_theory(const microslip_contact* contact) {
  microslip_exact* solver = NULL;
  microslip_exact_result result;
  microslip_error error;
  double largest = 0;
  result.struct_size = sizeof result;
  microslip_exact_create(NULL, &solver, &error);
  if (failed("create", &error)) return 1;
  microslip_exact_solve(solver, contact, NULL, &result, &error);
  if (failed("exact theory", &error) ||
      largest_traction(solver, (size_t)result.mx * (size_t)result.my, &largest, &error)) {
    microslip_exact_destroy(solver);
    return 1;
  }
  microslip_exact_destroy(solver);
  printf("exact    fx %.9g fy %.9g N mz %.9g N m largest traction %.9g Pa\n", result.forces.fx, result.forces.fy,
         result.forces.mz, largest);
  return 0;
}

int main(void) {
  const microslip_bodies bodies = {{0.46, INFINITY}, {INFINITY, 0.3}, {210e9, 210e9}, {0.28, 0.28}};
  microslip_contact contact = {0};
  microslip_hertz hertz;
  microslip_error error;
  printf("microslip %s\n", microslip_version());
  microslip_hertz_from_load(&bodies, 80e3, &hertz, &error);
  if (failed("Hertz", &error)) return 1;
  printf("Hertz    a %.9g b %.9g m\n", hertz.a, hertz.b);
  contact.a = hertz.a;
  contact.b = hertz.b;
  contact.shear_modulus = hertz.shear_modulus;
  contact.poisson_ratio = hertz.poisson_ratio;
  contact.normal_force = 80e3;
  contact.rolling_speed = 30;
  contact.friction = 0.3;
  contact.creepage_longitudinal = 0.0018;
  contact.creepage_lateral = 0.0006;
  contact.spin = 0.4;
  return simplified_theory(&contact) || exact_theory(&contact);
}
