#include "c/guarded_call.hpp"

using namespace microslip::c;

namespace {

constexpr const char* without_case_files = "this library was built without case files";

} // namespace

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
microslip_code microslip_problem_text(const microslip_problem* /*problem*/, char** /*text*/, microslip_error* error) {
  return report(error, MICROSLIP_NO_RESULT, without_case_files);
}
microslip_code microslip_set(microslip_problem* /*problem*/, const char* /*path*/, double /*value*/,
                             microslip_error* error) {
  return report(error, MICROSLIP_NO_RESULT, without_case_files);
}
microslip_code microslip_set_text(microslip_problem* /*problem*/, const char* /*path*/, const char* /*value*/,
                                  microslip_error* error) {
  return report(error, MICROSLIP_NO_RESULT, without_case_files);
}
microslip_code microslip_set_array(microslip_problem* /*problem*/, const char* /*path*/, size_t /*count*/,
                                   const double* /*values*/, microslip_error* error) {
  return report(error, MICROSLIP_NO_RESULT, without_case_files);
}
microslip_code microslip_unset(microslip_problem* /*problem*/, const char* /*path*/, microslip_error* error) {
  return report(error, MICROSLIP_NO_RESULT, without_case_files);
}
microslip_code microslip_get(const microslip_problem* /*problem*/, const char* /*path*/, double* /*value*/,
                             microslip_error* error) {
  return report(error, MICROSLIP_NO_RESULT, without_case_files);
}
microslip_code microslip_get_text(const microslip_problem* /*problem*/, const char* /*path*/, char** /*value*/,
                                  microslip_error* error) {
  return report(error, MICROSLIP_NO_RESULT, without_case_files);
}
microslip_code microslip_get_array(const microslip_problem* /*problem*/, const char* /*path*/, size_t /*capacity*/,
                                   double* /*values*/, size_t* /*count*/, microslip_error* error) {
  return report(error, MICROSLIP_NO_RESULT, without_case_files);
}
microslip_code microslip_set_progress(microslip_problem* /*problem*/, int (* /*progress*/)(double fraction, void* data),
                                      void* /*data*/, microslip_error* error) {
  return report(error, MICROSLIP_NO_RESULT, without_case_files);
}
microslip_code microslip_solve(microslip_problem* /*problem*/, microslip_error* error) {
  return report(error, MICROSLIP_NO_RESULT, without_case_files);
}
microslip_code microslip_differentiate(microslip_problem* /*problem*/, size_t /*count*/, double* /*jacobian*/,
                                       microslip_error* error) {
  return report(error, MICROSLIP_NO_RESULT, without_case_files);
}
microslip_code microslip_number(const microslip_problem* /*problem*/, const char* /*name*/, double* /*value*/,
                                microslip_error* error) {
  return report(error, MICROSLIP_NO_RESULT, without_case_files);
}
microslip_code microslip_field_size(const microslip_problem* /*problem*/, const char* /*name*/, size_t* /*columns*/,
                                    size_t* /*rows*/, microslip_error* error) {
  return report(error, MICROSLIP_NO_RESULT, without_case_files);
}
microslip_code microslip_field(microslip_problem* /*problem*/, const char* /*name*/, size_t /*count*/,
                               double* /*values*/, microslip_error* error) {
  return report(error, MICROSLIP_NO_RESULT, without_case_files);
}

microslip_code microslip_creep_table_read(const char* /*file*/, int /*direction*/, microslip_creep_table** table,
                                          microslip_error* error) {
  if (table) *table = nullptr;
  return report(error, MICROSLIP_NO_RESULT, "this library was built without reading files");
}
void microslip_creep_table_destroy(microslip_creep_table* /*table*/) {}
microslip_code microslip_creep_table_solve(const microslip_creep_table* /*table*/, size_t /*count*/,
                                           const microslip_contact* /*contacts*/, microslip_forces* /*forces*/) {
  return MICROSLIP_NO_RESULT;
}
microslip_code microslip_creep_table_differentiate(const microslip_creep_table* /*table*/, size_t /*count*/,
                                                   const microslip_contact* /*contacts*/,
                                                   microslip_derivatives* /*derivatives*/) {
  return MICROSLIP_NO_RESULT;
}

microslip_code microslip_wheel_rail_create(const microslip_problem* /*problem*/, microslip_wheel_rail** wheel_rail,
                                           microslip_error* error) {
  if (wheel_rail) *wheel_rail = nullptr;
  return report(error, MICROSLIP_NO_RESULT, without_case_files);
}
void microslip_wheel_rail_destroy(microslip_wheel_rail* /*wheel_rail*/) {}
microslip_code microslip_wheel_rail_state(const microslip_wheel_rail* /*wheel_rail*/, size_t /*width*/,
                                          double* /*state*/) {
  return MICROSLIP_NO_RESULT;
}
microslip_code microslip_wheel_rail_solve(microslip_wheel_rail* /*wheel_rail*/, size_t /*count*/,
                                          size_t /*state_width*/, const double* /*states*/, size_t /*result_width*/,
                                          double* /*results*/, int* /*status*/) {
  return MICROSLIP_NO_RESULT;
}
microslip_code microslip_wheel_rail_differentiate(microslip_wheel_rail* /*wheel_rail*/, size_t /*count*/,
                                                  size_t /*state_width*/, const double* /*states*/,
                                                  size_t /*result_width*/, double* /*results*/, int* /*status*/,
                                                  size_t /*row_count*/, size_t /*column_count*/, double* /*jacobian*/) {
  return MICROSLIP_NO_RESULT;
}
microslip_code microslip_wheel_rail_patches(const microslip_wheel_rail* /*wheel_rail*/, size_t /*width*/,
                                            size_t /*capacity*/, double* /*values*/, size_t* /*count*/,
                                            microslip_error* error) {
  return report(error, MICROSLIP_NO_RESULT, without_case_files);
}
microslip_code microslip_wheelset_contacts(microslip_wheel_rail* /*wheel_rail*/, int /*roll*/, double /*yaw*/,
                                           size_t /*count*/, const double* /*lateral*/, size_t /*width*/,
                                           double* /*contacts*/, int* /*status*/, microslip_error* error) {
  return report(error, MICROSLIP_NO_RESULT, without_case_files);
}
microslip_code microslip_equivalent_conicity(microslip_wheel_rail* /*wheel_rail*/, int /*roll*/,
                                             double /*contact_distance*/, size_t /*count*/,
                                             const double* /*amplitudes*/, double* /*conicity*/,
                                             microslip_error* error) {
  return report(error, MICROSLIP_NO_RESULT, without_case_files);
}
