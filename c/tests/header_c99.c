/* The header alone, twice. */
#include <microslip.h>

/* Zero is what leaves nothing out. */
int header_c99(void);
int header_c99(void) {
  const microslip_contact contact = {0};
  microslip_error error;
  return microslip_contact_check(&contact, &error) == MICROSLIP_INVALID_INPUT;
}
