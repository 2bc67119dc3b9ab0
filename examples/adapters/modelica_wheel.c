/* A wheel of a Modelica model by microslip: the C side of MicroslipWheel.mo.
 *
 * An external object holds the wheel. Its load is a function of the motion alone, as Modelica wants of functions
 * without the word "impure"; tests/adapters call it as a translated model does. The twelve numbers of a motion are
 * position of the wheelset's centre, its axle, velocity, angular velocity, in track axes. */
#include "wheel.h"

#ifdef MICROSLIP_MODELICA_UTILITIES
#include "ModelicaUtilities.h"
#else
/* The two that are used of ModelicaUtilities.h, which every tool has. */
extern void ModelicaFormatError(const char* text, ...);
extern void ModelicaFormatMessage(const char* text, ...);
#endif

void* microslip_modelica_create(const char* case_file);
void microslip_modelica_destroy(void* object);
int microslip_modelica_load(void* object, const double* motion, double curvature, double* load);
void microslip_modelica_load_der(void* object, const double* motion, double curvature, const double* motion_der,
                                 double* load_der);

void* microslip_modelica_create(const char* case_file) {
  microslip_error error = {0, ""};
  rail_wheel* const made = calloc(1, sizeof *made);
  if (made && wheel_create(made, case_file, &error) == MICROSLIP_OK) return made;
  free(made);
  ModelicaFormatError("microslip: %s", error.text);
  return NULL;
}

void microslip_modelica_destroy(void* object) {
  if (object) wheel_destroy(object);
  free(object);
}

static wheel_motion motion_from(const double* numbers, double curvature) {
  wheel_motion motion;
  memcpy(motion.position, numbers, sizeof motion.position);
  memcpy(motion.axle, numbers + 3, sizeof motion.axle);
  memcpy(motion.velocity, numbers + 6, sizeof motion.velocity);
  memcpy(motion.angular_velocity, numbers + 9, sizeof motion.angular_velocity);
  motion.curvature = curvature;
  return motion;
}

/* Force and moment; returns the status. A state out of range is an error, after which a tool tries a shorter step. */
int microslip_modelica_load(void* object, const double* motion, double curvature, double* load) {
  const wheel_motion now = motion_from(motion, curvature);
  wheel_load found;
  wheel_solve(object, &now, &found);
  memcpy(load, found.force, sizeof found.force);
  memcpy(load + 3, found.moment, sizeof found.moment);
  if (found.status == MICROSLIP_INVALID_INPUT) ModelicaFormatError("microslip: a wheel is far off its track");
  return found.status;
}

/* The change of force and moment with time where the motion changes by motion_der, for the tool's Jacobian: an axle of
 * constant length turns by axle x axle_der, which leaves out the turn about itself, on which nothing depends. */
void microslip_modelica_load_der(void* object, const double* motion, double curvature, const double* motion_der,
                                 double* load_der) {
  const wheel_motion now = motion_from(motion, curvature);
  double jacobian[6][12], turn[3], change[12];
  wheel_load found;
  int row, k;
  wheel_differentiate(object, &now, &found, jacobian);
  wheel_cross(now.axle, motion_der + 3, turn);
  memcpy(change, motion_der, 12 * sizeof *change);
  memcpy(change + 3, turn, sizeof turn);
  for (row = 0; row < 6; ++row)
    for (load_der[row] = 0, k = 0; k < 12; ++k) load_der[row] += jacobian[row][k] * change[k];
}
