/*
 * microslip for MATLAB and Octave, one function over the C interface:
 *
 *   text    = microslip('version')
 *   hertz   = microslip('hertz', bodies, normal_force)
 *   forces  = microslip('fastsim2', contact)          the simplified theory, 10 x 10 cells
 *   forces  = microslip('fastsim2', contact, mx, my)
 *   text    = microslip('solve_case', case)           a case file's text; the result as JSON, for jsondecode
 *
 *   problem = microslip('create', kind)               'bodies', 'wheel' or 'wheelset'
 *   problem = microslip('read', case)                 with the inputs of a case file's text
 *             microslip('set', problem, path, value, ...)
 *   value   = microslip('get', problem, path)
 *             microslip('unset', problem, path)
 *   status  = microslip('solve', problem)
 *   value   = microslip('number', problem, name)
 *   values  = microslip('field', problem, name)       x changes along columns, y along rows
 *   slopes  = microslip('differentiate', problem)     rows fx, fy, mz, columns xi, eta, phi
 *             microslip('destroy', problem)
 *
 * bodies, contact, hertz and forces are structs with the fields of microslip_bodies, microslip_contact, microslip_hertz
 * and microslip_forces in microslip.h, in SI units. A field of contact is one number or an array; arrays have the same
 * size, and then the fields of forces have it too. Fields that contact does not have are 0, rolling_speed is 1. Paths,
 * names and status are those of microslip_set, microslip_number and microslip_code there; a value is a number, a text
 * or an array.
 */
#include <mex.h>
#include <microslip.h>

#include <stddef.h>
#include <string.h>

/* Position of a number in a struct of C. */
typedef struct field {
  const char* name;
  size_t offset;
} field;

#define COUNT(array) (sizeof(array) / sizeof *(array))

static const field contact_fields[] = {{"a", offsetof(microslip_contact, a)},
                                       {"b", offsetof(microslip_contact, b)},
                                       {"shear_modulus", offsetof(microslip_contact, shear_modulus)},
                                       {"poisson_ratio", offsetof(microslip_contact, poisson_ratio)},
                                       {"normal_force", offsetof(microslip_contact, normal_force)},
                                       {"rolling_speed", offsetof(microslip_contact, rolling_speed)},
                                       {"creepage_longitudinal", offsetof(microslip_contact, creepage_longitudinal)},
                                       {"creepage_lateral", offsetof(microslip_contact, creepage_lateral)},
                                       {"spin", offsetof(microslip_contact, spin)},
                                       {"friction", offsetof(microslip_contact, friction)}};
static const field force_fields[] = {{"fx", offsetof(microslip_forces, fx)},
                                     {"fy", offsetof(microslip_forces, fy)},
                                     {"mz", offsetof(microslip_forces, mz)},
                                     {"adhesion_area", offsetof(microslip_forces, adhesion_area)},
                                     {"slip_area", offsetof(microslip_forces, slip_area)}};
static const field hertz_fields[] = {{"a", offsetof(microslip_hertz, a)},
                                     {"b", offsetof(microslip_hertz, b)},
                                     {"approach", offsetof(microslip_hertz, approach)},
                                     {"peak_pressure", offsetof(microslip_hertz, peak_pressure)},
                                     {"stiffness", offsetof(microslip_hertz, stiffness)},
                                     {"shear_modulus", offsetof(microslip_hertz, shear_modulus)},
                                     {"poisson_ratio", offsetof(microslip_hertz, poisson_ratio)},
                                     {"dissimilarity", offsetof(microslip_hertz, dissimilarity)}};
static const field body_fields[] = {{"rolling_radius", offsetof(microslip_bodies, rolling_radius)},
                                    {"transverse_radius", offsetof(microslip_bodies, transverse_radius)},
                                    {"young_modulus", offsetof(microslip_bodies, young_modulus)},
                                    {"poisson_ratio", offsetof(microslip_bodies, poisson_ratio)}};

static double* number_at(void* of, const field* f) {
  return (double*)((char*)of + f->offset);
}

/* Ends the call with the library's message. Memory of mxMalloc is released by the host. */
static void fail(const char* what) {
  mexErrMsgIdAndTxt("microslip:refused", "%s", what);
}

static void check(microslip_code code, const microslip_error* error) {
  if (code >= MICROSLIP_NULL_POINTER || code == MICROSLIP_INVALID_INPUT) fail(error->text);
}

static double* numbers(const mxArray* values, const char* name) {
  if (!mxIsDouble(values) || mxIsComplex(values) || mxIsSparse(values))
    mexErrMsgIdAndTxt("microslip:type", "%s must be real numbers", name);
  return (double*)mxGetData(values);
}

static void require_struct(int count, const mxArray* arguments[], int at, const char* what) {
  if (count <= at || !mxIsStruct(arguments[at]) || mxGetNumberOfElements(arguments[at]) != 1) fail(what);
}

static double one_number(const mxArray* value, const char* name) {
  if (mxGetNumberOfElements(value) != 1) mexErrMsgIdAndTxt("microslip:size", "%s must be one number", name);
  return *numbers(value, name);
}

/* An argument that is a number of cells, or what stands for it. */
static int cells(int count, const mxArray* arguments[], int at, int otherwise) {
  double given;
  if (count <= at) return otherwise;
  given = one_number(arguments[at], "a number of cells");
  if (!(given >= -1e6 && given <= 1e6) || given != (int)given) fail("mx and my must be whole numbers");
  return (int)given;
}

static mxArray* hertz(int count, const mxArray* arguments[]) {
  microslip_bodies bodies;
  microslip_hertz found;
  microslip_error error;
  const char* names[COUNT(hertz_fields)];
  mxArray* result;
  size_t k;
  require_struct(count, arguments, 1, "microslip('hertz', bodies, normal_force): bodies must be a struct");
  if (count != 3) fail("microslip('hertz', bodies, normal_force) takes three arguments");
  for (k = 0; k < COUNT(body_fields); ++k) {
    const mxArray* values = mxGetField(arguments[1], 0, body_fields[k].name);
    if (!values || mxGetNumberOfElements(values) != 2)
      mexErrMsgIdAndTxt("microslip:size", "bodies.%s must be two numbers", body_fields[k].name);
    memcpy(number_at(&bodies, &body_fields[k]), numbers(values, body_fields[k].name), 2 * sizeof(double));
  }
  check(microslip_hertz_from_load(&bodies, one_number(arguments[2], "normal_force"), &found, &error), &error);
  for (k = 0; k < COUNT(hertz_fields); ++k) names[k] = hertz_fields[k].name;
  result = mxCreateStructMatrix(1, 1, (int)COUNT(hertz_fields), names);
  for (k = 0; k < COUNT(hertz_fields); ++k)
    mxSetField(result, 0, names[k], mxCreateDoubleScalar(*number_at(&found, &hertz_fields[k])));
  return result;
}

/* A field of the host's struct spread over the contacts. */
static void spread(const mxArray* values, const field* f, size_t count, microslip_contact* contacts) {
  const double* given = numbers(values, f->name);
  const size_t step = mxGetNumberOfElements(values) == 1 ? 0 : 1;
  size_t k;
  for (k = 0; k < count; ++k) *number_at(&contacts[k], f) = given[k * step];
}

/* The contacts of the host's struct; `shape` becomes the array that gives them their number and size. */
static microslip_contact* contacts_of(const mxArray* given, const mxArray** shape) {
  microslip_contact* contacts;
  size_t k, j, count;
  int n;
  *shape = NULL;
  for (n = 0; n < mxGetNumberOfFields(given); ++n) {
    const char* name = mxGetFieldNameByNumber(given, n);
    const mxArray* values = mxGetFieldByNumber(given, 0, n);
    for (j = 0; j < COUNT(contact_fields) && strcmp(contact_fields[j].name, name) != 0; ++j) {
    }
    if (j == COUNT(contact_fields)) mexErrMsgIdAndTxt("microslip:field", "contact.%s: unknown", name);
    if (!*shape || mxGetNumberOfElements(*shape) == 1) *shape = values;
    if (mxGetNumberOfElements(values) != 1 && mxGetNumberOfElements(values) != mxGetNumberOfElements(*shape))
      mexErrMsgIdAndTxt("microslip:size", "contact.%s has another size than the arrays before it", name);
  }
  if (!*shape) fail("contact has no fields");
  count = mxGetNumberOfElements(*shape);
  contacts = mxCalloc(count ? count : 1, sizeof *contacts);
  for (k = 0; k < count; ++k) contacts[k].rolling_speed = 1;
  for (j = 0; j < COUNT(contact_fields); ++j) {
    const mxArray* values = mxGetField(given, 0, contact_fields[j].name);
    if (values) spread(values, &contact_fields[j], count, contacts);
  }
  return contacts;
}

/* Raises the error of the first contact that is out of range. */
static void check_contacts(size_t count, const microslip_contact* contacts) {
  microslip_error error;
  size_t k;
  for (k = 0; k < count; ++k)
    if (microslip_contact_check(&contacts[k], &error) != MICROSLIP_OK)
      mexErrMsgIdAndTxt("microslip:refused", "contact %u: %s", (unsigned)(k + 1), error.text);
}

static void solve_simplified(int mx, int my, size_t count, const microslip_contact* contacts,
                             microslip_forces* forces) {
  microslip_fastsim2_options options;
  microslip_fastsim2* solver;
  microslip_error error;
  microslip_fastsim2_options_init(&options, sizeof options);
  options.mx = mx;
  options.my = my;
  check(microslip_fastsim2_create(&options, &solver, &error), &error);
  microslip_fastsim2_solve(solver, count, contacts, forces);
  microslip_fastsim2_destroy(solver);
}

/* An array of the shape of another. */
static mxArray* array_like(const mxArray* shape) {
  return mxCreateNumericArray(mxGetNumberOfDimensions(shape), mxGetDimensions(shape), mxDOUBLE_CLASS, mxREAL);
}

static mxArray* solve_contacts(int count, const mxArray* arguments[]) {
  const char* names[COUNT(force_fields) + 1];
  const mxArray* shape;
  microslip_contact* contacts;
  microslip_forces* forces;
  mxArray *result, *status;
  size_t k, j, contact_count;
  require_struct(count, arguments, 1, "the second argument must be a struct of contacts");
  if (count != 2 && count != 4) fail("takes a contact and, if any, the numbers of cells mx and my");
  contacts = contacts_of(arguments[1], &shape);
  contact_count = mxGetNumberOfElements(shape);
  check_contacts(contact_count, contacts);
  forces = mxCalloc(contact_count ? contact_count : 1, sizeof *forces);
  solve_simplified(cells(count, arguments, 2, 10), cells(count, arguments, 3, 10), contact_count, contacts, forces);
  for (j = 0; j < COUNT(force_fields); ++j) names[j] = force_fields[j].name;
  names[COUNT(force_fields)] = "status";
  result = mxCreateStructMatrix(1, 1, (int)COUNT(names), names);
  for (j = 0; j < COUNT(force_fields); ++j) {
    mxArray* values = array_like(shape);
    for (k = 0; k < contact_count; ++k) ((double*)mxGetData(values))[k] = *number_at(&forces[k], &force_fields[j]);
    mxSetField(result, 0, names[j], values);
  }
  status = array_like(shape);
  for (k = 0; k < contact_count; ++k) ((double*)mxGetData(status))[k] = forces[k].status;
  mxSetField(result, 0, "status", status);
  return result;
}

static mxArray* solve_case(int count, const mxArray* arguments[]) {
  microslip_error error;
  mxArray* result;
  microslip_code code;
  char *text, *json = NULL;
  if (count != 2 || !mxIsChar(arguments[1]))
    fail("microslip('solve_case', case): case must be the text of a case file");
  text = mxArrayToString(arguments[1]);
  code = microslip_solve_case(text, "case", &json, &error);
  result = mxCreateString(json ? json : "");
  microslip_free_text(json);
  check(code, &error);
  return result;
}

/* The problems there are, by their numbers less 1; a number is what the host keeps. */
static microslip_problem* problems[256];

static void destroy_all(void) {
  size_t k;
  for (k = 0; k < COUNT(problems); ++k) {
    microslip_problem_destroy(problems[k]);
    problems[k] = NULL;
  }
}

/* The slot of an argument's problem. */
static size_t slot_of(int count, const mxArray* arguments[]) {
  double number;
  if (count < 2 || mxGetNumberOfElements(arguments[1]) != 1) fail("the second argument must be a problem");
  number = *numbers(arguments[1], "a problem");
  if (!(number >= 1 && number <= (double)COUNT(problems)) || !problems[(size_t)number - 1])
    fail("the second argument is no problem, or one that was destroyed");
  return (size_t)number - 1;
}

static char* text_of(int count, const mxArray* arguments[], int at, const char* what) {
  if (count <= at || !mxIsChar(arguments[at])) fail(what);
  return mxArrayToString(arguments[at]);
}

static mxArray* keep(microslip_problem* problem) {
  size_t k = 0;
  while (k < COUNT(problems) && problems[k]) ++k;
  if (k == COUNT(problems)) {
    microslip_problem_destroy(problem);
    fail("there are 256 problems already: destroy some");
  }
  problems[k] = problem;
  mexAtExit(destroy_all);
  return mxCreateDoubleScalar((double)k + 1);
}

static mxArray* create(int count, const mxArray* arguments[]) {
  static const char* const kinds[] = {"bodies", "wheel", "wheelset"};
  const char* kind = text_of(count, arguments, 1, "microslip('create', kind): kind must be a text");
  microslip_problem* problem;
  microslip_error error;
  int k = 0;
  while (k < (int)COUNT(kinds) && strcmp(kinds[k], kind) != 0) ++k;
  if (k == (int)COUNT(kinds)) fail("a problem is of kind 'bodies', 'wheel' or 'wheelset'");
  check(microslip_problem_create(k, &problem, &error), &error);
  return keep(problem);
}

static mxArray* read_case(int count, const mxArray* arguments[]) {
  microslip_problem* problem;
  microslip_error error;
  const char* text = text_of(count, arguments, 1, "microslip('read', case): case must be the text of a case file");
  check(microslip_problem_read(text, "case", &problem, &error), &error);
  return keep(problem);
}

static void set_one(microslip_problem* problem, const char* path, const mxArray* value) {
  microslip_error error;
  if (mxIsChar(value))
    check(microslip_set_text(problem, path, mxArrayToString(value), &error), &error);
  else if (mxGetNumberOfElements(value) == 1)
    check(microslip_set(problem, path, *numbers(value, path), &error), &error);
  else
    check(microslip_set_array(problem, path, mxGetNumberOfElements(value), numbers(value, path), &error), &error);
}

static void set(int count, const mxArray* arguments[]) {
  microslip_problem* problem = problems[slot_of(count, arguments)];
  int at;
  if (count < 4 || count % 2 != 0) fail("microslip('set', problem, path, value, ...): each path needs a value");
  for (at = 2; at < count; at += 2)
    set_one(problem, text_of(count, arguments, at, "a path must be a text"), arguments[at + 1]);
}

static void unset(int count, const mxArray* arguments[]) {
  microslip_problem* problem = problems[slot_of(count, arguments)];
  microslip_error error;
  check(microslip_unset(problem, text_of(count, arguments, 2, "a path must be a text"), &error), &error);
}

/* A number, a text or an array, whatever stands under the path. */
static mxArray* get(int count, const mxArray* arguments[]) {
  microslip_problem* problem = problems[slot_of(count, arguments)];
  const char* path = text_of(count, arguments, 2, "a path must be a text");
  microslip_error error, other;
  double value;
  size_t length;
  char* text = NULL;
  mxArray* result;
  const microslip_code code = microslip_get(problem, path, &value, &error);
  if (code == MICROSLIP_OK) return mxCreateDoubleScalar(value);
  if (microslip_get_text(problem, path, &text, &other) == MICROSLIP_OK) {
    result = mxCreateString(text);
    microslip_free_text(text);
    return result;
  }
  if (microslip_get_array(problem, path, 0, NULL, &length, &other) != MICROSLIP_OK) check(code, &error);
  result = mxCreateDoubleMatrix(1, length, mxREAL);
  check(microslip_get_array(problem, path, length, (double*)mxGetData(result), &length, &error), &error);
  return result;
}

static mxArray* solve(int count, const mxArray* arguments[]) {
  microslip_error error;
  const microslip_code code = microslip_solve(problems[slot_of(count, arguments)], &error);
  check(code, &error);
  return mxCreateDoubleScalar(code);
}

static mxArray* number(int count, const mxArray* arguments[]) {
  microslip_problem* problem = problems[slot_of(count, arguments)];
  microslip_error error;
  double value = 0;
  check(microslip_number(problem, text_of(count, arguments, 2, "a name must be a text"), &value, &error), &error);
  return mxCreateDoubleScalar(value);
}

static mxArray* field_of(int count, const mxArray* arguments[]) {
  microslip_problem* problem = problems[slot_of(count, arguments)];
  const char* name = text_of(count, arguments, 2, "a name must be a text");
  microslip_error error;
  size_t columns = 0, rows = 0;
  mxArray* values;
  check(microslip_field_size(problem, name, &columns, &rows, &error), &error);
  values = mxCreateDoubleMatrix(columns, rows, mxREAL);
  check(microslip_field(problem, name, columns * rows, (double*)mxGetData(values), &error), &error);
  return values;
}

static mxArray* differentiate(int count, const mxArray* arguments[]) {
  microslip_error error;
  double rows[9];
  mxArray* result = mxCreateDoubleMatrix(3, 3, mxREAL);
  int k;
  check(microslip_differentiate(problems[slot_of(count, arguments)], 9, rows, &error), &error);
  for (k = 0; k < 9; ++k) ((double*)mxGetData(result))[k % 3 * 3 + k / 3] = rows[k];
  return result;
}

static mxArray* version(int count, const mxArray* arguments[]) {
  (void)count, (void)arguments;
  return mxCreateString(microslip_version());
}

static void destroy(int count, const mxArray* arguments[]) {
  const size_t slot = slot_of(count, arguments);
  microslip_problem_destroy(problems[slot]);
  problems[slot] = NULL;
}

typedef struct command {
  const char* name;
  mxArray* (*value)(int count, const mxArray* arguments[]); /* or, without a result: */
  void (*action)(int count, const mxArray* arguments[]);
} command;

static const command commands[] = {{"version", version, NULL},
                                   {"hertz", hertz, NULL},
                                   {"fastsim2", solve_contacts, NULL},
                                   {"solve_case", solve_case, NULL},
                                   {"create", create, NULL},
                                   {"read", read_case, NULL},
                                   {"set", NULL, set},
                                   {"get", get, NULL},
                                   {"unset", NULL, unset},
                                   {"solve", solve, NULL},
                                   {"number", number, NULL},
                                   {"field", field_of, NULL},
                                   {"differentiate", differentiate, NULL},
                                   {"destroy", NULL, destroy}};

void mexFunction(int result_count, mxArray* results[], int count, const mxArray* arguments[]) {
  const char* name = count > 0 && mxIsChar(arguments[0]) ? mxArrayToString(arguments[0]) : "";
  size_t k = 0;
  (void)result_count;
  if (microslip_abi() != MICROSLIP_ABI)
    fail("the library has another binary interface than this file was compiled for");
  while (k < COUNT(commands) && strcmp(commands[k].name, name) != 0) ++k;
  if (k == COUNT(commands))
    fail("the first argument must be 'version', 'hertz', 'fastsim2', 'solve_case', 'create', 'read', 'set', 'get', "
         "'unset', 'solve', 'number', 'field', 'differentiate' or 'destroy'");
  if (commands[k].value)
    results[0] = commands[k].value(count, arguments);
  else
    commands[k].action(count, arguments);
}
