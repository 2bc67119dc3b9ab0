// The header stands alone in C++11.
#include "contact_addon.h"

int microslip_libcontact_in_cxx();

int microslip_libcontact_in_cxx() {
  return cntc_finalizelast();
}
