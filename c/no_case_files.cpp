#include "c/guarded_call.hpp"

using namespace microslip::c;

namespace {

constexpr const char* without_case_files = "this library was built without case files";

} // namespace

// Functions of the interface that the library does not have then, with a text why or without.
#define REFUSED(function, ...)                                                                                         \
  microslip_code function(__VA_ARGS__, microslip_error* error) {                                                       \
    return report(error, MICROSLIP_NO_RESULT, without_case_files);                                                     \
  }
#define WITHOUT_RESULT(function, ...)                                                                                  \
  microslip_code function(__VA_ARGS__) {                                                                               \
    return MICROSLIP_NO_RESULT;                                                                                        \
  }

microslip_code microslip_solve_case(const char* /*text*/, const char* /*name*/, char** json, microslip_error* error) {
  if (json) *json = nullptr;
  return report(error, MICROSLIP_NO_RESULT, without_case_files);
}

microslip_code microslip_problem_create(int /*kind*/, microslip_problem** problem, microslip_error* error) {
  if (problem) *problem = nullptr;
  return report(error, MICROSLIP_NO_RESULT, without_case_files);
}
microslip_code microslip_problem_read(const char* /*text*/, const char* /*name*/, microslip_problem** problem,
                                      microslip_error* error) {
  if (problem) *problem = nullptr;
  return report(error, MICROSLIP_NO_RESULT, without_case_files);
}
void microslip_problem_destroy(microslip_problem* /*problem*/) {}
REFUSED(microslip_problem_text, const microslip_problem*, char**)
REFUSED(microslip_set, microslip_problem*, const char*, double)
REFUSED(microslip_set_text, microslip_problem*, const char*, const char*)
REFUSED(microslip_set_array, microslip_problem*, const char*, size_t, const double*)
REFUSED(microslip_unset, microslip_problem*, const char*)
REFUSED(microslip_get, const microslip_problem*, const char*, double*)
REFUSED(microslip_get_text, const microslip_problem*, const char*, char**)
REFUSED(microslip_get_array, const microslip_problem*, const char*, size_t, double*, size_t*)
REFUSED(microslip_set_progress, microslip_problem*, int (*)(double fraction, void* data), void*)
REFUSED(microslip_solve, microslip_problem*)
REFUSED(microslip_differentiate, microslip_problem*, size_t, double*)
REFUSED(microslip_number, const microslip_problem*, const char*, double*)
REFUSED(microslip_field_size, const microslip_problem*, const char*, size_t*, size_t*)
REFUSED(microslip_field, microslip_problem*, const char*, size_t, double*)

microslip_code microslip_creep_table_read(const char* /*file*/, int /*direction*/, microslip_creep_table** table,
                                          microslip_error* error) {
  if (table) *table = nullptr;
  return report(error, MICROSLIP_NO_RESULT, "this library was built without reading files");
}
void microslip_creep_table_destroy(microslip_creep_table* /*table*/) {}
WITHOUT_RESULT(microslip_creep_table_solve, const microslip_creep_table*, size_t, const microslip_contact*,
               microslip_forces*)
WITHOUT_RESULT(microslip_creep_table_differentiate, const microslip_creep_table*, size_t, const microslip_contact*,
               microslip_derivatives*)

microslip_code microslip_wheel_rail_create(const microslip_problem* /*problem*/, microslip_wheel_rail** wheel_rail,
                                           microslip_error* error) {
  if (wheel_rail) *wheel_rail = nullptr;
  return report(error, MICROSLIP_NO_RESULT, without_case_files);
}
void microslip_wheel_rail_destroy(microslip_wheel_rail* /*wheel_rail*/) {}
WITHOUT_RESULT(microslip_wheel_rail_state, const microslip_wheel_rail*, size_t, double*)
WITHOUT_RESULT(microslip_wheel_rail_continue, microslip_wheel_rail*, size_t, size_t, const double*, size_t, double*,
               int*)
WITHOUT_RESULT(microslip_wheel_rail_solve, microslip_wheel_rail*, size_t, size_t, const double*, size_t, double*, int*)
WITHOUT_RESULT(microslip_wheel_rail_differentiate, microslip_wheel_rail*, size_t, size_t, const double*, size_t,
               double*, int*, size_t, size_t, double*)
REFUSED(microslip_wheel_rail_patches, const microslip_wheel_rail*, size_t, size_t, double*, size_t*)
REFUSED(microslip_wheelset_contacts, microslip_wheel_rail*, int, double, size_t, const double*, size_t, double*, int*)
REFUSED(microslip_equivalent_conicity, microslip_wheel_rail*, int, double, size_t, const double*, double*)
