/* A function of Octave and MATLAB: the forces of a right wheel at y [mm] under 10 kN, rolling at 2 m/s.
 *
 *   mkoctfile --mex wheel_forces.c -IPREFIX/include -LPREFIX/lib -Wl,-rpath,PREFIX/lib -lcontact     Octave
 *   mex wheel_forces.c -IPREFIX/include -LPREFIX/lib -lcontact                                       MATLAB
 *
 *   forces = wheel_forces('RAIL.prr', 'WHEEL.prw', y)      the 24 numbers of cntc_getglobalforces
 */
#include "contact_addon.h"
#include "mex.h"

#include <string.h>

static void require(int code, const char* function) {
  if (code == 0) return;
  cntc_finalizelast();
  mexErrMsgIdAndTxt("libcontact:code", "%s returned %d; contact_addon.out says why", function, code);
}

static void set_profile(int ire, int type, const mxArray* argument) {
  char* name = mxArrayToString(argument);
  int length = (int)strlen(name), choices[3] = {0, 0, 0}, three = 3, two = 2, code;
  double numbers[2] = {1, 0};
  choices[0] = type;
  code = cntc_setprofileinputfname(&ire, name, &length, &three, choices, &two, numbers);
  mxFree(name);
  require(code, "cntc_setprofileinputfname");
}

void mexFunction(int nlhs, mxArray* plhs[], int nrhs, const mxArray* prhs[]) {
  int version, error, output = 0, blank = 1, ire = 1, module = 1, whole = -1, method = 0, position = 2, all = 3;
  int codes[4] = {CNTC_ic_config, CNTC_ic_tang, CNTC_ic_pvtime, CNTC_ic_norm}, digits[4] = {1, 3, 2, 1};
  int two = 2, three = 3, four = 4, five = 5, six = 6, eleven = 11, count = 24, minus = -1;
  double material[4] = {0.28, 0.28, 82000, 82000}, friction[2] = {0.3, 0.3}, force = 10e3;
  double elements[5] = {0.2, 0.2, 1.5707963267948966, 8, 4};
  double track[11] = {14, 0, 1435, 0, 0, 0, 0, 0, 0, 0, 0}, wheelset[3] = {1360, -70, 460};
  double place[6] = {0, 0, 0, 0, 0, 0}, velocity[6] = {2000, 0, 0, 0, 0, -4.3481181};
  (void)nlhs;
  if (nrhs != 3) mexErrMsgIdAndTxt("libcontact:arguments", "wheel_forces(RAIL, WHEEL, Y)");
  place[1] = mxGetScalar(prhs[2]);
  cntc_initializefirst(&version, &error, &output, " ", " ", " ", &blank, &blank, &blank);
  require(cntc_initialize(&ire, &module, &version, &error, " ", &blank), "cntc_initialize");
  require(cntc_setflags(&ire, &whole, &four, codes, digits), "cntc_setflags");
  require(cntc_setmaterialparameters(&ire, &whole, &method, &four, material), "cntc_setmaterialparameters");
  require(cntc_setfrictionmethod(&ire, &whole, &method, &two, friction), "cntc_setfrictionmethod");
  require(cntc_setverticalforce(&ire, &force), "cntc_setverticalforce");
  require(cntc_setpotcontact(&ire, &whole, &minus, &five, elements), "cntc_setpotcontact");
  require(cntc_settrackdimensions(&ire, &all, &eleven, track), "cntc_settrackdimensions");
  set_profile(ire, 0, prhs[0]);
  set_profile(ire, 1, prhs[1]);
  require(cntc_setwheelsetdimensions(&ire, &all, &three, wheelset), "cntc_setwheelsetdimensions");
  require(cntc_setwheelsetposition(&ire, &position, &six, place), "cntc_setwheelsetposition");
  require(cntc_setwheelsetvelocity(&ire, &position, &six, velocity), "cntc_setwheelsetvelocity");
  require(cntc_calculate(&ire, &whole, &error), "cntc_calculate");
  plhs[0] = mxCreateDoubleMatrix(1, 24, mxREAL);
  require(cntc_getglobalforces(&ire, &whole, &count, mxGetPr(plhs[0])), "cntc_getglobalforces");
  cntc_finalizelast();
}
