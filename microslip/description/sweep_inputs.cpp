#include "microslip/contact/limits.hpp"
#include "microslip/description/input_lines.hpp"

#include <limits>

namespace microslip::description {
namespace {

std::vector<Input> all_inputs() {
  return lines_of({
      {"",
       {
           text("title", "heading of tables and pictures"),
           needed(text("case", "case file, a path that starts at this file's folder; or its sections, [case.body1]")),
           whole("chunk", between(1, most_sweep_chunk),
                 "cases that are handed out, and kept, at a time; left out: by their number"),
       }},
      {"range",
       {
           needed(number("from", "SI", any_number, "first value of a key that varies, in the unit of the key")),
           needed(number("to", "SI", any_number, "last value")),
           word("scale", sweep_scales, "linear", "of values between them, or of their probability in a sample"),
       }},
      {"grid.KEY",
       {
           needed(whole("count", between(1, most_cases), "values from the first one to the last")),
       }},
      {"sample",
       {
           needed(whole("count", between(1, most_cases), "random cases")),
           needed(whole("seed", between(0, std::numeric_limits<int>::max()), "of the random numbers")),
       }},
      {"list",
       {
           needed(text("file", "table of cases, a path that starts at this file's folder: keys in the first line")),
       }},
      {"output",
       {
           texts("quantities", "names of the quantities to keep; left out: all"),
           whole("patches", between(0, 8), 2, "patches of each wheel to keep"),
       }},
  });
}

} // namespace

const InputTable& sweep_inputs() {
  static const InputTable table(all_inputs(), {{"grid.KEY", "range"}, {"sample.KEY", "range"}});
  return table;
}

} // namespace microslip::description
