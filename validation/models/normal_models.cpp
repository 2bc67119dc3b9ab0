#include "validation/models/normal_models.hpp"

#include "validation/models/analyn.hpp"
#include "validation/models/equivalent_ellipse.hpp"
#include "validation/models/kik_piotrowski.hpp"
#include "validation/models/stripes.hpp"

namespace microslip::validation {

const std::vector<NormalModel>& normal_models() {
  static const std::vector<NormalModel> all = {
      {"Hertz, curvatures at the point", "Hertz 1882", hertz_at_point},
      {"equivalent ellipse", "Piotrowski & Chollet 2005", equivalent_ellipse},
      {"Kik & Piotrowski", "Kik & Piotrowski 1996", kik_piotrowski},
      {"Kik & Piotrowski, shape corrected", "Piotrowski & Kik 2008", kik_piotrowski_corrected},
      {"Kik & Piotrowski, CONTACT's KPEC", "CONTACT", kik_piotrowski_contact},
      {"STRIPES", "Ayasse & Chollet 2005; Quost & others 2006", stripes},
      {"ANALYN", "Sichani, Enblom & Berg 2014", analyn},
  };
  return all;
}

} // namespace microslip::validation
