#include "c/guarded_call.hpp"
#include "cases/case_document.hpp"
#include "cases/wheel_rail_result.hpp"

using namespace microslip;
using namespace microslip::c;

namespace {

/// Input is a RollingCase, a WheelRailCase or a WheelsetCase.
template <class Input>
microslip_code solve(const Input& input, const std::string& text, const std::string& file, char** json,
                     microslip_error* error) {
  const auto result = cases::solve_case(input);
  const io::Provenance provenance{
      .kind = cases::kind_of(input), .title = input.title, .case_file = file, .case_text = text};
  *json = text_copy(io::json_text(cases::case_document(input, result, provenance)));
  return report(error, code_of(result.status), result.reason);
}

} // namespace

microslip_code microslip_solve_case(const char* text, const char* name, char** json, microslip_error* error) {
  if (json) *json = nullptr;
  return guarded(error, [&] {
    require_pointer("json", json);
    const std::string case_text = require_pointer("text", text), file = require_pointer("name", name);
    if (io::is_wheelset_case(case_text, file))
      return solve(io::parse_wheelset_case(case_text, file), case_text, file, json, error);
    if (io::is_wheel_rail_case(case_text, file))
      return solve(io::parse_wheel_rail_case(case_text, file), case_text, file, json, error);
    return solve(io::parse_case(case_text, file), case_text, file, json, error);
  });
}
