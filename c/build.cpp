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
  switch (code) {
  case MICROSLIP_OK:
    return "ok";
  case MICROSLIP_INVALID_INPUT:
    return "a contact is not a number or out of range";
  case MICROSLIP_NOT_CONVERGED:
    return "not converged to the tolerance";
  case MICROSLIP_NO_CONTACT:
    return "the bodies do not touch";
  case MICROSLIP_NO_SOLUTION:
    return "prescribed force exceeds mu Fn";
  case MICROSLIP_OUT_OF_RANGE:
    return "beyond the range of the creep-force table";
  case MICROSLIP_IMPLAUSIBLE:
    return "solved, but it cannot be meant";
  case MICROSLIP_NULL_POINTER:
    return "a pointer is NULL";
  case MICROSLIP_WRONG_SIZE:
    return "an array or a struct has the wrong size";
  case MICROSLIP_INVALID_OPTION:
    return "an option or argument is out of range";
  case MICROSLIP_OUT_OF_MEMORY:
    return "not enough memory";
  case MICROSLIP_NO_RESULT:
    return "there is no such result yet";
  case MICROSLIP_INTERNAL_ERROR:
    return "a fault of the library";
  case MICROSLIP_IN_USE:
    return "the handle is in use by another thread";
  }
  return "no code of this library";
}
