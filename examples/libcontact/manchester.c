/* The Manchester contact benchmark through libcontact, as programs that are written for CONTACT's library have
 * it: both wheels of a wheelset that moves aside, 21 states each, with forces, positions, fields and sensitivities.
 *
 *   cc manchester.c -I PREFIX/include -L PREFIX/lib -lcontact -o manchester
 *   ./manchester RAIL.prr WHEEL.prw
 */
#include <contact_addon.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { states = 21, whole = -1, most_values = 40 };

static const double roll[states] = {0.00000000,  -0.00002304, -0.00005049, -0.00008103, -0.00011280, -0.00014570,
                                    -0.00018030, -0.00021680, -0.00025570, -0.00029770, -0.00035540, -0.00047770,
                                    -0.00062720, -0.00437600, -0.00639300, -0.00764200, -0.00860600, -0.00940800,
                                    -0.01010113, -0.01071386, -0.01126431};
static const double pitch_velocity[states] = {
    -4.34811810, -4.34741340, -4.34657520, -4.34624400, -4.34591970, -4.34556270, -4.34515030,
    -4.34466880, -4.34409300, -4.34337150, -4.33536370, -4.33188640, -4.32937180, -4.27488340,
    -4.26356290, -4.25757470, -4.25348570, -4.25032450, -4.24775610, -4.24556650, -4.24363750};

/* Ends the program if a call did not work. */
static void check(const char* what, int code) {
  if (code >= 0) return;
  fprintf(stderr, "%s: code %d, see contact_addon.out\n", what, code);
  exit(1);
}

static void set_profile(int ire, const char* file, int itype) {
  int length = (int)strlen(file), ints = 3, reals = 2, iparam[3] = {0, 0, 0};
  double rparam[2] = {1, 0};
  iparam[0] = itype;
  check("profile", cntc_setprofileinputfname(&ire, file, &length, &ints, iparam, &reals, rparam));
}

/* What does not change from state to state. */
static void set_up(int ire, const char* rail, const char* wheel) {
  int flags[10] = {CNTC_if_units, CNTC_ic_config, CNTC_ic_tang, CNTC_ic_pvtime, CNTC_ic_norm, CNTC_ic_discns};
  int values[10] = {CNTC_un_cntc, 0, 3, 2, 1, 2};
  int icp = whole, count = 10, method;
  double material[4] = {0.28, 0.28, 82000, 82000}, friction[2] = {0.3, 0.3}, force = 10000;
  double rules[5] = {0.2, 0.2, 1.5707963267948966, 8, 4}, chi = 0, dqrel = 1;
  double track[11] = {14, 0, 1435, 0, 0, 0, 0, 0, 0, 0, 0}, wheelset[3] = {1360, -70, 460};
  values[1] = ire - 1; /* 1: left, 2: right */
  check("flags", cntc_setflags(&ire, &icp, &count, flags, values));
  method = 0, count = 4;
  check("material", cntc_setmaterialparameters(&ire, &icp, &method, &count, material));
  method = 0, count = 2;
  check("friction", cntc_setfrictionmethod(&ire, &icp, &method, &count, friction));
  check("force", cntc_setverticalforce(&ire, &force));
  method = -1, count = 5;
  check("elements", cntc_setpotcontact(&ire, &icp, &method, &count, rules));
  check("step", cntc_setrollingstepsize(&ire, &icp, &chi, &dqrel));
  method = 3, count = 11;
  check("track", cntc_settrackdimensions(&ire, &method, &count, track));
  set_profile(ire, rail, 0);
  method = 3, count = 3;
  check("wheelset", cntc_setwheelsetdimensions(&ire, &method, &count, wheelset));
  set_profile(ire, wheel, 1);
}

static void set_state(int ire, int state) {
  int method = 2, count = 6;
  double position[6] = {0, 0, 0, 0, 0, 0}, velocity[6] = {2000, 0, 0, 0, 0, 0};
  position[1] = 0.5 * state;
  position[3] = roll[state];
  position[4] = 0.0012 * state;
  velocity[5] = pitch_velocity[state];
  check("position", cntc_setwheelsetposition(&ire, &method, &count, position));
  check("velocity", cntc_setwheelsetvelocity(&ire, &method, &count, velocity));
}

static void print_patch(int ire, int state, int icp) {
  double at[most_values] = {0}, fn, tx, ty, mz, pen, xi, eta, phi, v, c, h, s, pmax;
  int count = most_values;
  check("location", cntc_getcontactlocation(&ire, &icp, &count, at));
  check("velocity", cntc_getreferencevelocity(&ire, &icp, &v));
  check("approach", cntc_getpenetration(&ire, &icp, &pen));
  check("creepages", cntc_getcreepages(&ire, &icp, &xi, &eta, &phi));
  check("forces", cntc_getcontactforces(&ire, &icp, &fn, &tx, &ty, &mz));
  check("areas", cntc_getcontactpatchareas(&ire, &icp, &c, &h, &s));
  check("pressure", cntc_getmaximumpressure(&ire, &icp, &pmax));
  printf("patch %d %d %d %.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g\n", ire,
         state + 1, icp, at[0], at[1], at[2], at[3], at[5], at[6], v, pen, xi, eta, phi, fn, tx, ty, mz, c, pmax);
}

/* Pressures and tractions of all elements, and what they sum up to. */
static void print_fields(int ire, int icp) {
  int mx, my, count, k, in_contact = 0, *division;
  double dx, dy, force = 0, along = 0, *pn, *px, *py;
  check("elements", cntc_getnumelements(&ire, &icp, &mx, &my));
  check("sizes", cntc_getgriddiscretization(&ire, &icp, &dx, &dy));
  count = mx * my;
  pn = malloc(sizeof(double) * (size_t)count * 3);
  division = malloc(sizeof(int) * (size_t)count);
  if (!pn || !division) exit(1);
  px = pn + count;
  py = px + count;
  check("tractions", cntc_gettractions(&ire, &icp, &count, pn, px, py));
  check("division", cntc_getelementdivision(&ire, &icp, &count, division));
  for (k = 0; k < count; ++k) {
    force += pn[k] * dx * dy;
    along += px[k] * dx * dy;
    in_contact += division[k] > 0;
  }
  printf("fields %d %d %d %d %d %.9g %.9g\n", ire, icp, mx, my, in_contact, force, along);
  free(pn);
  free(division);
}

static void print_sensitivities(int ire, int icp) {
  int outputs = 4, inputs = 4, k;
  double sens[16] = {0};
  check("sensitivities", cntc_getsensitivities(&ire, &icp, &outputs, &inputs, sens));
  printf("sensitivities %d", ire);
  for (k = 0; k < 16; ++k) printf(" %.6g", sens[k]);
  printf("\n");
}

/* For the state that is calculated next. */
static void ask_for_sensitivities(int ire, int which) {
  int icp = whole, one = 1, code = CNTC_ic_sens;
  check("flags", cntc_setflags(&ire, &icp, &one, &code, &which));
}

int main(int argc, char** argv) {
  int version, error, quiet = 0, blank = 1, ire, state, module = 1, icp = whole;
  if (argc != 3) {
    fprintf(stderr, "usage: manchester RAIL.prr WHEEL.prw\n");
    return 2;
  }
  check("initialize", cntc_initializefirst(&version, &error, &quiet, " ", " ", " ", &blank, &blank, &blank));
  for (ire = 1; ire <= 2; ++ire) {
    check("initialize", cntc_initialize(&ire, &module, &version, &error, " ", &blank));
    set_up(ire, argv[1], argv[2]);
  }
  for (ire = 1; ire <= 2; ++ire)
    for (state = 0; state < states; ++state) {
      double forces[24], position[6];
      int count = 24, six = 6, patches, patch, is_last = state == states - 1;
      set_state(ire, state);
      ask_for_sensitivities(ire, is_last ? 3 : 0);
      check("calculate", cntc_calculate(&ire, &icp, &error));
      check("forces", cntc_getglobalforces(&ire, &icp, &count, forces));
      check("position", cntc_getwheelsetposition(&ire, &six, position));
      check("patches", cntc_getnumcontactpatches(&ire, &patches));
      printf("wheel %d %d %d %.9g %.9g %.9g %.9g %.9g %.9g %.9g\n", ire, state + 1, patches, position[2], forces[0],
             forces[1], forces[2], forces[6], forces[7], forces[8]);
      for (patch = 1; patch <= patches; ++patch) print_patch(ire, state, patch);
      if (is_last) {
        print_fields(ire, 1);
        print_sensitivities(ire, 1);
      }
    }
  check("finalize", cntc_finalizelast());
  return 0;
}
