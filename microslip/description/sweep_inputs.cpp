#include "microslip/contact/limits.hpp"
#include "microslip/description/input_lines.hpp"

#include <limits>
#include <span>

namespace microslip::description {
namespace {

constexpr std::span<const Word> words = distributions;
constexpr Condition with_ends{"distribution", words.first(4)}, uniform{"distribution", words.first(1)},
    normal{"distribution", words.subspan(1, 2)}, triangular{"distribution", words.subspan(3, 1)},
    empirical{"distribution", words.last(1)};

std::vector<Input> all_inputs() {
  return lines_of({
      {"",
       {
           text("title", "heading of tables and pictures"),
           needed(text("case", "case file, a path that starts at this file's folder; or its sections, [case.body1]")),
           whole("chunk", between(1, most_sweep_chunk),
                 "cases that are handed out, and kept, at a time; left out: by their number"),
       }},
      {"grid.KEY",
       {
           needed(number("from", "SI", any_number, "first value of a key that varies, in the unit of the key")),
           needed(number("to", "SI", any_number, "last value")),
           word("scale", sweep_scales, "linear", "of values between them"),
           needed(whole("count", between(1, most_cases), "values from the first one to the last")),
       }},
      {"sample",
       {
           needed(whole("count", between(1, most_cases), "points, which are cases unless aim is sobol_indices")),
           needed(whole("seed", between(0, std::numeric_limits<int>::max()), "of the random numbers")),
           word("points", point_sets, "random", "how they fill the space of the keys that vary"),
           word("aim", sample_aims, "quantiles",
                "what they are for; sobol_indices need as many cases as points times keys plus two"),
       }},
      {"sample.KEY",
       {
           word("distribution", distributions, "uniform", "of a key that varies"),
           only(with_ends, number("from", "SI", any_number,
                                  "least value, in the unit of the key; a normal or log_normal one is cut off there")),
           only(with_ends, number("to", "SI", any_number, "largest value")),
           only(uniform, word("scale", sweep_scales, "linear", "of values between them: the logarithm is uniform")),
           only(normal, number("mean", "SI", any_number, "of the values, before they are cut off")),
           only(normal, number("standard_deviation", "SI", positive, "the same")),
           only(triangular, number("mode", "SI", any_number, "the most probable value")),
           only(empirical,
                text("file", "table of values of one probability, a path that starts at this file's folder")),
           only(empirical, text("column", "its column; left out: it has one alone")),
       }},
      {"sample.correlations",
       {
           number("KEY with KEY", "-", between(-1, 1), "correlation of the normal scores of two keys that vary"),
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
  static const InputTable table(all_inputs(), {});
  return table;
}

} // namespace microslip::description
