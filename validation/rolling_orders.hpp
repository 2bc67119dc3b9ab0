#pragma once

namespace microslip::validation {

class Report;

/// Orders of the forces where a contact rolls otherwise than as an ellipse of similar bodies without spin: with spin,
/// as a patch that is given by its gap, with bodies of different materials, in transient rolling. A part of the study
/// `second-order`.
void report_rolling_orders(Report& report);

} // namespace microslip::validation
