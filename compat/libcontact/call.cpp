#include "compat/libcontact/call.hpp"

namespace microslip::libcontact {

std::string Call::heading() const {
  const auto number = [](const int* value) { return value ? std::to_string(*value) : std::string("NULL"); };
  return std::string(name) + "(" + number(ire) + ", " + number(icp) + ")";
}

std::shared_ptr<ContactProblem> find_problem(const Call& call) {
  if (!call.ire || !call.icp) throw Refusal(CNTC_err_icp, "ire or icp is NULL");
  Registry& registry = Registry::instance();
  const bool is_wheel = registry.module(*call.ire).value_or(*call.icp < 0 ? 1 : 3) == 1;
  const Module module = is_wheel ? Module::wheel : Module::contact;
  if (call.module != Module::any && call.module != module)
    throw Refusal(CNTC_err_icp, is_wheel ? "is not for module 1" : "is not for module 3");
  if (is_wheel && call.scope == Scope::whole && *call.icp > 0)
    throw Refusal(CNTC_err_icp, "icp must be -1 in module 1");
  if (is_wheel && call.scope == Scope::patch && *call.icp < 0)
    throw Refusal(CNTC_err_icp, "icp must be that of a contact patch");
  return registry.problem(*call.ire, is_wheel ? 1 : 3, *call.icp);
}

} // namespace microslip::libcontact
