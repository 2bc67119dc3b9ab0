/* A program in the style of those that come with CONTACT: no initialisation, no T, no folder for files; elements and
 * contact problems in turn, with calls in an unusual order; then the results of all by every function that gets some.
 * Lines are the function's name, ire, icp and its numbers: every_getter.f90 prints the same.
 *
 *   every_getter RAIL.prr WHEEL.prw
 */
#include <contact_addon.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { whole = -1, right = 1, left = 2, contacts = 3, layer = 4, most_values = 40 };

/* Ends the program if a call did not work. */
static void check(const char* what, int code) {
  if (code >= 0) return;
  fprintf(stderr, "%s: code %d, see contact_addon.out\n", what, code);
  exit(1);
}

static void show(const char* name, int ire, int icp, int count, const double* values) {
  int k;
  printf("%s %d %d", name, ire, icp);
  for (k = 0; k < count; ++k) printf(" %.17g", values[k]);
  printf("\n");
}

static void show_integers(const char* name, int ire, int icp, int count, const int* values) {
  int k;
  printf("%s %d %d", name, ire, icp);
  for (k = 0; k < count; ++k) printf(" %d", values[k]);
  printf("\n");
}

static void set_flag(int ire, int icp, int flag, int value) {
  int one = 1;
  check("flag", cntc_setflags(&ire, &icp, &one, &flag, &value));
}

static void set_profile(int ire, const char* file, int itype) {
  int length = (int)strlen(file), ints = 3, reals = 2, iparam[3] = {0, 0, 0};
  double rparam[2] = {1, 0};
  iparam[0] = itype;
  check("profile", cntc_setprofileinputfname(&ire, file, &length, &ints, iparam, &reals, rparam));
}

/* Results before there is a solution: a code, and no end of the program. */
static void ask_too_early(int ire, int icp) {
  double fn, fx, fy, mz;
  if (cntc_getcontactforces(&ire, &icp, &fn, &fx, &fy, &mz) != CNTC_err_icp) exit(1);
}

static void place_wheel(int ire) {
  int method = 2, count = 6;
  double at[6] = {0, 3, 0.2, -3e-4, 6e-3, 0}, moves[6] = {30000, 0, 0, 0, 0, -65};
  check("velocity", cntc_setwheelsetvelocity(&ire, &method, &count, moves));
  check("position", cntc_setwheelsetposition(&ire, &method, &count, at));
}

static void set_up_wheel(int ire, const char* rail, const char* wheel) {
  int icp = whole, method = 3, count = 11;
  double track[11] = {14, 0, 1435, 0.05, 0, 0, 0, 0, 0, 0, 0}, wheelset[3] = {1360, -70, 460};
  double rules[5] = {0.5, 0.5, 1.5707963267948966, 8, 4}, friction[2] = {0.3, 0.3};
  double material[4] = {0.28, 0.28, 82000, 82000};
  set_profile(ire, wheel, 1);
  check("track", cntc_settrackdimensions(&ire, &method, &count, track));
  count = 3;
  check("wheelset", cntc_setwheelsetdimensions(&ire, &method, &count, wheelset));
  method = 0, count = 2;
  check("friction", cntc_setfrictionmethod(&ire, &icp, &method, &count, friction));
  method = -1, count = 5;
  check("elements", cntc_setpotcontact(&ire, &icp, &method, &count, rules));
  set_profile(ire, rail, 0);
  method = 0, count = 4;
  check("material", cntc_setmaterialparameters(&ire, &icp, &method, &count, material));
  set_flag(ire, icp, CNTC_ic_config, ire == left ? 0 : 1);
}

static void set_motion(int ire, int icp, double vx, double vy, double phi) {
  double chi = 0, dq = 0.2, veloc = 2000;
  check("creepages", cntc_setcreepages(&ire, &icp, &vx, &vy, &phi));
  check("step", cntc_setrollingstepsize(&ire, &icp, &chi, &dq));
  check("velocity", cntc_setreferencevelocity(&ire, &icp, &veloc));
}

/* A sphere on a plane, with heat and falling friction. */
static void set_up_hot_sphere(int ire, int icp) {
  int method = 1, count = 6;
  double curvatures[6] = {0.005, 0, 0.005, 0, 0, 0}, grid[6] = {21, 21, -1.05, -1.05, 0.1, 0.1}, force = 1000;
  double heat[8] = {20, 450, 0.05, 7.85e-6, 20, 450, 0.05, 7.85e-6}, falls[7] = {0.2, 0.1, 50, 0, 10000, 0.001, 10};
  double material[4] = {0.28, 0.28, 82000, 82000};
  check("distance", cntc_setundeformeddistc(&ire, &icp, &method, &count, curvatures));
  method = 3, count = 8;
  check("heat", cntc_settemperaturedata(&ire, &icp, &method, &count, heat));
  check("force", cntc_setnormalforce(&ire, &icp, &force));
  method = 4, count = 7;
  check("friction", cntc_setfrictionmethod(&ire, &icp, &method, &count, falls));
  method = 1, count = 6;
  check("elements", cntc_setpotcontact(&ire, &icp, &method, &count, grid));
  set_motion(ire, icp, 0.001, -0.0005, 0.0001);
  method = 0, count = 4;
  check("material", cntc_setmaterialparameters(&ire, &icp, &method, &count, material));
}

/* An ellipse that is given its force along x, with sensitivities. */
static void set_up_ellipse(int ire, int icp) {
  int method = 0, count = 2;
  double friction[2] = {0.3, 0.3}, fx = 0.4, fy = 0, force = 2000, ellipse[5] = {16, 16, 1, 0.8, 1.25};
  double material[4] = {0.28, 0.28, 82000, 82000};
  set_flag(ire, icp, CNTC_ic_sens, 3);
  check("friction", cntc_setfrictionmethod(&ire, &icp, &method, &count, friction));
  check("forces", cntc_settangentialforces(&ire, &icp, &fx, &fy));
  set_motion(ire, icp, 0, 0.0005, 0);
  check("force", cntc_setnormalforce(&ire, &icp, &force));
  set_flag(ire, icp, CNTC_ic_force, 1);
  method = -3, count = 5;
  check("ellipse", cntc_sethertzcontact(&ire, &icp, &method, &count, ellipse));
  method = 0, count = 4;
  check("material", cntc_setmaterialparameters(&ire, &icp, &method, &count, material));
}

/* The ellipse at a given approach, with a layer that yields. */
static void set_up_layer(int ire, int icp) {
  int method = 0, count = 2;
  double friction[2] = {0.5, 0.5}, approach = 0.01, ellipse[5] = {12, 12, 1, 1, 1.2};
  double material[8] = {0.28, 0.28, 82000, 82000, 8200, 0.02, 60, 500};
  check("approach", cntc_setpenetration(&ire, &icp, &approach));
  set_motion(ire, icp, 0.004, 0.002, 0);
  check("friction", cntc_setfrictionmethod(&ire, &icp, &method, &count, friction));
  method = 4, count = 8;
  check("material", cntc_setmaterialparameters(&ire, &icp, &method, &count, material));
  method = -3, count = 5;
  check("ellipse", cntc_sethertzcontact(&ire, &icp, &method, &count, ellipse));
}

static void add_points(int ire, int icp) {
  int block = 1, method = 9, two = 2, one = 1;
  double x[2] = {0, 0.5}, y[1] = {0.25}, z[2] = {0.5, -1};
  check("points", subs_addblock(&ire, &icp, &block, &method, &two, &one, &two, x, y, z));
}

static void calculate(int ire, int icp) {
  int error = 0;
  check("calculate", cntc_calculate(&ire, &icp, &error));
  check("calculate", error);
}

static void show_interior(int ire, int icp, int calculated_icp) {
  int error = 0, block = 1, size[3], columns[21], count = 21, length = 4, k;
  double values[4 * 21];
  check("interior", subs_calculate(&ire, &calculated_icp, &error));
  check("size", subs_getblocksize(&ire, &icp, &block, &size[0], &size[1], &size[2]));
  show_integers("subs_getblocksize", ire, icp, 3, size);
  for (k = 0; k < count; ++k) columns[k] = k + 1;
  check("points", subs_getresults(&ire, &icp, &block, &length, &count, columns, values));
  show("subs_getresults", ire, icp, length * count, values);
}

static void show_fields(int ire, int icp) {
  static const int codes[] = {CNTC_fld_h,     CNTC_fld_mu,   CNTC_fld_px,     CNTC_fld_py,    CNTC_fld_pn,
                              CNTC_fld_ux,    CNTC_fld_uy,   CNTC_fld_un,     CNTC_fld_sx,    CNTC_fld_sy,
                              CNTC_fld_wx,    CNTC_fld_wy,   CNTC_fld_taucrt, CNTC_fld_uplsx, CNTC_fld_uplsy,
                              CNTC_fld_temp1, CNTC_fld_temp2};
  int mx, my, count, code, numbers[2];
  size_t k;
  double *a, *b, *c;
  int* division;
  char name[40];
  check("elements", cntc_getnumelements(&ire, &icp, &mx, &my));
  numbers[0] = mx, numbers[1] = my;
  show_integers("cntc_getnumelements", ire, icp, 2, numbers);
  count = mx * my;
  a = malloc((size_t)count * sizeof *a), b = malloc((size_t)count * sizeof *b), c = malloc((size_t)count * sizeof *c);
  division = malloc((size_t)count * sizeof *division);
  for (k = 0; k < sizeof codes / sizeof *codes; ++k) {
    code = codes[k];
    cntc_getfielddata(&ire, &icp, &code, &count, a); /* not all contacts have all */
    sprintf(name, "cntc_getfielddata_%d", code);
    show(name, ire, icp, count, a);
  }
  check("tractions", cntc_gettractions(&ire, &icp, &count, a, b, c));
  show("cntc_gettractions_pn", ire, icp, count, a);
  show("cntc_gettractions_px", ire, icp, count, b);
  show("cntc_gettractions_py", ire, icp, count, c);
  check("slip", cntc_getmicroslip(&ire, &icp, &count, a, b));
  show("cntc_getmicroslip_sx", ire, icp, count, a);
  show("cntc_getmicroslip_sy", ire, icp, count, b);
  check("displacements", cntc_getdisplacements(&ire, &icp, &count, a, b, c));
  show("cntc_getdisplacements_un", ire, icp, count, a);
  show("cntc_getdisplacements_ux", ire, icp, count, b);
  show("cntc_getdisplacements_uy", ire, icp, count, c);
  check("division", cntc_getelementdivision(&ire, &icp, &count, division));
  show_integers("cntc_getelementdivision", ire, icp, count, division);
  free(a), free(b), free(c), free(division);
}

static void show_contact(int ire, int icp) {
  static const int lengths[] = {6, 22, 7};
  double v[most_values];
  int four = 4, six = 6, task;
  char name[40];
  check("velocity", cntc_getreferencevelocity(&ire, &icp, v));
  show("cntc_getreferencevelocity", ire, icp, 1, v);
  check("sizes", cntc_getgriddiscretization(&ire, &icp, v, v + 1));
  show("cntc_getgriddiscretization", ire, icp, 2, v);
  check("approach", cntc_getpenetration(&ire, &icp, v));
  show("cntc_getpenetration", ire, icp, 1, v);
  check("creepages", cntc_getcreepages(&ire, &icp, v, v + 1, v + 2));
  show("cntc_getcreepages", ire, icp, 3, v);
  check("forces", cntc_getcontactforces(&ire, &icp, v, v + 1, v + 2, v + 3));
  show("cntc_getcontactforces", ire, icp, 4, v);
  check("areas", cntc_getcontactpatchareas(&ire, &icp, v, v + 1, v + 2));
  show("cntc_getcontactpatchareas", ire, icp, 3, v);
  check("pressure", cntc_getmaximumpressure(&ire, &icp, v));
  show("cntc_getmaximumpressure", ire, icp, 1, v);
  check("traction", cntc_getmaximumtraction(&ire, &icp, v));
  show("cntc_getmaximumtraction", ire, icp, 1, v);
  cntc_getmaximumtemperature(&ire, &icp, v, v + 1); /* 0 without heat */
  show("cntc_getmaximumtemperature", ire, icp, 2, v);
  check("grid", cntc_getpotcontact(&ire, &icp, &six, v));
  show("cntc_getpotcontact", ire, icp, 6, v);
  for (task = 1; task <= 3; ++task) {
    int length = lengths[task - 1];
    check("parameters", cntc_getparameters(&ire, &icp, &task, &length, v));
    sprintf(name, "cntc_getparameters_%d", task);
    show(name, ire, icp, length, v);
  }
  check("sensitivities", cntc_getsensitivities(&ire, &icp, &four, &four, v));
  show("cntc_getsensitivities", ire, icp, 16, v);
  show_fields(ire, icp);
}

static void show_hertz(int ire, int icp) {
  int ten = 10;
  double v[10];
  check("ellipse", cntc_gethertzcontact(&ire, &icp, &ten, v));
  show("cntc_gethertzcontact", ire, icp, ten, v);
}

static void show_wheel(int ire) {
  int patch, patches, count, icp = whole, type[2] = {0, 0}, two = 2, none = 0, task;
  double v[most_values], *points;
  char name[40];
  check("patches", cntc_getnumcontactpatches(&ire, &patches));
  show_integers("cntc_getnumcontactpatches", ire, whole, 1, &patches);
  count = 6;
  check("position", cntc_getwheelsetposition(&ire, &count, v));
  show("cntc_getwheelsetposition", ire, whole, count, v);
  check("velocity", cntc_getwheelsetvelocity(&ire, &count, v));
  show("cntc_getwheelsetvelocity", ire, whole, count, v);
  check("sizes", cntc_getgriddiscretization(&ire, &icp, v, v + 1));
  show("cntc_getgriddiscretization", ire, whole, 2, v);
  for (patch = 0; patch <= patches; ++patch) {
    icp = patch == 0 ? whole : patch, count = 24;
    check("forces", cntc_getglobalforces(&ire, &icp, &count, v));
    show("cntc_getglobalforces", ire, icp, count, v);
  }
  for (patch = 1; patch <= patches; ++patch) {
    count = 38;
    check("location", cntc_getcontactlocation(&ire, &patch, &count, v));
    show("cntc_getcontactlocation", ire, patch, count, v);
    show_contact(ire, patch);
  }
  for (type[0] = 0; type[0] < 2; ++type[0]) { /* the points of rail and wheel */
    task = 0, count = 1;
    check("points", cntc_getprofilevalues(&ire, &task, &two, type, &none, NULL, &count, v));
    task = 1, count = 2 * (int)v[0];
    points = malloc((size_t)count * sizeof *points);
    check("points", cntc_getprofilevalues_new(&ire, &task, &two, type, &none, NULL, &count, points));
    sprintf(name, "cntc_getprofilevalues_%d", type[0]);
    show(name, ire, whole, count, points);
    free(points);
  }
}

static void show_flags(int ire, int icp) {
  int codes[14] = {CNTC_ic_pvtime, CNTC_ic_bound,  CNTC_ic_tang,  CNTC_ic_norm, CNTC_ic_force,
                   CNTC_ic_frclaw, CNTC_ic_inflcf, CNTC_ic_mater, CNTC_ic_heat, CNTC_ic_iestim,
                   CNTC_ic_output, CNTC_ic_return, CNTC_if_units, CNTC_if_ncase};
  int values[14], count = 14;
  check("flags", cntc_getflags(&ire, &icp, &count, codes, values));
  show_integers("cntc_getflags", ire, icp, count, values);
}

static void check_time(int ire, int icp) {
  double cpu, wall;
  check("time", cntc_getcalculationtime(&ire, &icp, &cpu, &wall));
  if (!(wall > 0)) exit(1);
  check("time", cntc_resetcalculationtime(&ire, &icp));
  check("time", cntc_getcalculationtime(&ire, &icp, &cpu, &wall));
  if (wall != 0) exit(1);
}

int main(int count, char** words) {
  int ire = right, threads;
  double force = 80000;
  if (count != 3) return 1;
  place_wheel(left);
  set_up_ellipse(contacts, 2);
  ask_too_early(contacts, 1);
  check("force", cntc_setverticalforce(&ire, &force));
  add_points(right, whole);
  set_up_wheel(left, words[1], words[2]);
  set_up_hot_sphere(contacts, 1);
  calculate(contacts, 2);
  set_up_layer(layer, 5);
  set_up_wheel(right, words[1], words[2]);
  calculate(left, whole);
  place_wheel(right);
  calculate(layer, 5);
  calculate(contacts, 1);
  calculate(right, whole);
  add_points(contacts, 2);
  check("threads", cntc_getmaxnumthreads(&threads));
  show_wheel(left);
  show_contact(contacts, 1);
  show_wheel(right);
  show_contact(layer, 5);
  show_hertz(layer, 5);
  show_contact(contacts, 2);
  show_hertz(contacts, 2);
  show_interior(contacts, 2, 2);
  show_interior(right, 1, whole);
  show_flags(right, whole);
  show_flags(contacts, 1);
  show_flags(contacts, 2);
  show_flags(layer, 5);
  check_time(right, whole);
  check_time(layer, 5);
  check("end", cntc_finalizelast());
  return 0;
}
