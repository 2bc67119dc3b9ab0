#include "compat/contact/run.hpp"

namespace microslip::contact_program {

Outcome Run::run(const Case& c, const Progress& progress) {
  if (c.wheel_rail) return wheels_[c.sequence].run(c, progress);
  return contacts_[c.sequence].run(c, progress);
}

} // namespace microslip::contact_program
