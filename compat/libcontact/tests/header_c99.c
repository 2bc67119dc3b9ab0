/* The header stands alone in C99, and its functions are called as CONTACT's are. */
#include "contact_addon.h"

int microslip_libcontact_in_c99(void);

int microslip_libcontact_in_c99(void) {
  int ire = 1, icp = -1, error = 0;
  return cntc_calculate(&ire, &icp, &error);
}
