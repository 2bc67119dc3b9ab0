/* Loads a unit's binary, gives it inputs, makes a step and prints outputs, on Linux and on Windows, by FMI 2.0 or 3.0:
 * step_unit 2|3 BINARY TOKEN RESOURCES REFERENCE=VALUE... REFERENCE... */
#include "fmi/fmi2.h"
#include "fmi/fmi3.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef _WIN32
#include <windows.h>
#else
#include <dlfcn.h>
#endif

typedef void (*function)(void);

static function find(const char* binary, const char* name) {
  function found;
#ifdef _WIN32
  const HMODULE library = LoadLibraryA(binary);
  found = library ? (function)GetProcAddress(library, name) : NULL;
#else
  void* const library = dlopen(binary, RTLD_NOW);
  void* const address = library ? dlsym(library, name) : NULL;
  memcpy(&found, &address, sizeof found);
#endif
  if (found) return found;
  fprintf(stderr, "%s: has no %s\n", binary, name);
  exit(1);
}

static void print2(fmi2ComponentEnvironment environment, fmi2String instance, fmi2Status status, fmi2String category,
                   fmi2String message, ...) {
  va_list values;
  (void)environment;
  fprintf(stderr, "%s: %d, %s: ", instance, status, category);
  va_start(values, message);
  vfprintf(stderr, message, values);
  va_end(values);
  fputc('\n', stderr);
}

static void print3(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category, fmi3String message) {
  (void)environment;
  fprintf(stderr, "%d, %s: %s\n", status, category, message);
}

static void require(int status, const char* call) {
  if (status == 0) return; /* fmi2OK, fmi3OK */
  fprintf(stderr, "%s: status %d\n", call, status);
  exit(1);
}

#define FUNCTION(name) ((__typeof__(&name))find(binary, #name))
#define CALL(name, ...) require(FUNCTION(name)(__VA_ARGS__), #name)

static void step2(const char* binary, const char* token, const char* resources, int count, char** variables) {
  const fmi2CallbackFunctions functions = {print2, calloc, free, NULL, NULL};
  const fmi2Component unit =
      FUNCTION(fmi2Instantiate)("unit", fmi2CoSimulation, token, resources, &functions, fmi2False, fmi2True);
  require(!unit, "fmi2Instantiate");
  CALL(fmi2SetupExperiment, unit, fmi2False, 0, 0, fmi2False, 0);
  for (int i = 0; i < count; ++i) {
    const char* const value = strchr(variables[i], '=');
    const fmi2ValueReference reference = (fmi2ValueReference)atoi(variables[i]);
    const fmi2Real number = value ? atof(value + 1) : 0;
    if (value) CALL(fmi2SetReal, unit, &reference, 1, &number);
  }
  CALL(fmi2EnterInitializationMode, unit);
  CALL(fmi2ExitInitializationMode, unit);
  CALL(fmi2DoStep, unit, 0, 1e-3, fmi2True);
  for (int i = 0; i < count; ++i) {
    const fmi2ValueReference reference = (fmi2ValueReference)atoi(variables[i]);
    fmi2Real number = 0;
    if (strchr(variables[i], '=')) continue;
    CALL(fmi2GetReal, unit, &reference, 1, &number);
    printf("%.10g\n", number);
  }
  FUNCTION(fmi2FreeInstance)(unit);
}

static void step3(const char* binary, const char* token, const char* resources, int count, char** variables) {
  bool event = false, terminate = false, early = false;
  double time = 0;
  const fmi3Instance unit = FUNCTION(fmi3InstantiateCoSimulation)("unit", token, resources, false, true, false, false,
                                                                  NULL, 0, NULL, print3, NULL);
  require(!unit, "fmi3InstantiateCoSimulation");
  for (int i = 0; i < count; ++i) {
    const char* const value = strchr(variables[i], '=');
    const fmi3ValueReference reference = (fmi3ValueReference)atoi(variables[i]);
    const double number = value ? atof(value + 1) : 0;
    if (value) CALL(fmi3SetFloat64, unit, &reference, 1, &number, 1);
  }
  CALL(fmi3EnterInitializationMode, unit, false, 0, 0, false, 0);
  CALL(fmi3ExitInitializationMode, unit);
  CALL(fmi3DoStep, unit, 0, 1e-3, true, &event, &terminate, &early, &time);
  for (int i = 0; i < count; ++i) {
    const fmi3ValueReference reference = (fmi3ValueReference)atoi(variables[i]);
    double number = 0;
    if (strchr(variables[i], '=')) continue;
    CALL(fmi3GetFloat64, unit, &reference, 1, &number, 1);
    printf("%.10g\n", number);
  }
  FUNCTION(fmi3FreeInstance)(unit);
}

int main(int count, char** arguments) {
  if (count < 6) return 2;
  if (strcmp(arguments[1], "3") == 0)
    step3(arguments[2], arguments[3], arguments[4], count - 5, arguments + 5);
  else
    step2(arguments[2], arguments[3], arguments[4], count - 5, arguments + 5);
  return 0;
}
