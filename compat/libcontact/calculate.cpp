#include "compat/libcontact/arguments.hpp"
#include "compat/libcontact/call.hpp"

using namespace microslip::libcontact;

extern "C" {

int cntc_calculate(int* ire, int* icp, int* ierror) {
  const Call call{"cntc_calculate", ire, icp, Module::any, Scope::whole};
  const int code = guarded(call, [&](ContactProblem& p) {
    const Calculation found = p.calculate();
    for (const auto& message : found.messages) Registry::instance().log().write_once(call.heading() + ": " + message);
    return found.code;
  });
  if (ierror) *ierror = code;
  return code;
}

int subs_calculate(int* ire, int* icp, int* ierror) {
  const int code = guarded({"subs_calculate", ire, icp, Module::any, Scope::either},
                           [&](ContactProblem& p) { p.find_interior(*icp); });
  if (ierror) *ierror = code;
  return code;
}

int cntc_getcalculationtime(int* ire, int* icp, double* tcpu, double* twall) {
  return answered({"cntc_getcalculationtime", ire, icp, Module::any, Scope::either}, into(result(tcpu), result(twall)),
                  [&](ContactProblem& p) {
                    given("twall", twall) = p.time.wall;
                    given("tcpu", tcpu) = p.time.cpu;
                  });
}

int cntc_resetcalculationtime(int* ire, int* icp) {
  return guarded({"cntc_resetcalculationtime", ire, icp, Module::any, Scope::either},
                 [&](ContactProblem& p) { p.time = {}; });
}

} // extern "C"

LIBCONTACT_UNDERSCORED(cntc_calculate)
LIBCONTACT_UNDERSCORED(subs_calculate)
LIBCONTACT_UNDERSCORED(cntc_getcalculationtime)
LIBCONTACT_UNDERSCORED(cntc_resetcalculationtime)
