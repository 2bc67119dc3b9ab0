#include "cases/case_document.hpp"

#include "cases/interior_result.hpp"

namespace microslip::cases {

io::Json case_document(const io::RollingCase& input, const RollingContactResult& result,
                       const io::Provenance& provenance, io::JsonFields fields) {
  io::JsonResult written(provenance, fields);
  write_result(input, result, written);
  io::Json document = written.document();
  document["status"] = to_string(result.status);
  if (result.exact && !result.exact->interior.empty())
    document["interior_extremes"] = extremes_json(input.interior, result.exact->interior);
  document["warnings"] = result.warnings;
  return document;
}

} // namespace microslip::cases
