/* A wheel on a rail in C: Hertz, FASTSIM2 with derivatives, the exact theory by paths of inputs, and a field.
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

/* An input by its path, as case files have it; what is left out has its default. */
typedef struct input {
  const char* path;
  double value;
} input;

static const input inputs[] = {{"body1.rolling_radius", 0.46},
                               {"body1.transverse_radius", INFINITY},
                               {"body1.young_modulus", 210e9},
                               {"body1.poisson_ratio", 0.28},
                               {"body2.rolling_radius", INFINITY},
                               {"body2.transverse_radius", 0.3},
                               {"body2.young_modulus", 210e9},
                               {"body2.poisson_ratio", 0.28},
                               {"load.normal_force", 80e3},
                               {"friction.coefficient", 0.3},
                               {"motion.rolling_speed", 30},
                               {"motion.creepage_longitudinal", 0.0018},
                               {"motion.creepage_lateral", 0.0006},
                               {"motion.spin", 0.4},
                               {"solution.grid", 24}};

static int set_inputs(microslip_problem* problem, microslip_error* error) {
  size_t k;
  for (k = 0; k < sizeof inputs / sizeof *inputs; ++k)
    if (microslip_set(problem, inputs[k].path, inputs[k].value, error) != MICROSLIP_OK) return 1;
  return microslip_set_text(problem, "solution.theory", "exact", error) != MICROSLIP_OK;
}

/* The largest traction among the elements [Pa]. */
static int largest_traction(microslip_problem* problem, double* largest, microslip_error* error) {
  size_t columns = 0, rows = 0, count, k;
  double* tractions;
  *largest = 0;
  microslip_field_size(problem, "px", &columns, &rows, error);
  count = columns * rows;
  tractions = malloc(2 * count * sizeof(double));
  if (!tractions) return 1;
  if (microslip_field(problem, "px", count, tractions, error) == MICROSLIP_OK &&
      microslip_field(problem, "py", count, tractions + count, error) == MICROSLIP_OK)
    for (k = 0; k < count; ++k) *largest = fmax(*largest, hypot(tractions[k], tractions[count + k]));
  free(tractions);
  return failed("field", error);
}

static int exact_theory(void) {
  microslip_problem* problem = NULL;
  microslip_error error;
  double fx, fy, mz, largest;
  int bad;
  microslip_problem_create(MICROSLIP_BODIES, &problem, &error);
  if (failed("create", &error)) return 1;
  bad = set_inputs(problem, &error) || microslip_solve(problem, &error) != MICROSLIP_OK ||
        microslip_number(problem, "fx", &fx, &error) != MICROSLIP_OK ||
        microslip_number(problem, "fy", &fy, &error) != MICROSLIP_OK ||
        microslip_number(problem, "mz", &mz, &error) != MICROSLIP_OK || largest_traction(problem, &largest, &error);
  microslip_problem_destroy(problem);
  if (bad) {
    failed("exact theory", &error);
    return 1;
  }
  printf("exact    fx %.9g fy %.9g N mz %.9g N m largest traction %.9g Pa\n", fx, fy, mz, largest);
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
  return simplified_theory(&contact) || exact_theory();
}
