#include "c/guarded_call.hpp"

using namespace microslip::c;

microslip_code microslip_solve_case(const char* /*text*/, const char* /*name*/, char** json, microslip_error* error) {
  if (json) *json = nullptr;
  return report(error, MICROSLIP_NO_RESULT, "this library was built without case files");
}
