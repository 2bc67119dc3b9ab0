#include "explorer/core/rolling_start.hpp"

#include "cases/rolling_contact_result.hpp"
#include "explorer/core/solution_fields.hpp"
#include "microslip/contact/limits.hpp"
#include "microslip/contact/quantities.hpp"
#include "microslip/contact/solver_report.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/classical/contact_sequence.hpp"
#include "microslip/exact/normal/hertzian_gap.hpp"
#include "microslip/rolling/method.hpp"

#include <string>
#include <utility>
#include <vector>

namespace microslip::explorer {
namespace {

constexpr int most_frames = 400;

/// The step that is the same in all frames.
ContactStep step_of(const io::RollingCase& input, const HertzContact& hertz) {
  const Method& method = input.method;
  const ElementGrid grid = ElementGrid::across_ellipse(hertz.a, hertz.b, method.mx, method.my, contact_margin);
  return contact_step(input.problem, method, {grid, hertzian_gap(hertz.gap, grid)},
                      {NormalLoad::Given::force, hertz.normal_force});
}

/// What does not change from frame to frame.
constexpr std::string_view still_fields[] = {"x", "y", "pressure", "bound"};
/// What does.
constexpr std::string_view moving_fields[] = {"px", "py", "sx", "sy"};

io::Json frame_of(const ContactSolution& solution, double distance, io::Json& units) {
  io::Json frame = {{"distance", io::json_number(distance)}};
  for (const char* name : {"fx", "fy", "mz", "creepage_longitudinal", "creepage_lateral"}) {
    const Quantity& q = quantity(name);
    frame[name] = io::json_number(q.value(solution));
    units[name] = q.unit_of(solution);
  }
  add_fields(solution, moving_fields, frame, units);
  frame["state"] = states_of(solution);
  return frame;
}

} // namespace

io::Json rolling_start(const io::RollingCase& input) {
  const Motion& motion = input.problem.motion;
  if (input.method.theory != Theory::exact || motion.kind != ContactMotion::transient)
    throw Error("transient: needs a case with motion.kind = \"transient\" and solution.theory = \"exact\"");
  require_count("motion.steps", motion.steps, 1, most_frames);
  const HertzContact hertz = hertz_contact(input.problem);
  const bool shifts = motion.force_x || motion.force_y;
  ContactStep step = step_of(input, hertz);
  const double rolled = step.motion.step > 0 ? step.motion.step : step.grid.dx;
  ContactSequence sequence;
  io::Json result = io::Json::object(), units = {{"distance", "m"}}, frames = io::Json::array();
  Status status = Status::ok;
  for (int k = shifts ? 0 : 1; k <= motion.steps && status == Status::ok; ++k) {
    step.motion.motion = k == 0 ? ContactMotion::shift : ContactMotion::transient;
    step.start = frames.empty() ? StepStart::fresh : StepStart::previous;
    const ContactStepSolution solution = sequence.solve(step);
    status = solution.report.status;
    if (frames.empty()) add_fields(solution, still_fields, result, units);
    frames.push_back(frame_of(solution, k * rolled, units));
  }
  for (const cases::StoredNumber& q : cases::hertz_quantities(hertz))
    if (q.path.starts_with("hertz/")) result[io::Json::json_pointer("/" + q.path)] = io::json_number(q.value);
  result["shape"] = {step.grid.my, step.grid.mx};
  result["step"] = io::json_number(rolled);
  result["frames"] = std::move(frames);
  result["units"] = std::move(units);
  result["warnings"] = cases::case_warnings(input, hertz).texts;
  result["status"] = to_string(status);
  SolverReport report{.status = status};
  add_reason(report);
  if (!report.reason.empty()) result["reason"] = report.reason;
  return result;
}

} // namespace microslip::explorer
