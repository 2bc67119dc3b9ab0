/* A wheel of a vehicle program by microslip, for the adapters in this folder: pose and motion of the wheelset in, force
 * and moment on it out, with derivatives. Copy this file with the one for your program.
 *
 * All vectors are in track axes, whose origin is midway between the rails at their tops: x along the track, y to the
 * left, z up. Units are SI. The load depends on the motion alone, to the last bit: not on what was solved before, nor
 * on the order of calls, so that programs may repeat, reject and difference steps as they like. It takes no memory. */
#ifndef MICROSLIP_WHEEL_H
#define MICROSLIP_WHEEL_H

#include <microslip.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A wheel by its case file. One thread at a time may use it; make one for each thread. */
typedef struct rail_wheel {
  microslip_wheel_rail* contact;
  double radius;    /* height of the wheelset's centre above the rails' tops, nominal [m] */
  double half_base; /* from the wheelset's centre to the wheel's, along the axle: > 0 of a left wheel [m] */
} rail_wheel;

typedef struct wheel_motion {
  double position[3];         /* of the wheelset's centre [m] */
  double axle[3];             /* unit vector along the axle, to the left */
  double velocity[3];         /* of the wheelset's centre [m/s] */
  double angular_velocity[3]; /* of the wheelset, rolling included: about y > 0 forward [rad/s] */
  double curvature;           /* of the track, > 0 in a curve to the left [1/m] */
} wheel_motion;

typedef struct wheel_load {
  double force[3], moment[3]; /* on the wheelset, about its centre [N], [N m]; zero with MICROSLIP_INVALID_INPUT */
  int status;                 /* MICROSLIP_OK, _NO_CONTACT, _NOT_CONVERGED, _INVALID_INPUT, _IMPLAUSIBLE */
} wheel_load;

/* The numbers of a state that a rigid wheelset has, as the library's list has them in front. */
enum {
  wheel_lateral,
  wheel_vertical,
  wheel_roll,
  wheel_yaw,
  wheel_forward_velocity,
  wheel_lateral_velocity,
  wheel_vertical_velocity,
  wheel_roll_velocity,
  wheel_pitch_velocity,
  wheel_yaw_velocity,
  wheel_curvature,
  wheel_longitudinal = 28,
  wheel_state_width
};

/* Reads a case file of a wheel on a rail, whose state does not matter. Returns a microslip_code. */
static inline int wheel_create(rail_wheel* made, const char* case_file, microslip_error* error) {
  microslip_problem* problem = NULL;
  char *text = NULL, *side = NULL;
  double back_distance = 0, back_position = 0;
  long size;
  FILE* const file = fopen(case_file, "rb");
  memset(made, 0, sizeof *made);
  if (!file || fseek(file, 0, SEEK_END) != 0 || (size = ftell(file)) < 0 ||
      !(text = (char*)calloc(1, (size_t)size + 1))) {
    if (file) fclose(file);
    error->code = MICROSLIP_INVALID_OPTION;
    snprintf(error->text, sizeof error->text, "%.200s: cannot be read", case_file);
    return error->code;
  }
  rewind(file);
  text[fread(text, 1, (size_t)size, file)] = 0;
  fclose(file);
  if (microslip_problem_read(text, case_file, &problem, error) == MICROSLIP_OK &&
      microslip_get(problem, "wheelset.nominal_radius", &made->radius, error) == MICROSLIP_OK &&
      microslip_get(problem, "wheelset.flange_back_distance", &back_distance, error) == MICROSLIP_OK &&
      microslip_get(problem, "wheelset.flange_back_position", &back_position, error) == MICROSLIP_OK &&
      microslip_get_text(problem, "wheel.side", &side, error) == MICROSLIP_OK)
    microslip_wheel_rail_create(problem, &made->contact, error);
  made->half_base = (back_distance / 2 - back_position) * (side && strcmp(side, "right") == 0 ? -1 : 1);
  microslip_free_text(side);
  microslip_problem_destroy(problem);
  free(text);
  return error->code;
}

static inline void wheel_destroy(rail_wheel* made) {
  microslip_wheel_rail_destroy(made->contact);
  made->contact = NULL;
}

static inline double wheel_dot(const double* a, const double* b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
static inline void wheel_cross(const double* a, const double* b, double* product) {
  product[0] = a[1] * b[2] - a[2] * b[1];
  product[1] = a[2] * b[0] - a[0] * b[2];
  product[2] = a[0] * b[1] - a[1] * b[0];
}

/* Roll and yaw of an axle, and the wheelset's axes x and z, which do not roll with it: its axes are those of the track
 * turned by yaw about z, then by roll about x. */
typedef struct wheel_axes {
  double roll, yaw, x[3], z[3];
} wheel_axes;

static inline wheel_axes wheel_axes_of(const double* axle) {
  wheel_axes a;
  a.roll = atan2(axle[2], axle[1]);
  a.yaw = asin(fmax(-1, fmin(1, -axle[0])));
  a.x[0] = cos(a.yaw), a.x[1] = cos(a.roll) * sin(a.yaw), a.x[2] = sin(a.roll) * sin(a.yaw);
  a.z[0] = 0, a.z[1] = -sin(a.roll), a.z[2] = cos(a.roll);
  return a;
}

/* The state of the wheelset that microslip takes, with its height given. */
static inline void wheel_state(const rail_wheel* w, const wheel_motion* motion, double* state) {
  const wheel_axes axes = wheel_axes_of(motion->axle);
  memset(state, 0, wheel_state_width * sizeof *state);
  state[wheel_longitudinal] = motion->position[0];
  state[wheel_lateral] = motion->position[1];
  state[wheel_vertical] = motion->position[2] - w->radius;
  state[wheel_roll] = axes.roll;
  state[wheel_yaw] = axes.yaw;
  memcpy(state + wheel_forward_velocity, motion->velocity, 3 * sizeof *state);
  state[wheel_roll_velocity] = wheel_dot(axes.x, motion->angular_velocity);
  state[wheel_pitch_velocity] = wheel_dot(motion->axle, motion->angular_velocity);
  state[wheel_yaw_velocity] = wheel_dot(axes.z, motion->angular_velocity);
  state[wheel_curvature] = motion->curvature;
}

/* Moves a force and a moment on the wheel, about its centre, to the centre of the wheelset. */
static inline void wheel_take(const rail_wheel* w, const wheel_motion* motion, const double* result, wheel_load* load) {
  double lever[3];
  int k;
  if (load->status == MICROSLIP_INVALID_INPUT || load->status >= MICROSLIP_NULL_POINTER) {
    memset(load->force, 0, sizeof load->force), memset(load->moment, 0, sizeof load->moment);
    return;
  }
  memcpy(load->force, result, sizeof load->force);
  wheel_cross(motion->axle, load->force, lever);
  for (k = 0; k < 3; ++k) load->moment[k] = result[3 + k] + w->half_base * lever[k];
}

/* The load on the wheelset by this wheel. */
static inline void wheel_solve(const rail_wheel* w, const wheel_motion* motion, wheel_load* load) {
  double state[wheel_state_width], result[6];
  wheel_state(w, motion, state);
  const int code = microslip_wheel_rail_solve(w->contact, 1, wheel_state_width, state, 6, result, &load->status);
  if (code >= MICROSLIP_NULL_POINTER) load->status = code; /* another thread uses this wheel */
  wheel_take(w, motion, result, load);
}

/* How the state changes with the k-th of a wheelset's twelve numbers: position, rotation about the track's axes,
 * velocity, angular velocity. Only the wheelset turns, its velocities do not. */
static inline void wheel_state_change(const wheel_motion* motion, int k, double* change) {
  const double *axle = motion->axle, *omega = motion->angular_velocity;
  const wheel_axes axes = wheel_axes_of(axle);
  const double cos_roll = cos(axes.roll), sin_roll = sin(axes.roll), sin_yaw = sin(axes.yaw), cos_yaw = cos(axes.yaw);
  double turn[3] = {0, 0, 0}, moved[3], roll, yaw;
  memset(change, 0, wheel_state_width * sizeof *change);
  if (k == 0) change[wheel_longitudinal] = 1;
  if (k == 1) change[wheel_lateral] = 1;
  if (k == 2) change[wheel_vertical] = 1;
  if (k >= 6 && k < 9) change[wheel_forward_velocity + k - 6] = 1;
  if (k >= 9) {
    change[wheel_roll_velocity] = axes.x[k - 9];
    change[wheel_pitch_velocity] = axle[k - 9];
    change[wheel_yaw_velocity] = axes.z[k - 9];
  }
  if (k < 3 || k >= 6) return;
  turn[k - 3] = 1;
  wheel_cross(turn, axle, moved);
  yaw = -moved[0] / cos_yaw;
  roll = (axle[1] * moved[2] - axle[2] * moved[1]) / (axle[1] * axle[1] + axle[2] * axle[2]);
  change[wheel_roll] = roll, change[wheel_yaw] = yaw;
  change[wheel_roll_velocity] =
      yaw * (-sin_yaw * omega[0] + cos_roll * cos_yaw * omega[1] + sin_roll * cos_yaw * omega[2]) +
      roll * sin_yaw * (-sin_roll * omega[1] + cos_roll * omega[2]);
  change[wheel_pitch_velocity] = wheel_dot(moved, omega);
  change[wheel_yaw_velocity] = -roll * (cos_roll * omega[1] + sin_roll * omega[2]);
}

/* The load and its derivatives: force and moment by position, rotation about the track's axes, velocity and angular
 * velocity; of an unsolved state zeros. Some three solves. */
static inline void wheel_differentiate(const rail_wheel* w, const wheel_motion* motion, wheel_load* load,
                                       double jacobian[6][12]) {
  double state[wheel_state_width], result[6], by_state[6][wheel_state_width], change[wheel_state_width];
  int k, n, row;
  wheel_state(w, motion, state);
  const int code = microslip_wheel_rail_differentiate(w->contact, 1, wheel_state_width, state, 6, result, &load->status,
                                                      6, wheel_state_width, by_state[0]);
  memset(jacobian, 0, 6 * sizeof *jacobian);
  if (code >= MICROSLIP_NULL_POINTER) load->status = code;
  wheel_take(w, motion, result, load);
  if (load->status != MICROSLIP_OK && load->status != MICROSLIP_IMPLAUSIBLE) return;
  for (k = 0; k < 12; ++k) {
    double turn[3] = {0, 0, 0}, moved[3] = {0, 0, 0}, by_lever[3], by_axle[3], force[3];
    wheel_state_change(motion, k, change);
    for (row = 0; row < 6; ++row)
      for (n = 0; n < wheel_state_width; ++n) jacobian[row][k] += by_state[row][n] * change[n];
    if (k >= 3 && k < 6) turn[k - 3] = 1, wheel_cross(turn, motion->axle, moved);
    for (row = 0; row < 3; ++row) force[row] = jacobian[row][k];
    wheel_cross(motion->axle, force, by_lever);
    wheel_cross(moved, load->force, by_axle);
    for (row = 0; row < 3; ++row) jacobian[3 + row][k] += w->half_base * (by_lever[row] + by_axle[row]);
  }
}

#endif
