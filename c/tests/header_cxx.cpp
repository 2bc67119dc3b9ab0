// The header alone, twice, in an old C++.
#include <microslip.h>

bool header_cxx();
bool header_cxx() {
  const microslip_contact contact = microslip_contact();
  return microslip_contact_check(&contact, nullptr) == MICROSLIP_INVALID_INPUT;
}
