/*
 * A program that was built with microslip_abi_1.h, the header of the first version of the binary interface, and runs
 * with the library as it is: a state of a wheel on a rail, its patches and derivatives by name, and both theories.
 *
 *   abi_1_program RAIL WHEEL      files of profiles
 */
#include "microslip_abi_1.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The rows that this program knows: shorter or equal to those of the library. */
enum { STATE = 31, RESULT = 19, ROWS = 7, PATCH = 35, CONTACT = 17 };

static void require(int holds, const char* what) {
  if (holds) return;
  fprintf(stderr, "not so: %s\n", what);
  exit(1);
}

static size_t at(int list, const char* name) {
  microslip_error error;
  const int index = microslip_index(list, name, &error);
  require(index >= 0, error.text);
  return (size_t)index;
}

static int is_near(double value, double wanted, double tolerance) {
  return fabs(value - wanted) <= tolerance * fabs(wanted);
}

static microslip_wheel_rail* make(const char* rail, const char* wheel) {
  static char text[4096];
  microslip_wheel_rail* made;
  microslip_error error;
  snprintf(text, sizeof text,
           "[track]\ngauge = 1.435\ncant = 0.05\n[rail]\nprofile = \"%s\"\n[wheelset]\nprofile = \"%s\"\n"
           "nominal_radius = 0.46\nflange_back_distance = 1.36\n[wheel]\nlateral = 0.00604\nyaw = 0.002\n"
           "vertical_force = 80e3\nforward_velocity = 30.0\n[material]\nyoung_modulus = 210e9\npoisson_ratio = 0.28\n"
           "[friction]\ncoefficient = 0.3\n",
           rail, wheel);
  require(microslip_wheel_rail_create(text, "case.toml", &made, &error) == MICROSLIP_OK, error.text);
  return made;
}

static void solve_a_state(microslip_wheel_rail* wheel) {
  double state[STATE], result[RESULT], jacobian[ROWS][STATE], other[RESULT];
  int status;
  const size_t yaw = at(MICROSLIP_WHEEL_STATE, "yaw"), force_y = at(MICROSLIP_WHEEL_RESULT, "force_y");
  const size_t row = at(MICROSLIP_WHEEL_DERIVATIVE, "force_y");
  const double step = 1e-6;
  require(microslip_wheel_rail_state(wheel, STATE, state) == MICROSLIP_OK, "the first state");
  require(state[at(MICROSLIP_WHEEL_STATE, "lateral")] == 0.00604, "its lateral displacement");
  require(state[at(MICROSLIP_WHEEL_STATE, "vertical_force")] == 80e3, "its vertical force");
  require(microslip_wheel_rail_differentiate(wheel, 1, STATE, state, RESULT, result, &status, ROWS, STATE,
                                             &jacobian[0][0]) == MICROSLIP_OK,
          "differentiate");
  require(status == MICROSLIP_OK, "its status");
  require(is_near(result[at(MICROSLIP_WHEEL_RESULT, "force_z")], 80e3, 1e-5), "the force is carried");
  state[yaw] += step;
  require(microslip_wheel_rail_solve(wheel, 1, STATE, state, RESULT, other, &status) == MICROSLIP_OK, "solve");
  require(is_near(jacobian[row][yaw], (other[force_y] - result[force_y]) / step, 0.02), "dFy/dyaw is a difference");
}

static void get_its_patches(microslip_wheel_rail* wheel) {
  double first[1][PATCH], *patches, vertical = 0;
  size_t count, again, k;
  microslip_error error;
  require(microslip_wheel_rail_patches(wheel, PATCH, 1, first[0], &count, &error) == MICROSLIP_WRONG_SIZE,
          "two patches");
  require(count == 2, "both are counted");
  patches = malloc(count * PATCH * sizeof *patches);
  require(patches != NULL, "memory");
  require(microslip_wheel_rail_patches(wheel, PATCH, count, patches, &again, &error) == MICROSLIP_OK, error.text);
  for (k = 0; k < count; ++k) {
    const double* patch = patches + k * PATCH;
    const double angle = patch[at(MICROSLIP_WHEEL_PATCH, "angle")];
    require(patch[at(MICROSLIP_WHEEL_PATCH, "status")] == MICROSLIP_OK, "status of a patch");
    vertical += patch[at(MICROSLIP_WHEEL_PATCH, "normal_force")] * cos(angle) +
                patch[at(MICROSLIP_WHEEL_PATCH, "fy")] * sin(angle);
  }
  free(patches);
  require(is_near(vertical, 80e3, 1e-3), "the patches carry the force");
}

static void find_the_contacts(microslip_wheel_rail* wheel) {
  const double lateral[2] = {0, 0.003}, amplitude = 0.003;
  double contact[2][CONTACT], conicity;
  int status[2];
  microslip_error error;
  const size_t left = at(MICROSLIP_WHEELSET_CONTACT, "left_rolling_radius");
  const size_t right = at(MICROSLIP_WHEELSET_CONTACT, "right_rolling_radius");
  const size_t difference = at(MICROSLIP_WHEELSET_CONTACT, "rolling_radius_difference");
  require(microslip_wheelset_contacts(wheel, MICROSLIP_ROLL_EQUILIBRIUM, 0, 2, lateral, CONTACT, contact[0], status,
                                      &error) == MICROSLIP_OK,
          error.text);
  require(is_near(contact[1][left] - contact[1][right], contact[1][difference], 1e-9), "the radii differ by that");
  require(microslip_equivalent_conicity(wheel, MICROSLIP_ROLL_NONE, 1.5, 1, &amplitude, &conicity, &error) ==
              MICROSLIP_OK,
          error.text);
  require(conicity > 0 && conicity < 0.05, "S1002 on 60E1 at a cant of 1:20 has little conicity");
}

static void describe_a_number(void) {
  microslip_quantity yaw;
  yaw.struct_size = sizeof yaw;
  require(microslip_describe(MICROSLIP_WHEEL_STATE, at(MICROSLIP_WHEEL_STATE, "yaw"), &yaw, NULL) == MICROSLIP_OK,
          "describe");
  require(strcmp(yaw.name, "yaw") == 0 && strcmp(yaw.unit, "rad") == 0, "name and unit");
}

static void solve_a_contact_by_both_theories(void) {
  microslip_contact contact;
  microslip_fastsim2_options simplified;
  microslip_exact_options options;
  microslip_fastsim2* fastsim2;
  microslip_exact* exact;
  microslip_derivatives found;
  microslip_exact_result result;
  microslip_error error;
  double power;
  memset(&contact, 0, sizeof contact);
  contact.a = 6.7e-3, contact.b = 5e-3, contact.shear_modulus = 82e9, contact.poisson_ratio = 0.28;
  contact.normal_force = 80e3, contact.rolling_speed = 30, contact.friction = 0.3;
  contact.creepage_longitudinal = 0.0018, contact.spin = 0.4;
  require(microslip_fastsim2_options_init(&simplified, sizeof simplified) == MICROSLIP_OK, "fastsim2_options_init");
  require(microslip_fastsim2_create(&simplified, &fastsim2, &error) == MICROSLIP_OK, error.text);
  require(microslip_fastsim2_differentiate(fastsim2, 1, &contact, &found) == MICROSLIP_OK, "fastsim2_differentiate");
  microslip_fastsim2_destroy(fastsim2);
  require(microslip_exact_options_init(&options, sizeof options) == MICROSLIP_OK, "exact_options_init");
  require(microslip_exact_create(&options, &exact, &error) == MICROSLIP_OK, error.text);
  result.struct_size = sizeof result;
  require(microslip_exact_solve(exact, &contact, NULL, &result, &error) == MICROSLIP_OK, error.text);
  require(microslip_exact_quantity(exact, "frictional_power", &power, &error) == MICROSLIP_OK, error.text);
  require(power == result.frictional_power, "the power by its name");
  microslip_exact_destroy(exact);
  require(is_near(found.forces.fx, result.forces.fx, 0.05), "both theories agree within 5 %");
}

int main(int count, char** words) {
  microslip_wheel_rail* wheel;
  require(count == 3, "abi_1_program RAIL WHEEL");
  require(microslip_abi() == MICROSLIP_ABI, "the library has the binary interface of this program");
  wheel = make(words[1], words[2]);
  solve_a_state(wheel);
  get_its_patches(wheel);
  find_the_contacts(wheel);
  microslip_wheel_rail_destroy(wheel);
  describe_a_number();
  solve_a_contact_by_both_theories();
  puts("all is as it was");
  return 0;
}
