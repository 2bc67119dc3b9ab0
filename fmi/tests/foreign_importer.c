/* An importer that knows the standard only: it includes no header of microslip, and has from modelDescription.xml what
 * it sets, gets and expects. It steps a unit of wheels by FMI 2.0 or 3.0 and compares every directional derivative with
 * a difference, and both with the dependencies that are described; a step with inputs out of range must be discarded
 * and leave no trace:
 *
 *   foreign_importer FOLDER
 *
 * FOLDER is that of the unpacked unit, whose heights are first found for forces, and then given. */
#include <dlfcn.h>
#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { name_length = 128, most_variables = 4096 };

static void fail(const char* format, ...) {
  va_list values;
  va_start(values, format);
  vfprintf(stderr, format, values);
  va_end(values);
  fputc('\n', stderr);
  exit(1);
}

/* --- modelDescription.xml --- */

/* Copies an attribute of the element that begins at `element`; empty if it has none of this name. */
static void attribute(const char* element, const char* name, char* value, size_t size) {
  const char* const end = strchr(element, '>');
  char key[32];
  snprintf(key, sizeof key, " %s=\"", name);
  value[0] = 0;
  const char* found = strstr(element, key);
  if (!found || found > end) return;
  found += strlen(key);
  snprintf(value, size, "%.*s", (int)strcspn(found, "\""), found);
}

typedef struct variable {
  char name[name_length], unit[16], causality[16];
  unsigned reference;
} variable;

typedef struct unit {
  int version;
  char identifier[name_length], key[name_length];
  variable inputs[most_variables], outputs[most_variables];
  int input_count, output_count;
  bool depends[64][512]; /* of outputs on inputs, as described */
  void* library;
  void* instance;
} unit;

static char* read_text(const char* path) {
  FILE* const file = fopen(path, "rb");
  if (!file) fail("%s: cannot be read", path);
  fseek(file, 0, SEEK_END);
  const long size = ftell(file);
  rewind(file);
  char* const text = malloc((size_t)size + 1);
  text[fread(text, 1, (size_t)size, file)] = 0;
  fclose(file);
  return text;
}

/* Real inputs and outputs; by 2.0 variables have an element for their type, by 3.0 they are one. */
static void read_variables(unit* u, const char* text) {
  const char* const element = u->version == 2 ? "<ScalarVariable" : "<Float64";
  for (const char* at = strstr(text, element); at; at = strstr(at + 1, element)) {
    variable v;
    char reference[16];
    const char* const type = u->version == 2 ? strstr(at + 1, "<") : at;
    if (u->version == 2 && strncmp(type, "<Real", 5) != 0) continue;
    attribute(at, "name", v.name, sizeof v.name);
    attribute(at, "causality", v.causality, sizeof v.causality);
    attribute(at, "valueReference", reference, sizeof reference);
    attribute(type, "unit", v.unit, sizeof v.unit);
    v.reference = (unsigned)atoi(reference);
    if (strcmp(v.causality, "input") == 0) u->inputs[u->input_count++] = v;
    if (strcmp(v.causality, "output") == 0) u->outputs[u->output_count++] = v;
  }
  if (u->output_count > 64 || u->input_count > 512 || u->output_count == 0) fail("%d outputs", u->output_count);
}

/* Dependencies of an output: by 2.0 indices of variables counted from 1, which this unit has one above references. */
static void read_dependencies(unit* u, const char* text) {
  const char* const element = u->version == 2 ? "<Unknown index=\"%u\"" : "<Output valueReference=\"%u\"";
  const unsigned shift = u->version == 2 ? 1 : 0;
  for (int i = 0; i < u->output_count; ++i) {
    char start[64];
    snprintf(start, sizeof start, element, u->outputs[i].reference + shift);
    const char* at = strstr(text, start);
    if (!at || !(at = strstr(at, "dependencies=\""))) fail("%s has no dependencies", u->outputs[i].name);
    at += strlen("dependencies=\"");
    for (char* end; *at != '"'; at = end) {
      const unsigned reference = (unsigned)strtoul(at, &end, 10) - shift;
      for (int k = 0; k < u->input_count; ++k) u->depends[i][k] |= u->inputs[k].reference == reference;
    }
  }
}

static void read_description(unit* u, const char* folder) {
  char path[1024], version[8];
  snprintf(path, sizeof path, "%s/modelDescription.xml", folder);
  char* const text = read_text(path);
  const char* const root = strstr(text, "<fmiModelDescription");
  attribute(root, "fmiVersion", version, sizeof version);
  u->version = atoi(version);
  attribute(root, u->version == 2 ? "guid" : "instantiationToken", u->key, sizeof u->key);
  attribute(strstr(text, "<CoSimulation"), "modelIdentifier", u->identifier, sizeof u->identifier);
  read_variables(u, text);
  read_dependencies(u, text);
  free(text);
}

/* --- the standard's functions, declared here --- */

typedef void (*function)(void);

static function find(const unit* u, const char* name) {
  void* const address = dlsym(u->library, name);
  function found;
  if (!address) fail("the binary has no %s", name);
  memcpy(&found, &address, sizeof found);
  return found;
}

static void log_by_2(void* environment, const char* instance, int status, const char* category, const char* message,
                     ...) {
  (void)environment, (void)instance, (void)status, (void)category, (void)message;
}
static void log_by_3(void* environment, int status, const char* category, const char* message) {
  (void)environment, (void)status, (void)category, (void)message;
}

static const struct {
  void (*logger)(void*, const char*, int, const char*, const char*, ...);
  void* (*allocate)(size_t, size_t);
  void (*release)(void*);
  void* finished;
  void* environment;
} callbacks = {log_by_2, calloc, free, NULL, NULL};

static void require(int status, const char* what) {
  if (status != 0) fail("%s: status %d", what, status);
}

static void instantiate(unit* u, const char* folder) {
  char path[1024];
  snprintf(path, sizeof path, "%s/binaries/%s/%s.so", folder, u->version == 2 ? "linux64" : "x86_64-linux",
           u->identifier);
  u->library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (!u->library) fail("%s", dlerror());
  snprintf(path, sizeof path, u->version == 2 ? "file://%s/resources" : "%s/resources/", folder);
  if (u->version == 2) {
    u->instance = ((void* (*)(const char*, int, const char*, const char*, const void*, int, int))find(
        u, "fmi2Instantiate"))("wheels", 1, u->key, path, &callbacks, 0, 0);
  } else {
    u->instance =
        ((void* (*)(const char*, const char*, const char*, bool, bool, bool, bool, const unsigned*, size_t, void*,
                    void (*)(void*, int, const char*, const char*), void*))find(u, "fmi3InstantiateCoSimulation"))(
            "wheels", u->key, path, false, false, false, false, NULL, 0, NULL, log_by_3, NULL);
  }
  if (!u->instance) fail("is not instantiated");
}

static void initialize(unit* u) {
  if (u->version == 2) {
    require(
        ((int (*)(void*, int, double, double, int, double))find(u, "fmi2SetupExperiment"))(u->instance, 0, 0, 0, 0, 0),
        "set-up");
    require(((int (*)(void*))find(u, "fmi2EnterInitializationMode"))(u->instance), "initialization");
    require(((int (*)(void*))find(u, "fmi2ExitInitializationMode"))(u->instance), "initialization");
  } else {
    require(((int (*)(void*, bool, double, double, bool, double))find(u, "fmi3EnterInitializationMode"))(
                u->instance, false, 0, 0, false, 0),
            "initialization");
    require(((int (*)(void*))find(u, "fmi3ExitInitializationMode"))(u->instance), "initialization");
  }
}

static void set(unit* u, unsigned reference, double value) {
  if (u->version == 2)
    require(((int (*)(void*, const unsigned*, size_t, const double*))find(u, "fmi2SetReal"))(u->instance, &reference, 1,
                                                                                             &value),
            "set");
  else
    require(((int (*)(void*, const unsigned*, size_t, const double*, size_t))find(u, "fmi3SetFloat64"))(
                u->instance, &reference, 1, &value, 1),
            "set");
}

static int step(unit* u) {
  static double time = 0;
  const double length = 1e-3;
  bool event, terminate, early;
  double last;
  if (u->version == 2)
    return ((int (*)(void*, double, double, int))find(u, "fmi2DoStep"))(u->instance, time, length, 1);
  return ((int (*)(void*, double, double, bool, bool*, bool*, bool*, double*))find(u, "fmi3DoStep"))(
      u->instance, time, length, true, &event, &terminate, &early, &last);
}

static void get_outputs(unit* u, double* values) {
  unsigned references[64];
  const size_t count = (size_t)u->output_count;
  for (size_t i = 0; i < count; ++i) references[i] = u->outputs[i].reference;
  if (u->version == 2)
    require(((int (*)(void*, const unsigned*, size_t, double*))find(u, "fmi2GetReal"))(u->instance, references, count,
                                                                                       values),
            "get");
  else
    require(((int (*)(void*, const unsigned*, size_t, double*, size_t))find(u, "fmi3GetFloat64"))(
                u->instance, references, count, values, count),
            "get");
}

/* The column of all outputs by the k-th input. */
static void derivatives_by(unit* u, int k, double* column) {
  unsigned references[64];
  const size_t count = (size_t)u->output_count;
  const double seed = 1;
  for (size_t i = 0; i < count; ++i) references[i] = u->outputs[i].reference;
  if (u->version == 2)
    require(((int (*)(void*, const unsigned*, size_t, const unsigned*, size_t, const double*, double*))find(
                u, "fmi2GetDirectionalDerivative"))(u->instance, references, count, &u->inputs[k].reference, 1, &seed,
                                                    column),
            "derivative");
  else
    require(((int (*)(void*, const unsigned*, size_t, const unsigned*, size_t, const double*, size_t, double*,
                      size_t))find(u, "fmi3GetDirectionalDerivative"))(
                u->instance, references, count, &u->inputs[k].reference, 1, &seed, 1, column, count),
            "derivative");
}

/* --- what is tried --- */

/* The change of an input that is small in a simulation, by its unit of measurement. */
static double scale_of(const char* measure) {
  static const struct {
    const char* unit;
    double scale;
  } scales[] = {{"m", 1e-3}, {"rad", 1e-3}, {"m/s", 0.1}, {"rad/s", 0.1}, {"1/m", 1e-3}, {"N", 1e3}};
  for (size_t k = 0; k < sizeof scales / sizeof *scales; ++k)
    if (strcmp(scales[k].unit, measure) == 0) return scales[k].scale;
  fail("the unit %s is unknown", measure);
  return 0;
}

static bool ends_with(const char* text, const char* end) {
  const size_t length = strlen(text), of_end = strlen(end);
  return length >= of_end && strcmp(text + length - of_end, end) == 0;
}

/* Values of inputs in a running vehicle, a little different for every wheel. */
static double running(const variable* v, int wheel) {
  if (ends_with(v->name, "state.lateral")) return 2e-3 + 1e-4 * wheel;
  if (ends_with(v->name, "state.yaw")) return 2e-3;
  if (ends_with(v->name, "state.forward_velocity")) return 20;
  if (ends_with(v->name, "state.pitch_velocity")) return 20 / 0.46 * 1.001;
  if (ends_with(v->name, "state.vertical_force")) return 60e3 + 1e3 * wheel;
  return 0;
}

static void compare_derivatives(unit* u, const double* base) {
  static double analytic[512][64], difference[512][64], largest[64];
  double plus[64], minus[64], worst = 0;
  memset(largest, 0, sizeof largest);
  for (int k = 0; k < u->input_count; ++k) {
    const double scale = scale_of(u->inputs[k].unit), length = 1e-4 * scale;
    derivatives_by(u, k, analytic[k]);
    set(u, u->inputs[k].reference, base[k] + length);
    require(step(u), "step");
    get_outputs(u, plus);
    set(u, u->inputs[k].reference, base[k] - length);
    require(step(u), "step");
    get_outputs(u, minus);
    set(u, u->inputs[k].reference, base[k]);
    require(step(u), "step");
    for (int i = 0; i < u->output_count; ++i) {
      difference[k][i] = (plus[i] - minus[i]) / (2 * length) * scale;
      analytic[k][i] *= scale;
      largest[i] = fmax(largest[i], fabs(analytic[k][i]));
    }
  }
  for (int k = 0; k < u->input_count; ++k)
    for (int i = 0; i < u->output_count; ++i) {
      if (!u->depends[i][k] && (analytic[k][i] != 0 || difference[k][i] != 0))
        fail("%s depends on %s, which is not described", u->outputs[i].name, u->inputs[k].name);
      const double error = fabs(analytic[k][i] - difference[k][i]);
      if (!(error <= 2e-4 * largest[i]))
        fail("%s by %s: %g, by differences %g", u->outputs[i].name, u->inputs[k].name, analytic[k][i],
             difference[k][i]);
      worst = fmax(worst, error / fmax(largest[i], 1e-300));
    }
  printf("%d outputs by %d inputs: largest error %.1e of the largest derivative\n", u->output_count, u->input_count,
         worst);
}

/* A state that no wheel has, after which the one before is solved as it was. */
static void step_back(unit* u, const double* base) {
  double before[64], after[64];
  get_outputs(u, before);
  set(u, u->inputs[0].reference, 1e9);
  if (step(u) != 2) fail("a step with %s = 1e9 is not discarded", u->inputs[0].name);
  set(u, u->inputs[0].reference, NAN);
  if (step(u) != 2) fail("a step with %s = NaN is not discarded", u->inputs[0].name);
  set(u, u->inputs[0].reference, base[0]);
  require(step(u), "step");
  get_outputs(u, after);
  if (memcmp(before, after, sizeof(double) * (size_t)u->output_count) != 0) fail("a discarded step left a trace");
}

int main(int count, char** arguments) {
  static unit u;
  static double base[512];
  double outputs[64];
  if (count != 2) fail("usage: foreign_importer FOLDER");
  read_description(&u, arguments[1]);
  instantiate(&u, arguments[1]);
  initialize(&u);
  const int wheels = u.output_count / 7, of_wheel = u.input_count / wheels;
  for (int k = 0; k < u.input_count; ++k) {
    base[k] = running(&u.inputs[k], k / of_wheel);
    set(&u, u.inputs[k].reference, base[k]);
  }
  require(step(&u), "step");
  compare_derivatives(&u, base);
  step_back(&u, base);
  /* The same heights given: the force is what it was. */
  get_outputs(&u, outputs);
  for (int k = 0; k < u.input_count; ++k) {
    if (ends_with(u.inputs[k].name, "state.vertical")) base[k] = outputs[7 * (k / of_wheel) + 6];
    if (ends_with(u.inputs[k].name, "state.vertical_force")) base[k] = 0;
    set(&u, u.inputs[k].reference, base[k]);
  }
  require(step(&u), "step");
  double given[64];
  get_outputs(&u, given);
  for (int i = 0; i < u.output_count; ++i)
    if (!(fabs(given[i] - outputs[i]) <= 1e-4 * fmax(1, fabs(outputs[7 * (i / 7) + 2]))))
      fail("%s = %g with the height given, %g with the force", u.outputs[i].name, given[i], outputs[i]);
  /* A force of 0 means that the height counts: no differences across it. */
  unit* const without = &u;
  int kept = 0;
  for (int k = 0; k < u.input_count; ++k)
    if (!ends_with(u.inputs[k].name, "state.vertical_force")) {
      without->inputs[kept] = u.inputs[k];
      base[kept] = base[k];
      for (int i = 0; i < u.output_count; ++i) without->depends[i][kept] = u.depends[i][k];
      ++kept;
    }
  without->input_count = kept;
  compare_derivatives(without, base);
  return 0;
}
