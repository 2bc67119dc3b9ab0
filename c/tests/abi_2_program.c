/*
 * A program that was built with microslip_abi_2.h, the header of version 1.0.0, and runs with the library as it is:
 * problems by path, states of a wheel on a rail, its patches and derivatives by name, both theories, and the element of
 * forces with memory.
 *
 *   abi_2_program RAIL WHEEL      files of profiles
 */
#include "microslip_abi_2.h"

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

static void set(microslip_problem* problem, const char* path, double value) {
  microslip_error error;
  require(microslip_set(problem, path, value, &error) == MICROSLIP_OK, error.text);
}

static void set_text(microslip_problem* problem, const char* path, const char* value) {
  microslip_error error;
  require(microslip_set_text(problem, path, value, &error) == MICROSLIP_OK, error.text);
}

static microslip_wheel_rail* make(const char* rail, const char* wheel) {
  microslip_problem* problem;
  microslip_wheel_rail* made;
  microslip_error error;
  require(microslip_problem_create(MICROSLIP_WHEEL, &problem, &error) == MICROSLIP_OK, error.text);
  set(problem, "track.gauge", 1.435), set(problem, "track.cant", 0.05);
  set_text(problem, "rail.profile", rail), set_text(problem, "wheelset.profile", wheel);
  set(problem, "wheelset.nominal_radius", 0.46), set(problem, "wheelset.flange_back_distance", 1.36);
  set(problem, "wheel.lateral", 0.00604), set(problem, "wheel.yaw", 0.002);
  set_text(problem, "wheel.vertical_force", "80 kN"), set(problem, "wheel.forward_velocity", 30);
  set(problem, "material.young_modulus", 210e9), set(problem, "material.poisson_ratio", 0.28);
  set(problem, "friction.coefficient", 0.3);
  require(microslip_wheel_rail_create(problem, &made, &error) == MICROSLIP_OK, error.text);
  microslip_problem_destroy(problem);
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
  require(microslip_wheel_rail_continue(wheel, 1, STATE, state, RESULT, result, &status) == MICROSLIP_OK, "continue");
  require(is_near(result[force_y], other[force_y], 1e-3), "the same state from the one before");
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

/* A wheel of steel on a rail, by the exact theory. */
static microslip_problem* two_bodies(void) {
  const double grid[2] = {16, 12};
  microslip_problem* problem;
  microslip_error error;
  require(microslip_problem_create(MICROSLIP_BODIES, &problem, &error) == MICROSLIP_OK, error.text);
  set(problem, "body1.rolling_radius", 0.46), set_text(problem, "body2.rolling_radius", "1000 km");
  set(problem, "body1.transverse_radius", INFINITY), set(problem, "body2.transverse_radius", 0.3);
  set(problem, "body1.young_modulus", 210e9), set(problem, "body2.young_modulus", 210e9);
  set(problem, "body1.poisson_ratio", 0.28), set(problem, "body2.poisson_ratio", 0.28);
  set(problem, "load.normal_force", 80e3), set(problem, "friction.coefficient", 0.3);
  set(problem, "motion.rolling_speed", 30), set(problem, "motion.creepage_longitudinal", 0.0018);
  set_text(problem, "solution.theory", "exact");
  require(microslip_set_array(problem, "solution.grid", 2, grid, &error) == MICROSLIP_OK, error.text);
  return problem;
}

static void look_at_the_fields(microslip_problem* problem, double fx) {
  size_t columns, rows, k;
  double *values, sum = 0;
  microslip_error error;
  require(microslip_field_size(problem, "px", &columns, &rows, &error) == MICROSLIP_OK, error.text);
  values = malloc(2 * columns * rows * sizeof *values);
  require(values != NULL, "memory");
  require(microslip_field(problem, "px", columns * rows, values, &error) == MICROSLIP_OK, error.text);
  require(microslip_field(problem, "area", columns * rows, values + columns * rows, &error) == MICROSLIP_OK,
          error.text);
  for (k = 0; k < columns * rows; ++k) sum += values[k] * values[columns * rows + k];
  free(values);
  require(is_near(sum, fx, 1e-9), "the tractions make the force");
}

static void solve_a_problem_by_path(void) {
  microslip_problem* problem = two_bodies();
  double fx, moved, jacobian[9], value;
  char *text, *json;
  microslip_error error;
  require(microslip_differentiate(problem, 9, jacobian, &error) == MICROSLIP_OK, error.text);
  require(microslip_number(problem, "fx", &fx, &error) == MICROSLIP_OK, error.text);
  look_at_the_fields(problem, fx);
  set(problem, "motion.creepage_longitudinal", 0.0018 + 1e-6);
  require(microslip_get(problem, "motion.creepage_longitudinal", &value, &error) == MICROSLIP_OK, error.text);
  require(value == 0.0018 + 1e-6, "what was set");
  require(microslip_solve(problem, &error) == MICROSLIP_OK, error.text);
  require(microslip_number(problem, "fx", &moved, &error) == MICROSLIP_OK, error.text);
  require(is_near(jacobian[0], (moved - fx) / 1e-6, 0.02), "dfx/dxi is a difference");
  require(microslip_set(problem, "load.normal_forse", 1, &error) == MICROSLIP_INVALID_OPTION, "a path misspelt");
  require(strstr(error.text, "load.normal_force") != NULL, "the nearest path");
  require(microslip_problem_text(problem, &text, &error) == MICROSLIP_OK, error.text);
  require(microslip_solve_case(text, "case.toml", &json, &error) == MICROSLIP_OK, error.text);
  require(strstr(json, "frictional_power") != NULL, "the document of the case file");
  microslip_free_text(text), microslip_free_text(json);
  microslip_problem_destroy(problem);
}

static void solve_a_contact(void) {
  microslip_contact contact;
  microslip_fastsim2_options options;
  microslip_fastsim2* solver;
  microslip_derivatives found;
  microslip_forces forces;
  microslip_error error;
  double power;
  memset(&contact, 0, sizeof contact);
  contact.a = 6.7e-3, contact.b = 5e-3, contact.shear_modulus = 82e9, contact.poisson_ratio = 0.28;
  contact.normal_force = 80e3, contact.rolling_speed = 30, contact.friction = 0.3;
  contact.creepage_longitudinal = 0.0018, contact.spin = 0.4;
  require(microslip_fastsim2_options_init(&options, sizeof options) == MICROSLIP_OK, "fastsim2_options_init");
  require(microslip_fastsim2_create(&options, &solver, &error) == MICROSLIP_OK, error.text);
  require(microslip_fastsim2_differentiate(solver, 1, &contact, &found) == MICROSLIP_OK, "fastsim2_differentiate");
  require(microslip_fastsim2_solve_fields(solver, &contact, &forces, &error) == MICROSLIP_OK, error.text);
  require(is_near(found.forces.fx, forces.fx, 1e-9), "the forces once more");
  require(microslip_fastsim2_quantity(solver, "frictional_power", &power, &error) == MICROSLIP_OK, error.text);
  require(power > 0, "the power");
  microslip_fastsim2_destroy(solver);
}

/* Forces with one pole, -50/m, that were steady and go on with other inputs, and once more from the state before. */
static void go_on_with_a_force_element(void) {
  const char* text =
      "microslip force element 1\nsteady 0.001 0 0 80000\nforces -8000 0 0\nconstants -100000 0 0 0 0 0 0 0 0 0 0 0\n"
      "errors 0 0 0 0 0 0 0 0 0 0 0 0\npoles 1\n"
      "pole -50 0 -400000000 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0\n";
  const double steady[MICROSLIP_ELEMENT_INPUTS] = {0.001, 0, 0, 80e3},
               input[MICROSLIP_ELEMENT_INPUTS] = {0.0011, 0, 0, 80e3};
  double forces[MICROSLIP_ELEMENT_FORCES], again[MICROSLIP_ELEMENT_FORCES], state[64];
  microslip_force_element* element;
  microslip_error error;
  size_t size;
  require(microslip_force_element_create(text, &element, &error) == MICROSLIP_OK, error.text);
  size = microslip_force_element_state_size(element);
  require(size > 0 && size <= 64, "the size of its state");
  require(microslip_force_element_reset(element, NULL) == MICROSLIP_OK, "reset");
  require(microslip_force_element_step(element, 1e-3, steady, forces) == MICROSLIP_OK, "a steady step");
  require(is_near(forces[0], -8e3, 1e-12), "the steady force");
  require(microslip_force_element_get_state(element, size, state) == MICROSLIP_OK, "get_state");
  require(microslip_force_element_step(element, 1e-3, input, forces) == MICROSLIP_OK, "a step");
  require(forces[0] < -8e3, "more creepage, more force against it");
  require(microslip_force_element_set_state(element, size, state) == MICROSLIP_OK, "set_state");
  require(microslip_force_element_step(element, 1e-3, input, again) == MICROSLIP_OK, "the step once more");
  require(again[0] == forces[0], "the same forces");
  microslip_force_element_destroy(element);
}

int main(int count, char** words) {
  microslip_wheel_rail* wheel;
  require(count == 3, "abi_2_program RAIL WHEEL");
  require(microslip_abi() == MICROSLIP_ABI, "the library has the binary interface of this program");
  wheel = make(words[1], words[2]);
  solve_a_state(wheel);
  get_its_patches(wheel);
  find_the_contacts(wheel);
  microslip_wheel_rail_destroy(wheel);
  describe_a_number();
  solve_a_problem_by_path();
  solve_a_contact();
  go_on_with_a_force_element();
  puts("all is as it was");
  return 0;
}
