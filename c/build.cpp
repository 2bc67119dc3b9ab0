#include "microslip.h"
#include "microslip/version.hpp"

// The texts are literals, which end with a zero.
const char* microslip_version(void) {
  return microslip::build_info().version.data();
}

int microslip_abi(void) {
  return MICROSLIP_ABI;
}

microslip_build microslip_build_info(void) {
  const microslip::BuildInfo info = microslip::build_info();
  return {info.version.data(), info.commit.data(), info.compiler.data(), info.build_type.data()};
}

const char* microslip_code_text(int code) {
  constexpr struct {
    int code;
    const char* text;
  } texts[] = {
      {MICROSLIP_OK, "ok"},
      {MICROSLIP_INVALID_INPUT, "a contact is not a number or out of range"},
      {MICROSLIP_NOT_CONVERGED, "not converged to the tolerance"},
      {MICROSLIP_NO_CONTACT, "the bodies do not touch"},
      {MICROSLIP_NO_SOLUTION, "prescribed force exceeds mu Fn"},
      {MICROSLIP_OUT_OF_RANGE, "beyond the range of the creep-force table"},
      {MICROSLIP_IMPLAUSIBLE, "solved, but it cannot be meant"},
      {MICROSLIP_NULL_POINTER, "a pointer is NULL"},
      {MICROSLIP_WRONG_SIZE, "an array or a struct has the wrong size"},
      {MICROSLIP_INVALID_OPTION, "an option or argument is out of range"},
      {MICROSLIP_OUT_OF_MEMORY, "not enough memory"},
      {MICROSLIP_NO_RESULT, "there is no such result yet"},
      {MICROSLIP_INTERNAL_ERROR, "a fault of the library"},
      {MICROSLIP_IN_USE, "the handle is in use by another thread"},
  };
  for (const auto& known : texts)
    if (known.code == code) return known.text;
  return "no code of this library";
}
