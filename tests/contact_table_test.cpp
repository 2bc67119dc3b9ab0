#include "io/contact_table.hpp"

#include "microslip/error.hpp"
#include "tests/support/expect_error.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

const std::string header =
    "a,b,shear_modulus,poisson_ratio,friction,normal_force,creepage_longitudinal,creepage_lateral,spin\n";
const std::string row = "0.006,0.005,82e9,0.28,0.3,80e3,0.001,-0.002,0.5\n";

struct Table {
  std::vector<std::string> columns;
  std::vector<EllipticContact> contacts;
  std::string text; ///< as result_rows has it
};

/// With an Error for the first bad row.
Table read_table(const std::string& csv) {
  std::istringstream stream(csv);
  io::ContactTableReader reader(stream, "in.csv");
  Table table;
  table.columns = reader.columns();
  io::TextChunk chunk;
  while (reader.read(chunk)) {
    const auto rows = reader.parse(chunk);
    if (!rows.bad.empty()) throw Error(reader.message(rows.bad.front()));
    table.contacts.insert(table.contacts.end(), rows.contacts.begin(), rows.contacts.end());
    table.text += io::result_rows(rows, std::vector<ContactForces>(rows.contacts.size()));
  }
  EXPECT_EQ(reader.bytes_read(), csv.size());
  return table;
}

std::string message_of(const std::string& csv) {
  return error_of([&] { read_table(csv); });
}

/// The good row with one field replaced.
std::string row_with(std::size_t column, const std::string& field) {
  std::string line;
  std::istringstream stream(row.substr(0, row.size() - 1));
  std::string good;
  for (std::size_t i = 0; std::getline(stream, good, ','); ++i)
    line += (i > 0 ? "," : "") + (i == column ? field : good);
  return line + "\n";
}

TEST(ContactTable, ReadsARow) {
  const auto table = read_table(header + row);
  ASSERT_EQ(table.contacts.size(), 1u);
  const auto& contact = table.contacts[0];
  EXPECT_EQ(contact.a, 0.006);
  EXPECT_EQ(contact.b, 0.005);
  EXPECT_EQ(contact.shear_modulus, 82e9);
  EXPECT_EQ(contact.poisson_ratio, 0.28);
  EXPECT_EQ(contact.friction.static_coefficient(), 0.3);
  EXPECT_EQ(contact.normal_force, 80e3);
  EXPECT_EQ(contact.creepage.longitudinal, 0.001);
  EXPECT_EQ(contact.creepage.lateral, -0.002);
  EXPECT_EQ(contact.creepage.spin, 0.5);
}

TEST(ContactTable, ReadsDissimilarityAndSpeedWhereTheyAreGiven) {
  std::istringstream stream("rolling_speed,dissimilarity," + header + "30,-0.22," + row + "40,0," + row);
  io::ContactTableReader reader(stream, "in.csv");
  io::TextChunk chunk;
  ASSERT_TRUE(reader.read(chunk));
  const auto rows = reader.parse(chunk);
  ASSERT_EQ(rows.contacts.size(), 2u);
  EXPECT_EQ(rows.contacts[0].dissimilarity, -0.22);
  EXPECT_EQ(rows.contacts[1].dissimilarity, 0);
  EXPECT_EQ(rows.contacts[0].rolling_speed, 30);
  EXPECT_EQ(rows.contacts[1].rolling_speed, 40);
  EXPECT_EQ(rows.contacts[1].a, 0.006);
}

TEST(ContactTable, RefusesImpossibleDissimilaritiesAndThoseThatTheSolverCannotHonour) {
  const auto message = [&](const std::string& dissimilarity) {
    return message_of("dissimilarity," + header + dissimilarity + "," + row);
  };
  EXPECT_EQ(message("0.2"), "no error");
  EXPECT_EQ(message("0.7"), "in.csv:2: column dissimilarity = 0.7 [-]: must be in [-0.5, 0.5]");
  EXPECT_EQ(message("-0.3").find("in.csv:2: column dissimilarity = -0.3 [-]: must be in [-0.2"), 0u); // |K| <= 1/2 - nu
  EXPECT_EQ(message_of("rolling_speed," + header + "0," + row),
            "in.csv:2: column rolling_speed = 0 [m/s]: must be positive and finite");
  std::istringstream stream("dissimilarity," + header + "0," + row + "1e-9," + row);
  io::ContactTableReader reader(stream, "in.csv");
  reader.refuse_dissimilar_bodies("unless pigs fly");
  io::TextChunk chunk;
  ASSERT_TRUE(reader.read(chunk));
  const auto rows = reader.parse(chunk);
  ASSERT_EQ(rows.bad.size(), 1u);
  EXPECT_EQ(reader.message(rows.bad[0]), "in.csv:3: column dissimilarity = 1e-09 [-]: must be 0 unless pigs fly");
}

TEST(ContactTable, ReadsColumnsByTheirFormerNames) {
  const std::string former = "a,b,shear_modulus,poisson_ratio,friction,normal_force,creep_x,creep_y,spin\n";
  std::istringstream stream(former + row);
  io::ContactTableReader reader(stream, "in.csv");
  EXPECT_EQ(reader.columns().at(6), "creepage_longitudinal");
  EXPECT_EQ(message_of(former + row), "no error");
}

TEST(ContactTable, FindsColumnsByNameInAnyOrder) {
  const auto table =
      read_table("spin,creepage_lateral,creepage_longitudinal,normal_force,friction,poisson_ratio,shear_modulus,b,a\n"
                 "0.5,-0.002,0.001,80e3,0.3,0.28,82e9,0.005,0.006\n");
  ASSERT_EQ(table.contacts.size(), 1u);
  EXPECT_EQ(table.columns.front(), "spin");
  EXPECT_EQ(table.contacts[0].a, 0.006);
  EXPECT_EQ(table.contacts[0].creepage.spin, 0.5);
}

TEST(ContactTable, TakesEveryCommonFormOfCsv) {
  const auto expected = read_table(header + row).text;
  const auto body = row.substr(0, row.size() - 1);
  const auto head = header.substr(0, header.size() - 1);
  EXPECT_EQ(read_table("\xef\xbb\xbf" + header + row).text, expected) << "byte-order mark";
  EXPECT_EQ(read_table(head + "\r\n" + body + "\r\n").text, expected) << "CRLF";
  EXPECT_EQ(read_table(header + body).text, expected) << "no final newline";
  EXPECT_EQ(read_table("\n \r\n" + header + "\n\t\n" + row + "\n\n").text, expected) << "blank lines";
  std::string spread, quotes;
  for (const char letter : header + row) {
    spread += letter == ',' ? " ,\t" : std::string(1, letter);
    quotes += letter == ',' ? "\",\"" : letter == '\n' ? "\"\n\"" : std::string(1, letter);
  }
  EXPECT_EQ(read_table(spread).text, expected) << "blanks";
  EXPECT_EQ(read_table("\"" + quotes.substr(0, quotes.size() - 1)).text, expected) << "quotes";
  EXPECT_EQ(read_table(header).text, "") << "no rows";
  EXPECT_EQ(read_table(header + row_with(0, "+6E-3")).contacts[0].a, 0.006);
}

TEST(ContactTable, KeepsTheTextOfItsFields) {
  EXPECT_EQ(read_table(header + row_with(0, " 6.000e-03 ")).text.rfind("6.000e-03,0.005,82e9,", 0), 0u);
}

std::string replaced(std::string text, char from, const std::string& to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, 1, to);
  return text;
}

TEST(ContactTable, TakesSemicolonsTabsAndDecimalCommas) {
  const auto expected = read_table(header + row);
  for (const char* separator : {";", "\t", " ; "}) {
    EXPECT_EQ(read_table(replaced(header + row, ',', separator)).text, expected.text);
    const auto table = read_table(replaced(header, ',', separator) + replaced(replaced(row, ',', separator), '.', ","));
    EXPECT_EQ(table.text, expected.text);
    EXPECT_EQ(table.contacts.at(0).a, 0.006);
  }
  const auto german = replaced(header, ',', ";");
  EXPECT_EQ(message_of(german + "1.234,5" + replaced(row.substr(5), ',', ";")),
            "in.csv:2: column a: \"1.234,5\" is not a number");
}

TEST(ContactTable, PassesFurtherColumnsOn) {
  const auto semicolons = [](const std::string& text) { return replaced(text, ',', ";"); };
  const auto table = read_table("name;time;" + semicolons(header) + "\"a;b, \"\"c\"\"\";0,5;" + semicolons(row) + ";;" +
                                semicolons(row));
  EXPECT_EQ(table.columns.at(0), "name");
  EXPECT_EQ(table.columns.at(1), "time");
  const auto named = read_table("\";;;;;;;;;;;;\"," + header + "x," + row);
  EXPECT_EQ(read_table(io::result_header(named.columns) + named.text).text, named.text);
  const std::string fields = row.substr(0, row.size() - 1) + ",0,0,0,0,0,ok\n";
  EXPECT_EQ(table.text, "\"a;b, \"\"c\"\"\",\"0,5\"," + fields + ",," + fields);
}

/// What a run writes can be the next one's input.
TEST(ContactTable, ReplacesResultsOfAnEarlierRun) {
  const auto first = read_table(header + row);
  const auto second =
      read_table(io::result_header(first.columns, true) + row.substr(0, row.size() - 1) + ",1,2,3,4,5,ok,1e-9,7\n");
  EXPECT_EQ(io::result_header(second.columns), io::result_header(first.columns));
  EXPECT_EQ(second.text, first.text);
}

TEST(ContactTable, ColumnsHaveOtherUnits) {
  auto head = header;
  for (const auto& [name, unit] : {std::pair("a,", "a [mm],"),
                                   {",b,", ",b [mm],"},
                                   {"shear_modulus", "shear_modulus [GPa]"},
                                   {"normal_force", "normal_force [kN]"},
                                   {"spin", "spin [1/m]"}})
    head.replace(head.find(name), std::string(name).size(), unit);
  const auto table = read_table(head + "6,5,82,0.28,0.3,80,0.001,-0.002,0.5\n");
  const auto& contact = table.contacts.at(0);
  EXPECT_EQ(contact.a, 0.006);
  EXPECT_EQ(contact.shear_modulus, 82e9);
  EXPECT_EQ(contact.normal_force, 80e3);
  EXPECT_EQ(contact.creepage.spin, 0.5);
  EXPECT_EQ(table.columns.at(0), "a [mm]");
  EXPECT_EQ(table.text.rfind("6,5,82,", 0), 0u);
  EXPECT_EQ(message_of(head.replace(head.find("[kN]"), 4, "[mm]")),
            "in.csv:1: column normal_force [mm]: must be in N, kN, MN, kgf, lbf or kip, e.g. \"80 kN\"");
}

TEST(ContactTable, FindsAllBadRows) {
  std::istringstream stream(header + row + "1,2,3\n" + row_with(4, "abc") + row + row_with(3, "0.7"));
  io::ContactTableReader reader(stream, "in.csv");
  io::TextChunk chunk;
  reader.read(chunk);
  const auto rows = reader.parse(chunk);
  EXPECT_EQ(rows.contacts.size(), 2u);
  EXPECT_EQ(rows.ends.size(), 2u);
  ASSERT_EQ(rows.bad.size(), 3u);
  EXPECT_EQ(reader.message(rows.bad[0]), "in.csv:3: 3 fields, not 9");
  EXPECT_EQ(reader.message(rows.bad[1]), "in.csv:4: column friction: \"abc\" is not a number");
  EXPECT_EQ(reader.message(rows.bad[2]), "in.csv:6: column poisson_ratio = 0.7 [-]: must be in [0, 0.5]");
  EXPECT_EQ(io::result_rows(rows, std::vector<ContactForces>(2)), read_table(header + row + row).text);
}

TEST(ContactTable, NamesColumnsThatAreWrong) {
  const auto renamed = [](const std::string& from, const std::string& to) {
    auto text = header + row;
    return message_of(text.replace(text.find(from), from.size(), to));
  };
  EXPECT_EQ(renamed(",spin", ""), "in.csv:1: column spin: is missing");
  EXPECT_EQ(renamed("creepage_longitudinal", "creepage_longitudina"),
            "in.csv:1: column \"creepage_longitudina\": unknown; did you mean creepage_longitudinal?");
  EXPECT_EQ(renamed("creepage_lateral", "creepage_longitudinal"),
            "in.csv:1: column creepage_longitudinal: is there twice");
  EXPECT_EQ(renamed("spin", "spin,rolling_sped"),
            "in.csv:1: column \"rolling_sped\": unknown; did you mean rolling_speed?");
  EXPECT_EQ(renamed("a,", "\"a,"), "in.csv:1: a quote is not closed or inside a field");
}

TEST(ContactTable, NamesLineAndColumnOfABadField) {
  const auto message = [](std::size_t column, const std::string& field) {
    return message_of(header + row + "\n" + row_with(column, field) + row);
  };
  EXPECT_EQ(message(4, "abc"), "in.csv:4: column friction: \"abc\" is not a number");
  EXPECT_EQ(message(3, "0.7"), "in.csv:4: column poisson_ratio = 0.7 [-]: must be in [0, 0.5]");
  EXPECT_EQ(message(3, "-0.1"), "in.csv:4: column poisson_ratio = -0.1 [-]: must be in [0, 0.5]");
  EXPECT_EQ(message(4, "11"), "in.csv:4: column friction = 11 [-]: must be in [0, 10]");
  EXPECT_EQ(message(8, "inf"), "in.csv:4: column spin = inf [1/m]: must be finite");
  EXPECT_EQ(message(0, ""), "in.csv:4: column a: there is nothing");
  EXPECT_EQ(message(0, "1e999"), "in.csv:4: column a: \"1e999\" is too large or too small");
  for (const auto* text : {"0.1x", "1 2", "0x10", "++1", "+", "-", "1e", "1;2"})
    EXPECT_EQ(message(0, text), "in.csv:4: column a: \"" + std::string(text) + "\" is not a number");
  for (std::size_t column = 0; column < 9; ++column)
    for (const auto* text : {"nan", "inf", "-inf"})
      EXPECT_NE(message(column, text).find("in.csv:4: column "), std::string::npos) << column << text;
  for (const std::size_t positive : {0, 1, 2, 5})
    for (const auto* text : {"0", "-1", "-0.0"})
      EXPECT_NE(message(positive, text).find("]: must be positive and finite"), std::string::npos) << positive << text;
}

TEST(ContactTable, NamesLinesThatAreWrong) {
  EXPECT_EQ(message_of(header + row + "1,2,3\n" + row), "in.csv:3: 3 fields, not 9");
  EXPECT_EQ(message_of(header + row.substr(0, row.size() - 1) + ",\n"),
            "in.csv:2: 10 fields, not 9; decimal commas need semicolons between fields");
  EXPECT_EQ(message_of(header + row + "0.006,0.005,82e"),
            "in.csv:3: 3 fields, not 9; the file ends in the middle of a line");
  EXPECT_EQ(message_of(header + row + "\"0.006,0.005\n" + row), "in.csv:3: a quote is not closed or inside a field");
  EXPECT_EQ(message_of(header + row.substr(0, 5) + "\r" + row), "in.csv:2: a carriage return inside a line");
}

TEST(ContactTable, RefusesFilesThatAreNoTables) {
  const std::string empty =
      "in.csv: is empty; the first line must name the columns a, b, shear_modulus, poisson_ratio, "
      "friction, normal_force, creepage_longitudinal, creepage_lateral and spin";
  EXPECT_EQ(message_of(""), empty);
  EXPECT_EQ(message_of("\n \n"), empty);
  EXPECT_EQ(message_of("\xef\xbb\xbf"), empty);
  std::string binary;
  for (unsigned i = 0; i < 1000000; ++i) binary += static_cast<char>((i * 7919) >> 3);
  const std::string no_text = "in.csv: is UTF-16 or no text; it must be UTF-8 or ASCII";
  EXPECT_EQ(message_of(binary), no_text);
  EXPECT_EQ(message_of(header + binary).rfind("in.csv:2: ", 0), 0u) << message_of(header + binary);
  EXPECT_EQ(message_of(header + std::string(1000000, '1')), "in.csv:2: a line of more than 32 KiB");
  EXPECT_EQ(message_of(std::string(1000000, '\0')), no_text);
  EXPECT_EQ(message_of("a b shear_modulus\n1 2 3\n"),
            "in.csv:1: is one column: commas, semicolons or tabs must separate several");
  EXPECT_EQ(message_of(std::string("\xff\xfe") + "a"), no_text);
  EXPECT_EQ(message_of(std::string("a\0,\0b\0\n\0", 8)), no_text);
}

TEST(ContactTable, ReadsMoreThanAChunkWithTheRightLineNumbers) {
  std::string csv = header;
  for (int i = 1; i <= 20000; ++i) csv += row_with(8, std::to_string(i)) + (i % 7 == 0 ? "\n" : "");
  const auto table = read_table(csv);
  ASSERT_EQ(table.contacts.size(), 20000u);
  for (int i = 1; i <= 20000; ++i) ASSERT_EQ(table.contacts[i - 1].creepage.spin, i);
  EXPECT_EQ(message_of(csv + "x\n").substr(0, 13), "in.csv:22859:"); // 1 + 20000 + 2857 + 1
}

TEST(ContactTable, WritesNumbersThatReadBackAsTheSame) {
  std::istringstream stream(header + row);
  io::ContactTableReader reader(stream, "in.csv");
  io::TextChunk chunk;
  reader.read(chunk);
  const auto rows = reader.parse(chunk);
  const double third = 1.0 / 3, tiny = std::numeric_limits<double>::denorm_min();
  const std::vector<ContactForces> forces = {{third, -2e300, tiny, 0.1, 0, Status::ok}};
  EXPECT_EQ(io::result_rows(rows, forces),
            row.substr(0, row.size() - 1) + ",0.3333333333333333,-2e+300,5e-324,0.1,0,ok\n");
  const std::vector<ContactForces> invalid = {{std::nan(""), 0, 0, 0, 0, Status::invalid_input}};
  EXPECT_EQ(io::result_rows(rows, invalid), row.substr(0, row.size() - 1) + ",nan,0,0,0,0,invalid_input\n");
  EXPECT_EQ(io::result_header(reader.columns()),
            header.substr(0, header.size() - 1) + ",fx,fy,mz,adhesion_area,slip_area,status\n");
}

} // namespace
} // namespace microslip
