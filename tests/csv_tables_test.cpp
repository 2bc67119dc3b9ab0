// Result files as tables of CSV.

#include "io/csv_tables.hpp"

#include "io/csv_line.hpp"
#include "io/result_file.hpp"
#include "io/result_reader.hpp"
#include "tests/support/case_text.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/numbers.hpp"
#include "tests/support/program_run.hpp"
#include "tests/support/same_bits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using Names = std::vector<std::string>;
using Cells = std::vector<std::string>;

/// A column of a table of CSV by its name, without its unit.
std::map<std::string, Cells> columns_of(const std::filesystem::path& csv) {
  std::istringstream lines(contents(csv));
  io::CsvLine parser;
  Names heads;
  std::map<std::string, Cells> columns;
  for (std::string line; std::getline(lines, line);) {
    const auto& fields = parser.split(line);
    const bool is_head = heads.empty();
    for (std::size_t k = 0; k < fields.size(); ++k)
      if (is_head)
        heads.emplace_back(io::name_and_unit(fields[k]).first);
      else
        columns[heads.at(k)].emplace_back(fields[k]);
    EXPECT_EQ(fields.size(), heads.size()) << line;
  }
  return columns;
}

/// Cells of a dataset in the tables, wherever they are.
Cells find_cells(const std::filesystem::path& csv, const io::StoredDataset& dataset) {
  const auto beside = [&](std::string name) {
    std::replace(name.begin(), name.end(), '/', '.');
    return csv.parent_path() / (csv.stem().string() + "." + name + ".csv");
  };
  for (const auto& numbers : {csv, beside("numbers")}) {
    const auto columns = columns_of(numbers);
    if (columns.contains(dataset.path())) return columns.at(dataset.path());
    if (!columns.contains("name")) continue;
    Cells found;
    for (std::size_t k = 0; k < columns.at("name").size(); ++k)
      if (const auto name = columns.at("name")[k]; name == dataset.path() || name.starts_with(dataset.path() + "["))
        found.push_back(columns.at("value")[k]);
    if (!found.empty()) return found;
  }
  for (const auto& table : {beside(dataset.path()), beside(dataset.group)})
    if (const auto columns = columns_of(table); columns.contains(dataset.name)) return columns.at(dataset.name);
  return {};
}

bool is_same(const std::string& cell, double value) {
  if (std::isnan(value)) return cell.empty();
  return same_bits(std::stod(cell), value);
}
bool is_same(const std::string& cell, int value) {
  return cell == std::to_string(value);
}
bool is_same(const std::string& cell, const std::string& value) {
  return cell == value;
}

/// All that a result file holds is in the tables, but for the datasets of these names.
void expect_all(const std::filesystem::path& result_file, const std::filesystem::path& csv, const Names& but = {}) {
  const io::ResultReader reader(result_file);
  std::size_t compared = 0;
  for (const io::StoredDataset& dataset : reader.datasets()) {
    if (std::find(but.begin(), but.end(), dataset.path()) != but.end() || dataset.size() == 0) continue;
    const Cells cells = find_cells(csv, dataset);
    std::visit(
        [&](const auto& values) {
          ASSERT_EQ(cells.size(), values.size()) << dataset.path();
          for (std::size_t k = 0; k < values.size(); ++k)
            ASSERT_TRUE(is_same(cells[k], values[k])) << dataset.path() << " " << k << " " << cells[k];
        },
        reader.read(dataset));
    ++compared;
  }
  EXPECT_GT(compared, 20u);
}

/// Half a field of a line that is refused came before the next one's: 2 and 0.5 made 20.5.
TEST(CsvLine, ForgetsALineThatItRefuses) {
  for (const char* bad : {"1,2\"x,3", "\"1,2,3", "1,\"2\"x,3"}) {
    io::CsvLine line;
    EXPECT_THROW(line.split(bad), Error) << bad;
    EXPECT_EQ(line.split("0.5,\"0,4\",1"), (std::vector<std::string_view>{"0.5", "0,4", "1"})) << bad;
    io::CsvLine semicolons(';');
    EXPECT_THROW(semicolons.split(bad), Error) << bad;
    EXPECT_EQ(semicolons.split("0,5;4"), (std::vector<std::string_view>{"0,5", "4"})) << bad;
  }
}

TEST(CsvTables, SortNumbersFieldsPointsAndCurves) {
  const TemporaryFolder folder;
  {
    io::ResultFile file(folder / "r.h5", {});
    file.scalar("exact/fx", 0.1 + 0.2, "N", "force, on body 1");
    file.scalar("exact/least", std::numeric_limits<double>::denorm_min(), "-", "a number");
    file.scalar("exact/limit", infinity, "N", "a \"limit\"");
    file.scalar("exact/none", nan, "N", "not there");
    file.array("exact/at", std::vector<double>{1, -0.0}, "m", "place");
    file.text("exact/status", "ok", "how it ended");
    file.array("exact/fields/px", std::vector<double>{1, 2, 3, 4, 5, 6}, "Pa", "traction", {2, 3});
    file.array("exact/fields/state", std::vector<std::uint8_t>{0, 1, 2, 0, 1, 2}, "-", "state", {2, 3});
    file.array("exact/fields/y", std::vector<double>{7, 7, 7, 8, 8, 8}, "m", "place", {2, 3});
    file.array("inside/x", std::vector<double>{1, 2, 3}, "m", "place");
    file.array("inside/z", std::vector<double>{5, 6}, "m", "place");
    file.array("inside/y", std::vector<double>{4}, "m", "place");
    file.array("inside/ux", std::vector<double>{11, 12, 13, 14, 15, 16}, "m", "shift", {2, 1, 3});
    file.array("curve/fx", std::vector<double>{1, 2}, "N", "forces");
    file.array("curve/fy", std::vector<double>{3, 4}, "N", "forces");
    file.array("curve/long", std::vector<int>{5, 6, 7}, "-", "counts");
    file.append("empty/fx", std::vector<double>{}, "N", "nothing");
    file.commit();
  }
  const auto names = io::write_csv_tables(folder / "r.h5", folder / "t.csv");
  EXPECT_EQ(names.front(), folder / "t.csv");
  EXPECT_EQ(folder.entries(),
            (Names{"r.h5", "t.csv", "t.curve.csv", "t.curve.long.csv", "t.exact.fields.csv", "t.inside.csv"}));
  EXPECT_EQ(contents(folder / "t.csv"), "name,value,unit,description\n"
                                        "exact/at[0],1,m,place\n"
                                        "exact/at[1],-0,m,place\n"
                                        "exact/fx,0.30000000000000004,N,\"force, on body 1\"\n"
                                        "exact/least,5e-324,-,a number\n"
                                        "exact/limit,inf,N,\"a \"\"limit\"\"\"\n"
                                        "exact/none,,N,not there\n"
                                        "exact/status,ok,-,how it ended\n");
  EXPECT_EQ(contents(folder / "t.exact.fields.csv"), "y [m],px [Pa],state\n7,1,0\n7,2,1\n7,3,2\n8,4,0\n8,5,1\n8,6,2\n");
  EXPECT_EQ(contents(folder / "t.inside.csv"), "x [m],y [m],z [m],ux [m]\n1,4,5,11\n2,4,5,12\n3,4,5,13\n"
                                               "1,4,6,14\n2,4,6,15\n3,4,6,16\n");
  EXPECT_EQ(contents(folder / "t.curve.csv"), "fx [N],fy [N]\n1,3\n2,4\n");
  EXPECT_EQ(contents(folder / "t.curve.long.csv"), "long\n5\n6\n7\n");
}

/// Longer arrays than what is read at a time, of one dimension and of two.
TEST(CsvTables, AreWholeAcrossBlocks) {
  const TemporaryFolder folder;
  std::vector<double> values;
  for (int k = 0; k < 9000; ++k) values.push_back(std::sqrt(k));
  {
    io::ResultFile file(folder / "r.h5", {});
    file.array("line/x", values, "m", "numbers");
    file.array("map/y", values, "m", "numbers", {90, 100});
    file.commit();
  }
  io::write_csv_tables(folder / "r.h5", folder / "t.csv");
  for (const auto& [table, column] : {std::pair("t.line.csv", "x"), std::pair("t.map.csv", "y")}) {
    const Cells cells = columns_of(folder / table).at(column);
    ASSERT_EQ(cells.size(), values.size());
    for (std::size_t k = 0; k < values.size(); ++k) ASSERT_TRUE(is_same(cells[k], values[k])) << k;
  }
}

TEST(CsvTables, HaveAllThatSolveWrites) {
  const TemporaryFolder folder;
  for (const std::string name : {"two_rollers", "lateral_sweep", "wheelset_in_curve"}) {
    const std::string file = "'" MICROSLIP_SOURCE_DIR "/examples/" + name + ".toml'";
    const Outcome solved = run_program(folder, "solve " + file + " -o " + name + " --no-pictures");
    ASSERT_EQ(solved.exit_code, 0) << solved.errors;
    const Outcome tables = run_program(folder, "solve " + file + " -o tables/" + name + ".csv");
    ASSERT_EQ(tables.exit_code, 0) << tables.errors;
    EXPECT_NE(tables.output.find("\ntables/" + name + ".csv\n"), std::string::npos) << tables.output;
    expect_all(folder / name / "result.h5", folder / "tables" / (name + ".csv"));
    run_program(folder, "convert " + name + "/result.h5 -o " + name + ".csv");
    EXPECT_EQ(contents(folder / (name + ".csv")), contents(folder / "tables" / (name + ".csv")));
  }
  for (const auto& entry : folder.entries()) EXPECT_EQ(entry.find(".tmp"), std::string::npos) << entry;
}

TEST(CsvTables, OfASweepAreOne) {
  const TemporaryFolder folder;
  save(folder / "s.toml", "[grid]\nload.normal_force = [-1, 40e3]\nsolution.theory = [\"fastsim\", \"fastsim2\"]\n" +
                              in_sweep(two_bodies_text));
  ASSERT_EQ(run_program(folder, "sweep s.toml -o r.h5").exit_code, 1); // forces of -1 N
  const Outcome outcome = run_program(folder, "sweep s.toml -o r.csv");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.output, "4 cases\nr.csv\n");
  EXPECT_EQ(folder.entries(), (Names{"r.csv", "r.h5", "s.toml"}));
  const Outcome converted = run_program(folder, "convert r.h5 -o again.csv");
  EXPECT_EQ(converted.output, "again.csv\n");
  EXPECT_EQ(contents(folder / "again.csv"), contents(folder / "r.csv"));
  const auto columns = columns_of(folder / "r.csv");
  EXPECT_EQ(columns.at("parameters/solution.theory"), (Cells{"fastsim", "fastsim2", "fastsim", "fastsim2"}));
  const std::string reason = "s.toml: load.normal_force = -1 [N]: must be positive and finite";
  EXPECT_EQ(columns.at("failures/reason"), (Cells{reason, reason, "", ""}));
  const io::ResultReader reader(folder / "r.h5");
  for (const io::StoredDataset& dataset : reader.datasets())
    if (dataset.group != "failures" && dataset.name != "shape") {
      EXPECT_EQ(columns.at(dataset.path()).size(), 4u) << dataset.path();
    }
}

TEST(CsvTables, ReplaceNoFileOfASweep) {
  const TemporaryFolder folder;
  save(folder / "s.toml", "[grid]\nload.normal_force = [30e3, 40e3]\n" + in_sweep(two_bodies_text));
  save(folder / "r.csv", "mine\n");
  const Outcome outcome = run_program(folder, "sweep s.toml -o r.csv");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.errors, "microslip: r.csv: is there already; remove it, or name another file\n");
  EXPECT_EQ(contents(folder / "r.csv"), "mine\n");
}

TEST(CsvTables, LeaveNothingBehindAFailure) {
  const TemporaryFolder folder;
  save(folder / "cut.h5", "\x89HDF\r\n\x1a\n and no more");
  save(folder / "bad.toml", "[load]\nnormal_forse = 1\n");
  const auto expect_refused = [&](const std::string& arguments, const std::string& message) {
    const Outcome outcome = run_program(folder, arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_NE(outcome.errors.find(message), std::string::npos) << outcome.errors;
    EXPECT_EQ(folder.entries(), (Names{"bad.toml", "cut.h5"}));
  };
  expect_refused("convert cut.h5", "cut.h5: cannot be read as HDF5");
  expect_refused("convert cut.h5 -o out.xlsx",
                 "out.xlsx: needs a name that ends with .csv, for tables, or .vtp, for surfaces with fields");
  expect_refused("convert none.h5", "none.h5: cannot be read");
  expect_refused("solve bad.toml -o out.csv", "[body1] is missing");
  expect_refused("convert cut.h5 -o none/out.csv", "cut.h5: cannot be read as HDF5");
}

} // namespace
} // namespace microslip
