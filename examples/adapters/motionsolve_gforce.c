/* A wheel of MotionSolve by microslip: the Force_Vector_TwoBody of a wheel on its rail, type ForceAndTorque, as a C
 * subroutine.
 *
 * Not run in MotionSolve: tests/adapters call it as the manual says, with utilities of their own.
 *
 *   usrsub_param_string = "USER(1, 101, 501, 1.0)"  usrsub_dll_name = "microslip_motionsolve"
 *   usrsub_fnc_name = "GFOSUB"
 *
 *   USER    number n of the wheel: its case file is wheel_n.toml in the working folder; marker of the wheelset, which
 * is also i_marker_id: its origin in the middle of the axle, y along it to the left; marker of the track, which is also
 * ref_marker_id: its origin midway between the rails at their tops, x along the track, y to the left, z up; the model's
 * length in m (1.0, or 0.001 for mm; forces in N)
 *
 *   cc -shared -fPIC motionsolve_gforce.c $(pkg-config --cflags --libs microslip_c) -lm -o microslip_motionsolve.so
 *
 * CFFSUB, the friction of a contact, has no way to give the normal force and the position of a contact on profiles: it
 * is the place for the tangential law alone (microslip_fastsim2_solve). */
#include "numbered_wheels.h"

#ifdef _WIN32
#define EXPORTED __declspec(dllexport) void __stdcall
#else
#define EXPORTED void
#endif

/* MotionSolve's utilities. */
extern void c_sysary(const char* name, const int* parameters, int size, double* states, int* count, int* failed);
extern void c_errmes(int failed, const char* message, int id, const char* what);

EXPORTED GFOSUB(int* id, double* time, double* par, int* npar, int* dflag, int* iflag, double* result);

/* Pose and motion of the wheelset's marker against that of the track, in its axes, in SI units. DC has the direction
 * cosines row by row: the axle is the middle column. */
static int motion_of(int wheelset, int track, double length, wheel_motion* motion) {
  const int from_track[4] = {wheelset, track, track, track};
  double velocity[6], cosines[9];
  int count, failed, any_failed, k;
  memset(motion, 0, sizeof *motion);
  c_sysary("TDISP", from_track, 3, motion->position, &count, &any_failed);
  c_sysary("DC", from_track, 2, cosines, &count, &failed);
  any_failed |= failed;
  c_sysary("VEL", from_track, 4, velocity, &count, &failed);
  for (k = 0; k < 3; ++k) {
    motion->position[k] *= length;
    motion->axle[k] = cosines[3 * k + 1];
    motion->velocity[k] = length * velocity[k];
    motion->angular_velocity[k] = velocity[3 + k];
  }
  return !(any_failed | failed);
}

EXPORTED GFOSUB(int* id, double* time, double* par, int* npar, int* dflag, int* iflag, double* result) {
  microslip_error error = {0, ""};
  wheel_motion motion;
  wheel_load load;
  int k;
  (void)time, (void)dflag;
  memset(result, 0, 6 * sizeof *result);
  if (*npar < 3) {
    c_errmes(1, "USER must have a wheel, its marker and that of the track", *id, "STOP");
    return;
  }
  const double length = *npar > 3 ? par[3] : 1;
  if (!motion_of((int)par[1], (int)par[2], length, &motion)) {
    c_errmes(1, "the markers of a wheel are not to be had", *id, "STOP");
    return;
  }
  if (*iflag) return; /* what the force depends on is told */
  numbered_wheel* const taken = take_wheel((int)par[0], &error);
  if (!taken) {
    c_errmes(1, error.text, *id, "STOP");
    return;
  }
  wheel_solve(&taken->made, &motion, &load);
  give_wheel_back(taken);
  if (load.status == MICROSLIP_INVALID_INPUT) c_errmes(1, "a wheel is far off its track", *id, "CONTINUE");
  for (k = 0; k < 3; ++k) {
    result[k] = load.force[k];
    result[3 + k] = load.moment[k] / length;
  }
}
