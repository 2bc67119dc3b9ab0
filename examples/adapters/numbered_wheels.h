/* Wheels by their numbers, for programs whose subroutines have no object of their own: wheel n is that of the case file
 * wheel_n.toml in the working folder. Copy this file with the one for your program. Subroutines may run in many threads
 * at a time: each call takes a wheel that no other one uses, and makes one if there is none, since loads do not depend
 * on which it is. Nothing is locked. */
#ifndef MICROSLIP_NUMBERED_WHEELS_H
#define MICROSLIP_NUMBERED_WHEELS_H

#include "wheel.h"

#include <stdatomic.h>

enum { most_wheels = 16, most_calls_at_once = 64 };

typedef struct numbered_wheel {
  atomic_flag taken;
  rail_wheel made;
} numbered_wheel;

/* Takes the n-th wheel, n in [1, 16], to be given back; NULL if its case file is refused, with the reason. */
static inline numbered_wheel* take_wheel(int n, microslip_error* error) {
  static numbered_wheel wheels[most_wheels][most_calls_at_once];
  char file[32];
  int k;
  error->code = MICROSLIP_INVALID_OPTION;
  if (n < 1 || n > most_wheels) {
    snprintf(error->text, sizeof error->text, "the wheel %d of USER must be in [1, %d]", n, most_wheels);
    return NULL;
  }
  for (k = 0; k < most_calls_at_once; ++k) {
    numbered_wheel* const taken = &wheels[n - 1][k];
    if (atomic_flag_test_and_set(&taken->taken)) continue;
    snprintf(file, sizeof file, "wheel_%d.toml", n);
    if (taken->made.contact || wheel_create(&taken->made, file, error) == MICROSLIP_OK) return taken;
    atomic_flag_clear(&taken->taken);
    return NULL;
  }
  snprintf(error->text, sizeof error->text, "more than %d calls at once for a wheel", most_calls_at_once);
  return NULL;
}

static inline void give_wheel_back(numbered_wheel* taken) {
  atomic_flag_clear(&taken->taken);
}

#endif
