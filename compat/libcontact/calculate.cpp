#include "compat/libcontact/arguments.hpp"
#include "compat/libcontact/call.hpp"
#include "compat/libcontact/result_files.hpp"

namespace microslip::libcontact {

extern "C" {

int cntc_calculate(int* ire, int* icp, int* ierror) {
  const Call call = problem_call(__func__, ire, icp);
  const int code = guarded(call, [&](ContactProblem& p) {
    int of_files = 0; // a file that cannot be written is no reason to solve nothing
    const Calculation found =
        p.calculate([&](const Case& c) { of_files = guarded_body(call, [&] { write_input(p, c); }); });
    for (const auto& message : found.messages) Registry::instance().log().write_once(call.heading() + ": " + message);
    const int of_results = found.is_skipped ? 0 : guarded_body(call, [&] { write_results(p); });
    if (found.code < 0) return found.code;
    if (of_files != 0) return of_files;
    return of_results != 0 ? of_results : found.code;
  });
  if (ierror) *ierror = code;
  return code;
}

int subs_calculate(int* ire, int* icp, int* ierror) {
  const int code = guarded(either_call(__func__, ire, icp), [&](ContactProblem& p) {
    p.find_interior(*icp);
    for (const int patch : p.contacts_of(*icp)) write_interior(p, patch);
  });
  if (ierror) *ierror = code;
  return code;
}

int cntc_getcalculationtime(int* ire, int* icp, double* tcpu, double* twall) {
  return get_numbers<double>(either_call(__func__, ire, icp), {{"tcpu", tcpu}, {"twall", twall}},
                             [](ContactProblem& p) {
                               return std::array{p.time.cpu, p.time.wall};
                             });
}

int cntc_resetcalculationtime(int* ire, int* icp) {
  return guarded(either_call(__func__, ire, icp), [&](ContactProblem& p) { p.time = {}; });
}

} // extern "C"
} // namespace microslip::libcontact
