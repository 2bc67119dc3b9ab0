// `microslip bench --compare`: ratios of two runs' times, line by line.

#include "io/json.hpp"
#include "tests/support/program_run.hpp"

#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using Times = std::vector<std::pair<std::string, double>>;

/// Writes what `bench --json` prints, as far as it is compared.
void write(const TemporaryFolder& folder, const std::string& name, const Times& times) {
  io::Json document = {{"kind", "bench"}, {"version", "1"}, {"commit", "abc"}, {"machine", "some machine"}};
  document["rows"] = io::Json::array();
  for (const auto& [row, seconds] : times) document["rows"].push_back({{"name", row}, {"seconds", seconds}});
  std::ofstream(folder / name) << document;
}

TEST(ProgramBench, ComparesLinesByTheirNames) {
  const TemporaryFolder folder;
  write(folder, "old.json", {{"a", 2e-3}, {"gone", 1e-6}, {"b", 1e-3}, {"c", 4e-3}});
  write(folder, "new.json", {{"b", 3e-3}, {"a", 1e-3}, {"c", 5e-3}, {"fresh", 7e-9}});
  const auto text = run_program(folder, "bench --compare old.json new.json");
  EXPECT_EQ(text.exit_code, 0) << text.errors;
  EXPECT_EQ(text.output, R"(old: microslip 1, commit abc, some machine
new: microslip 1, commit abc, some machine

a contact                                        old       new  new / old
b                                               1 ms      3 ms       3.00
a                                               2 ms      1 ms       0.50
c                                               4 ms      5 ms       1.25
fresh                                              -      7 ns
gone                                            1 us         -

median of 3 ratios 1.25
)");
  const auto json = run_program(folder, "bench --compare old.json new.json --json");
  const auto rows = io::Json::parse(json.output).at("rows");
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[0].at("new_over_old"), 3);
  EXPECT_EQ(rows[1].at("before"), 2e-3);
  EXPECT_FALSE(rows[3].contains("new_over_old"));
}

TEST(ProgramBench, RefusesWhatIsNoRun) {
  const TemporaryFolder folder;
  write(folder, "old.json", {{"a", 2e-3}});
  std::ofstream(folder / "text.json") << "not json";
  std::ofstream(folder / "vehicle.json") << R"({"kind": "bench", "rows": [{"name": "car", "real_time": 3}]})";
  const auto expect_error = [&](const std::string& arguments, const std::string& message) {
    const auto outcome = run_program(folder, "bench " + arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_NE(outcome.errors.find(message), std::string::npos) << outcome.errors;
  };
  expect_error("--compare missing.json", "missing.json");
  expect_error("--compare text.json", "text.json: not what `microslip bench --json` prints");
  expect_error("--compare old.json vehicle.json", "vehicle.json: not what `microslip bench --json` prints");
  expect_error("vehicle --compare old.json", "--compare is for contacts");
}

} // namespace
} // namespace microslip
