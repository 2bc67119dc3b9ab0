// `report`: what an engineer files of a case.

#include "paths.hpp"
#include "tests/support/case_text.hpp"
#include "tests/support/program_document.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using Names = std::vector<std::string>;
const std::string examples = MICROSLIP_SOURCE_DIR "/examples/";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

/// Text of a part of a page: without tags, numbers as computers write them.
std::string plain(std::string text) {
  text = replaced(replaced(replaced(text, "·10<sup>", "e"), "−", "-"), "\u00a0", " ");
  text = replaced(text, "&nbsp;", " ");
  std::string letters;
  bool is_tag = false;
  for (const char letter : text) {
    if (letter == '<') is_tag = true;
    if (!is_tag) letters += letter;
    if (letter == '>') is_tag = false;
  }
  return letters;
}

/// What stands between each `begin` and the `end` behind it.
Names parts(const std::string& text, const std::string& begin, const std::string& end) {
  Names found;
  for (std::size_t at = 0; (at = text.find(begin, at)) != std::string::npos; ++at)
    found.push_back(text.substr(at, text.find(end, at) - at));
  return found;
}

/// A row of a table: its cells as texts.
using Row = std::vector<std::string>;

std::vector<Row> rows_of(const std::string& page, const std::string& table_class) {
  std::vector<Row> rows;
  for (const auto& table : parts(page, "<table class=\"" + table_class + "\">", "</table>"))
    for (const auto& text : parts(table, "<tr", "</tr>")) {
      rows.emplace_back();
      for (std::size_t at = 0; (at = std::min(text.find("<th", at), text.find("<td", at))) != std::string::npos; ++at) {
        const std::size_t end = std::min(text.find("</th>", at), text.find("</td>", at));
        rows.back().push_back(plain(text.substr(at, end - at)));
      }
    }
  return rows;
}

const std::map<std::string, double>& units() {
  static const std::map<std::string, double> known = {{"", 1},        {"N", 1},       {"kN", 1e3},
                                                      {"mm", 1e-3},   {"mm²", 1e-6},  {"mm³/m", 1e-9},
                                                      {"MPa", 1e6},   {"N m", 1},     {"W", 1},
                                                      {"kW", 1e3},    {"J", 1},       {"1/m", 1},
                                                      {"kN/mm", 1e6}, {"nm", 1e-9},   {"µm", 1e-6},
                                                      {"N/mm²", 1e6}, {"µg/m", 1e-9}, {"rad/s", 1},
                                                      {"mrad", 1e-3}, {"mm/s", 1e-3}, {"deg", std::numbers::pi / 180}};
  return known;
}

void collect(const io::Json& json, std::vector<double>& numbers) {
  if (json.is_number()) numbers.push_back(json.get<double>());
  if (json.is_structured())
    for (const auto& one : json) collect(one, numbers);
}

/// Six digits of a number agree.
bool agree(double printed, double number) {
  return std::abs(printed - number) <= 6e-6 * std::abs(number) + 1e-12;
}

class CaseReport : public testing::Test {
protected:
  std::string report(const std::string& example, const std::string& options = "") {
    const Outcome outcome = run_program(folder, "report '" + examples + example + ".toml' -o r.html " + options);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    EXPECT_EQ(outcome.output, "r.html\n");
    return contents(folder / "r.html");
  }

  void expect_refused(const std::string& arguments, const std::string& message, const std::string& before = "true") {
    const Names there = folder.entries();
    const Outcome outcome = run_program(folder, "report " + arguments, before);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_EQ(outcome.output, "");
    EXPECT_NE(outcome.errors.find(message), std::string::npos) << outcome.errors;
    EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
    EXPECT_EQ(folder.entries(), there);
  }

  TemporaryFolder folder;
};

TEST_F(CaseReport, HasTheNumbersOfTheResult) {
  for (const std::string example : {"rubber_roller", "wheel_on_rail"}) {
    const std::string page = report(example);
    std::vector<double> numbers;
    collect(program_document(folder, "solve '" + examples + example + ".toml' -o out --no-pictures"), numbers);
    std::size_t compared = 0;
    for (const Row& row : rows_of(page, "numbers")) {
      if (row.size() < 3 || row.back().find("µF") != std::string::npos) continue;
      ASSERT_TRUE(units().contains(row.back())) << row.back();
      for (std::size_t k = 1; k + 1 < row.size(); ++k) {
        if (row[k].find_first_not_of("-+.e0123456789") != std::string::npos || row[k].empty()) continue;
        const double printed = std::stod(row[k]) * units().at(row.back());
        EXPECT_TRUE(std::ranges::any_of(numbers, [&](double number) { return agree(printed, number); }))
            << example << ": " << row[0] << " " << row[k] << " " << row.back();
        ++compared;
      }
    }
    EXPECT_GT(compared, 20u) << example;
  }
}

TEST_F(CaseReport, HasEachNumberInItsPlace) {
  const auto rows = rows_of(report("hertzian_contact"), "numbers");
  const io::Json json = program_document(folder, "solve '" + examples + "hertzian_contact.toml' -o out --no-pictures");
  const auto expect = [&](const std::string& name, std::size_t column, const char* pointer) {
    const auto row = std::ranges::find_if(rows, [&](const Row& one) { return !one.empty() && one[0] == name; });
    ASSERT_NE(row, rows.end()) << name;
    const double printed = std::stod(row->at(column)) * units().at(row->back());
    const double number = json.at(io::Json::json_pointer(pointer));
    EXPECT_TRUE(agree(printed, number)) << name << " " << printed << " " << number;
  };
  expect("semi-axis a, along x", 1, "/hertz/a");
  expect("longitudinal force fx", 1, "/exact/fx");
  expect("longitudinal force fx", 2, "/fastsim2/fx");
  expect("lateral force fy", 1, "/exact/fy");
  expect("spin moment mz", 2, "/fastsim2/mz");
  expect("frictional power", 1, "/exact/frictional_power");
  expect("frictional power by creepages", 1, "/exact/power_by_creepage");
  expect("peak pressure", 1, "/hertz/peak_pressure");
  expect("discretisation error of power", 1, "/tolerances/exact/discretisation_error_frictional_power");
  expect("residual", 1, "/exact/residual");
}

TEST_F(CaseReport, NamesTheLineOfEachInput) {
  const std::string page = report("rubber_roller");
  std::istringstream text(contents(examples + "rubber_roller.toml"));
  Names lines = {""};
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  std::size_t found = 0;
  for (const Row& row : rows_of(page, "inputs")) {
    if (row.at(0) == "key") continue;
    const std::string key = row[0].substr(row[0].rfind('.') + 1);
    EXPECT_EQ(lines.at(static_cast<std::size_t>(std::stoi(row.back()))).find(key + " = "), 0u) << row[0];
    ++found;
  }
  EXPECT_EQ(found, 19u); // all lines of it with a value but the title
  EXPECT_NE(plain(page).find("friction.law = coulomb;"), std::string::npos); // a default
}

TEST_F(CaseReport, HasTheChecksWithinRounding) {
  std::size_t found = 0;
  for (const Row& row : rows_of(report("wheelset_in_curve"), "numbers checks")) {
    if (row.size() < 5 || row[0].empty()) continue;
    EXPECT_LT(std::stod(row[4]), 1e-6) << row[0];
    ++found;
  }
  EXPECT_EQ(found, 11u); // four of each wheel, three of both
}

TEST_F(CaseReport, HasTheHashOfEachFile) {
  const std::string page = report("wheel_on_rail");
  const auto hash_of = [&](const std::string& file) {
    const std::string command = "sha256sum '" + file + "' > '" + (folder / "hash").string() + "'";
    EXPECT_EQ(std::system(command.c_str()), 0);
    return contents(folder / "hash").substr(0, 64);
  };
  const auto rows = rows_of(page, "hashes");
  ASSERT_EQ(rows.size(), 4u);
  for (const std::string file : {"wheel_on_rail.toml", "profiles/60e1.prr", "profiles/s1002.prw"})
    EXPECT_NE(std::ranges::find(rows, Row{examples + file, hash_of(examples + file)}), rows.end()) << file;
}

TEST_F(CaseReport, IsOneFileThatIsTheSameEachTime) {
  const std::string first = report("two_rollers"), second = report("two_rollers");
  EXPECT_TRUE(first == second);
  EXPECT_EQ(folder.entries(), Names{"r.html"});
  EXPECT_EQ(first.find("src=\"data:image/png;base64,"), first.find("src="));
  EXPECT_EQ(first.find("http"), std::string::npos);
  EXPECT_EQ(first.find("<th>date</th>"), std::string::npos);
}

TEST_F(CaseReport, HasTheDateThatIsGiven) {
  const std::string command = "report '" + examples + "two_rollers.toml' -o r.html";
  run_program(folder, command, "export SOURCE_DATE_EPOCH=86400");
  EXPECT_NE(contents(folder / "r.html").find("<th>date</th><td>1970-01-02</td>"), std::string::npos);
  run_program(folder, command + " --date '3 May' --purpose 'Of <two> rollers'", "export SOURCE_DATE_EPOCH=86400");
  const std::string page = contents(folder / "r.html");
  EXPECT_NE(page.find("<th>date</th><td>3 May</td>"), std::string::npos);
  EXPECT_NE(page.find("<p class=\"purpose\">Of &lt;two&gt; rollers</p>"), std::string::npos);
}

TEST_F(CaseReport, TakesATemplate) {
  save(folder / "logo.png", "a logo");
  save(folder / "company.html", "{% extends \"report.html\" %}{% block head %}<p>Works &amp; Sons</p>"
                                "<img alt=\"logo\" src=\"{{ picture('logo.png') }}\">{% endblock %}");
  const std::string page = report("two_rollers", "--template company.html");
  EXPECT_NE(page.find("<p>Works &amp; Sons</p><img alt=\"logo\" src=\"data:image/png;base64,YSBsb2dv\">"),
            std::string::npos);
  EXPECT_NE(page.find("<h1>Two rollers</h1>"), std::string::npos);
}

TEST_F(CaseReport, SaysWhatIsNotSolved) {
  save(folder / "s.toml", "title = \"Loads\"\n[grid]\nload.normal_force = [-1, 40e3]\n" + in_sweep(two_bodies_text));
  const Outcome outcome = run_program(folder, "report s.toml -o r.html");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.errors;
  const std::string page = contents(folder / "r.html");
  EXPECT_NE(page.find("Not all solved: 1 of the cases have another status than ok."), std::string::npos);
  EXPECT_NE(page.find("<h1>Loads</h1>"), std::string::npos);
  EXPECT_NE(page.find("<code>load.normal_force = [-1, 40e3]</code>"), std::string::npos);
  EXPECT_EQ(folder.entries(), (Names{"r.html", "s.toml"}));
}

TEST_F(CaseReport, RefusesInWords) {
  const std::string two = "'" + examples + "two_rollers.toml'";
  save(folder / "wrong.html", "{% extends \"report.html\" %}\n{% block head %}");
  save(folder / "undefined.html", "{% extends \"report.html\" %}{% block head %}{{ logo }}{% endblock %}");
  save(folder / "bad.toml", "[load]\n");
  expect_refused(two + " -o r.docx", "r.docx: a report's name must end with .html or .pdf");
  expect_refused(two + " -o r", "r: a report's name must end with .html or .pdf");
  expect_refused("bad.toml -o r.html", "[body1] is missing");
  expect_refused("none.toml -o r.html", "none.toml: cannot be read");
  expect_refused(two + " -o r.html --template none.html", "none.html: no such template");
  expect_refused(two + " -o r.html --template wrong.html", "wrong.html:2: ");
  expect_refused(two + " -o r.html --template undefined.html", "'logo' is undefined");
  expect_refused(two + " -o r.html", "the report cannot be made by /none: ", "export MICROSLIP_PYTHON=/none");
}

/// A module that is not there, as Python says it.
void hide_module(const TemporaryFolder& folder, const std::string& name) {
  save(folder / (name + ".py"), "raise ModuleNotFoundError(\"No module named '" + name + "'\", name='" + name + "')\n");
}

TEST_F(CaseReport, NamesThePackageThatIsMissing) {
  const std::string two = "'" + examples + "two_rollers.toml'", path = "export PYTHONPATH=$PWD";
  hide_module(folder, "weasyprint");
  expect_refused(
      two + " -o r.pdf",
      "microslip: a report needs the Python module weasyprint, which is not there: install the Debian package "
      "weasyprint, or name a file that ends with .html\n",
      path);
  EXPECT_EQ(run_program(folder, "report " + two + " -o r.html", path).exit_code, 0);
  hide_module(folder, "jinja2");
  expect_refused(two + " -o r.html", "jinja2, which is not there: install the Debian package python3-jinja2\n", path);
}

TEST_F(CaseReport, IsPrinted) {
  if (std::system("pdfinfo -v >/dev/null 2>&1") != 0) GTEST_SKIP() << "no poppler-utils";
  const auto printed = [&] {
    const Outcome outcome = run_program(folder, "report '" + examples + "two_rollers.toml' -o r.pdf");
    return outcome.exit_code == 0 ? contents(folder / "r.pdf") : outcome.errors;
  };
  const std::string first = printed();
  if (first.find("Debian package weasyprint") != std::string::npos) GTEST_SKIP() << "no weasyprint";
  EXPECT_TRUE(first == printed());
  const std::string at = (folder / "r").string();
  ASSERT_EQ(std::system(("pdfinfo '" + at + ".pdf' > '" + at + ".txt'").c_str()), 0);
  EXPECT_NE(contents(at + ".txt").find("Two rollers"), std::string::npos); // the title
  EXPECT_TRUE(std::regex_search(contents(at + ".txt"), std::regex("Pages: +1\n"))) << contents(at + ".txt");
  ASSERT_EQ(std::system(("pdftotext -layout '" + at + ".pdf' '" + at + ".txt'").c_str()), 0);
  EXPECT_NE(contents(at + ".txt").find("Files and reproduction"), std::string::npos);
}

} // namespace
} // namespace microslip
