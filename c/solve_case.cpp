#include "c/guarded_call.hpp"
#include "cases/case_document.hpp"

using namespace microslip;
using namespace microslip::c;

microslip_code microslip_solve_case(const char* text, const char* name, char** json, microslip_error* error) {
  if (json) *json = nullptr;
  return guarded(error, [&] {
    require_pointer("json", json);
    const std::string case_text = require_pointer("text", text), file = require_pointer("name", name);
    const RollingCase input = parse_case(case_text, file);
    const RollingContactResult result = solve_case(input);
    const Provenance provenance{
        .kind = "rolling_contact", .title = input.title, .case_file = file, .case_text = case_text};
    *json = text_copy(json_text(case_document(input, result, provenance)));
    return report(error, code_of(result.status), result.reason);
  });
}
