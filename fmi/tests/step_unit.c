/* Loads a unit's binary, gives it inputs, makes a step and prints outputs, on Linux and on Windows:
 * step_unit BINARY GUID RESOURCES REFERENCE=VALUE... REFERENCE... */
#include "fmi/fmi2.h"

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

static void print(fmi2ComponentEnvironment environment, fmi2String instance, fmi2Status status, fmi2String category,
                  fmi2String message, ...) {
  va_list values;
  (void)environment;
  fprintf(stderr, "%s: %d, %s: ", instance, status, category);
  va_start(values, message);
  vfprintf(stderr, message, values);
  va_end(values);
  fputc('\n', stderr);
}

static void require(int status, const char* call) {
  if (status == fmi2OK) return;
  fprintf(stderr, "%s: status %d\n", call, status);
  exit(1);
}

#define CALL(name, ...) require(((__typeof__(&name))find(binary, #name))(__VA_ARGS__), #name)

int main(int count, char** arguments) {
  const fmi2CallbackFunctions functions = {print, calloc, free, NULL, NULL};
  const char* const binary = count > 3 ? arguments[1] : "";
  fmi2Component unit = ((__typeof__(&fmi2Instantiate))find(binary, "fmi2Instantiate"))(
      "unit", fmi2CoSimulation, arguments[2], arguments[3], &functions, fmi2False, fmi2True);
  if (!unit) return 1;
  CALL(fmi2SetupExperiment, unit, fmi2False, 0, 0, fmi2False, 0);
  for (int i = 4; i < count; ++i) {
    const char* const value = strchr(arguments[i], '=');
    const fmi2ValueReference reference = (fmi2ValueReference)atoi(arguments[i]);
    const fmi2Real number = value ? atof(value + 1) : 0;
    if (value) CALL(fmi2SetReal, unit, &reference, 1, &number);
  }
  CALL(fmi2EnterInitializationMode, unit);
  CALL(fmi2ExitInitializationMode, unit);
  CALL(fmi2DoStep, unit, 0, 1e-3, fmi2True);
  for (int i = 4; i < count; ++i) {
    const fmi2ValueReference reference = (fmi2ValueReference)atoi(arguments[i]);
    fmi2Real number = 0;
    if (strchr(arguments[i], '=')) continue;
    CALL(fmi2GetReal, unit, &reference, 1, &number);
    printf("%.10g\n", number);
  }
  ((__typeof__(&fmi2FreeInstance))find(binary, "fmi2FreeInstance"))(unit);
  return 0;
}
