#include "compat/libcontact/call.hpp"

namespace microslip::libcontact {

std::string Call::heading() const {
  const auto number = [](const int* value) { return value ? std::to_string(*value) : std::string("NULL"); };
  return std::string(name) + "(" + number(ire) + ", " + number(icp) + ")";
}

std::shared_ptr<ContactProblem> find_problem(const Call& call) {
  if (!call.ire || !call.icp) throw Refusal(CNTC_err_icp, "ire or icp is NULL");
  auto problem = Registry::instance().problem(*call.ire, *call.icp);
  const Module module = problem->is_wheel() ? Module::wheel : Module::contact;
  if (call.module != Module::any && call.module != module)
    throw Refusal(CNTC_err_icp, problem->is_wheel() ? "is not for module 1" : "is not for module 3");
  if (!problem->is_wheel()) return problem;
  if (call.scope == Scope::whole && *call.icp > 0) throw Refusal(CNTC_err_icp, "icp must be -1 in module 1");
  if (call.scope == Scope::patch && *call.icp < 0) throw Refusal(CNTC_err_icp, "icp must be that of a contact patch");
  return problem;
}

} // namespace microslip::libcontact
