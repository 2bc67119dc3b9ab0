// What a sweep's file says: which values which case has, by its number alone; what is wrong is named.

#include "campaign/sweep_spec.hpp"

#include "campaign/rows.hpp"
#include "microslip/error.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/program_run.hpp"
#include "tests/support/temporary_folder.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

constexpr const char* inside = "[case]\nx.y = 1\n";

double number(const campaign::SweepSpec& spec, std::size_t index, std::size_t k) {
  const campaign::CaseValue value = spec.value(index, k);
  return value.node == nullptr ? value.number : value.node->value_or(std::nan(""));
}

std::vector<double> numbers(const campaign::SweepSpec& spec, std::size_t k) {
  std::vector<double> all;
  for (std::size_t i = 0; i < spec.count(); ++i) all.push_back(number(spec, i, k));
  return all;
}

void expect_refused(const std::string& text, const std::string& what) {
  expect_words([&] { campaign::SweepSpec(text, "s.toml"); }, what);
}

TEST(SweepSpec, KeysOfACasesOwnSweepAreNone) {
  expect_refused(std::string("[grid]\nsweep.lateral = [0.0, 0.001]\n") + inside,
                 "s.toml:2: sweep.lateral: names no key that cases have; vary the key itself, e.g. wheel.lateral");
}

TEST(SweepSpec, GridsVaryTheLastKeyFastestInTheOrderOfTheFile) {
  const campaign::SweepSpec spec(
      std::string("[grid]\nz.z = [1, 2]\n\"a.a\" = { from = 0, to = 1, count = 3 }\nm.b = [7]\n") + inside, "s.toml");
  ASSERT_EQ(spec.count(), 6u);
  EXPECT_EQ(spec.shape(), (std::vector<std::size_t>{2, 3, 1}));
  EXPECT_EQ(spec.parameters()[0].name, "z.z");
  EXPECT_EQ(spec.parameters()[1].name, "a.a");
  EXPECT_EQ(numbers(spec, 0), (std::vector<double>{1, 1, 1, 2, 2, 2}));
  EXPECT_EQ(numbers(spec, 1), (std::vector<double>{0, 0.5, 1, 0, 0.5, 1}));
}

TEST(SweepSpec, TextsWithUnitsBecomeNumbersInTheUnitsOfTheirKeys) {
  const std::string base = "[case.load]\nnormal_force = \"80 kN\"\n[case.a]\nword = \"3d\"\n";
  const io::TomlSection::KeyUnits units = {
      {"load.normal_force", "N"}, {"body.radius", "m"}, {"body.temperature", "deg C"}};
  campaign::SweepSpec spec("[grid]\nbody.radius = { from = \"100 mm\", to = 0.4, count = 4 }\n"
                           "body.temperature = [20, \"293.15 K\", \"50 degC\"]\na.word = [\"3d\", \"2d\"]\n" +
                               base,
                           "s.toml");
  ASSERT_TRUE(spec.has_units());
  EXPECT_EQ(spec.case_as_written(0).at_path("body.radius").value_or(std::string()), "100 mm");
  spec.convert_units(units);
  EXPECT_EQ(number(spec, 0, 0), 0.1);
  EXPECT_EQ(number(spec, spec.count() - 1, 0), 0.4);
  EXPECT_EQ(number(spec, 0, 1), 20);
  EXPECT_NEAR(number(spec, 2, 1), 20, 1e-12);
  EXPECT_EQ(number(spec, 4, 1), 50);
  EXPECT_TRUE(spec.parameters()[1].is_number);
  EXPECT_FALSE(spec.parameters()[2].is_number);
  EXPECT_EQ(spec.text_of(1, 2), "2d");
  EXPECT_EQ(spec.base().at_path("load.normal_force").value_or(0.0), 80e3);
  const auto refused = [&](const std::string& line) {
    campaign::SweepSpec wrong("[grid]\n" + line + "\n" + base, "s.toml");
    return error_of([&] { wrong.convert_units(units); });
  };
  EXPECT_EQ(refused("body.radius = [1, \"2 N\"]"),
            "s.toml:2: body.radius = \"2 N\" [m]: must be in m, mm, um, cm, km, in or ft, e.g. \"460 mm\"");
  EXPECT_EQ(refused("body.radius = { from = \"0 mm\", to = 1, count = 3, scale = \"logarithmic\" }"),
            "s.toml:2: a logarithmic scale needs ends of one sign");
  EXPECT_EQ(refused("\"body.radius, load.normal_force\" = [\"2 m\"]"),
            "s.toml:2: body.radius, load.normal_force: keys of different units cannot take the same text with a unit");
}

TEST(SweepSpec, EvenValuesAreWholeWhereTheyCanBe) {
  const auto expect_even = [](int from, int to, int count, int step) {
    const std::string range = "{ from = " + std::to_string(from) + ", to = " + std::to_string(to) +
                              ", count = " + std::to_string(count) + " }\n";
    const campaign::SweepSpec spec("[grid]\na.a = " + range + inside, "s.toml");
    std::vector<double> expected;
    for (int i = 0; i < count; ++i) expected.push_back(from + i * step);
    EXPECT_EQ(numbers(spec, 0), expected);
  };
  expect_even(6, 81, 16, 5);
  expect_even(81, 6, 16, -5);
  expect_even(-7, 29, 13, 3);
  expect_even(5, 5, 1, 0);
  const campaign::SweepSpec same(std::string("[grid]\na.a = { from = 0.1, to = 0.1, count = 7 }\n") + inside, "s.toml");
  EXPECT_EQ(numbers(same, 0), std::vector<double>(7, 0.1)); // none beyond the ends
}

TEST(SweepSpec, ALogarithmicScaleHasConstantRatios) {
  const campaign::SweepSpec spec(
      std::string("[grid]\na.a = { from = -1e-3, to = -10, count = 9, scale = \"logarithmic\" }\n") + inside, "s.toml");
  const auto values = numbers(spec, 0);
  EXPECT_EQ(values.front(), -1e-3);
  EXPECT_EQ(values.back(), -10);
  for (std::size_t i = 1; i < values.size(); ++i) EXPECT_NEAR(values[i] / values[i - 1], std::sqrt(10), 1e-12);
}

TEST(SweepSpec, KeysMayTakeOneValueTogether) {
  const campaign::SweepSpec spec(std::string("[grid]\n\"a.n, b.n\" = [0.25, 0.5]\n") + inside, "s.toml");
  toml::table table = spec.base();
  spec.set(1, 0, table);
  EXPECT_EQ(table.at_path("a.n").value<double>(), 0.5);
  EXPECT_EQ(table.at_path("b.n").value<double>(), 0.5);
  EXPECT_EQ(table.at_path("x.y").value<double>(), 1);
}

TEST(SweepSpec, WholeNumbersServeKeysOfEitherKind) {
  const campaign::SweepSpec spec(std::string("[grid]\na.a = { from = 0, to = 1, count = 3 }\n") + inside, "s.toml");
  toml::table table = spec.base();
  spec.set(2, 0, table);
  EXPECT_TRUE(table.at_path("a.a").is_integer());
  spec.set(1, 0, table);
  EXPECT_TRUE(table.at_path("a.a").is_floating_point());
}

TEST(SweepSpec, ListsAreTablesOfCases) {
  const TemporaryFolder folder;
  save(folder / "l.csv", "a.a, b.word ,c.c\n1,left,2.5\n\n-3e2,right,4\n");
  const campaign::SweepSpec spec(std::string("[list]\nfile = \"l.csv\"\n") + inside, (folder / "s.toml").string());
  ASSERT_EQ(spec.count(), 2u);
  EXPECT_EQ(numbers(spec, 0), (std::vector<double>{1, -300}));
  EXPECT_FALSE(spec.parameters()[1].is_number);
  EXPECT_EQ(spec.text_of(1, 1), "right");
  save(folder / "l.csv", "a.a,b.b\n1,2\n3\n");
  EXPECT_THROW(campaign::SweepSpec(spec.text(), spec.name()), Error);
  save(folder / "l.csv", "a.a,b.b\n");
  EXPECT_THROW(campaign::SweepSpec(spec.text(), spec.name()), Error);
}

TEST(SweepSpec, ListsAreReadAsTheyComeFromSpreadsheets) {
  const TemporaryFolder folder;
  save(folder / "l.csv", "a.a,b.word,c.c\n1.5,left,2.5\n-3e2,right,4\n");
  const std::string text = std::string("[list]\nfile = \"l.csv\"\n") + inside, name = (folder / "s.toml").string();
  const campaign::SweepSpec plain(text, name);
  for (const char* table : {"\xef\xbb\xbf"
                            "a.a;b.word;c.c\r\n1,5;left;2,5\r\n-3e2;right;4\r\n",
                            "\"a.a\"\tb.word\tc.c\n1,5\tleft\t2.5\n\n-300\tright\t4"}) {
    save(folder / "l.csv", table);
    const campaign::SweepSpec spec(text, name);
    ASSERT_EQ(spec.count(), plain.count());
    for (const std::size_t k : {std::size_t{0}, std::size_t{2}})
      EXPECT_EQ(numbers(spec, k), numbers(plain, k)) << table;
    EXPECT_EQ(spec.text_of(1, 1), "right");
  }
  save(folder / "l.csv", std::string("a\0,\0b\0\n\0", 8));
  EXPECT_THROW(campaign::SweepSpec(text, name), Error);
}

TEST(SweepSpec, ListsHaveUnitsInTheirHeadings) {
  const TemporaryFolder folder;
  save(folder / "l.csv", "a.a [mm];b.n [-];c.c\n6,5;3;7 mm\n-1;4;8 mm\n");
  campaign::SweepSpec spec(std::string("[list]\nfile = \"l.csv\"\n") + inside, (folder / "s.toml").string());
  spec.convert_units({{"a.a", "m"}, {"c.c", "m"}});
  EXPECT_EQ(numbers(spec, 0), (std::vector<double>{6.5e-3, -1e-3}));
  EXPECT_EQ(numbers(spec, 1), (std::vector<double>{3, 4}));
  EXPECT_EQ(numbers(spec, 2), (std::vector<double>{7e-3, 8e-3}));
}

TEST(SweepSpec, ListsMayHaveTextsAmongNumbers) {
  const TemporaryFolder folder;
  save(folder / "l.csv", "a.a,c.c\n1.25,5 mm\n\nbad,0.5\n");
  campaign::SweepSpec spec(std::string("[list]\nfile = \"l.csv\"\n") + inside, (folder / "s.toml").string());
  EXPECT_EQ(spec.value(0, 0).node->value<double>(), 1.25);
  EXPECT_EQ(spec.text_of(1, 0), "bad");
  spec.convert_units({{"a.a", "m"}, {"c.c", "m"}});
  EXPECT_EQ(spec.value(0, 1).node->value<double>(), 5e-3);
  EXPECT_EQ(spec.value(1, 1).node->value<double>(), 0.5);
}

TEST(SweepSpec, AKeyVariesOnce) {
  const TemporaryFolder folder;
  save(folder / "l.csv", "a.a,c.c,a.a\n1,2,3\n");
  const auto expect_twice = [&](const std::string& text, const std::string& file) {
    EXPECT_EQ(error_of([&] { campaign::SweepSpec(text, (folder / "s.toml").string()); }),
              (folder / file).string() + ": a.a: is varied twice");
  };
  expect_twice(std::string("[list]\nfile = \"l.csv\"\n") + inside, "l.csv");
  expect_twice(std::string("[grid]\na.a = [1, 2]\n\"c.c, a.a\" = [3]\n") + inside, "s.toml");
}

TEST(SweepSpec, WrongUnitsInListsHaveTheirLine) {
  const TemporaryFolder folder;
  save(folder / "l.csv", "a.a\n3 mm\n\n4 kN\n");
  campaign::SweepSpec spec(std::string("[list]\nfile = \"l.csv\"\n") + inside, (folder / "s.toml").string());
  EXPECT_EQ(spec.location(1), (folder / "l.csv").string() + ":4: ");
  const std::string text = error_of([&] { spec.convert_units({{"a.a", "m"}}); });
  EXPECT_TRUE(text.starts_with(spec.location(1) + "a.a = \"4 kN\" [m]: must be in")) << text;
}

std::string sample(int count, int seed) {
  return "[sample]\ncount = " + std::to_string(count) + "\nseed = " + std::to_string(seed) +
         "\na.a = { from = 2, to = 4 }\na.b = { from = 2, to = 4 }\na.l = { from = 1, to = 100, scale = "
         "\"logarithmic\" }\na.w = [\"u\", \"v\"]\n" +
         inside;
}

TEST(SweepSpec, SamplesAreUniformAndOfTheirSeedAlone) {
  const campaign::SweepSpec spec(sample(20000, 1), "s.toml"), more(sample(40000, 1), "s.toml"),
      other(sample(20000, 2), "s.toml");
  double sum = 0, squares = 0, mixed = 0, logarithms = 0;
  std::size_t words = 0;
  for (std::size_t i = 0; i < spec.count(); ++i) {
    const double a = number(spec, i, 0) - 3, b = number(spec, i, 1) - 3;
    ASSERT_LE(std::abs(a), 1);
    sum += a;
    squares += a * a;
    mixed += a * b;
    logarithms += std::log10(number(spec, i, 2));
    words += spec.text_of(i, 3) == "u";
    ASSERT_EQ(number(more, i, 0), number(spec, i, 0));
    ASSERT_NE(number(other, i, 0), number(spec, i, 0));
  }
  // Five standard deviations of the means.
  const double n = 20000, sigma = 5 / std::sqrt(n);
  EXPECT_NEAR(sum / n, 0, sigma * std::sqrt(1. / 3));
  EXPECT_NEAR(squares / n, 1. / 3, sigma * std::sqrt(4. / 45));
  EXPECT_NEAR(mixed / n, 0, sigma / 3);
  EXPECT_NEAR(logarithms / n, 1, sigma * std::sqrt(1. / 3));
  EXPECT_NEAR(static_cast<double>(words) / n, 0.5, sigma / 2);
}

/// Every part of a Latin hypercube has one case: the middles of ten parts lie beside the quantiles.
TEST(SweepSpec, SamplesHaveTheDistributionsOfTheirKeys) {
  const TemporaryFolder folder;
  save(folder / "speeds.csv", "run,speed [km/h]\n1,72\n2,36\n3,108\n");
  campaign::SweepSpec spec(std::string("[sample]\ncount = 4000\nseed = 3\npoints = \"latin_hypercube\"\n"
                                       "a.load = { distribution = \"normal\", mean = \"80 kN\", standard_deviation = "
                                       "\"8 kN\" }\n"
                                       "a.temperature = { distribution = \"normal\", mean = \"293.15 K\", "
                                       "standard_deviation = \"5 K\" }\n"
                                       "a.speed = { distribution = \"empirical\", file = \"speeds.csv\", column = "
                                       "\"speed\" }\n"
                                       "[sample.correlations]\n\"a.temperature with a.load\" = -0.8\n") +
                               inside,
                           (folder / "s.toml").string());
  ASSERT_TRUE(spec.has_units());
  spec.convert_units({{"a.load", "N"}, {"a.temperature", "deg C"}, {"a.speed", "m/s"}});
  const std::vector<double> load = numbers(spec, 0), temperature = numbers(spec, 1), speed = numbers(spec, 2);
  const auto mean = [](const std::vector<double>& values, const auto& of) {
    double sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) sum += of(i);
    return sum / static_cast<double>(values.size());
  };
  EXPECT_NEAR(mean(load, [&](std::size_t i) { return load[i]; }), 80e3, 20);
  EXPECT_NEAR(mean(load, [&](std::size_t i) { return std::pow(load[i] - 80e3, 2); }), 64e6, 5e5);
  EXPECT_NEAR(mean(load, [&](std::size_t i) { return temperature[i]; }), 20, 0.3);
  EXPECT_NEAR(mean(load, [&](std::size_t i) { return (load[i] - 80e3) / 8e3 * (temperature[i] - 20) / 5; }), -0.8,
              0.03);
  for (const double value : {10.0, 20.0, 30.0})
    EXPECT_NEAR(static_cast<double>(std::count(speed.begin(), speed.end(), value)), 4000 / 3.0, 1);
  EXPECT_EQ(spec.parameters()[2].unit, "m/s");
  EXPECT_TRUE(spec.parameters()[2].is_number);
  const std::uint64_t before = spec.identity();
  save(folder / "speeds.csv", "run,speed [km/h]\n1,72\n2,36\n3,109\n");
  EXPECT_NE(campaign::SweepSpec(spec.text(), spec.name()).identity(), before);
}

/// A, B, and one that differs from A in a key alone, where it is as in B.
TEST(SweepSpec, TablesMayBeginWithBlankLines) {
  const TemporaryFolder folder;
  save(folder / "t.csv", "\r\n \nmu;b\n0,25;1\n\n0,5;2\n");
  const auto spec_of = [&](const std::string& text) {
    return campaign::SweepSpec(text + inside, (folder / "s.toml").string());
  };
  const auto list = spec_of("[list]\nfile = \"t.csv\"\n");
  EXPECT_EQ(numbers(list, 0), (std::vector<double>{0.25, 0.5}));
  const auto sample = spec_of("[sample]\ncount = 1\nseed = 1\na.a = { distribution = \"empirical\", file = \"t.csv\", "
                              "column = \"mu\" }\n");
  EXPECT_TRUE(number(sample, 0, 0) == 0.25 || number(sample, 0, 0) == 0.5);
}

TEST(SweepSpec, ATableOfASampleHasAFieldForEachHeading) {
  const TemporaryFolder folder;
  const auto expect_line = [&](const std::string& table, const std::string& what) {
    save(folder / "t.csv", table);
    const std::string text = "[sample]\ncount = 2\nseed = 1\na.a = { distribution = \"empirical\", file = \"t.csv\", "
                             "column = \"mu\" }\n";
    expect_words([&] { campaign::SweepSpec(text + inside, (folder / "s.toml").string()); }, "t.csv:" + what);
  };
  const std::string advice = "; decimal commas need semicolons between fields";
  expect_line("mu\n0,3\n0,4\n", "2: 2 fields, not 1" + advice);
  expect_line("mu,b\n0.3,1\n0,4,1\n", "3: 3 fields, not 2" + advice);
  expect_line("mu,b\n0.3,1\n0.4\n", "3: 1 field, not 2");
  expect_line("mu;b\n0,3;1\n0,4;1;2\n", "3: 3 fields, not 2");
}

TEST(SweepSpec, CasesForSobolsIndicesFollowEachOther) {
  const campaign::SweepSpec spec(std::string("[sample]\ncount = 8\nseed = 3\npoints = \"sobol\"\naim = "
                                             "\"sobol_indices\"\na.x = { from = 0, to = 1 }\na.y = { from = 0, to = 1 "
                                             "}\n") +
                                     inside,
                                 "s.toml");
  ASSERT_EQ(spec.count(), 32u);
  for (std::size_t i = 0; i < 32; i += 4)
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_NE(number(spec, i, k), number(spec, i + 1, k));
      EXPECT_EQ(number(spec, i + 2, k), number(spec, k == 0 ? i + 1 : i, k));
      EXPECT_EQ(number(spec, i + 3, k), number(spec, k == 1 ? i + 1 : i, k));
    }
}

TEST(SweepSpec, WhatIsWrongWithASampleIsNamed) {
  const auto refused = [](const std::string& lines, const std::string& what) {
    expect_refused("[sample]\ncount = 8\nseed = 3\n" + lines + inside, what);
  };
  refused("a.x = { distribution = \"norml\", mean = 1 }\n", "s.toml:4: a.x.distribution");
  refused("a.x = { distribution = \"norml\", mean = 1 }\n", "did you mean normal?");
  refused("a.x = { distribution = \"normal\", mean = 1 }\n", "s.toml:4: [a.x]: standard_deviation is missing");
  refused("a.x = { distribution = \"normal\", mean = 1, standard_deviation = -1 }\n",
          "a.x.standard_deviation = -1 [SI]: must be positive");
  refused("a.x = { distribution = \"normal\", mean = 1, standard_deviation = 1, mode = 2 }\n",
          "a.x.mode: needs a.x.distribution = triangular");
  refused("a.x = { distribution = \"triangular\", from = 1, to = 2, mode = 3 }\n",
          "s.toml:4: mode = 3 []: must be between from and to");
  refused("a.x = { distribution = \"empirical\", file = \"no.csv\" }\n", "s.toml:4: no.csv: cannot be read");
  refused("a.x = { from = 0, to = 1 }\naim = \"all\"\n", "sample.aim");
  const std::string two = "a.x = { from = 0, to = 1 }\na.y = { from = 0, to = 1 }\na.z = [1, 2]\n";
  const auto correlated = [&](const std::string& line, const std::string& what) {
    refused(two + "[sample.correlations]\n" + line + "\n", what);
  };
  correlated("\"a.x with a.y\" = 1", "s.toml:8: sample.correlations.a.x with a.y: must be a number between -1 and 1");
  correlated("\"a.x with a.w\" = 0.5", "\"a.w\" does not vary");
  correlated("\"a.x with a.z\" = 0.5", "a.z: is a list, whose values have no order");
  correlated("\"a.x with a.x\" = 0.5", "are the same");
  correlated("\"a.x and a.y\" = 0.5", "must be of the form");
  refused("aim = \"sobol_indices\"\n" + two + "[sample.correlations]\n\"a.x with a.y\" = 0.5\n",
          "sobol_indices need keys that vary without correlations");
}

TEST(SweepSpec, ABillionCasesTakeNoMemory) {
  const std::string axis = " = { from = 0, to = 1, count = 1000 }\n";
  const campaign::SweepSpec spec("[grid]\na.a" + axis + "a.b" + axis + "a.c" + axis + inside, "s.toml");
  EXPECT_EQ(spec.count(), 1'000'000'000u);
  EXPECT_EQ(number(spec, 999'999'999, 2), 1);
  EXPECT_LE((spec.count() + spec.chunk() - 1) / spec.chunk(), campaign::most_chunks);
  expect_refused("[grid]\na.a" + axis + "a.b" + axis + "a.c" + axis + "a.d" + axis + inside,
                 "s.toml: [grid]: more than 2000000000 cases");
}

TEST(SweepSpec, WhatIsWrongIsNamed) {
  const auto of_case = [](const std::string& text) { return text + inside; };
  expect_refused("", "s.toml: case is missing");
  expect_refused(inside, "needs one of [grid], [list] and [sample]");
  expect_refused(of_case("[grid]\na.a = [1]\n[sample]\n"), "needs one of");
  expect_refused(of_case("[grid]\n"), "[grid]: names no key that varies");
  expect_refused(of_case("[grid]\na.a = []\n"), "s.toml:2: a.a: must have at least one value");
  expect_refused(of_case("[grid]\na.a = 3\n"), "s.toml:2: a.a: must be a list");
  expect_refused(of_case("[grid]\na.a = { from = 1, to = 2, cuont = 3 }\n"),
                 "a.a.cuont: unknown key; did you mean count?");
  expect_refused(of_case("[grid]\na.a = { from = 1, to = 2 }\n"), "count is missing");
  expect_refused(of_case("[grid]\na.a = { from = 1, to = 2, count = 0 }\n"), "a.a.count = 0");
  expect_refused(of_case("[grid]\na.a = { from = 0, to = 2, count = 4, scale = \"logarithmic\" }\n"),
                 "ends of one sign");
  expect_refused(of_case("[sample]\ncount = 0\nseed = 1\na.a = [1]\n"), "sample.count = 0");
  expect_refused(of_case("[sample]\ncount = 3\na.a = [1]\n"), "needs count and seed");
  expect_refused(of_case("[list]\nfile = \"nowhere.csv\"\n"), "nowhere.csv: cannot be read");
  expect_refused(of_case("chunk = 0\n[grid]\na.a = [1]\n"), "chunk = 0");
  expect_refused("case = \"nowhere.toml\"\n[grid]\na.a = [1]\n", "nowhere.toml: cannot be read");
  expect_refused("[grid]\na.a = [1]\n[case.sweep]\nx = 1\n", "[sweep]: must be left out");
}

TEST(SweepSpec, ItsIdentityIsThatOfAllItsFiles) {
  const TemporaryFolder folder;
  const auto identity = [&](const std::string& text) {
    return campaign::SweepSpec(text, (folder / "s.toml").string()).identity();
  };
  const std::string text = "case = \"c.toml\"\n[grid]\na.a = [1]\n";
  save(folder / "p.prr", "1");
  save(folder / "c.toml", "[rail]\nprofile = \"p.prr\"\n");
  const auto first = identity(text);
  EXPECT_EQ(identity(text), first);
  EXPECT_NE(identity(text + "\n"), first);
  save(folder / "p.prr", "2");
  const auto second = identity(text);
  EXPECT_NE(second, first);
  save(folder / "c.toml", "[rail]\nprofile = \"p.prr\"\n#\n");
  EXPECT_NE(identity(text), second);
  save(folder / "mu.csv", "1");
  save(folder / "c.toml", "[friction]\ntable = \"mu.csv\"\n");
  const auto third = identity(text);
  save(folder / "mu.csv", "2");
  EXPECT_NE(identity(text), third);
}

TEST(SweepSpec, ItsIdentityIsThatOfAllProfiles) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "sl");
  const auto expect_changed = [&](const std::string& text, const std::string& changed) {
    SCOPED_TRACE(text + changed);
    const auto identity = [&] { return campaign::SweepSpec(text, (folder / "s.toml").string()).identity(); };
    save(folder / changed, "1");
    const auto first = identity();
    EXPECT_EQ(identity(), first);
    save(folder / changed, "2");
    EXPECT_NE(identity(), first);
  };
  const std::string one = "[grid]\na.a = [1]\n";
  expect_changed(one + "[case.right_rail]\nprofile = \"sl/p.prr\"\n", "sl/p.prr");
  expect_changed(one + "[case.right_wheel]\nprofile = \"sl/p.prr\"\n", "sl/p.prr");
  expect_changed(one + "[case.friction]\ntable = 'sl\\mu.csv'\n", "sl/mu.csv");
  expect_changed("[grid]\nright_rail.profile = [\"no.prr\", \"sl/q.prr\"]\n[case.rail]\n", "sl/q.prr");
  save(folder / "sl/r.slcs", "0 1\n2\n0\n1\n0 'p.prr'\n1 'q.prr'\n");
  expect_changed(one + "[case.rail]\nprofile = \"sl/r.slcs\"\n", "sl/q.prr");
  expect_changed("[grid]\nrail.profile = [\"sl/r.slcs\"]\n[case.rail]\n", "sl/p.prr");
  save(folder / "sl/r.slcs", "broken"); // a case that fails by itself
  expect_changed("[grid]\nrail.profile = [\"sl/r.slcs\", \"sl/q.prr\"]\n[case.rail]\n", "sl/q.prr");
}

} // namespace
} // namespace microslip
