#include "microslip/response/force_element.hpp"
#include "c/guarded_call.hpp"

#include <algorithm>
#include <cmath>
#include <span>

using namespace microslip;
using namespace microslip::c;

static_assert(MICROSLIP_ELEMENT_INPUTS == element_inputs && MICROSLIP_ELEMENT_FORCES == element_outputs);

struct microslip_force_element {
  ForceElement element;
  mutable InUse in_use = false;
};

namespace {

ElementInput input_of(const double* numbers) {
  return {{numbers[0], numbers[1], numbers[2]}, numbers[3]};
}

bool are_finite(std::span<const double> numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); });
}

} // namespace

microslip_code microslip_force_element_create(const char* text, microslip_force_element** element,
                                              microslip_error* error) {
  return guarded(error, [&] {
    require_pointer("element", element);
    *element = new microslip_force_element{ForceElement(force_element_from(require_pointer("text", text)))};
  });
}

void microslip_force_element_destroy(microslip_force_element* element) {
  delete element;
}

microslip_code microslip_force_element_step(microslip_force_element* element, double distance,
                                            const double input[MICROSLIP_ELEMENT_INPUTS],
                                            double forces[MICROSLIP_ELEMENT_FORCES]) {
  if (!input || !forces) return MICROSLIP_NULL_POINTER;
  return with_handle(element, [&] {
    if (!are_finite({input, element_inputs}) || !std::isfinite(distance) || distance < 0)
      return MICROSLIP_INVALID_INPUT;
    const ElementForces found = element->element.step(distance, input_of(input));
    forces[0] = found.fx, forces[1] = found.fy, forces[2] = found.mz;
    return MICROSLIP_OK;
  });
}

microslip_code microslip_force_element_reset(microslip_force_element* element, const double* input) {
  return with_handle(element, [&] {
    if (input && !are_finite({input, element_inputs})) return MICROSLIP_INVALID_INPUT;
    element->element.reset(input ? input_of(input) : element->element.fit().steady);
    return MICROSLIP_OK;
  });
}

size_t microslip_force_element_state_size(const microslip_force_element* element) {
  return element ? element->element.state_size() : 0;
}

microslip_code microslip_force_element_get_state(const microslip_force_element* element, size_t count, double* state) {
  if (!state) return MICROSLIP_NULL_POINTER;
  return with_handle(element, [&] {
    if (count != element->element.state_size()) return MICROSLIP_WRONG_SIZE;
    element->element.copy_state({state, count});
    return MICROSLIP_OK;
  });
}

microslip_code microslip_force_element_set_state(microslip_force_element* element, size_t count, const double* state) {
  if (!state) return MICROSLIP_NULL_POINTER;
  return with_handle(element, [&] {
    if (count != element->element.state_size()) return MICROSLIP_WRONG_SIZE;
    if (!are_finite({state, count})) return MICROSLIP_INVALID_INPUT;
    element->element.set_state({state, count});
    return MICROSLIP_OK;
  });
}
