/* A wheel of Adams (also VI-Rail) by microslip: the GFORCE of a wheel on its rail as a C subroutine.
 *
 * Not run in Adams: tests/adapters call it as the manual says, with utilities of their own. slv_c_utils.h is Adams'.
 *
 *   GFORCE/11, I = 101, JFLOAT = 901, RM = 501, FUNCTION = USER(1, 1.0), ROUTINE = microslip_adams:Gfosub
 *
 *   I       on the wheelset: its origin in the middle of the axle, y along it to the left; it may roll with the
 * wheelset RM      the track: its origin midway between the rails at their tops, x along the track, y to the left, z up
 *   JFLOAT  of the ground
 *   USER    number n of the wheel: its case file is wheel_n.toml in the working folder; the model's length in m (1.0,
 * or 0.001 for mm; forces in N). Left and right wheel have a GFORCE each, on the same markers.
 *
 *   cc -shared -fPIC adams_gforce.c $(pkg-config --cflags --libs microslip_c) -lm -o microslip_adams.so
 *
 * Adams wants user subroutines pure and re-entrant: the load depends on the motion alone, so that dflag and repeated or
 * rejected times need no care, and threads use wheels of their own. */
#include "slv_c_utils.h"

#include "numbered_wheels.h"

adams_c_Gfosub Gfosub;

/* Pose and motion of marker I against RM, in its axes, in SI units. These calls also tell Adams what the force depends
 * on, and so are made in every pass. Velocities are differentiated in RM, which stands still or runs along the track.
 */
static int motion_of(const struct sAdamsGforce* force, double length, wheel_motion* motion) {
  const int from_track[4] = {force->I, force->RM, force->RM, force->RM};
  double velocity[6];
  int count, failed, any_failed, k;
  memset(motion, 0, sizeof *motion);
  c_sysary("TDISP", from_track, 3, motion->position, &count, &any_failed);
  c_sysary("UVY", from_track, 2, motion->axle, &count, &failed);
  any_failed |= failed;
  c_sysary("VEL", from_track, 4, velocity, &count, &failed);
  for (k = 0; k < 3; ++k) {
    motion->position[k] *= length;
    motion->velocity[k] = length * velocity[k];
    motion->angular_velocity[k] = velocity[3 + k];
  }
  return !(any_failed | failed);
}

void Gfosub(const struct sAdamsGforce* force, double time, int dflag, int iflag, double* result) {
  microslip_error error = {0, ""};
  wheel_motion motion;
  wheel_load load;
  int k;
  (void)time, (void)dflag;
  memset(result, 0, 6 * sizeof *result);
  if (iflag == 5 || iflag == 7 || iflag == 9) return; /* nothing is kept that would be saved */
  const double length = force->NPAR > 1 ? force->PAR[1] : 1;
  if (!motion_of(force, length, &motion)) {
    c_errmes(1, "the markers of a wheel are not to be had", force->ID, "STOP");
    return;
  }
  if (iflag != 0) return; /* what the force depends on is told */
  numbered_wheel* const taken = take_wheel((int)force->PAR[0], &error);
  if (!taken) {
    c_errmes(1, error.text, force->ID, "STOP");
    return;
  }
  wheel_solve(&taken->made, &motion, &load);
  give_wheel_back(taken);
  if (load.status == MICROSLIP_INVALID_INPUT) c_errmes(1, "a wheel is far off its track", force->ID, "CONTINUE");
  for (k = 0; k < 3; ++k) {
    result[k] = load.force[k];
    result[3 + k] = load.moment[k] / length;
  }
}
